"""Drives on a bus with third-party masters: canopen's BaseNode402, and raw frames."""

from __future__ import annotations

import json
import re
import shutil
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from math import inf
from pathlib import Path
from typing import Any

import can
import canopen
import pytest
from canopen.objectdictionary import ODVariable

from motionlang.kernel.planners import hold
from motionlang_copley.bus import BusError
from motionlang_copley.eds import eds
from motionlang_copley.server import DriveServer
from motionlang_copley.switches import Switches
from test_copley.bus import CHANNELS, Bus, dictionary

PATIENCE = 30.0
# Frames of drives, for interfaces that give a master its own frames back.
FROM_DRIVES: Any = [{"can_id": 0x080, "can_mask": 0x080}, {"can_id": 0x700, "can_mask": 0x780}]


def emergencies(frames: list[tuple[int, bytes]]) -> list[bytes]:
    """Return the codes of the EMCY messages of drive 1, low byte first."""
    return [data[:2] for can_id, data in frames if can_id == 0x81]


@pytest.fixture
def bus() -> Iterator[Bus]:
    """Yield a bus; no frame may be dropped on it."""
    made = Bus()
    yield made
    made.close()
    assert made.complaints == []


def test_boot_up_and_reset(bus: Bus) -> None:
    assert bus.frames() == [(0x701, b"\0"), (0x702, b"\0")]
    bus.send(0, 130, 2)
    assert bus.until(0.05) == [(0x702, b"\0")]


def test_the_heartbeat_has_its_period_and_the_state(bus: Bus) -> None:
    """Its period is 50 ms from the write on; 127 is pre-operational, 5 operational."""
    bus.until(0.01)
    bus.ask(1, 0x2B, 0x17, 0x10, 0, 50)
    assert bus.until(0.111) == [(0x701, b"\x7f")] * 2
    bus.send(0, 1, 1)
    assert (0x701, b"\5") in bus.until(0.161)


def test_the_objects_of_cia_301(bus: Bus) -> None:
    assert bus.ask(1, 0x40, 0x00, 0x10)[4:] == bytes([0x92, 0x01, 0x02, 0x00])
    assert bus.ask(1, 0x40, 0x01, 0x10)[4] == 0
    assert bus.ask(2, 0x40, 0x18, 0x10, 4)[4:] == bytes([2, 0, 0, 0])
    assert bus.ask(2, 0x40, 0x14, 0x10)[4:] == bytes([0x82, 0, 0, 0])
    assert bus.ask(1, 0x40, 0x02, 0x65)[4:] == bytes([0x65, 0, 0, 0])
    assert bus.ask(1, 0x40, 0xC2, 0x60, 2)[4] == 0xFD  # -3
    # 0x80 rejects: no such object 0x06020000, and a mode that is not simulated 0x06090030.
    assert bus.ask(1, 0x40, 0x99, 0x20) == bytes([0x80, 0x99, 0x20, 0, 0, 0, 0x02, 0x06])
    assert bus.ask(1, 0x2F, 0x60, 0x60, 0, 4) == bytes([0x80, 0x60, 0x60, 0, 0x30, 0, 0x09, 0x06])


def test_the_default_pdos_carry_the_control_and_the_status_word(bus: Bus) -> None:
    bus.until(0.01)
    bus.send(0, 1, 1)
    assert bus.until(0.02) == [(0x181, b"\x50\x06")]
    bus.send(0x201, 6, 0)
    assert bus.until(0.03) == [(0x181, b"\x31\x06")]
    assert bus.until(0.23) == [(0x181, b"\x31\x06")] * 2  # every 100 ms, for a master that listens late


def test_the_next_event_of_an_operational_drive_is_its_status(bus: Bus) -> None:
    """It is sent after 1 ms, and then every 100 ms.

    The other drive is pre-operational.
    """
    bus.send(0, 1, 1)
    bus.until(0.01)
    assert [node.next_time() for node in bus.server.nodes] == pytest.approx([0.101, inf])


def test_a_change_is_sent_in_the_next_millisecond(bus: Bus) -> None:
    """However many frames arrive, PDOs are sent once in a millisecond."""
    bus.send(0, 1, 1)
    bus.until(0.01)
    for bus.time in (0.0103, 0.0106, 0.0109):
        bus.send(0x201, 6, 0)
    assert bus.frames() == []
    assert bus.until(0.011) == [(0x181, b"\x31\x06")]


def test_pdos_wait_for_operational(bus: Bus) -> None:
    bus.send(0x201, 6, 0)
    assert bus.until(0.3)[2:] == []
    assert bus.ask(1, 0x40, 0x41, 0x60)[4:6] == b"\x50\x06"


def test_a_stopped_node_answers_nothing(bus: Bus) -> None:
    bus.send(0, 2, 1)
    bus.frames()
    bus.send(0x601, 0x40, 0x41, 0x60, 0, 0, 0, 0, 0)
    bus.send(0x201, 6, 0)
    assert bus.until(0.3) == []
    bus.send(0, 128, 1)
    assert bus.ask(1, 0x40, 0x41, 0x60)[4:6] == b"\x50\x06"


