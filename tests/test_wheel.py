"""Every command from the bare wheel, with only the libraries that it depends on, and without each extra in turn.

The wheel is unpacked beside links to the installed libraries that are to be there, and Python is started without its
own ones (`-S`): nothing is installed, and what is missing is really missing. One process runs all commands.
"""

from __future__ import annotations

import ast
import json
import os
import re
import signal
import subprocess
import sys
import tomllib
import zipfile
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

import pytest
from packaging.requirements import Requirement

from motionlang.cli.commands import COMMANDS
from motionlang.client import Client
from motionlang.extras import LIBRARIES
from tests.built import ROOT, distributions
from tests.cli.programs import LONGEST

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
EXTRAS: dict[str, list[str]] = PROJECT["optional-dependencies"]
USED = sorted({extra for extra, _ in LIBRARIES.values()})
# Extras of which the package itself imports nothing: for those who work on it, and Dask, whose executor users pass in.
UNUSED = {"dev", "bench", "dask"}
PROGRAM = "SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n"
# Where that move is each 20 ms: half of 500 uu/s² over 0.1 s, and the same back.
RECORDED = "time_s,axis0_position_uu\n" + "".join(
    f"{time / 100},{250 * (time / 100) ** 2 if time <= 10 else 5 - 250 * (0.2 - time / 100) ** 2}\n"
    for time in range(0, 21, 2)
)
HELP = [*COMMANDS, *(f"pvt {name}" for name in ("plot", "refine", "export", "stream")), "servo step"]
links = pytest.mark.skipif(os.name == "nt", reason="links need a privilege on Windows")
# Real uses of every command, and in brackets the extra that it needs.
USES = """\
run move.mnt
run move.mnt --report json --prove
run move.mnt --trace move.csv --rate 100
run move.mnt --trace move.npz
run move.mnt --trace move.parquet [parquet]
run move.mnt --trace move.mcap [mcap]
run move.mnt --plot move.html
run move.mnt --plot move.svg [plot]
check move.mnt
repl move.mnt
plan --distance 10 --time 1 --rule third
profiles
profiles --plot profiles.png [plot]
keywords SPEED
verify move.mnt --update
verify move.mnt --jobs 1
pvt plot --positions 0,10,20 --time 10
pvt plot --positions 0,10,20 --time 10 --plot pvt.svg [plot]
pvt refine --positions 0,10,20 --time 10
pvt export --positions 0,10,20 --time 10 --format pdo
pvt stream --positions 0,10,20 --time 10 [can]
servo slip
servo step
servo step --plot step.svg [plot]
servo figure 12.1 --plot figure.svg [plot]
diff move.mnt move.mnt
sweep move.mnt --vary axis.0.start=1,2 --jobs 1 --out rows.csv
sweep move.mnt --vary axis.0.start=1,2 --jobs 1 --out rows.parquet [parquet]
sweep move.mnt --vary axis.0.start=1,2 --jobs 1 --plot sweep.svg [plot]
compare move.mnt recorded.csv
probe mint
serve move.mnt --modbus 127.0.0.1:0
completion bash [completion]
"""
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
    """The names of installed distributions that are required, and required by those in turn."""
    found: set[str] = set()
    left = [(Requirement(each), {""}) for each in requirements]
    while left:
        required, asked = left.pop()
        if required.marker and not any(required.marker.evaluate({"extra": extra}) for extra in asked):
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
    """Make the top-level modules and packages of installed distributions importable from `folder`."""
    for name in names:
        there = distribution(name)
        for top in {
            file.parts[0] for file in there.files or () if file.parts[0] not in ("..", "__pycache__")
        }:
            if not (folder / top).exists():
                (folder / top).symlink_to(str(there.locate_file(top)))


