"""A master streams to a simulated drive through a CANopen stack, in lockstep."""

from __future__ import annotations

import contextlib
import io
import json
import math
import random
import threading
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import can
import canopen
import pytest

from motionlang.cli import main
from motionlang.kernel.planners.pvt.velocities import smooth_velocities
from motionlang.lab.pvt.drive import packet
from motionlang.lab.pvt.drive.point import WirePoint, from_wire, to_wire
from motionlang.lab.pvt.fit import track_error
from motionlang.lab.pvt.points import Point, plan_points, points_from
from motionlang_copley.bus import NEWS_TIMEOUT, LockstepBus, RealBus
from motionlang_copley.drive import IDLE, Drive
from motionlang_copley.master import BusMaster, StreamError
from motionlang_copley.node import DriveNode
from tests.counted_calls import count_calls

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence


SCRIPTS = Path(__file__).parents[3] / "scripts"


def winding(count: int, milliseconds: int = 2) -> list[WirePoint]:
    """Return a move with many reversals: a product of sines in whole counts."""
    positions = [float(round(20_000 * math.sin(0.01 * i) * math.cos(0.0013 * i))) for i in range(count)]
    velocities = smooth_velocities(positions, milliseconds / 1000)
    return to_wire(points_from(positions, velocities, milliseconds / 1000))


def departure(drive: Drive, points: Sequence[Point]) -> float:
    """Return the largest deviation of the drive's motion from the points, counts."""
    begin = next(time for time, what in drive.log if what.startswith("move started"))
    return track_error([begin], [plan_points(points)], drive.starts, drive.profiles, begin, drive.now)


def test_two_thousand_points_by_pdo() -> None:
    """The start takes two of the 32 points in the buffer, then each segment takes one."""
    points, drive = winding(2_000), Drive()
    with LockstepBus(drive) as bus:
        done = BusMaster(bus).stream(points)
    assert (done.sent, done.resent) == (2_000, 0)
    assert done.lowest == 30
    assert departure(drive, from_wire(points)) < 1e-6
    assert drive.log == [(0.0, "move started at 0"), (3.998, f"move ended at {points[-1].position}")]
    assert drive.buffer.errors == 0


@pytest.mark.parametrize("transfer", ["sdo", "-3"])
def test_cubic_moves_by_sdo(transfer: str) -> None:
    points, drive = winding(300), Drive()
    with LockstepBus(drive) as bus:
        BusMaster(bus).stream(points, transfer)
    assert departure(drive, from_wire(points)) < 1e-6


@pytest.mark.parametrize("transfer", ["-1", "-2"])
def test_linear_moves(transfer: str) -> None:
    points, drive = winding(300), Drive()
    with LockstepBus(drive) as bus:
        BusMaster(bus).stream(points, transfer)
    assert departure(drive, [Point(p.position, None, p.time / 1000) for p in points]) < 1e-6
    assert drive.position == points[-1].position
    assert drive.state == IDLE


def test_a_master_at_its_own_pace_in_sub_mode_0() -> None:
    """A position every 10.1 ms for segments of 10 ms: the drive stretches its times."""
    points, drive = winding(300, 10), Drive()
    with LockstepBus(drive, step=10_100) as bus:
        BusMaster(bus).stream(points, "0")
    assert drive.buffer.errors == 0
    assert drive.position == points[-1].position
    spans = {round(p.duration * 1e6) for p in drive.profiles if p.shape == "pvt"}
    assert spans == {10_000, 10_250}


@pytest.mark.parametrize("transfer", ["0", "-1"])
@pytest.mark.parametrize("positions", [(0, 100, 0), (0, 10, 40, 10, 0, -30, 0), (5, 5, 5)])
def test_a_move_that_ends_where_it_began_is_made_to_its_end(
    transfer: str, positions: tuple[int, ...]
) -> None:
    """In the sub-modes that do not signal the end, the master polls the progress."""
    points = [WirePoint(position, None, 10) for position in positions[:-1]] + [
        WirePoint(positions[-1], None, 0)
    ]
    drive = Drive(positions[0])
    with LockstepBus(drive, step=10_000) as bus:
        BusMaster(bus).stream(points, transfer)
    made = [p for p in drive.profiles if p.shape == "pvt"]
    assert [p.end for p in made[: len(positions) - 1]] == [float(position) for position in positions[1:]]
    assert drive.position == positions[-1]
    assert drive.state == IDLE