def test_a_pdo_that_is_too_short_is_an_emergency(bus: Bus) -> None:
    """The error is 8210; bits 0 and 4 of the error register are set."""
    bus.send(0, 1, 1)
    bus.frames()
    bus.send(0x201, 6)
    assert (0x81, b"\x10\x82\x11" + bytes(5)) in bus.frames()
    assert bus.ask(1, 0x40, 0x01, 0x10)[4] == 0x11


def test_a_master_that_dies_leaves_the_node_pre_operational(bus: Bus) -> None:
    """Its heartbeat shows state 5, and 127 after the error; without object 0x1029, CiA 301 has no other behaviour."""
    bus.send(0, 1, 1)
    bus.ask(1, 0x2B, 0x17, 0x10, 0, 50, 0)
    bus.ask(1, 0x23, 0x16, 0x10, 1, 100, 0, 0x7F, 0)
    bus.send(0x77F, 5)
    assert dict(bus.until(0.095))[0x701] == b"\x05"
    assert dict(bus.until(0.2))[0x701] == b"\x7f"


@pytest.mark.parametrize(
    ("request_", "answer"),
    [
        # A threshold of 0, or below the size of the name, does not allow a normal upload.
        ((0xA0, 0x08, 0x10, 0, 127, 0, 0, 0), "8008100001000405"),
        ((0xA4, 0x08, 0x10, 0, 127, 23, 0, 0), "8008100001000405"),
        ((0xA0, 0x08, 0x10, 0, 127, 24, 0, 0), "4108100018000000"),
        ((0xA0, 0x01, 0x10, 0, 127, 1, 0, 0), "4f01100000000000"),
        # The later steps of a block upload that was not begun.
        ((0xA3, 0, 0, 0, 0, 0, 0, 0), "8000000001000405"),
        ((0xA2, 5, 127, 0, 0, 0, 0, 0), "80057f0001000405"),
        # An object that the drive does not have.
        ((0xA0, 0xFF, 0x5F, 0, 127, 0, 0, 0), "80ff5f0000000206"),
    ],
)
def test_a_block_upload_becomes_a_normal_one_if_its_threshold_allows_it(
    request_: tuple[int, ...], answer: str, bus: Bus
) -> None:
    assert bus.ask(1, *request_).hex() == answer


def test_a_master_that_dies_trips_the_drive(bus: Bus) -> None:
    """Object 0x1016:1 requires a heartbeat of node 0x7F at least every 100 ms.

    The last one arrives at 0.39 s.
    """
    bus.send(0, 1, 1)
    bus.ask(1, 0x23, 0x16, 0x10, 1, 100, 0, 0x7F, 0)
    assert bus.until(0.3) != []
    bus.send(0x77F, 5)
    bus.until(0.39)
    bus.send(0x77F, 5)
    assert 0x81 not in dict(bus.until(0.4895))
    assert dict(bus.until(0.49))[0x81] == b"\x30\x81\x11" + bytes(5)
    assert bus.ask(1, 0x40, 0x41, 0x60)[4] & 0x4F == 0x08
    bus.send(0, 1, 1)
    bus.send(0x201, 0x80, 0)
    assert dict(bus.until(0.7))[0x81] == bytes(8)


def test_a_fault_reset_clears_the_error_of_a_homing(bus: Bus) -> None:
    """Method 0 is none. Bit 7 of the control word acknowledges the error."""
    bus.send(0, 1, 1)
    bus.ask(1, 0x2F, 0x60, 0x60, 0, 6)
    bus.ask(1, 0x2F, 0x98, 0x60, 0, 0)
    for word in (0x06, 0x07, 0x0F):
        bus.send(0x201, word, 0)
    assert 0x81 not in dict(bus.until(0.01))
    bus.send(0x201, 0x1F, 0)
    assert emergencies(bus.until(0.02)) == [b"\x02\xff"]
    assert bus.ask(1, 0x40, 0x01, 0x10)[4] & 1 == 1
    bus.send(0x201, 0x8F, 0)
    assert emergencies(bus.until(0.03)) == [b"\0\0"]
    assert (bus.ask(1, 0x40, 0x01, 0x10)[4], bus.ask(1, 0x40, 0x3F, 0x60)[4:6]) == (0, b"\0\0")
    assert bus.complaints.pop() == "drive 1: homing failed: 0x6098 is 0, which selects no method"