@pytest.fixture(scope="session")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder with the unpacked wheel."""
    folder = tmp_path_factory.mktemp("wheel")
    (built,) = distributions(folder, "wheel")
    with zipfile.ZipFile(built) as archive:
        archive.extractall(folder / "unpacked")
    return folder / "unpacked"


class Install:
    """A folder with a program, in which the wheel runs with the distributions that are named, and no other."""

    def __init__(self, folder: Path, wheel: Path, names: Iterable[str]) -> None:
        self.folder = folder / "work"
        self.folder.mkdir()
        (self.folder / "move.mnt").write_text(PROGRAM, encoding="utf-8")
        (self.folder / "recorded.csv").write_text(RECORDED, encoding="utf-8")
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

    def start(self, *command: str, code: str = "") -> subprocess.Popen[str]:
        """A command, or Python code, in a process of its own."""
        return subprocess.Popen(
            [sys.executable, "-S", *(("-c", code) if code else ("-m", "motionlang", *command))],
            cwd=self.folder, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        )  # fmt: skip

    def __call__(self, commands: Iterable[str]) -> dict[str, tuple[int, str, str]]:
        """Exit status, standard output and standard error of each command, all run by one process."""
        ran = subprocess.run(
            [sys.executable, "-S", self.driver], input=json.dumps(list(commands)), cwd=self.folder,
            env=self.environment, capture_output=True, text=True, encoding="utf-8", check=False,
        )  # fmt: skip
        assert ran.returncode == 0, ran.stderr
        found: dict[str, tuple[int, str, str]] = json.loads(ran.stdout)
        return found


def needed() -> dict[str, str]:
    """Each of `USES` and the extra that it needs, or ""."""
    found = (re.fullmatch(r"(.*?)(?: \[(\w+)\])?", line) for line in USES.splitlines())
    return {each[1]: each[2] or "" for each in found if each}


def check(install: Install, uses: dict[str, str], absent: set[str]) -> None:
    """Each help is shown; each use works, or names the extra that it needs and what installs it."""
    helps = [f"{command} --help" for command in HELP]
    ran = install([*helps, *uses])
    for command in helps:
        status, out, err = ran[command]
        assert (status, err) == (0, ""), command
        assert out.startswith("usage: motionlang"), command
    for command, extra in uses.items():
        status, out, err = ran[command]
        if extra in absent:
            assert (status, out) == (2 if "--" in err.partition(" needs ")[0] else 1, ""), command
            assert err.startswith("error[extra]: "), command
            assert err.endswith(f'\n  hint: python -m pip install "motionlang[{extra}]"\n'), command
        else:
            assert status == 0, (command, err)
            assert "error" not in err, command


@links
def test_every_command_from_the_bare_wheel(wheel: Path, tmp_path: Path) -> None:
    install = Install(tmp_path, wheel, closure(PROJECT["dependencies"]))
    check(install, needed(), set(USED))


@links
@pytest.mark.parametrize("absent", USED)
def test_every_command_without_one_extra(absent: str, wheel: Path, tmp_path: Path) -> None:
    """One use of each command, the first, and those that need the extra."""
    present = [each for extra in USED if extra != absent for each in EXTRAS[extra]]
    install = Install(tmp_path, wheel, closure([*PROJECT["dependencies"], *present]))
    firsts: dict[str, str] = {}
    for command in needed():
        firsts.setdefault(command.split()[0], command)
    uses = {use: extra for use, extra in needed().items() if extra == absent or use in firsts.values()}
    check(install, uses, {absent})


# What needs numpy among those that need no extra, and some more: by the option or the command that says so.
WITHOUT_NUMPY = {
    "run move.mnt --report json --prove": "--prove",
    "run move.mnt --certify": "--certify",
    "run move.mnt --paths": "--paths",
    "run move.mnt --trace move.csv --rate 100": "--trace",
    "run move.mnt --trace move.npz": "--trace",
    "run move.mnt --plot move.html": "--plot",
    "sweep move.mnt --vary axis.0.start=1,2 --jobs 1 --prove": "--prove",
    "run motor.mnt": "this run",
    "pvt export --positions 0,10,20 --time 10 --format pdo": "motionlang pvt",
    "servo step": "motionlang servo",
    "diff move.mnt move.mnt": "motionlang diff",
    "compare move.mnt recorded.csv --map position.0=2": "motionlang compare",
    "compare move.mnt recorded.csv": "motionlang compare",
}


@links
def test_every_command_without_numpy(wheel: Path, tmp_path: Path) -> None:
    """As in a browser's Python: each help is shown, and what needs numpy says so in a sentence."""
    install = Install(tmp_path, wheel, closure(PROJECT["dependencies"]) - {"numpy"})
    (install.folder / "motor.mnt").write_text("PRINT 1\n")
    (install.folder / "motor.machine.toml").write_text("[axis.0.plant]\nkind = 'dc'\n")
    plain = [use for use, extra in needed().items() if not extra and use not in WITHOUT_NUMPY]
    ran = install([f"{command} --help" for command in HELP] + plain + [*WITHOUT_NUMPY])
    for command, (status, out, err) in ran.items():
        user = WITHOUT_NUMPY.get(command)
        if user is None:
            assert status == 0, (command, err)
            assert "error" not in err, command
        else:
            told = f"error[extra]: {user} needs numpy\n  hint: python -m pip install numpy\n"
            assert (status, out, err) == (2 if user.startswith("--") else 1, "", told), command
    lines = "MOVER(0) = 5 : GO(0)\n.settle\n.plot\nPRINT POS(0)\n"
    asked = subprocess.run(
        [sys.executable, "-S", "-m", "motionlang", "repl"], input=lines, cwd=install.folder,
        env=install.environment, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert "velocity of axis 0" in asked.stdout
    assert asked.stdout.endswith("5.0000\n")


@links
@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGTERM to send")
def test_a_board_is_served_from_the_bare_wheel(wheel: Path, tmp_path: Path) -> None:
    install = Install(tmp_path, wheel, closure(PROJECT["dependencies"]))
    with install.start("serve", "--tcp", "127.0.0.1:0") as process:
        assert process.stdout is not None
        address = next(line for line in process.stdout if line.startswith("listening on "))
        with Client.open(address.split()[-1]) as board:
            assert board.send("1TP") == ["01 0"]
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=LONGEST)
    assert (process.returncode, err) == (0, "")
    assert out.startswith("served 1 hosts")


