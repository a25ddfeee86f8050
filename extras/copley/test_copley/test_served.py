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


@pytest.fixture
def bus() -> Iterator[Bus]:
    """Yield a bus; no frame may be dropped on it."""
    made = Bus()
    yield made
    made.close()
    assert made.complaints == []


def test_the_next_event_of_an_operational_drive_is_its_status(bus: Bus) -> None:
    """It is sent after 1 ms, and then every 100 ms.

    The other drive is pre-operational.
    """
    bus.send(0, 1, 1)
    bus.until(0.01)
    assert [node.next_time() for node in bus.server.nodes] == pytest.approx([0.101, inf])


def test_an_idle_server_is_on_time_after_a_day(bus: Bus) -> None:
    bus.time = 86_400.0
    bus.server.run_once()
    assert [node.now for node in bus.server.nodes] == [86_400.0] * 2


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