def test_the_error_of_a_limit_is_cleared_when_the_axis_leaves_it() -> None:
    """The axis moves to 5000, is stopped at 1000, and moves to 0."""
    bus = Bus(switches=[Switches(positive=1000.0)])
    bus.send(0, 1, 1)
    bus.ask(1, 0x2F, 0x60, 0x60, 0, 1)
    bus.ask(1, 0x23, 0x7A, 0x60, 0, *(5000).to_bytes(4, "little"))
    for word in (0x06, 0x07, 0x0F, 0x1F):
        bus.send(0x201, word, 0)
    assert emergencies(bus.until(1.0)) == [b"\x12\x86"]
    bus.send(0x201, 0x8F, 0)  # the cause is still there
    assert emergencies(bus.until(1.1)) == []
    assert bus.ask(1, 0x40, 0x01, 0x10)[4] & 1 == 1
    bus.ask(1, 0x23, 0x7A, 0x60)
    bus.send(0x201, 0x0F, 0)
    bus.send(0x201, 0x1F, 0)
    assert emergencies(bus.until(1.2)) == [b"\0\0"]
    assert (bus.ask(1, 0x40, 0x01, 0x10)[4], bus.ask(1, 0x40, 0x3F, 0x60)[4:6]) == (0, b"\0\0")
    bus.close()
    assert bus.complaints == ["drive 1: the positive limit switch has stopped the axis"]


def test_a_synchronous_pdo_shows_the_position_at_the_sync(bus: Bus) -> None:
    """PDO 3 has status word and position on every SYNC; the axis runs at 10 000/s."""
    bus.ask(1, 0x2F, 0x02, 0x18, 2, 1)
    bus.ask(1, 0x23, 0x02, 0x18, 1, 0x81, 0x03, 0, 0)
    bus.send(0, 1, 1)
    bus.ask(1, 0x2F, 0x60, 0x60, 0, 3)
    for control in (6, 7, 15):
        bus.send(0x201, control, 0)
    bus.ask(1, 0x23, 0xFF, 0x60, 0, *(100_000).to_bytes(4, "little"))
    positions = []
    for k in range(1, 4):
        bus.until(k * 0.1)
        bus.send(0x80)
        ((_, data),) = [each for each in bus.frames() if each[0] == 0x381]
        positions.append(int.from_bytes(data[2:], "little"))
    assert positions == [500, 1500, 2500]


@pytest.mark.parametrize("objects", [0, 1])
def test_a_pdo_without_objects_is_not_sent(objects: int, bus: Bus) -> None:
    """The status word is mapped to transmit PDO 1 or not, and PDO 2 is disabled."""
    bus.ask(1, 0x2F, 0x00, 0x1A, 0, objects)
    bus.send(0, 1, 1)
    assert bus.until(0.05) == [(0x181, b"\x50\x06")] * objects


def test_each_drive_has_its_switches() -> None:
    """Bit 0 of object 0x60FD is the negative limit switch, bit 1 the positive one.

    The second of two drives has no switches if there are those of one.
    """
    for switches, inputs in (
        ([Switches(negative=0.0)], [0b01, 0]),
        ([Switches(negative=0.0), Switches(positive=0.0)], [0b01, 0b10]),
    ):
        bus = Bus(switches=switches)
        assert [bus.ask(node, 0x40, 0xFD, 0x60)[4] for node in (1, 2)] == inputs
        bus.close()


def test_an_idle_server_is_on_time_after_a_day(bus: Bus) -> None:
    bus.time = 86_400.0
    bus.server.run_once()
    assert [node.now for node in bus.server.nodes] == [86_400.0] * 2


def test_machine_time_is_a_multiple_of_real_time() -> None:
    """At twice the speed, a heartbeat of 50 ms, set at 10 ms, arrives every 25 ms."""
    bus = Bus(factor=2.0)
    bus.until(0.01)
    bus.ask(1, 0x2B, 0x17, 0x10, 0, 50)
    assert [bus.until(time) for time in (0.034, 0.036, 0.059, 0.061)] == [[], [(0x701, b"\x7f")]] * 2
    bus.close()


def test_how_long_a_server_waits_for_a_frame(monkeypatch: pytest.MonkeyPatch) -> None:
    """It waits 100 ms or until the next event, and 1 ms after a frame or in motion.

    At twice the speed, the heartbeat of 50 ms is due 25 ms after its write.
    """
    bus, waits = Bus(factor=2.0), list[float]()
    receive = bus.server._bus.recv

    def spy(timeout: float) -> can.Message | None:
        waits.append(round(timeout, 6))
        bus.server.stop()
        return receive(0.0)

    def wait(time: float) -> float:
        """Let the server wait once at a time, and return how long it would wait."""
        bus.time = time
        bus.server.run()
        bus.server._over = False
        return waits[-1]

    monkeypatch.setattr(bus.server._bus, "recv", spy)
    assert wait(0.0) == 0.1
    period = [0x2B, 0x17, 0x10, 0, 50, 0, 0, 0]
    bus.master.send(can.Message(arbitration_id=0x601, data=period, is_extended_id=False))
    assert [wait(time) for time in (0.0, 0.0, 0.002, 0.03)] == [0.1, 0.001, 0.023, 0.0]
    drive = bus.server.nodes[1].drive
    drive.follow(hold(0.0), 1.0, drive.rest)
    assert wait(0.031) == 0.001
    bus.close()