@links
def test_a_serial_line_from_the_bare_wheel(wheel: Path, tmp_path: Path) -> None:
    install = Install(tmp_path, wheel, closure(PROJECT["dependencies"]))
    opened = "from motionlang.client import Client; Client.open('COM7')"
    with install.start(code=opened) as process:
        _, err = process.communicate(timeout=LONGEST)
    assert err.splitlines()[-1] == (
        "motionlang.client.errors.ConnectionLost: "
        'a serial line needs pyserial: python -m pip install "motionlang[serial]"'
    )


# ------------------------------------------------------------------------------------------ the table of extras


def at_run_time(text: str) -> list[str]:
    """The imports of a module but for those that are for types alone."""
    left: list[ast.AST] = [ast.parse(text)]
    found = []
    while left:
        node = left.pop()
        if isinstance(node, ast.Import | ast.ImportFrom):
            found.append(ast.unparse(node))
        elif not (isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)):
            left += ast.iter_child_nodes(node)
    return found


def test_the_extras_are_those_of_the_project() -> None:
    named: dict[str, set[str]] = {}
    for extra, library in LIBRARIES.values():
        named.setdefault(extra, set()).add(library)
    declared = {
        extra: {Requirement(each).name for each in requirements}
        for extra, requirements in EXTRAS.items()
        if extra not in UNUSED
    }
    assert named == declared


def test_every_module_that_imports_a_library_of_an_extra_needs_it_first() -> None:
    """A test above reaches each of them; a new one is to be reached there, too."""
    imported = re.compile(rf"^\s*(?:from|import) (?:{'|'.join(LIBRARIES)})\b", re.MULTILINE)
    found = set()
    for path in (ROOT / "motionlang").rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        if imported.search(text) and any(imported.match(line) for line in at_run_time(text)):
            found.add(path)
    silent = {
        path.relative_to(ROOT / "motionlang").as_posix()
        for path in found
        if "need(" not in path.read_text(encoding="utf-8")
    }
    assert silent == {
        # Called by modules that need matplotlib: `write_plot` and `drawing`.
        "views/chapter12_plot.py",
        "views/path_plot.py",
        "views/plot_panel.py",
        # Imported by `motionlang pvt stream`, which needs the CAN libraries first.
        "copley/bus.py",
        "copley/master.py",
        "copley/node.py",
    }


def test_what_installs_an_extra_is_written_in_one_way() -> None:
    """In double quotes, which every shell accepts, and in the package only where `need` writes it."""
    texts = [*(ROOT / "motionlang").rglob("*.py"), *(ROOT / "docs").glob("*.md"), ROOT / "README.md"]
    found = {
        (path.name, line.strip())
        for path in texts
        for line in path.read_text(encoding="utf-8").splitlines()
        if re.search(r"pip install.*\[\S+\]", line)
    }
    wrong = {each for each in found if not re.search(r'pip install[^\[]* "[\w.]+\[\S+\]"', each[1])}
    assert wrong == set()
    assert {name for name, _ in found if name.endswith(".py")} == {"extras.py"}
