"""`motionlang mcapi`, used as by a user: build, path, and a host with a board."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from test_mcapi.conftest import motionlang, needs_compiler

HERE = Path(__file__).parent
# A host in Python that calls the C library as PMC's binding does.
HOST = """
import sys
from ctypes import CDLL, byref, c_double
library = CDLL(None)
handle = library.MCOpen(0, 2, None)
library.MCEnableAxis(handle, 1, 1)
library.MCMoveAbsolute(handle, 1, c_double(2000.0))
assert library.MCIsStopped(handle, 1, c_double(10.0)) == 1
position = c_double(0.0)
assert library.MCGetPositionEx(handle, 1, byref(position)) == 0
print(position.value)
sys.exit(7)
"""


@needs_compiler
def test_the_path_is_that_of_the_build(cache: Path) -> None:
    done = motionlang(cache, "path")
    assert done.returncode == 0
    assert Path(done.stdout.strip()).name == "libmcapi-4.4.1.so"
    assert Path(done.stdout.strip()).is_relative_to(cache)


@needs_compiler
def test_the_exports_for_a_host_that_a_user_starts(cache: Path) -> None:
    library = motionlang(cache, "path").stdout.strip()
    lines = [f"export LD_PRELOAD={library}", f"export LD_LIBRARY_PATH='{Path(library).parent}:/a b'"]
    for words, board in (((), []), (("127.0.0.1:4411",), ["export MCAPI_HOST=127.0.0.1:4411"])):
        done = motionlang(cache, "path", "--env", *words, LD_PRELOAD="", LD_LIBRARY_PATH="/a b")
        assert (done.stdout.splitlines(), done.stderr) == (board + lines, "")


@needs_compiler
def test_a_host_runs_with_the_exports(cache: Path) -> None:
    """A shell takes them by eval; the host finds the library by its name."""
    exports = motionlang(cache, "path", "--env").stdout
    code = "import ctypes; print(ctypes.CDLL('libmcapi.so').MCOpen is not None)"
    command = ["sh", "-c", f'eval "$1"; "{sys.executable}" -c "{code}"', "sh", exports]
    found = subprocess.run(command, capture_output=True, text=True, check=True)
    assert found.stdout == "True\n"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--env", "x"), "'x' is not HOST:PORT"),
        (("--env", "--target", "win64"), "--env is for Linux; on Windows copy the DLL next to the program"),
    ],
)
def test_exports_that_cannot_be_printed(tmp_path: Path, words: tuple[str, ...], message: str) -> None:
    done = motionlang(tmp_path, "path", *words)
    assert (done.returncode, done.stdout) == (2, "")
    assert message in done.stderr


def test_a_path_before_a_build(tmp_path: Path) -> None:
    done = motionlang(tmp_path, "path", "--target", "win64")
    assert done.returncode == 1
    assert "the library of this version has not been built" in done.stderr
    assert "motionlang mcapi build --target win64 compiles it" in done.stderr
    assert motionlang(tmp_path, "run", "--", "true").returncode == 1


@needs_compiler
def test_a_host_runs_and_its_record_replays(cache: Path, tmp_path: Path) -> None:
    """The exit status is that of the host."""
    log = tmp_path / "a.log"
    done = motionlang(cache, "run", "--record", str(log), "--", sys.executable, "-c", HOST)
    assert (done.returncode, done.stdout, done.stderr) == (7, "2000.0\n", "")
    first = motionlang(cache, "replay", str(log))
    assert (first.returncode, first.stdout) == (0, "5 calls, 0 differences\n")
    assert motionlang(cache, "replay", str(log)).stdout == first.stdout


@needs_compiler
@pytest.mark.parametrize(
    ("program", "status", "message"),
    [
        (["no-such-program"], 127, "there is no program no-such-program"),
        ([str(HERE / "host.c")], 126, "is not a program that can be run"),
        ([sys.executable, "-c", "import os; os.kill(os.getpid(), 9)"], 137, ""),
        (["true"], 0, ""),
    ],
)
def test_the_exit_status_is_that_of_the_program(
    cache: Path, program: list[str], status: int, message: str
) -> None:
    done = motionlang(cache, "run", "--", *program)
    assert done.returncode == status
    assert message in done.stderr


@needs_compiler
def test_the_board_is_that_of_the_options(cache: Path) -> None:
    code = (
        "from ctypes import *; l = CDLL(None); h = l.MCOpen(0, 2, None); m = (c_int * 4)();"
        "l.MCGetInstalledModules(h, m, 4); print(list(m))"
    )
    options = ["--set", "controller.model=dcx-pci100", "--set", "controller.axes=2"]
    done = motionlang(cache, "run", *options, "--", sys.executable, "-c", code)
    assert done.stdout == "[4, 4, 15, 15]\n"
    done = motionlang(cache, "run", "--set", "controller.model=none", "--", "true")
    assert done.returncode == 2
    assert "none" in done.stderr


@needs_compiler
def test_a_program_linked_with_the_library(cache: Path, chost: Path, tmp_path: Path) -> None:
    """The program loads libmcapi-4.4.1.so, which is found by LD_LIBRARY_PATH."""
    log = tmp_path / "c.log"
    done = motionlang(cache, "run", "--record", str(log), "--", str(chost))
    assert (done.returncode, done.stdout, done.stderr.splitlines()[-1:]) == (
        0,
        "5001\n",
        ["motionlang serve: MCConfigureCompare is not supported: position compare has no documented command and no "
         "documented output"],
    )  # fmt: skip
    done = motionlang(cache, "replay", str(log))
    assert done.returncode == 0, done.stdout
    assert done.stdout.endswith(" calls, 0 differences\n")
    assert shutil.which("cc") is None or done.stderr == ""