def test_a_server_forgets_old_motion() -> None:
    """A drive stores its last 100 profiles; each 1000th wait deletes the others."""
    bus = Bus()
    drive = bus.server.nodes[1].drive
    for _ in range(200):
        drive.rest()
    lengths = set[int]()
    for _ in range(999):
        bus.server.run_once()
        lengths.add(len(drive.profiles))
    bus.server.run_once()
    assert (lengths, len(drive.profiles)) == ({201}, 100)
    bus.close()


def test_each_problem_is_reported_once_and_at_most_a_hundred(bus: Bus) -> None:
    def fail(text: str) -> None:
        raise can.CanError(text)

    for number in (1, 1, *range(1, 150)):
        bus.server._guard(lambda text=f"problem {number}": fail(text))  # type: ignore[misc]
    assert bus.complaints == [f"the CAN bus: problem {number}" for number in range(1, 101)]
    bus.complaints.clear()


def test_only_frames_of_masters_are_counted(bus: Bus) -> None:
    """Standard data frames count, of any identifier with bit 7 clear, and SYNC."""
    assert bus.server.frames == 0
    for can_id in (0x000, 0x201, 0x601, 0x77F, 0x080):
        bus.send(can_id, 0x40, 0x41, 0x60, *bytes(5))
    assert bus.server.frames == 5
    for can_id in (0x081, 0x181, 0x5FF):
        bus.send(can_id, 0, 0)
    bus.master.send(can.Message(arbitration_id=0x201, data=[6, 0], is_extended_id=True))
    bus.master.send(can.Message(arbitration_id=0x201, is_remote_frame=True, is_extended_id=False))
    bus.master.send(can.Message(arbitration_id=0x201, is_error_frame=True, is_extended_id=False))
    bus.until(0.05)
    assert bus.server.frames == 5


def test_a_reset_of_the_communication_keeps_the_motion_and_the_values(bus: Bus) -> None:
    """Command 130 restores the objects of communication alone, 129 all of them."""
    bus.ask(1, 0x2F, 0x60, 0x60, 0, 3)
    for control in (6, 7, 15):
        bus.ask(1, 0x2B, 0x40, 0x60, 0, control)
    bus.ask(1, 0x23, 0xFF, 0x60, 0, *(100_000).to_bytes(4, "little"))
    bus.ask(1, 0x2B, 0x17, 0x10, 0, 50)
    bus.send(0, 130, 1)
    frames = bus.until(0.5)
    assert frames.count((0x701, b"\0")) == 1
    assert (0x701, b"\x7f") not in frames
    assert bus.ask(1, 0x40, 0x17, 0x10)[4:6] == bytes(2)
    assert bus.ask(1, 0x40, 0x60, 0x60)[4] == 3
    assert int.from_bytes(bus.ask(1, 0x40, 0x6C, 0x60)[4:], "little") == 100_000
    bus.send(0, 129, 0)
    bus.until(1.0)
    assert bus.ask(1, 0x40, 0x60, 0x60)[4] == 0
    assert int.from_bytes(bus.ask(1, 0x40, 0x6C, 0x60)[4:], "little") == 0


def test_the_time_from_a_reset_to_the_boot_up_message(bus: Bus) -> None:
    """It is 20 ms; other nodes do not take part."""
    bus.until(0.01)
    bus.send(0, 129, 1)
    assert bus.until(0.0295) == []
    assert bus.until(0.03) == [(0x701, b"\0")]


def test_a_heartbeat_of_period_0_ends_it(bus: Bus) -> None:
    bus.ask(1, 0x2B, 0x17, 0x10, 0, 20)
    found = [bus.until(time) for time in (0.0195, 0.02, 0.0395, 0.04)]
    assert found == [[], [(0x701, b"\x7f")], [], [(0x701, b"\x7f")]]
    bus.ask(1, 0x2B, 0x17, 0x10, 0, 0)
    assert bus.until(0.5) == []


@pytest.mark.parametrize("value", [[0, 0, 0x7F, 0], [100, 0, 0, 0]], ids=["no time", "no node"])
def test_a_heartbeat_is_expected_only_of_a_node_within_a_time(value: list[int], bus: Bus) -> None:
    """Writing 0 for one of them ends the monitoring of node 7F."""
    bus.ask(1, 0x23, 0x16, 0x10, 1, 100, 0, 0x7F, 0)
    bus.send(0x77F, 5)
    bus.ask(1, 0x23, 0x16, 0x10, 1, *value)
    bus.send(0x77F, 5)
    bus.send(0x701, 5)
    assert 0x81 not in dict(bus.until(1.0))


def test_a_drive_expects_no_heartbeat_until_it_is_configured(bus: Bus) -> None:
    bus.send(0, 130, 0)
    bus.until(0.1)
    for node in (3, 0x7F, 1):
        bus.send(0x700 + node, 5)
    assert not {0x81, 0x82} & dict(bus.until(0.5)).keys()


