"""The end of a process: an immediate exit loses no output; exit handlers run."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = "Dim n As Integer\nFor n = 1 To 20000\n  PRINT n\nNext\n"
CALL = "import sys\nfrom motionlang.__main__ import main\n"
# Code before the call, and true if the process then exits at once.
BEFORE = {
    "": True,
    "import atexit\natexit.register(print, 'called')\n": False,
    "import threading\n": False,
    "sys.settrace(lambda *each: None)\n": False,
    "sys.setprofile(lambda *each: None)\n": False,
}
# Reports where the process exits.
WITNESS = "import os\nleave = os._exit\nos._exit = lambda status: (os.write(2, b'at once'), leave(status))\n"


def left(before: str, *words: str) -> subprocess.CompletedProcess[str]:
    script = f"{CALL}{WITNESS}{before}sys.exit(main())"
    environment = {**os.environ, "PYTHONUNBUFFERED": ""}
    return subprocess.run(
        [sys.executable, "-c", script, *words], capture_output=True, text=True, check=False, env=environment
    )


@pytest.fixture
def program(tmp_path: Path) -> str:
    path = tmp_path / "count.mnt"
    path.write_text(PROGRAM)
    return str(path)


@pytest.mark.skipif(sys.implementation.name != "cpython", reason="only CPython tells who waits for the end")
@pytest.mark.parametrize("before", BEFORE)
def test_a_process_leaves_at_once_if_no_one_waits_for_its_end(program: str, before: str) -> None:
    """The program is compiled before: Lark, which parses it, imports threads."""
    left("", "run", program, "--format", "none")
    ran = left(before, "run", program, "--format", "none")
    assert ran.returncode == 0
    lines = ran.stdout.split()
    assert lines[:20_000] == [str(n) for n in range(1, 20_001)]
    assert lines[20_000:] == (["called"] if "atexit" in before else [])
    assert ran.stderr == ("at once" if BEFORE[before] else "")


def test_the_exit_status_is_that_of_the_command(tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.mnt"
    wrong.write_text("PRNT 1\n")
    assert left("", "run", str(wrong), "--no-cache").returncode == 1
    assert left("", "run", "--no-such-option").returncode == 2
