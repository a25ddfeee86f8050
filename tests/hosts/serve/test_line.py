"""The host line of a Mint program as a process: TCP, a serial device, Modbus."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from pymodbus.client import ModbusTcpClient

from tests.cli.programs import MAX_SECONDS
from tests.hosts.mint.lines import answer_frame, read_frame, write_frame
from tests.hosts.serve.conftest import Wire
from tests.hosts.serve.test_command import line_with

# The host writes a distance to COMMS 1; the position is COMMS 2.
PACKER = """\
SPEED(0) = 1000 : ACCEL(0) = 1e6 : DECEL(0) = 1e6
Print "ready"
Loop
  COMMS(2) = POS(0)
  Wait = 10
End Loop
Event COMMS1
  MOVER(0) = COMMS(1) : GO(0)
End Event
"""
ESB = ("--set", "controller.model=NextMove ESB-2")


@contextmanager
def running(folder: Path, text: str, *options: str) -> Iterator[subprocess.Popen[str]]:
    program = folder / "packer.mnt"
    program.write_text(text)
    command = [sys.executable, "-m", "motionlang", "serve", str(program), *ESB, *options]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            yield process
        finally:
            process.kill()


@contextmanager
def host(process: subprocess.Popen[str]) -> Iterator[Wire]:
    name, _, port = line_with(process, "listening on ").rpartition(":")
    wire = Wire((name, int(port)))
    with wire.socket:
        yield wire


def read(wire: Wire, element: int) -> float:
    """Read a comms element by HCP."""
    wire.send(read_frame(element))
    found = re.search(rb"\x02\d\d([^\x03]*)\x03", wire.until(b"\x03"))
    assert found
    wire.until(bytes([answer_frame(element, found[1].decode())[-1]]))
    return float(found[1])


def test_a_host_moves_the_axis_of_a_program(tmp_path: Path) -> None:
    """HCP writes a distance and reads the position, then come Ctrl-E and a typed line."""
    with running(tmp_path, PACKER, "--tcp", "0", "--factor", "20") as process, host(process) as wire:
        wire.until(b"ready\r\n")
        wire.send(write_frame(1, "250"))
        wire.until(b"\x06")
        while read(wire, 2) != 250.0:
            pass
        wire.send(b"\x05")
        assert wire.until(b"P>").startswith(b"Break at line ")
        wire.send(b"Print POS(0) * 2\n")
        assert wire.until(b"P>") == b"500.0000\r\nP>"
        process.send_signal(signal.SIGTERM)
        out, err = process.communicate(timeout=MAX_SECONDS)
    assert process.returncode == 0
    ends = r"host 1 connected from 127\.0\.0\.1:\d+\nhost 1 is disconnected: the server ends\n"
    assert re.fullmatch(ends, err), err
    assert re.fullmatch(r"served 1 host; machine time \d+\.\d{3} s\n", out), out


def test_a_serial_device_with_pyserial(tmp_path: Path) -> None:
    """A roll former's host downloads a program, with a library that is not ours."""
    pytest.importorskip("pty")
    serial = pytest.importorskip("serial")
    with running(tmp_path, PACKER, "--pty", "--no-echo") as process:
        device = line_with(process, "serial device ")
        with serial.Serial(device, 9600, timeout=MAX_SECONDS) as line:
            line.write(b"\x05")
            assert b"Break at line" in line.read_until(b"P>")
            for sent, mark in (
                (b"PROG\n", b"P>"),
                (b"NEW\n", b"P>"),
                (b"EDIT\n", b"1>"),
                (b'Input "width? ", w\n', b"2>"),
                (b'Print "twice ", 2 * w\n', b"3>"),
                (b"\n", b"P>"),
            ):
                line.write(sent)
                assert line.read_until(mark) == mark
            line.write(b"RUN\n")
            assert line.read_until(b"? ") == b"width? "
            line.write(b"21\r\n")
            assert line.read_until(b"P>") == b"\r\ntwice 42.0000\r\nP>"


def test_modbus_and_the_line_at_once(tmp_path: Path) -> None:
    options = ("--tcp", "0", "--modbus", "0", "--unit", "17")
    with running(tmp_path, PACKER, *options) as process, host(process) as wire:
        port = int(line_with(process, "listening on ").split()[0].rpartition(":")[2])
        wire.send(write_frame(9, "1"))
        wire.until(b"\x06")
        with ModbusTcpClient("127.0.0.1", port=port, timeout=MAX_SECONDS) as client:
            # 1.0 is 0x3F800000, its low half first.
            assert client.read_holding_registers(18, count=2, device_id=17).registers == [0, 0x3F80]
            assert not client.write_registers(20, [0, 0x4000], device_id=17).isError()
        assert read(wire, 10) == 2.0


def test_output_of_a_program_that_no_host_reads_holds_up_no_one(tmp_path: Path) -> None:
    chatter = 'Loop\n  COMMS(3) = COMMS(3) + 1\n  Print "{}"\n  Wait = 1\nEnd Loop'.format("x" * 99)
    options = ("--tcp", "0", "--tcp", "0", "--factor", "100")
    with running(tmp_path, chatter, *options) as process, host(process), host(process) as wire:
        wire.send(b"\x05")
        wire.until(b"P>")
        wire.send(b"Print 1 + 1\r")
        assert wire.until(b"P>") == b"2\r\nP>"


def test_the_log_shows_frames_and_lines(tmp_path: Path) -> None:
    with running(tmp_path, PACKER, "--tcp", "0", "--log") as process, host(process) as wire:
        wire.until(b"ready\r\n")
        wire.send(write_frame(1, "0") + b"\x05")
        wire.until(b"P>")
        wire.send(b"Print 7\n")
        wire.until(b"7\r\nP>")
        process.send_signal(signal.SIGTERM)
        _, err = process.communicate(timeout=MAX_SECONDS)
    lines = err.splitlines()
    assert "1 < \\x0400\\x02010\\x032" in lines
    assert "1 > \\x06" in lines
    assert "1 < Print 7" in lines
    assert "1 > 7" in lines