def test_a_pdo_may_have_another_identifier(bus: Bus) -> None:
    """The first of each direction get 305 and 385 while they are off; 201 and 181 are no longer theirs."""
    for record, low in ((0x18, 0x85), (0x14, 0x05)):
        assert bus.ask(1, 0x23, 0x00, record, 1, low, 0x03, 0, 0)[4:] == (0x08000022).to_bytes(4, "little")
        assert bus.ask(1, 0x23, 0x00, record, 1, low, 0x03, 0, 0x80)[0] == 0x60
        assert bus.ask(1, 0x23, 0x00, record, 1, low, 0x03, 0, 0)[0] == 0x60
    bus.send(0, 1, 1)
    bus.send(0x201, 6, 0)
    assert bus.until(0.01) == [(0x385, b"\x50\x06")]
    bus.send(0x305, 6, 0)
    assert bus.until(0.02) == [(0x385, b"\x31\x06")]


def test_objects_of_the_communication_refuse_what_does_not_fit(bus: Bus) -> None:
    """The heartbeat time has 16 bits, and the identity is read only."""
    assert bus.ask(1, 0x2F, 0x17, 0x10, 0, 50)[4:] == (0x06070010).to_bytes(4, "little")
    assert bus.ask(1, 0x23, 0x18, 0x10, 4, 1, 0, 0, 0)[4:] == (0x06010002).to_bytes(4, "little")
    assert bus.ask(1, 0x2B, 0x60, 0x60, 0, 3, 0)[4:] == (0x06070010).to_bytes(4, "little")


@pytest.mark.parametrize(
    ("kind", "answer"),
    [(0xF1, 0x80), (0xFB, 0x80), (0xFC, 0x80), (0xFD, 0x80), (0xFE, 0x60), (1, 0x60), (0xF0, 0x60)],
)
def test_the_types_of_a_pdo(kind: int, answer: int, bus: Bus) -> None:
    """Types 241 to 251 are reserved, and a PDO is not sent on a remote frame (252 and 253)."""
    refused = bus.ask(1, 0x2F, 0x01, 0x18, 2, kind)
    assert refused[0] == answer
    if answer == 0x80:
        assert refused[4:] == (0x06090030).to_bytes(4, "little")
    assert bus.ask(1, 0x2F, 0x01, 0x14, 2, kind)[0] == answer
    assert [bus.ask(1, 0x2F, pdo, 0x18, 2, kind)[0] for pdo in (0, 3)] == [answer] * 2


def test_a_synchronous_pdo_acts_at_a_sync(bus: Bus) -> None:
    """PDO 2 has the control word and the mode of operation."""
    assert bus.ask(1, 0x2F, 0x60, 0x60, 0, 3)[0] == 0x60
    assert bus.ask(1, 0x2F, 0x01, 0x14, 2, 1)[0] == 0x60
    assert bus.ask(1, 0x23, 0x01, 0x14, 1, 0x01, 0x03, 0, 0)[0] == 0x60
    bus.send(0, 1, 1)
    bus.send(0x301, 0, 0, 1)
    assert bus.ask(1, 0x40, 0x60, 0x60, 0)[4] == 3
    bus.send(0x80)
    assert bus.ask(1, 0x40, 0x60, 0x60, 0)[4] == 1


@pytest.mark.parametrize(("index", "value"), [(0x6060, [3]), (0x6040, [6, 0]), (0x607A, [1, 2, 3, 4])])
def test_an_expedited_download_may_leave_out_the_size(index: int, value: list[int], bus: Bus) -> None:
    assert bus.ask(1, 0x22, index & 0xFF, index >> 8, 0, *value)[0] == 0x60


def test_the_inhibit_time_of_a_pdo_in_use_stays(bus: Bus) -> None:
    """A master may write the identifier that it has, as one does that downloads all parameters."""
    assert bus.ask(1, 0x23, 0x00, 0x18, 1, 0x81, 0x01, 0, 0)[0] == 0x60
    assert bus.ask(1, 0x2B, 0x00, 0x18, 3, 0x10, 0)[4:] == (0x08000022).to_bytes(4, "little")
    assert bus.ask(1, 0x2B, 0x01, 0x18, 3, 0x10, 0)[0] == 0x60


def test_a_frame_of_network_management_that_is_too_short() -> None:
    bus = Bus()
    bus.send(0, 1)
    bus.close()
    assert bus.complaints == ["a frame was dropped: network management needs 2 bytes, not 1"]


def test_eight_objects_of_a_byte_fit_a_pdo_and_five_of_sixteen_bits_do_not(bus: Bus) -> None:
    """A PDO has 64 bits, in at most eight objects."""
    for sub in range(1, 9):
        assert bus.ask(1, 0x23, 0x01, 0x1A, sub, 0x08, 0, 0x61, 0x60)[0] == 0x60
    assert bus.ask(1, 0x2F, 0x01, 0x1A, 0, 8)[0] == 0x60
    for sub in range(1, 6):
        assert bus.ask(1, 0x23, 0x02, 0x1A, sub, 0x10, 0, 0x41, 0x60)[0] == 0x60
    assert bus.ask(1, 0x2F, 0x02, 0x1A, 0, 4)[0] == 0x60
    assert bus.ask(1, 0x2F, 0x02, 0x1A, 0, 5)[4:] == (0x06040042).to_bytes(4, "little")