def test_relative_linear_and_cubic_points_in_one_stream() -> None:
    chance = random.Random(5)
    points = [
        WirePoint(chance.randint(-300, 300), chance.choice([None, chance.randint(-9000, 9000)]), 20, True)
        for _ in range(100)
    ]
    points.append(WirePoint(0, 0, 0))
    drive = Drive()
    with LockstepBus(drive) as bus:
        BusMaster(bus).stream(points)
    assert departure(drive, from_wire(points)) < 1e-6


def test_positions_beyond_24_bits() -> None:
    points = [WirePoint(p.position + 50_000_000, p.velocity, p.time) for p in winding(100)]
    drive = Drive(50_000_000.0)
    with LockstepBus(drive) as bus:
        BusMaster(bus).stream(points)
    assert departure(drive, from_wire(points)) < 1e-6


@pytest.mark.parametrize("lost", [{3}, {40}, {40, 41, 47}, {99}, set(range(60, 70))])
def test_lost_frames_are_sent_again(lost: set[int]) -> None:
    """By its running number a missing segment is detected, and sent again."""
    points, drive = winding(100), Drive()
    with LockstepBus(drive) as bus:
        send, count = bus.network.send_message, [0]

        def forget_some(can_id: int, data: bytes, remote: bool = False) -> None:
            if can_id == 0x201:
                count[0] += 1
                if count[0] - 1 in lost:
                    return
            send(can_id, data, remote)

        bus.network.send_message = forget_some  # type: ignore[method-assign]
        done = BusMaster(bus).stream(points)
    assert done.resent >= 1
    assert departure(drive, from_wire(points)) < 1e-6


def test_a_master_that_polls_too_rarely_lets_the_buffer_run_dry() -> None:
    points, drive = winding(300), Drive()
    with LockstepBus(drive, step=100_000) as bus, pytest.raises(StreamError, match="underflow"):
        BusMaster(bus).stream(points)
    assert any("underflow" in what for _, what in drive.log)


def test_a_drive_with_old_points_and_errors_is_cleared_first() -> None:
    points, drive = winding(50), Drive()
    for n in range(32):
        drive.add(WirePoint(n, 0, 9))
    drive.add(WirePoint(0, 0, 9))
    with LockstepBus(drive) as bus:
        BusMaster(bus).stream(points)
    assert departure(drive, from_wire(points)) < 1e-6


@pytest.mark.parametrize(
    ("transfer", "control"),
    [
        ("pdo", [0x06, 0x07, 0x0F, 0x1F]),
        ("sdo", [0x06, 0x07, 0x0F, 0x1F]),
        ("-2", [0x06, 0x07, 0x0F, 0x1F]),
        ("-1", [0x06, 0x07, 0x0F, 0x1F, 0x0F]),
        ("0", [0x06, 0x07, 0x0F, 0x1F, 0x0F]),
    ],
)
def test_the_control_words_of_a_stream(transfer: str, control: list[int]) -> None:
    """Switch on and start once; sub-modes 0 and -1 end with bit 4 cleared."""
    points, drive = winding(100), Drive()
    with LockstepBus(drive, step=2000) as bus:
        send, found = bus.network.send_message, list[int]()

        def spy(can_id: int, data: bytes, remote: bool = False) -> None:
            if can_id == 0x601 and bytes(data[:4]) == b"\x2b\x40\x60\0":
                found.append(int.from_bytes(data[4:6], "little"))
            send(can_id, data, remote)

        bus.network.send_message = spy  # type: ignore[method-assign]
        BusMaster(bus).stream(points, transfer)
    assert found == control


