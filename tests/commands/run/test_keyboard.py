"""An operator at the keyboard of a real-time run, simulated by a pseudo-terminal."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pty = pytest.importorskip("pty")

PROGRAM = """\
Dim n As Integer
PRINT "how many?"
INPUT n
PRINT "twice that is ", n * 2
PAUSE INKEY = Asc("q")
PRINT "bye"
"""


def run_at_terminal(tmp_path: Path, program: str, *exchanges: tuple[str, str]) -> tuple[int, str, str]:
    """Run a program and type an answer after each of its prompts."""
    file = tmp_path / "asks.mnt"
    file.write_text(program)
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "motionlang", "run", str(file), "--realtime", "10", "--format", "none"]
    with subprocess.Popen(
        command, stdin=theirs, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        os.close(theirs)
        assert process.stdout is not None
        for wanted, typed in exchanges:
            assert process.stdout.readline() == wanted
            os.write(ours, typed.encode())
        out, err = process.communicate(timeout=60)
    os.close(ours)
    return process.returncode, out, err


def test_a_line_is_typed_where_the_program_asks_and_keys_where_it_looks_for_them(tmp_path: Path) -> None:
    echo = "217" + 3 * "\b \b" + "21\n"
    exchanges = ("how many?\n", "217\x7f\n"), (echo, ""), ("twice that is 42\n", "xq")
    assert run_at_terminal(tmp_path, PROGRAM, *exchanges) == (0, "bye\n", "")


def test_a_program_that_does_not_listen_is_not_waited_for(tmp_path: Path) -> None:
    status, _, err = run_at_terminal(tmp_path, 'PRINT "x"\nPAUSE INX(3)\n')
    assert status == 1
    assert "the program waits until INX(3), which can never happen" in err