@pytest.mark.parametrize(
    ("mapping", "entry", "fits"),
    [
        (0x1A01, 0x1001_00_08, True),
        (0x1A01, 0x1001_00_10, False),
        (0x1601, 0x1001_00_08, False),
        (0x1A01, 0x6099_01_20, True),
        (0x1A01, 0x2010_00_40, False),
        (0x1601, 0x2010_00_40, True),
        (0x1601, 0x6064_00_20, False),
        (0x1601, 0, True),
        (0x1A01, 0x1017_00_10, False),
        (0x1600, 0x6064_00_20, False),
        (0x1603, 0x6064_00_20, False),
        (0x1A00, 0x2010_00_40, False),
        (0x1A03, 0x2010_00_40, False),
    ],
)
def test_what_a_pdo_may_carry(mapping: int, entry: int, fits: bool, bus: Bus) -> None:
    """An entry has index, sub-index and bits; 0 is no object."""
    answer = bus.ask(1, 0x23, mapping & 0xFF, mapping >> 8, 1, *entry.to_bytes(4, "little"))
    assert (answer[0] == 0x60) is fits
    if not fits:
        assert answer[4:] == (0x06040041).to_bytes(4, "little")


def test_the_error_register_can_be_sent(bus: Bus) -> None:
    """PDO 2 carries the register and the mode; the register is 1 after any error."""
    bus.ask(1, 0x23, 0x01, 0x1A, 1, 0x08, 0, 0x01, 0x10)
    bus.ask(1, 0x23, 0x01, 0x18, 1, 0x81, 0x02, 0, 0)
    bus.send(0, 1, 1)
    assert dict(bus.until(0.01))[0x281] == b"\0\0"
    bus.ask(1, 0x2F, 0x60, 0x60, 0, 6)
    for control in (6, 7, 15, 31):
        bus.ask(1, 0x2B, 0x40, 0x60, 0, control)
    frames = dict(bus.until(0.02))
    assert frames[0x281] == b"\1\6"
    bus.complaints.clear()


def test_frames_without_sense_change_nothing(bus: Bus) -> None:
    bus.send(0)
    bus.send(0, 1)
    bus.send(0x601, 0xFF)
    bus.send(0x601)
    bus.master.send(can.Message(arbitration_id=0x201, data=[6, 0], is_extended_id=True))
    bus.master.send(can.Message(arbitration_id=0x201, is_remote_frame=True, is_extended_id=False))
    bus.until(0.05)
    assert bus.ask(1, 0x40, 0x41, 0x60)[4:6] == b"\x50\x06"
    assert bus.complaints != []
    assert all(text.startswith("a frame was dropped: ") for text in bus.complaints)
    bus.complaints.clear()


# ---------------------------------------------------------------------------------------------------- BaseNode402


ISOLATED = 'ip link set lo up && ip route add 239.0.0.0/8 dev lo && exec "$@"'


def is_isolated() -> bool:
    """True in a network namespace whose only routes are those of loopback."""
    routes = Path("/proc/net/route")
    lines = routes.read_text(encoding="ascii").splitlines()[1:] if routes.exists() else []
    return {line.split()[0] for line in lines} == {"lo"}


@pytest.mark.slow
def test_masters_on_udp_multicast() -> None:
    """Run the tests of this file on `udp_multicast` in a network namespace of their own."""
    isolated = ["unshare", "-rn", "sh", "-c", ISOLATED, "sh"]
    if shutil.which("unshare") is None or subprocess.call([*isolated, "true"], stderr=subprocess.DEVNULL):
        pytest.skip("no network namespaces here")
    tests = [sys.executable, "-m", "pytest", "-q", "-p", "no:xdist", "-p", "no:cacheprovider", "--slow"]
    command = [*isolated, *tests, "-k", "udp_multicast]", __file__]
    ran = subprocess.run(command, check=False, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert re.match(r"\.+ ", ran.stdout), ran.stdout  # none is skipped


def channel_of(interface: str, monkeypatch: pytest.MonkeyPatch) -> str:
    """Return a channel of the interface that no other test uses; skip one on a network that others share."""
    if interface == "virtual":
        return f"served-{next(CHANNELS)}"
    pytest.importorskip("msgpack")
    if not is_isolated():
        pytest.skip("udp_multicast needs a network namespace whose one route is loopback")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("", 0))
        monkeypatch.setenv("CAN_CONFIG", json.dumps({"port": free.getsockname()[1]}))
    return "239.74.163.2"


