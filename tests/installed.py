"""The wheel with chosen libraries: the help and real uses of every command.

The wheel is unpacked next to links to the installed libraries that it may use, and Python is started without
its own site-packages (`-S`). So nothing is installed, and every other library is really missing. One process
runs all commands.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterable, Mapping
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

from packaging.requirements import Requirement

from motionlang.cli.commands import COMMANDS, FOLDERS
from motionlang.extras import installation
from motionlang.kernel.tools import LIBRARIES
from tests.built import ROOT

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS: dict[str, list[str]] = PROJECT["optional-dependencies"]
USED = sorted({extra for extra, _ in LIBRARIES.values()})
PROGRAM = "SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n"
# The positions of that move every 20 ms: half of 500 uu/s² over 0.1 s, and the same back.
RECORDED = "time_s,axis0_position_uu\n" + "".join(
    f"{time / 100},{250 * (time / 100) ** 2 if time <= 10 else 5 - 250 * (0.2 - time / 100) ** 2}\n"
    for time in range(0, 21, 2)
)
# The options with which Python reports all that it warns of.
STRICT = ("-X", "dev", "-W", "error")
HELP = [*COMMANDS, *(f"pvt {name}" for name in ("plot", "refine", "export")), "servo step"]
# Real uses of every command, and in brackets the extra that each needs.
USES = """\
run move.mnt
profile move.mnt
trace move.mnt move.csv --rate 100
trace move.mnt move.npz
trace move.mnt move.parquet [parquet]
plot move.mnt move.html
plot move.mnt move.png [plot]
check move.mnt
repl move.mnt
plan --distance 10 --time 1 --rule third
help SPEED
verify move.mnt --update
verify move.mnt --jobs 1
pvt plot --positions 0,10,20 --time 10
pvt plot --positions 0,10,20 --time 10 --plot pvt.png [plot]
pvt refine --positions 0,10,20 --time 10
pvt export --positions 0,10,20 --time 10 --format pdo
servo step
servo step --plot step.png [plot]
diff move.mnt move.mnt
sweep move.mnt --vary axis.0.start=1,2 --jobs 1 --rows-to rows.csv
sweep move.mnt --vary axis.0.start=1,2 --jobs 1 --rows-to rows.parquet [parquet]
compare move.mnt recorded.csv
serve move.mnt --modbus 127.0.0.1:0
completion bash [completion]
"""
# Those of motionlang-explore.
USES_OF_EXPLORE = (
    "map move.mnt",
    "cover move.mnt",
    "improve move.mnt --set axis.0.limits.speed=60 --set axis.0.limits.acceleration=600",
)
# Commands that the package does not have itself, by the distribution that brings each.
ELSEWHERE = {f"{name} move.mnt": folder for name, folder in FOLDERS.items() if name not in COMMANDS}
DRIVER = """\
import contextlib, io, json, sys
from motionlang.cli import main

ran = {}
for command in json.load(sys.stdin):
    out, err, sys.stdin = io.StringIO(), io.StringIO(), io.StringIO("")
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = main(command.split())
        except SystemExit as end:
            status = end.code
    ran[command] = status, out.getvalue(), err.getvalue()
