"""What only a process of its own can show: a closed pipe, Ctrl-C, the module as a program."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.programs import BALLSCREW

COMMAND = [sys.executable, "-m", "motionlang"]


def test_a_reader_that_goes_away_is_no_error(tmp_path: Path) -> None:
    read, write = os.pipe()
    os.close(read)
    ran = subprocess.run([*COMMAND, "keywords"], stdout=write, stderr=subprocess.PIPE, text=True, check=False)
    os.close(write)
    assert (ran.returncode, ran.stderr) == (141, "")


def test_a_full_disk_under_standard_output_is_said_once() -> None:
    with open("/dev/full", "w") as full:
        ran = subprocess.run(
            [*COMMAND, "keywords"], stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    message = "motionlang: the output cannot be written: no space left on device\n"
    assert (ran.returncode, ran.stderr) == (1, message)


def test_ctrl_c_while_it_waits_for_the_machine(tmp_path: Path) -> None:
    """The position is printed before the pace sleeps, so its line says that the run is under way."""
    program = tmp_path / "ballscrew.mcl"
    program.write_text("1MN,1TP\n" + BALLSCREW.replace("SV250", "SV0.5"))
    command = [*COMMAND, "run", str(program), "--realtime"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "01 0\n"
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=20)
    assert process.returncode == 130
    assert " · interrupted at " in out
    assert err.startswith("error[interrupted]: the run was ended from the keyboard\n")


def test_a_long_run_on_a_terminal_says_how_far_it_is(tmp_path: Path) -> None:
    """From the first second on; Ctrl-C then takes the line away and reports."""
    pty = pytest.importorskip("pty")
    program = tmp_path / "shuttle.mcl"
    program.write_text("1MN,1PM,1SV1000,1SA10000,1DS10000\n1MR10,1WS,1MR-10,1WS,RP\n")
    main, terminal = pty.openpty()
    command = [*COMMAND, "run", str(program), "--report", "none"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=terminal) as process:
        os.close(terminal)
        shown = b""
        while b" of machine time " not in shown:
            shown += os.read(main, 4096)
        process.send_signal(signal.SIGINT)
        while b"run was ended from the keyboard" not in shown:
            shown += os.read(main, 4096)
        process.communicate(timeout=20)
    os.close(main)
    assert process.returncode == 130


def test_standard_output_may_be_closed(tmp_path: Path) -> None:
    program = tmp_path / "ballscrew.mcl"
    program.write_text(BALLSCREW)
    line = f"{' '.join(COMMAND)} run {program} >&-"
    ran = subprocess.run(line, shell=True, stderr=subprocess.PIPE, text=True, check=False)
    assert (ran.returncode, ran.stderr) == (0, "")


def test_standard_input_may_be_closed() -> None:
    line = f"{' '.join(COMMAND)} run - --dialect mint --report none <&-"
    ran = subprocess.run(line, shell=True, capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "")
