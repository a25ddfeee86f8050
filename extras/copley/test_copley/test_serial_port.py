"""A PVT move over the serial line: the note's procedure, step by step."""

from __future__ import annotations

import pytest

from motionlang.lab.pvt.drive import serial
from motionlang.lab.pvt.drive.packet import OVERFLOW
from motionlang.lab.pvt.drive.point import WirePoint, from_wire, to_wire
from motionlang.lab.pvt.export import export
from motionlang.lab.pvt.fit import track_error
from motionlang.lab.pvt.points import plan_points
from motionlang.lab.pvt.scurve import scurve
from motionlang_copley.drive import IDLE, Drive
from tests.lab.pvt.drive.serial_port import PortRefused, SerialPort


def port() -> SerialPort:
    made = SerialPort(Drive())
    made.write(0xC8, [3])
    return made


def test_the_procedure_of_the_note() -> None:
    """Configure, write the exported points, start: the drive executes the S-curve."""
    line, points = port(), to_wire(scurve(1000.0, 0.1))
    for text in export(points, "serial").lines:
        if not text.startswith("#"):
            line.write(0x115, [int(word, 16) for word in text.split()])
    assert line.read(0x115) == (27, 0, 0)
    line.command(17)
    line.drive.run_until(500_000)
    assert line.drive.log == [(0.0, "move started at 0"), (0.4, "move ended at 1000")]


def test_a_master_that_polls_for_free_entries_keeps_the_buffer_fed() -> None:
    line = port()
    points = [WirePoint(n * n // 7, n * 90, 5) for n in range(500)] + [WirePoint(40_000, 0, 0)]
    waiting, started = list(points), False
    while waiting or line.drive.state != IDLE:
        free = line.read(0x115)[0]
        burst, waiting = waiting[:free], waiting[free:]
        for point in burst:
            line.write(0x115, serial.encode_point(point))
        if not started:
            line.command(17)
            started = True
        line.drive.run_until(line.drive.microseconds + 20_000)
    profile = plan_points(from_wire(points))
    drive = line.drive
    assert drive.buffer.errors == 0
    assert track_error([0.0], [profile], drive.starts, drive.profiles, 0.0, drive.now) < 1e-6


def test_buffer_commands() -> None:
    line = port()
    for n in range(5):
        line.write(0x115, serial.encode_point(WirePoint(n, None, 10)))
    line.write(0x115, (0x8102,))
    assert line.read(0x115)[0] == 29
    line.write(0x115, (0x8000,))
    assert line.read(0x115)[0] == 32


def test_a_full_buffer_overflows() -> None:
    line = port()
    for n in range(33):
        line.write(0x115, serial.encode_point(WirePoint(n, 0, 10)))
    assert line.drive.buffer.errors == OVERFLOW
    assert line.read(0x115)[0] == 0


def test_without_its_configuration_the_drive_does_not_start() -> None:
    line = SerialPort(Drive())
    assert line.read(0xC8) == (0,)
    line.write(0x115, serial.encode_point(WirePoint(0, 0, 0)))
    with pytest.raises(PortRefused, match="0xC8 must be 3"):
        line.command(17)
    line.write(0xC8, [3])
    assert line.read(0xC8) == (3,)
    line.command(17)


@pytest.mark.parametrize(
    ("parameter", "message", "reason"),
    [
        (0x115, [0x0100, 0], "reserved bits 0x0100"),
        (0x115, [], "needs at least"),
        (0xC8, [1], "is not simulated: 3 is PVT"),
        (0x24, [0], "parameter 0x24 is not simulated"),
    ],
)
def test_other_messages_are_refused(parameter: int, message: list[int], reason: str) -> None:
    with pytest.raises(PortRefused, match=reason):
        port().write(parameter, message)


def test_other_parameters_and_op_codes_are_refused() -> None:
    with pytest.raises(PortRefused, match="not simulated"):
        port().read(0x24)
    with pytest.raises(PortRefused, match="op-code 1 is not simulated"):
        port().command(1)
