"""Serial parameter 0x115: all bits of the note's two tables, in both directions."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.lab.pvt.drive import serial
from motionlang.lab.pvt.drive.point import WirePoint
from motionlang.lab.pvt.drive.serial import BadWord
from tests.lab.pvt.drive.serial_port import CLEAR, POP, BufferCommand, decode

int32 = st.integers(-(2**31), 2**31 - 1)
wire_points = st.builds(WirePoint, int32, st.one_of(st.none(), int32), st.integers(0, 255), st.booleans())


@pytest.mark.parametrize(
    ("point", "message"),
    [
        (WirePoint(5000, 7_500_000, 10), (0x000A, 0x00001388, 0x007270E0)),
        (WirePoint(5000, None, 10), (0x000A, 0x00001388)),
        (WirePoint(-1, -1, 255), (0x00FF, 0xFFFFFFFF, 0xFFFFFFFF)),
        (WirePoint(20, 0, 1, relative=True), (0x1001, 0x00000014, 0x00000000)),
        (WirePoint(0, 0, 0), (0x0000, 0, 0)),
        # the note's example of the velocity unit: 1234 is 123.4 counts/s
        (WirePoint(0, 1234, 7), (0x0007, 0, 0x000004D2)),
    ],
)
def test_points_are_these_words(point: WirePoint, message: tuple[int, ...]) -> None:
    assert serial.encode_point(point) == message
    assert decode(message) == point


@pytest.mark.parametrize(
    ("command", "word"),
    [
        (BufferCommand(CLEAR), 0x8000),
        (BufferCommand(POP, 3), 0x8103),
        (BufferCommand(POP, 255), 0x81FF),
    ],
)
def test_commands_are_these_words(command: BufferCommand, word: int) -> None:
    assert decode((word,)) == command


@given(wire_points)
def test_every_point_survives_the_transfer(point: WirePoint) -> None:
    message = serial.encode_point(point)
    assert decode(message) == point


@pytest.mark.parametrize("bit", [8, 9, 10, 11, 13, 14])
def test_each_reserved_bit_of_a_point_is_refused(bit: int) -> None:
    with pytest.raises(BadWord, match=f"reserved bits {1 << bit:#06x}"):
        decode((1 << bit, 0, 0))


@pytest.mark.parametrize("bit", [9, 10, 11, 12, 13, 14])
def test_each_reserved_bit_of_a_command_is_refused(bit: int) -> None:
    with pytest.raises(BadWord, match=f"reserved bits {1 << bit:#06x}"):
        decode((0x8000 | 1 << bit,))


@pytest.mark.parametrize(
    ("message", "reason"),
    [
        ((), "needs at least"),
        ((0x000A,), "needs one or two 32-bit values after it, not 0"),
        ((0x000A, 1, 2, 3), "not 3"),
        ((0x8000, 0), "no data follows a buffer command"),
        ((0x1_0000, 0), "not a 16-bit word"),
        ((0x000A, 2**32), "not a 32-bit value"),
        ((0x000A, -1), "not a 32-bit value"),
    ],
)
def test_other_messages_are_refused(message: tuple[int, ...], reason: str) -> None:
    with pytest.raises(BadWord, match=reason):
        decode(message)


@pytest.mark.parametrize(
    ("point", "reason"),
    [
        (WirePoint(0, 0, 256), "256 ms does not fit bits 0-7"),
        (WirePoint(0, 0, -1), "does not fit bits 0-7"),
        (WirePoint(2**31, 0, 1), "does not fit 32 bits"),
        (WirePoint(0, -(2**31) - 1, 1), "does not fit 32 bits"),
    ],
)
def test_points_that_fit_no_field_are_refused(point: WirePoint, reason: str) -> None:
    with pytest.raises(BadWord, match=reason):
        serial.encode_point(point)
