"""The objects 0x2010 and 0x2012, byte by byte."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.lab.pvt.drive import packet
from motionlang.lab.pvt.drive.packet import BadPacket, BufferStatus, Packet, PacketCommand
from motionlang.lab.pvt.drive.point import WirePoint

int24 = st.integers(-(2**23), 2**23 - 1)
int32 = st.integers(-(2**31), 2**31 - 1)
bytes8 = st.binary(min_size=8, max_size=8)


@pytest.mark.parametrize(
    ("content", "data"),
    [
        (Packet(0, WirePoint(5000, 7_500_000, 10)), "000a881300e07072"),
        (Packet(1, WirePoint(-2, -1, 255)), "01fffeffffffffff"),
        (Packet(2, WirePoint(5000, 90_000_000, 10)), "0a0a881300a0bb0d"),
        (Packet(3, WirePoint(5, 0, 10, relative=True)), "130a050000000000"),
        (Packet(4, WirePoint(5, 90_000_000, 10, relative=True)), "1c0a050000a0bb0d"),
        (Packet(5, initial=0x12345678), "2578563412000000"),
        (Packet(5, initial=-2), "25feffffff000000"),
        (Packet(6, WirePoint(2**31 - 1, None, 10)), "2e0affffff7f0000"),
        (Packet(7, WirePoint(-3, None, 10, relative=True)), "370afdffffff0000"),
    ],
)
def test_segments_are_these_bytes(content: Packet, data: str) -> None:
    assert packet.encode_packet(content).hex() == data
    assert packet.decode(bytes.fromhex(data)) == content


@pytest.mark.parametrize(
    ("command", "data"),
    [
        (PacketCommand(packet.CLEAR), "8000000000000000"),
        (PacketCommand(packet.POP, 300), "812c010000000000"),
        (PacketCommand(packet.CLEAR_ERRORS, packet.SEQUENCE | packet.UNDERFLOW), "8205000000000000"),
        (PacketCommand(packet.RESET_ID), "8300000000000000"),
    ],
)
def test_commands_are_these_bytes(command: PacketCommand, data: str) -> None:
    assert packet.encode_command(command).hex() == data
    assert packet.decode(bytes.fromhex(data)) == command


@pytest.mark.parametrize(
    ("data", "content"),
    [
        ("812c01ffffffffff", PacketCommand(packet.POP, 300)),
        ("8205ffffffffffff", PacketCommand(packet.CLEAR_ERRORS, 5)),
        ("80ffffffffffffff", PacketCommand(packet.CLEAR)),
        ("2578563412ffffff", Packet(5, initial=0x12345678)),
        ("2e0affffff7fffff", Packet(6, WirePoint(2**31 - 1, None, 10))),
    ],
)
def test_unused_bytes_are_ignored(data: str, content: object) -> None:
    assert packet.decode(bytes.fromhex(data)) == content


@given(st.integers(0, 7), int24, int24, st.integers(0, 255), st.booleans())
def test_every_cubic_point_survives_the_transfer(
    number: int, position: int, velocity: int, time: int, relative: bool
) -> None:
    content = Packet(number, WirePoint(position, velocity, time, relative))
    assert packet.decode(packet.encode_packet(content)) == content


@given(bytes8)
def test_any_eight_bytes_are_understood_or_refused(data: bytes) -> None:
    try:
        content = packet.decode(data)
    except BadPacket:
        return
    if isinstance(content, Packet):
        assert packet.decode(packet.encode_packet(content)).number == content.number  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "8 bytes, not 0"),
        (bytes(9), "8 bytes, not 9"),
        (bytes([7 << 3]) + bytes(7), "no segment format 7"),
        (bytes([15 << 3]) + bytes(7), "no segment format 15"),
        (bytes([0x84]) + bytes(7), "no buffer command 4"),
        (bytes([0xFF]) + bytes(7), "no buffer command 127"),
    ],
)
def test_other_bytes_are_refused(data: bytes, reason: str) -> None:
    with pytest.raises(BadPacket, match=reason):
        packet.decode(data)


def test_numbers_run_on_modulo_eight() -> None:
    messages = packet.encode_points([WirePoint(0, 0, 1)] * 10, number=65_534)
    assert [message[0] & 7 for message in messages] == [6, 7, 0, 1, 2, 3, 4, 5, 6, 7]


def test_far_positions_go_as_an_initial_position_and_distances() -> None:
    points = [WirePoint(9_000_000, 0, 10), WirePoint(9_000_100, 500, 10), WirePoint(9_000_150, 0, 0)]
    contents = [packet.decode(message) for message in packet.encode_points(points)]
    assert contents == [
        Packet(0, initial=9_000_000),
        Packet(1, WirePoint(0, 0, 10, relative=True)),
        Packet(2, WirePoint(100, 500, 10, relative=True)),
        Packet(3, WirePoint(50, 0, 0, relative=True)),
    ]


def test_far_negative_positions_are_distances_from_24_bits_on() -> None:
    """-8 388 608 is the last position of 24 bits."""
    for position, packets in ((-(2**23), 1), (-(2**23) - 1, 2)):
        assert len(packet.encode_points([WirePoint(position, 0, 0)])) == packets


def test_a_distance_counts_from_the_position_that_a_relative_point_reaches() -> None:
    """From 9 000 100 to 9 000 300 it is 200 counts, from 8 999 900 it is 400."""
    for distance, left in ((100, 200), (-100, 400)):
        points = [
            WirePoint(9_000_000, 0, 10),
            WirePoint(distance, 0, 10, relative=True),
            WirePoint(9_000_300, 0, 0),
        ]
        *_, last = (packet.decode(message) for message in packet.encode_points(points))
        assert last == Packet(3, WirePoint(left, 0, 0, relative=True))


def test_a_distance_beyond_24_bits_is_named_by_its_point() -> None:
    points = [WirePoint(0, 0, 10), WirePoint(20_000_000, 0, 0)]
    with pytest.raises(BadPacket, match="point 1: neither its position nor its distance fits the 24 bits"):
        packet.encode_points(points)


def test_a_velocity_beyond_all_bits_is_refused() -> None:
    with pytest.raises(BadPacket, match="velocity"):
        packet.encode_packet(Packet(0, WirePoint(0, 2**31 - 1, 10)))


@pytest.mark.parametrize(
    ("status", "value"),
    [
        (BufferStatus(0, 32, 0, True), 0x8020_0000),
        (BufferStatus(0xABCD, 5, 0, False), 0x0005_ABCD),
        (BufferStatus(1, 0, packet.SEQUENCE, False), 0x0100_0001),
        (BufferStatus(1, 0, packet.OVERFLOW, False), 0x0200_0001),
        (BufferStatus(1, 32, packet.UNDERFLOW, True), 0x8420_0001),
    ],
)
def test_the_status_is_these_bits(status: BufferStatus, value: int) -> None:
    assert packet.encode_status(status) == value
    assert packet.decode_status(value) == status


def test_errors_in_words() -> None:
    assert packet.error_names(packet.SEQUENCE | packet.UNDERFLOW) == "sequence error, underflow"


@pytest.mark.parametrize("time", [-1, 256])
def test_a_time_that_does_not_fit_a_byte_is_refused(time: int) -> None:
    with pytest.raises(BadPacket, match=f"the time {time} ms does not fit a byte"):
        packet.encode_packet(Packet(0, WirePoint(0, 0, time)))
