"""Inputs, answers and keys given on the command line."""

from __future__ import annotations

import io
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.programs import MAX_SECONDS, Cell

SPOOL = """\
INPUT "Turns ", turns
PAUSE INX(2)
OUTX(4) = 1
PAUSE INX(3)
PRINT turns; " at "; TIME
PAUSE INKEY = Asc("R")
PRINT "R at "; TIME; ", force "; ADC(0)
"""
WORLD = ("--input", "2=1@0.5", "--input", "3=out4+0.3", "--keys", "R@2", "--analog", "0=25@1")
# The input comes at 0.5 s, the output it starts is followed 0.3 s later.
SHOWN = "Turns 200\n200.0000 at 800\nR at 2000, force 25.0000\n"


def test_a_run(cell: Cell) -> None:
    cell.write("spool.mnt", SPOOL)
    ran = cell("run", "spool.mnt", *WORLD, "--answer", "turns=200", "--format", "none")
    assert (ran.status, ran.out, ran.err) == (0, SHOWN, "")


def test_they_are_laid_over_the_machine_file(cell: Cell) -> None:
    cell.write("spool.mnt", SPOOL)
    cell.write(
        "spool.machine.toml",
        'input = [{ channel = 2, name = "start", at = 9.0 }, { channel = 3, at = 1.0 }]\n'
        'answer = [{ text = "100" }]\nkey = [{ text = "R", at = 2.0 }]\n',
    )
    ran = cell("run", "spool.mnt", "--input", "start=1@0.5", "--answer", "7", "--format", "none")
    assert ran.out == "Turns 7\n7.0000 at 1000\nR at 2000, force 0.0000\n"


def test_a_question_takes_a_line_of_standard_input(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("spool.mnt", SPOOL)
    monkeypatch.setattr(sys, "stdin", io.StringIO("200\r\n300\n"))
    assert cell("run", "spool.mnt", *WORLD, "--format", "none").out == SHOWN
    assert sys.stdin.read() == "300\n"


def test_a_question_at_the_end_of_standard_input_is_an_error(
    cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    cell.write("spool.mnt", SPOOL)
    monkeypatch.setattr(sys, "stdin", io.StringIO(""))
    ran = cell("run", "spool.mnt", "--format", "none")
    assert ran.status == 1
    hint = '--answer "Turns=1" ends it, as does [[answer]] of the machine file'
    note = "motionlang init spool.mnt writes a first machine file"
    assert ran.err.endswith(f"hint: {hint}\nnote: {note}\n")


@pytest.mark.parametrize(
    ("program", "given"),
    [
        ("PAUSE INX(2) And INX(1)\n", ["--input", "1=1"]),
        ("PAUSE INX(2)\n", ["--set", "controller.axes=2"]),
        ("PAUSE INX(2)\n", ["--machine", "b.toml"]),
        ("PAUSE POS(0) > 5\n", []),
    ],
)
def test_no_note_on_init_if_it_does_not_help(program: str, given: list[str], cell: Cell) -> None:
    cell.write("a.mnt", program)
    cell.write("b.toml", "[controller]\n")
    ran = cell("run", "a.mnt", *given, "--format", "none")
    assert "error[never]" in ran.err
    assert "motionlang init" not in ran.err


@pytest.mark.parametrize(
    ("program", "given", "hint"),
    [
        ("a.mnt", "WAIT = 700\nPAUSE INX(2) = 0 And INX(4)", "--input 2=0@1.2 --input 4=1@1.2 end it"),
        ("a.mnt", "PAUSE INKEY = 65 And INX(2)", "--keys A@0.5 ends it"),
        ("a.mnt", "PAUSE ADC(2) > 10", "--analog 2=15@0.5 ends it"),
        ("a.mcl", "WN2,WN7", "--input 7=1@0.5 ends it"),
        ("a.mcl", "2MN,2VM,2GO,2FE0", "the machine file says where it is: axis.2.home_switch"),
    ],
)
def test_a_wait_that_never_ends_names_the_option_that_ends_it(
    cell: Cell, program: str, given: str, hint: str
) -> None:
    cell.write(program, given)
    ran = cell("run", program, "--input", "2", "--format", "none")
    assert f"hint: {hint}" in ran.err


def test_a_sweep_runs_every_variant_in_this_world(cell: Cell) -> None:
    cell.write("spool.mnt", SPOOL)
    vary = ("--vary", "controller.axes=2,4", "--keep", "time", "--format", "csv", "--jobs", "1")
    ran = cell("sweep", "spool.mnt", *WORLD, "--answer", "200", *vary)
    assert [line.split(",")[2][:5] for line in ran.out.splitlines()[1:]] == ["2.000", "2.000"]


def test_the_prompt(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    """Times count from the moment when the line is typed."""
    typed = (
        ".run 1\n.input 3=1@0.5\nPAUSE INX(3)\nPRINT TIME\n.answer 7\nINPUT n\n"
        ".keys A@1\nPAUSE INKEY=65\nPRINT TIME\n"
    )
    monkeypatch.setattr(sys, "stdin", io.StringIO(typed))
    ran = cell("repl")
    assert [line for line in ran.out.splitlines() if line.isdigit()] == ["1500", "7", "2500"]


def test_a_person_is_asked_at_once(tmp_path: Path) -> None:
    pty = pytest.importorskip("pty")
    program = tmp_path / "asks.mnt"
    program.write_text('INPUT "Turns ", n\nINPUT m\nPRINT "sum "; n + m\n')
    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "motionlang", "run", str(program), "--format", "none"]
    shown = b""
    with subprocess.Popen(command, stdin=theirs, stdout=theirs, stderr=theirs) as process:
        os.close(theirs)
        for wanted, typed in ((b"Turns ", b"4\n"), (b"? ", b"5\n"), (b"sum 9.0000\r\n", b"")):
            while wanted not in shown:
                shown += os.read(ours, 1024)
            os.write(ours, typed)
        assert process.wait(MAX_SECONDS) == 0
    os.close(ours)
    assert shown.split(b"\r\n")[:3] == [b"Turns 4", b"? 5", b"sum 9.0000"]