@pytest.fixture(params=["virtual", "udp_multicast"])
def node(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Any]:
    """A third-party master of drive 1, with the EDS file; the drive is enabled."""
    interface, channel = request.param, channel_of(request.param, monkeypatch)
    machine = [Switches(negative=-2000.0, positive=1e6, home=800.0, index=300.0)]
    try:
        server = DriveServer(interface, channel, 2, switches=machine)
    except BusError as error:
        pytest.skip(f"no multicast here: {error}")
    thread = threading.Thread(target=server.run, daemon=True)
    network = canopen.Network()
    network.connect(interface=interface, channel=channel, can_filters=FROM_DRIVES)
    path = tmp_path / "drive.eds"
    path.write_text(eds())
    made: Any = canopen.BaseNode402(1, str(path))  # type: ignore[no-untyped-call]
    made.sdo.RESPONSE_TIMEOUT = PATIENCE
    network.add_node(made)
    thread.start()
    try:
        made.nmt.state = "RESET COMMUNICATION"
        made.nmt.wait_for_bootup(PATIENCE)
        made.setup_402_state_machine()
        made.nmt.state = "OPERATIONAL"
        made.TIMEOUT_SWITCH_STATE_FINAL = made.TIMEOUT_SWITCH_STATE_SINGLE = made.TIMEOUT_SWITCH_OP_MODE = (
            PATIENCE
        )
        made.state = "OPERATION ENABLED"
        yield made
    finally:
        network.disconnect()
        server.stop()
        thread.join(PATIENCE)
        server.close()


def wait(condition: Callable[[], bool]) -> None:
    """Poll the drive until a condition is true; each poll is answered."""
    while not condition():
        pass


def status(node: Any, bit: int) -> Callable[[], bool]:
    return lambda: bool(node.sdo[0x6041].raw & bit)


@pytest.mark.slow
def test_a_foreign_master_does_profile_position(node: Any) -> None:
    node.op_mode = "PROFILED POSITION"
    assert node.op_mode == "PROFILED POSITION"
    for target in (3000, -1000):
        node.sdo[0x607A].raw = target
        node.controlword = 0x1F
        wait(status(node, 0x1000))
        node.controlword = 0x0F
        wait(status(node, 0x0400))
        assert node.sdo[0x6064].raw == target