print(json.dumps(ran))
"""


def closure(requirements: Iterable[str]) -> set[str]:
    """Return the names of distributions required directly or indirectly."""
    found: set[str] = set()
    left = [(Requirement(each), {""}) for each in requirements]
    while left:
        required, enabled_extras = left.pop()
        if required.marker and not any(
            required.marker.evaluate({"extra": extra}) for extra in enabled_extras
        ):
            continue
        try:
            there = distribution(required.name)
        except PackageNotFoundError:
            continue
        if there.name not in found:
            found.add(there.name)
            extras = {"", *required.extras}
            left += [(Requirement(each), extras) for each in there.requires or ()]
    return found


def link(folder: Path, names: Iterable[str]) -> None:
    """Make the top-level modules of installed distributions importable from `folder`."""
    for name in names:
        there = distribution(name)
        for top in {
            file.parts[0] for file in there.files or () if file.parts[0] not in ("..", "__pycache__")
        }:
            if not (folder / top).exists():
                (folder / top).symlink_to(str(there.locate_file(top)))


class Install:
    """A folder with a program, where the wheel finds only the named distributions."""

    def __init__(self, folder: Path, wheel: Path, names: Iterable[str]) -> None:
        self.folder = folder / "work"
        self.folder.mkdir()
        write_files(self.folder)
        (folder / "site").mkdir()
        link(folder / "site", names)
        (folder / "driver.py").write_text(DRIVER, encoding="utf-8")
        self.driver = str(folder / "driver.py")
        self.environment = {
            **os.environ,
            "PYTHONPATH": os.pathsep.join((str(wheel), str(folder / "site"))),
            "MOTIONLANG_CACHE": str(folder / "cache"),
            "PYTHONUTF8": "1",
        }

    def python(self, *flags: str) -> list[str]:
        """Return the command that starts Python without its site-packages."""
        return [sys.executable, "-S", *flags]

    def environment_with(self, changes: Mapping[str, str | None]) -> dict[str, str]:
        """Return the environment with some variables changed; None removes a variable."""
        changed = {**self.environment, **changes}
        return {name: value for name, value in changed.items() if value is not None}

    def start(self, *command: str, code: str = "") -> subprocess.Popen[str]:
        """Start a command, or Python code, in a process of its own."""
        return subprocess.Popen(
            [*self.python(), *(("-c", code) if code else ("-m", "motionlang", *command))],
            cwd=self.folder, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        )  # fmt: skip

    def __call__(
        self, commands: Iterable[str], *flags: str, **changes: str | None
    ) -> dict[str, tuple[int, str, str]]:
        """Run all commands in one process; return exit status, output and errors of each.

        `flags` are options of Python, `changes` are changes of the environment.
        """
        command = [*self.python(*flags), self.driver]
        return drive(command, commands, self.folder, self.environment_with(changes))


def write_files(folder: Path) -> None:
    """Write the files that `USES` name."""
    (folder / "move.mnt").write_text(PROGRAM, encoding="utf-8")
    (folder / "recorded.csv").write_text(RECORDED, encoding="utf-8")


def drive(
    command: list[str], commands: Iterable[str], folder: Path, environment: dict[str, str]
) -> dict[str, tuple[int, str, str]]:
    """Run `commands` in the `DRIVER`, started by `command`, and return their output."""
    ran = subprocess.run(
        command, input=json.dumps(list(commands)), cwd=folder, env=environment, capture_output=True, text=True,
        encoding="utf-8", check=False,
    )  # fmt: skip
    assert (ran.returncode, ran.stderr) == (0, "")
    found: dict[str, tuple[int, str, str]] = json.loads(ran.stdout)
    return found


def needed() -> dict[str, str]:
    """Return the extra that each of `USES` needs, or "" if none."""
    found = (re.fullmatch(r"(.*?)(?: \[(\w+)\])?", line) for line in USES.splitlines())
    return {each[1]: each[2] or "" for each in found if each}


def first_uses() -> list[str]:
    """Return the first use of each command; only that of `completion` needs an extra."""
    firsts: dict[str, str] = {}
    for command in needed():
        firsts.setdefault(command.split()[0], command)
    return list(firsts.values())


def helps() -> list[str]:
    """Return the command lines that show each command's help."""
    return [f"{command} --help" for command in HELP]


def check_helps(ran: Mapping[str, tuple[int, str, str]]) -> None:
    """Check that the help of each command is shown."""
    for command in helps():
        status, out, err = ran[command]
        assert (status, err) == (0, ""), command
        assert out.startswith("usage: motionlang"), command


def check_uses(ran: Mapping[str, tuple[int, str, str]], uses: Mapping[str, str], absent: set[str]) -> None:
    """Check that each use works or names the missing extra."""
    for command, extra in uses.items():
        status, out, err = ran[command]
        if extra in absent:
            assert (status, out) == (1, ""), command
            assert err.startswith("error[extra]: "), command
            assert err.endswith(f'\n  hint: python -m pip install "motionlang[{extra}]"\n'), command
        else:
            assert status == 0, (command, err)
            assert "error" not in err, command


def check_elsewhere(ran: Mapping[str, tuple[int, str, str]]) -> None:
    """Check that each command of a distribution that is not installed says what to install."""
    for command, folder in ELSEWHERE.items():
        name = command.partition(" ")[0]
        message = f"motionlang: error: {name} needs motionlang-{folder}: {installation(folder)}\n"
        status, out, err = ran[command]
        assert (status, out, err) == (2, "", message), command
