"""Behaviour as a process: a closed pipe, Ctrl-C, and `python -m motionlang`."""

from __future__ import annotations

import io
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.programs import BALLSCREW, MAX_SECONDS, Cell

COMMAND = [sys.executable, "-m", "motionlang"]


def test_a_reader_that_goes_away_is_no_error(tmp_path: Path) -> None:
    read, write = os.pipe()
    os.close(read)
    ran = subprocess.run(
        [*COMMAND, "help", "keywords"], stdout=write, stderr=subprocess.PIPE, text=True, check=False
    )
    os.close(write)
    assert (ran.returncode, ran.stderr) == (141, "")


# Programs for commands whose reader disappears: one prints more than a pipe's buffer, one moves.
LOUD = 'Dim i As Integer\nFor i = 1 To 2000\nPRINT "line "; i\nNext\n'
MOVES = "SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n"
WRITERS = """\
--help
--version
run --help
run loud.mnt
run loud.mnt --format none
certify loud.mnt --format none
run loud.mnt --format none --realtime 1000
run loud.mnt --format json
run moves.mnt
profile moves.mnt --all
certify moves.mnt
run wrong.mnt --format json
repl loud.mnt
check moves.mnt
check moves.mnt --format json
help SPEED
plan --distance 10 --time 1 --rule third
diff moves.mnt loud.mnt
diff moves.mnt moves.mnt
sweep moves.mnt --vary controller.axes=1,2
verify moves.mnt
verify moves.mnt --format json
pvt --help
servo step --help
"""


def test_every_command_ends_quietly_where_its_reader_goes_away(
    cell: Cell, monkeypatch: pytest.MonkeyPatch, tmp_path_factory: pytest.TempPathFactory
) -> None:
    crashes = tmp_path_factory.mktemp("crashes")
    monkeypatch.setattr("tempfile.tempdir", str(crashes))
    cell.write("loud.mnt", LOUD)
    cell.write("moves.mnt", MOVES)
    cell.write("moves.machine.toml", "[axis.0.limits]\nspeed = 500\n")
    cell.write("wrong.mnt", "PRIMT 1\n")
    ends = {}
    for command in WRITERS.splitlines():
        read, write = os.pipe()
        os.close(read)
        with open(write, "w") as pipe, monkeypatch.context() as patched:
            patched.setattr(sys, "stdin", io.StringIO(""))
            patched.setattr(sys, "stdout", pipe)
            ran = cell(*command.split())
        ends[command] = ran.status, ran.err
    assert ends == dict.fromkeys(ends, (141, ""))
    assert list(crashes.iterdir()) == []


def test_a_full_disk_under_standard_output_is_reported_once() -> None:
    with open("/dev/full", "w") as full:
        ran = subprocess.run(
            [*COMMAND, "help", "keywords"], stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    message = "motionlang: cannot write the output: no space left on device\n"
    assert (ran.returncode, ran.stderr) == (1, message)


def test_ctrl_c_while_it_waits_for_the_machine(tmp_path: Path) -> None:
    """Once the position is printed, the run is in progress and sleeps."""
    program = tmp_path / "ballscrew.mcl"
    program.write_text("1MN,1TP\n" + BALLSCREW.replace("SV250", "SV0.5"))
    command = [*COMMAND, "run", str(program), "--realtime"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "01 0\n"
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=MAX_SECONDS)
    assert process.returncode == 130
    assert " · interrupted at " in out
    assert err.startswith("error[interrupted]: the run was ended from the keyboard\n")


@pytest.mark.slow
def test_a_long_run_on_a_terminal_says_how_far_it_is(tmp_path: Path) -> None:
    """The progress line appears after a second; Ctrl-C replaces it by a message."""
    pty = pytest.importorskip("pty")
    program = tmp_path / "shuttle.mcl"
    program.write_text("1MN,1PM,1SV1000,1SA10000,1DS10000\n1MR10,1WS,1MR-10,1WS,RP\n")
    main, terminal = pty.openpty()
    command = [*COMMAND, "run", str(program), "--format", "none", "--until", "28800"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=terminal) as process:
        os.close(terminal)
        shown = b""
        while b" of 8 h" not in shown:
            shown += os.read(main, 4096)
        process.send_signal(signal.SIGINT)
        while b"run was ended from the keyboard" not in shown:
            shown += os.read(main, 4096)
        process.communicate(timeout=MAX_SECONDS)
    os.close(main)
    assert process.returncode == 130


HURRY = "Dim k As Float\nLoop\n  k = k + 0.001\n  JOG(0) = k\nEnd Loop\n"
WARNING = "JOG starts motions without waiting for them"


def test_a_loop_that_never_waits_is_reported_while_it_runs(tmp_path: Path) -> None:
    """The message with its line comes before the run ends, and only once."""
    program = tmp_path / "hurry.mnt"
    program.write_text(HURRY)
    command = [*COMMAND, "run", str(program)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        early = [process.stderr.readline() for _ in range(4)]
        assert WARNING in early[0]
        assert early[1].endswith("hurry.mnt:4\n")
        assert early[3] == "4 |   JOG(0) = k\n"
        assert process.poll() is None
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=MAX_SECONDS)
    assert process.returncode == 130
    assert WARNING not in err
    assert "the run was ended from the keyboard" in err


@pytest.mark.slow
def test_on_a_terminal_it_is_above_the_line_of_progress(tmp_path: Path) -> None:
    pty = pytest.importorskip("pty")
    program = tmp_path / "hurry.mnt"
    program.write_text(HURRY)
    main, terminal = pty.openpty()
    with subprocess.Popen(
        [*COMMAND, "run", str(program)], stdout=subprocess.PIPE, stderr=terminal
    ) as process:
        os.close(terminal)
        shown = b""
        while b" of 8 h" not in shown.partition(WARNING.encode())[2]:
            shown += os.read(main, 4096)
        process.send_signal(signal.SIGINT)
        while b"run was ended from the keyboard" not in shown:
            shown += os.read(main, 4096)
        process.communicate(timeout=MAX_SECONDS)
    os.close(main)
    assert shown.count(WARNING.encode()) == 1


def test_standard_output_may_be_closed(tmp_path: Path) -> None:
    program = tmp_path / "ballscrew.mcl"
    program.write_text(BALLSCREW)
    line = f"{' '.join(COMMAND)} run {program} >&-"
    ran = subprocess.run(line, shell=True, stderr=subprocess.PIPE, text=True, check=False)
    assert (ran.returncode, ran.stderr) == (0, "")


def test_standard_input_may_be_closed() -> None:
    line = f"{' '.join(COMMAND)} run - --lang mint --format none <&-"
    ran = subprocess.run(line, shell=True, capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "")