@pytest.mark.parametrize("interface", ["virtual", "udp_multicast"])
def test_the_program_of_the_page(
    interface: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The program of docs/hosts-can.md; a master on udp_multicast gets its own frames back."""
    page = (Path(__file__).parents[1] / "docs" / "hosts-can.md").read_text(encoding="utf-8")
    program = page.split("```py\n")[1].split("```")[0]
    channel, file = channel_of(interface, monkeypatch), tmp_path / "drive.eds"
    for shown, used in (("socketcan", interface), ("vcan0", channel), ("drive.eds", str(file))):
        assert program.count(shown) == 1
        program = program.replace(shown, used)
    file.write_text(eds())
    try:
        server = DriveServer(interface, channel, 2)
    except BusError as error:
        pytest.skip(f"no multicast here: {error}")
    thread = threading.Thread(target=server.run, daemon=True)
    thread.start()
    names: dict[str, Any] = {}
    try:
        exec(program, names)
    finally:
        names["network"].disconnect()
        server.stop()
        thread.join(PATIENCE)
        server.close()
    assert capsys.readouterr().out == "5000\n"


def test_a_foreign_master_does_profile_velocity(node: Any) -> None:
    node.op_mode = "PROFILED VELOCITY"
    node.sdo[0x60FF].raw = 20_000
    wait(status(node, 0x0400))
    assert node.sdo[0x606C].raw == 20_000
    first = node.sdo[0x6064].raw
    wait(lambda: node.sdo[0x6064].raw > first + 100)
    node.sdo[0x60FF].raw = 0
    wait(status(node, 0x1000))
    assert node.sdo[0x606C].raw == 0


def test_a_foreign_master_homes(node: Any) -> None:
    node.sdo[0x6098].raw = 19
    assert node.homing(timeout=PATIENCE, restore_op_mode=False)
    assert node.sdo[0x6064].raw == 0
    assert node.is_homed()


def test_a_foreign_master_homes_again_after_a_failure(node: Any) -> None:
    """Method 0 is none; the master leaves bit 4 of the control word set."""
    node.sdo[0x6098].raw = 0
    assert not node.homing(timeout=PATIENCE)
    assert [error.code for error in node.emcy.log] == [0xFF02]
    node.sdo[0x6098].raw = 35
    assert node.homing(timeout=PATIENCE)


def test_a_foreign_master_interpolates(node: Any) -> None:
    """In sub-mode -2 it reaches 500 and 1000 counts, after 50 ms each."""
    node.op_mode = "INTERPOLATED POSITION"
    node.sdo[0x60C0].raw = -2
    for position, milliseconds in ((0, 50), (500, 50), (1000, 0)):
        node.sdo[0x60C1][1].raw = position
        node.sdo[0x60C1][2].raw = milliseconds
    node.controlword = 0x1F
    wait(lambda: node.sdo[0x6064].raw == 1000)


def test_what_the_drive_does_not_do_is_refused(node: Any) -> None:
    with pytest.raises(TypeError, match="VELOCITY not suppported"):
        node.op_mode = "VELOCITY"
    with pytest.raises(canopen.SdoAbortedError) as refused:
        node.sdo[0x6060].raw = 8
    assert refused.value.code == 0x06090030


def test_the_eds_has_what_the_drive_has(node: Any) -> None:
    """Each readable object in the file has the size of the drive's answer."""
    for entry in node.object_dictionary.values():
        is_variable = isinstance(entry, canopen.objectdictionary.ODVariable)
        for variable in [entry] if is_variable else list(entry.values()):
            if variable.readable and variable.data_type in canopen.objectdictionary.NUMBER_TYPES:
                assert 8 * len(node.sdo.upload(variable.index, variable.subindex)) == len(variable)
    assert node.object_dictionary[0x1800][1].default == 0x181
    assert eds() == eds()


# The entries of a mapping: index, sub-index and bits, as CiA 402 gives them for PDO 1 to 4.
DEFAULT_MAPPINGS = {
    0x1600: [0x6040_00_10],
    0x1601: [0x6040_00_10, 0x6060_00_08],
    0x1602: [0x6040_00_10, 0x607A_00_20],
    0x1603: [0x6040_00_10, 0x60FF_00_20],
    0x1A00: [0x6041_00_10],
    0x1A01: [0x6041_00_10, 0x6061_00_08],
    0x1A02: [0x6041_00_10, 0x6064_00_20],
    0x1A03: [0x6041_00_10, 0x606C_00_20],
}


def number(bus: Bus, index: int, sub: int) -> int:
    """Return the value of an object of drive 2, read by SDO."""
    answer = bus.ask(2, 0x40, index & 0xFF, index >> 8, sub)
    assert answer[0] & 0xE0 == 0x40
    return int.from_bytes(answer[4:], "little")


@pytest.mark.parametrize("index", DEFAULT_MAPPINGS, ids=hex)
def test_the_default_mapping_is_that_of_the_profile(index: int, bus: Bus) -> None:
    entries = DEFAULT_MAPPINGS[index]
    assert number(bus, index, 0) == len(entries)
    assert [number(bus, index, sub) for sub in range(1, 9)] == entries + [0] * (8 - len(entries))


def test_the_identity_has_the_node_as_its_serial_number(bus: Bus) -> None:
    assert [number(bus, 0x1018, sub) for sub in range(5)] == [4, 0, 0, 0x10000, 2]


def test_a_mapping_of_more_than_eight_objects_is_too_long(bus: Bus) -> None:
    too_long = (0x06040042).to_bytes(4, "little")
    for objects in (9, 64, 255):
        assert bus.ask(1, 0x2F, 0x01, 0x16, 0, objects)[4:] == too_long


def test_a_pdo_that_stays_as_it_was_is_not_sent_again(bus: Bus) -> None:
    """PDO 1 is sent when the drive becomes operational, and when its status changes."""
    bus.send(0, 1, 1)
    assert 0x181 in dict(bus.until(0.05))
    bus.ask(1, 0x2F, 0x01, 0x18, 2, 255)  # the transmission type of PDO 2
    assert 0x181 not in dict(bus.until(0.06))


def entries(index: int) -> list[tuple[int, str, int]]:
    """Return sub-index, access and default of the entries of an object of node 5."""
    record = dictionary(5)[index]
    assert isinstance(record, canopen.objectdictionary.ODRecord)
    return [(sub, each.access_type, each.default) for sub, each in sorted(record.subindices.items())]


def test_an_object_that_is_no_record_has_sub_index_0() -> None:
    variables = [each for each in dictionary(5).values() if isinstance(each, ODVariable)]
    assert {each.index for each in variables} > {0x1000, 0x1001, 0x1005, 0x1017, 0x6040, 0x60FF}
    assert {each.subindex for each in variables} == {0}


@pytest.mark.parametrize(("number", "switch"), [(0, 0), (1, 1 << 31), (3, 1 << 31)])
def test_only_the_first_pdo_of_each_direction_is_on(number: int, switch: int) -> None:
    """The identifiers are 0x200 and 0x180 plus the node, and 0x100 more for each PDO.

    Bit 31 disables a PDO. A transmit PDO also has an inhibit time and an event timer.
    """
    can_id = 0x100 * number + 5
    assert entries(0x1400 + number) == [(0, "ro", 2), (1, "rw", switch | 0x200 + can_id), (2, "rw", 255)]
    *first, (sub, access, timer) = entries(0x1800 + number)
    assert first == [(0, "ro", 5), (1, "rw", switch | 0x180 + can_id), (2, "rw", 255), (3, "rw", 0)]
    assert (sub, access, timer > 0) == (5, "rw", number == 0)


@pytest.mark.parametrize("index", DEFAULT_MAPPINGS, ids=hex)
def test_a_mapping_has_eight_entries_that_may_be_written(index: int) -> None:
    assert [(sub, access) for sub, access, _ in entries(index)] == [(sub, "rw") for sub in range(9)]
