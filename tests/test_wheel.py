"""Every command of the bare wheel: with required libraries, without each extra."""

from __future__ import annotations

import ast
import os
import re
import signal
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest
from packaging.requirements import Requirement

from motionlang.client import Client
from motionlang.kernel.tools import LIBRARIES
from tests.built import ROOT
from tests.cli.programs import MAX_SECONDS
from tests.installed import (
    ELSEWHERE,
    EXTRAS,
    PROJECT,
    USED,
    Install,
    check_elsewhere,
    check_helps,
    check_uses,
    closure,
    helps,
    needed,
)
from tests.lowest import SUPPORTED, lowest

# Extras that the package itself does not import: for developers, and Dask, whose executor users pass in.
UNUSED = {"dev", "dask", "release", "site"}
links = pytest.mark.skipif(os.name == "nt", reason="links need a privilege on Windows")


@pytest.mark.slow
@links
def test_every_command_from_the_bare_wheel(wheel: Path, tmp_path: Path) -> None:
    install = Install(tmp_path, wheel, closure(PROJECT["dependencies"]))
    uses = needed()
    ran = install([*helps(), *uses, *ELSEWHERE])
    check_helps(ran)
    check_uses(ran, uses, set(USED))
    check_elsewhere(ran)


@pytest.mark.slow
@links
@pytest.mark.parametrize("absent", sorted({*needed().values()} - {""}))
def test_every_command_without_one_extra(absent: str, wheel: Path, tmp_path: Path) -> None:
    """It runs the uses that need the extra; all others work without any extra."""
    present = [each for extra in USED if extra != absent for each in EXTRAS[extra]]
    install = Install(tmp_path, wheel, closure([*PROJECT["dependencies"], *present]))
    uses = {use: extra for use, extra in needed().items() if extra == absent}
    check_uses(install(uses), uses, {absent})


# Uses that need numpy among those that need no extra, and some more: by the option or command in the message.
WITHOUT_NUMPY = {
    "trace move.mnt move.csv --rate 100": "motionlang trace",
    "trace move.mnt move.npz": "motionlang trace",
    "run motor.mnt": "this run",
    "pvt export --positions 0,10,20 --time 10 --format pdo": "motionlang pvt",
    "servo step": "motionlang servo",
    "diff move.mnt move.mnt": "motionlang diff",
    "compare move.mnt recorded.csv --map position.0=2": "motionlang compare",
    "compare move.mnt recorded.csv": "motionlang compare",
}


def check_without_numpy(ran: Mapping[str, tuple[int, str, str]], users: Mapping[str, str]) -> None:
    """Check that uses name numpy if they need it, and work if not."""
    for command, (status, out, err) in ran.items():
        user = users.get(command)
        if user is None:
            assert status == 0, (command, err)
            assert "error" not in err, command
        else:
            message = f"error[extra]: {user} needs numpy\n  hint: python -m pip install numpy\n"
            assert (status, out, err) == (69, "", message), command


@pytest.mark.slow
@links
def test_every_command_without_numpy(wheel: Path, tmp_path: Path) -> None:
    """A Python in a browser has no numpy: each help is shown, and messages name numpy."""
    install = Install(tmp_path, wheel, closure(PROJECT["dependencies"]) - {"numpy"})
    (install.folder / "motor.mnt").write_text("PRINT 1\n")
    (install.folder / "motor.machine.toml").write_text("[axis.0.plant]\nkind = 'dc'\n")
    plain = [use for use, extra in needed().items() if not extra and use not in WITHOUT_NUMPY]
    ran = install([*helps(), *plain, *WITHOUT_NUMPY])
    check_without_numpy(ran, WITHOUT_NUMPY)
    lines = "MOVER(0) = 5 : GO(0)\n.settle\n.plot\nPRINT POS(0)\n"
    result = subprocess.run(
        [sys.executable, "-S", "-m", "motionlang", "repl"], input=lines, cwd=install.folder,
        env=install.environment, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert "velocity of axis 0" in result.stdout
    assert result.stdout.endswith("5.0000\n")


@pytest.mark.slow
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
        out, err = process.communicate(timeout=MAX_SECONDS)
    assert process.returncode == 0
    connected, ended = err.splitlines()
    assert connected.startswith("host 1 connected from 127.0.0.1:")
    assert ended.startswith("host 1 ")
    assert out.startswith("served 1 host")


@pytest.mark.slow
@links
def test_a_serial_line_from_the_bare_wheel(wheel: Path, tmp_path: Path) -> None:
    install = Install(tmp_path, wheel, closure(PROJECT["dependencies"]))
    opened = "from motionlang.client import Client; Client.open('COM7')"
    with install.start(code=opened) as process:
        _, err = process.communicate(timeout=MAX_SECONDS)
    assert err.splitlines()[-1] == (
        "motionlang.hosts.errors.ConnectionLost: "
        'a serial line needs pyserial: python -m pip install "motionlang[serial]"'
    )


def test_the_lowest_versions_are_declared_for_each_python() -> None:
    """`python -m tests.lowest` installs these.

    The lowest numpy is the first one with a wheel for that Python.
    """
    numpy = {version: lowest(version)[1] for version in SUPPORTED}
    assert numpy == {
        "3.11": "numpy==1.26",
        "3.12": "numpy==1.26",
        "3.13": "numpy==2.1",
        "3.14": "numpy==2.3.2",
    }
    assert {len(lowest(version)) for version in SUPPORTED} == {4}
    named = {each.rpartition(" ")[2] for each in PROJECT["classifiers"] if " :: 3." in each}
    assert named == set(SUPPORTED)


# ------------------------------------------------------------------------------------------ the table of extras


def at_run_time(text: str) -> list[str]:
    """Return the import lines of a module, except those that are only for types."""
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


@pytest.mark.slow
def test_every_module_that_imports_a_library_of_an_extra_needs_it_first() -> None:
    """Each such module calls `need` first, or is called only by modules that do.

    A test above reaches each of them; add a new module there.
    """
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
        # Imported by `figure_files.py`, which needs matplotlib first.
        "views/figure_matplotlib.py",
    }


def test_what_installs_an_extra_is_written_in_one_way() -> None:
    """The command quotes the extra with double quotes, which suit every shell.

    In the package, the command is only in `need`.
    """
    texts = [*(ROOT / "motionlang").rglob("*.py"), *(ROOT / "docs").glob("*.md"), ROOT / "README.md"]
    found = {
        (path.name, line.strip())
        for path in texts
        for line in path.read_text(encoding="utf-8").splitlines()
        if re.search(r"pip install.*\[\S+\]", line)
    }
    wrong = {each for each in found if not re.search(r'pip install[^\[]* "[\w.]+\[\S+\]"', each[1])}
    assert wrong == set()
    assert {name for name, _ in found if name.endswith(".py")} == {"tools.py"}