@pytest.mark.parametrize(
    ("transfer", "sent", "reads"),
    [("pdo", 100, 3), ("sdo", 100, 3), ("-3", 100, 2), ("-2", 100, 2), ("-1", 134, 2)],
)
def test_the_figures_of_a_stream(
    transfer: str, sent: int, reads: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of 32 points the start takes 2, and the first wait, of five segments, 5.

    Sub-mode -1 repeats the last position until 101 points have left the buffer. After 20 waits these are
    2 + 20 × 5 = 102, and 32 more are in the buffer. The master reads the status twice at the beginning. At the end of a
    stream of packets it reads it again, to see if the last one has arrived.
    """
    points, drive, counted = winding(100), Drive(), count_calls(monkeypatch, (BusMaster, "refresh"))
    with LockstepBus(drive, step=10_000) as bus:
        done = BusMaster(bus).stream(points, transfer)
    assert (done.sent, done.resent, done.lowest, counted.calls) == (sent, 0, 25, reads)


@pytest.mark.parametrize("transfer", ["pdo", "-3", "-1"])
@pytest.mark.parametrize(("count", "lowest"), [(32, 32), (33, 30)])
def test_a_buffer_is_low_only_while_points_are_left(transfer: str, count: int, lowest: int) -> None:
    """The drive has room for 32 points; the start takes two of them."""
    with LockstepBus(Drive()) as bus:
        assert BusMaster(bus).stream(winding(count), transfer).lowest == lowest


@pytest.mark.parametrize("node", [1, 5])
def test_the_first_pdos_carry_points_and_the_status(node: int) -> None:
    """They have 0x2010 of 64 bits, and 0x2012 of 32 bits; type 255 is event-driven."""
    with LockstepBus(Drive(), node) as bus:
        master = BusMaster(bus, node)
        master.prepare()
        found = [
            [master.node.sdo[communication][1].raw, master.node.sdo[communication][2].raw]
            + [master.node.sdo[communication + 0x200][sub].raw for sub in (0, 1)]
            for communication in (0x1400, 0x1800)
        ]
    assert found == [[0x200 + node, 255, 1, 0x20100040], [0x180 + node, 255, 1, 0x20120020]]


def test_a_frame_is_delivered_after_those_before_it() -> None:
    """A frame that is sent while another one is delivered does not overtake a third."""
    log: list[str] = []
    with LockstepBus(Drive(), channel="order") as bus, can.Bus(interface="virtual", channel="order") as other:

        def answer(can_id: int, data: bytearray, _: float) -> None:
            log.append(f"{data[0]} begins")
            bus.network.send_message(0x7FF, b"")
            log.append(f"{data[0]} ends")

        bus.network.subscribe(0x3FF, answer)
        for number in (1, 2):
            other.send(can.Message(arbitration_id=0x3FF, data=[number], is_extended_id=False))
        bus.deliver()
    assert log == ["1 begins", "1 ends", "2 begins", "2 ends"]


@pytest.mark.parametrize(("interface", "patience"), [("virtual", 0.0), ("socketcan", 0.01)])
def test_a_kernel_gets_10_ms_to_return_a_frame(
    interface: str, patience: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    waits: list[float] = []

    class Kernel:
        """A bus without frames."""

        def recv(self, timeout: float) -> None:
            waits.append(timeout)

        def shutdown(self) -> None:
            pass

    monkeypatch.setattr("motionlang_copley.bus.open_bus", lambda interface, channel: Kernel())
    with LockstepBus(Drive(), interface=interface) as bus:
        bus.deliver()
    assert waits == [patience] * 2


@pytest.mark.parametrize("transfer", ["pdo", "-2", "-1"])
@pytest.mark.parametrize("begun", [0, 20])
def test_a_drive_whose_time_stands_still_ends_the_stream(
    transfer: str, begun: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With a patience of 10 waits without a status, the master gives up at the 11th.

    In the 20 waits before these, each of a segment of 2 ms, the drive sends its status.
    """
    waits = []
    with LockstepBus(Drive(), step=2000) as bus:
        pass_time = bus.wait

        def wait() -> None:
            waits.append(bus.frames)
            if len(waits) <= begun:
                pass_time()

        monkeypatch.setattr(bus, "patience", 10)
        monkeypatch.setattr(bus, "wait", wait)
        with pytest.raises(StreamError, match="the drive does not take points any more"):
            BusMaster(bus).stream(winding(99), transfer)
    assert len(waits) == begun + 11


def test_a_real_bus_waits_until_the_drive_sends_its_status() -> None:
    """The status of node 1 has the identifier 181; other frames do not end the wait."""
    with RealBus(1, "virtual", "status") as bus, can.Bus(interface="virtual", channel="status") as drive:
        others, arrived = threading.Event(), list[bool]()
        bus.network.subscribe(0x183, lambda *_: others.set())
        for can_id in (0x180, 0x182, 0x183):
            drive.send(can.Message(arbitration_id=can_id, is_extended_id=False))
        others.wait(30.0)
        arrived.append(bus._news.is_set())
        drive.send(can.Message(arbitration_id=0x181, is_extended_id=False))
        bus._news.wait(30.0)
        arrived.append(bus._news.is_set())
        bus.wait()
        arrived.append(bus._news.is_set())
    assert arrived == [False, True, False]


def test_a_master_waits_five_seconds_for_a_status() -> None:
    """A wait takes 50 ms of real time, or 1 ms of virtual time."""
    with LockstepBus(Drive()) as bus:
        assert bus.patience * bus.step == 5_000_000
    assert RealBus.patience * NEWS_TIMEOUT == 5.0


def test_the_master_of_a_real_bus_polls_every_50_ms(monkeypatch: pytest.MonkeyPatch) -> None:
    waits: list[float] = []
    with RealBus(1, "virtual", "idle") as bus:
        monkeypatch.setattr(bus, "_news", SimpleNamespace(wait=waits.append, clear=lambda: None))
        bus.wait()
        assert (waits, bus.network.NOTIFIER_CYCLE) == ([0.05], 0.05)


def test_a_second_move_follows_the_first() -> None:
    points, drive = winding(40), Drive()
    back = [WirePoint(p.position, -p.velocity if p.velocity else 0, 2) for p in reversed(points[:-1])]
    back[-1] = WirePoint(0, 0, 0)
    with LockstepBus(drive) as bus:
        master = BusMaster(bus)
        master.stream(points)
        master.stream([WirePoint(points[-1].position, 0, 2), *back])
    assert drive.position == 0.0


@pytest.mark.parametrize(
    ("points", "transfer", "message"),
    [
        ([WirePoint(0, 0, 10), WirePoint(1, 0, 20), WirePoint(2, 0, 0)], "-1", "need one time for all"),
        ([WirePoint(0, None, 10), WirePoint(1, 0, 0)], "-3", "a linear point needs 0x2010"),
        ([WirePoint(0, 0, 10, True), WirePoint(1, 0, 0)], "-2", "has no relative points"),
        ([WirePoint(0, 0, 10), WirePoint(1, 0, 0)], "7", "there is no way '7'"),
    ],
)
def test_what_a_transfer_cannot_carry_is_rejected(
    points: list[WirePoint], transfer: str, message: str
) -> None:
    with LockstepBus(Drive()) as bus, pytest.raises(StreamError, match=message):
        BusMaster(bus).stream(points, transfer)


def test_the_node_answers_as_a_canopen_device() -> None:
    """Reads and rejections with their abort codes are those that any master expects."""
    drive = Drive()
    with LockstepBus(drive, node_id=5) as bus:
        node = BusMaster(bus, 5).node
        assert node.sdo[0x2011].raw == 32
        assert bus.frames == 2  # the request and its answer
        assert node.sdo[0x60C2][1].raw == 1
        assert node.sdo[0x1001].raw == 0
        assert node.sdo[0x1000].raw == 0x00020192
        refusals: list[tuple[Callable[[], object], int]] = [
            (lambda: node.sdo.download(0x2011, 0, b"\1\0"), 0x06010002),
            (lambda: node.sdo.upload(0x2010, 0), 0x06010001),
            (lambda: node.sdo.download(0x60C0, 0, b"\1\0"), 0x06090030),
            (lambda: node.sdo.download(0x2010, 0, b"\1"), 0x06070010),
            (lambda: node.sdo.upload(0x3000, 0), 0x06020000),
            (lambda: node.sdo.upload(0x60C1, 9), 0x06090011),
            (lambda: node.sdo.upload(0x6081, 5), 0x06090011),
            (lambda: node.sdo.download(0x6081, 5, b"\1\0\0\0"), 0x06090011),
            (lambda: node.sdo.upload(0x1008, 1), 0x06090011),
        ]
        for refused, code in refusals:
            with pytest.raises(canopen.SdoAbortedError) as abort:
                refused()
            assert abort.value.code == code


def test_the_record_can_come_by_pdo_too() -> None:
    """The master maps position and time to one PDO, and the velocity to another."""
    drive = Drive()
    with LockstepBus(drive) as bus:
        master = BusMaster(bus)
        master.prepare()
        master.node.sdo[0x60C0].raw = -3
        for number, entries in ((2, [(1, 32), (2, 8)]), (3, [(3, 32)])):
            pdo = master.node.rpdo[number]
            pdo.clear()
            for sub, size in entries:
                pdo.add_variable(0x60C1, sub, size)
            pdo.cob_id, pdo.trans_type, pdo.enabled = 0x101 + number * 0x100, 255, True
            pdo.save()
        bus.network.send_message(0x301, (500).to_bytes(4, "little") + b"\x14")
        assert drive.buffer.free == 32
        bus.network.send_message(0x401, (-70).to_bytes(4, "little", signed=True))
    assert [(e.position, e.velocity, e.microseconds) for e in drive.buffer.entries] == [(500, -70, 20_000)]


def test_the_status_comes_on_every_event() -> None:
    points, drive, seen = winding(10), Drive(), list[packet.BufferStatus]()
    with LockstepBus(drive) as bus:
        master = BusMaster(bus)
        bus.network.subscribe(
            0x181, lambda _, data, __: seen.append(packet.decode_status(int.from_bytes(data, "little")))
        )
        master.stream(points)
    assert [status.free for status in seen] == list(range(23, 33))


class FencedBus(RealBus):
    """The real master's bus, with its drive in this process."""

    drive: Drive
    node: canopen.RemoteNode

    def wait(self) -> None:
        self.drive.run_until(self.drive.microseconds + 1000)
        # a value read after an event arrives after it
        self.node.sdo.upload(0x2011, 0)


def test_the_master_of_a_real_bus() -> None:
    """Both ends have threads of python-can, as with hardware."""
    points, drive = winding(120), Drive()
    far = canopen.Network()
    far.NOTIFIER_CYCLE = 0.01
    far.add_node(DriveNode(1, drive))
    far.connect(interface="virtual", channel="real")
    try:
        with FencedBus(1, "virtual", "real") as bus:
            master = BusMaster(bus)
            bus.drive, bus.node = drive, master.node
            done = master.stream(points)
    finally:
        far.disconnect()
    assert done.resent == 0
    assert departure(drive, from_wire(points)) < 1e-6


def test_a_status_is_read_as_long_as_the_drive_has_sent_none(monkeypatch: pytest.MonkeyPatch) -> None:
    reads = count_calls(monkeypatch, (BusMaster, "refresh"))
    with LockstepBus(Drive()) as bus:
        master = BusMaster(bus)
        for expected in 1, 2:
            master._at_rest()
            assert reads.calls == expected
        master._received(master.node.tpdo[1])
        master._at_rest()
    assert reads.calls == 2


def streamed(*words: str) -> Any:
    """Return the JSON document of `motionlang copley stream`."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        assert main(["copley", "stream", *words, "--format", "json"]) == 0
    return json.loads(out.getvalue())


def test_a_move_is_streamed() -> None:
    report = streamed("--scurve", "1000", "--time", "100")
    assert (report["sent"], report["position"]) == (5, 1000.0)
    assert report["error"] < 1e-9


def test_a_program_is_streamed() -> None:
    report = streamed(str(SCRIPTS / "mint" / "shuttle.mnt"), "--tolerance", "2")
    assert report["error"] < 1e-6
    assert report["log"][-1]["event"] == "move ended at 0"


@pytest.mark.usefixtures("unrendered")
def test_a_stream_is_drawn(tmp_path: Path) -> None:
    streamed("--scurve", "1000", "--time", "100", "--plot", str(tmp_path / "move.png"))
    assert (tmp_path / "move.png").exists()


def test_a_poll_takes_time(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(["copley", "stream", "--scurve", "5", "--time", "1", "--poll-interval", "0"])
    assert end.value.code == 2
    assert "'0' is not a number greater than zero" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (
            "--scurve 1000 --jerk 500000 --speed 3000 --transfer -1",
            "sub-modes 0 and -1 need one time for all segments",
        ),
        (
            "--positions 0,20000000,0 --time 5",
            "point 1: neither its position nor its distance fits the 24 bits",
        ),
        (
            "--scurve 10000 --jerk 500000 --speed 300 --poll-interval 30000",
            "the drive reports: underflow",
        ),
    ],
)
def test_a_stream_that_fails(line: str, message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["copley", "stream", *line.split()]) == 1
    assert f"the stream failed: {message}" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--interface", "nope"], "error[file]: the CAN bus 'nope motionlang-"),
        (["--interface", "nope", "--real"], "error[file]: the CAN bus 'nope' cannot be opened"),
        (["--real", "--channel", "nobody"], "error[never]: the stream failed: node 1 does not answer\n"),
    ],
)
def test_a_bus_that_is_not_there(
    words: list[str], message: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("canopen.sdo.SdoClient.RESPONSE_TIMEOUT", 0.001)
    assert main(["copley", "stream", "--scurve", "10", "--time", "5", *words]) == 1
    assert capsys.readouterr().err.startswith(message)
