"""CANopen objects without a bus: accepted and rejected values, and their effects."""

from __future__ import annotations

import pytest

from motionlang.lab.pvt.drive import packet
from motionlang.lab.pvt.drive.packet import Packet, PacketCommand
from motionlang.lab.pvt.drive.point import WirePoint
from motionlang_copley.drive import MOVING, Drive
from motionlang_copley.objects import BY_ADDRESS, OBJECTS, Abort, ObjectServer

VALUE_RANGE, DEVICE_STATE, READ_ONLY, WRITE_ONLY = 0x06090030, 0x08000022, 0x06010002, 0x06010001


@pytest.fixture
def server() -> ObjectServer:
    """A drive that is switched on, in interpolated position mode, sub-mode -3."""
    made = ObjectServer(Drive())
    for index, value in ((0x6060, 7), (0x60C0, -3), (0x6040, 6), (0x6040, 7), (0x6040, 15)):
        made.write(index, 0, value)
    return made


def send(server: ObjectServer, number: int, point: WirePoint) -> None:
    server.write_packet(packet.encode_packet(Packet(number, point)))


def added(server: ObjectServer) -> list[tuple[int, int | None, int]]:
    return [(e.position, e.velocity, e.microseconds) for e in server.drive.buffer.entries]


def test_bit_4_of_the_control_word_starts_and_ends(server: ObjectServer) -> None:
    send(server, 0, WirePoint(0, 0, 100))
    send(server, 1, WirePoint(500, 50_000, 100))
    send(server, 2, WirePoint(1000, 0, 0))
    assert server.read(0x6041, 0) == 0x0637
    server.write(0x6040, 0, 0x1F)
    assert server.drive.state == MOVING
    assert server.read(0x6041, 0) == 0x1237
    server.drive.run_until(50_000)
    server.write(0x6040, 0, 0x0F)
    assert "move aborted at 187.5: by the control word" in [what for _, what in server.drive.log]


@pytest.mark.parametrize("control", [0x00, 0x06, 0x07, 0x0B, 0x010F, 0x011F])
def test_what_takes_the_drive_out_of_the_move(server: ObjectServer, control: int) -> None:
    """Disable voltage, shutdown, disable operation, quick stop and halt do."""
    send(server, 0, WirePoint(0, 0, 255))
    send(server, 1, WirePoint(500, 50_000, 255))
    server.write(0x6040, 0, 0x1F)
    server.drive.run_until(100_000)
    server.write(0x6040, 0, control)
    assert server.drive.state != MOVING


def test_a_drive_that_is_disabled_in_mid_move_brakes_first(server: ObjectServer) -> None:
    """Bit 6 is disabled, bit 12 is in motion, and bit 10 is at the target."""
    send(server, 0, WirePoint(0, 0, 255))
    send(server, 1, WirePoint(500, 50_000, 255))
    server.write(0x6040, 0, 0x1F)
    server.drive.run_until(100_000)
    server.write(0x6040, 0, 0x00)
    assert server.read(0x6041, 0) == 0x1250
    server.drive.run_until(200_000)
    assert (server.read(0x6041, 0), server.read(0x603F, 0)) == (0x0650, 0)


def test_a_lost_segment_is_a_sequence_error_until_it_is_cleared(server: ObjectServer) -> None:
    send(server, 0, WirePoint(0, 0, 10))
    send(server, 2, WirePoint(2, 0, 10))
    send(server, 1, WirePoint(1, 0, 10))
    assert added(server) == [(0, 0, 10_000)]
    status = packet.decode_status(server.read(0x2012, 0))
    assert (status.errors, status.next_number) == (packet.SEQUENCE, 1)
    server.write_packet(packet.encode_command(PacketCommand(packet.CLEAR_ERRORS, packet.SEQUENCE)))
    send(server, 1, WirePoint(1, 0, 10))
    assert len(added(server)) == 2
    assert packet.decode_status(server.read(0x2012, 0)).errors == 0


def test_buffer_commands(server: ObjectServer) -> None:
    for n in range(5):
        send(server, n, WirePoint(n, 0, 10))
    server.write_packet(packet.encode_command(PacketCommand(packet.POP, 2)))
    assert [index for index, _, _ in added(server)] == [0, 1, 2]
    server.write_packet(packet.encode_command(PacketCommand(packet.CLEAR)))
    assert added(server) == []
    assert server.read(0x2013, 0) == 5
    server.write_packet(packet.encode_command(PacketCommand(packet.RESET_ID)))
    assert server.read(0x2013, 0) == 0


def test_free_count_and_status(server: ObjectServer) -> None:
    assert server.read(0x2011, 0) == 32
    assert server.read(0x2012, 0) == 0x8020_0000
    send(server, 0, WirePoint(0, 0, 10))
    assert server.read(0x2011, 0) == 31
    assert server.read(0x2012, 0) == 0x001F_0001


@pytest.mark.parametrize("entry", OBJECTS, ids=lambda o: f"{o.index:04X}-{o.sub}")
def test_every_object_keeps_its_access(server: ObjectServer, entry: object) -> None:
    index, sub = next(address for address, o in BY_ADDRESS.items() if o is entry)
    access = BY_ADDRESS[index, sub].access
    if "r" in access:
        assert isinstance(server.read(index, sub), int)
    else:
        with pytest.raises(Abort) as refused:
            server.read(index, sub)
        assert refused.value.code == WRITE_ONLY
    if "w" not in access:
        with pytest.raises(Abort) as refused:
            server.write(index, sub, 0)
        assert refused.value.code == READ_ONLY


def test_three_objects_are_records(server: ObjectServer) -> None:
    """They are the homing speeds, and the point and the fixed time of interpolation."""
    subs: dict[int, list[int]] = {}
    for each in OBJECTS:
        subs.setdefault(each.index, []).append(each.sub)
    assert {index: found for index, found in subs.items() if found != [0]} == {
        0x6099: [1, 2],
        0x60C1: [1, 2, 3],
        0x60C2: [1, 2],
    }
    assert server.read(0x6061, 0) == server.read(0x6060, 0) == 7
    assert server.read(0x606B, 0) == server.read(0x606C, 0) == 0


@pytest.mark.parametrize(("data", "code"), [(b"123", 0x06070010), (b"\x38" + bytes(7), VALUE_RANGE)])
def test_bad_packets_are_refused_with_their_code(server: ObjectServer, data: bytes, code: int) -> None:
    with pytest.raises(Abort) as refused:
        server.write_packet(data)
    assert refused.value.code == code
