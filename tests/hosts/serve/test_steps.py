"""The components of the server without sockets.

Log, buffers, addresses, clocks and Modbus requests.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.hosts.address import BadAddress, is_loopback, listen, parse, shown
from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import Limits, LockStep, RealTime
from motionlang.hosts.serve import pace as pace_module
from motionlang.hosts.serve.host import Host
from motionlang.hosts.serve.modbus_requests import Identity, Rejected, Request
from motionlang.hosts.serve.modbus_requests import parse as parse_request
from motionlang.hosts.serve.pace import BUDGET, TICK
from motionlang.hosts.serve.spy import Spy
from motionlang.kernel import INFINITY, Machine
from tests.hosts.serve.test_time import Wall

# ------------------------------------------------------------------------------------------------- the log


@pytest.mark.parametrize(
    ("pieces", "lines"),
    [
        ([b"1TP\r"], ["1 < 1TP"]),
        ([b"1T", b"P\r\n2TP\n"], ["1 < 1TP", "1 < 2TP"]),
        ([b"1MR\x1b"], ["1 < 1MR\\x1b"]),
        ([b"\x05"], ["1 < \\x05"]),
        ([b"\r\n\n"], ["1 < "]),
        # A frame ends with its checksum behind ETX.
        ([b"\x0201\x03", b"2"], ["1 < \\x0201\\x032"]),
        ([b"\x06\x15"], ["1 < \\x06", "1 < \\x15"]),
        ([b"x" * 199], []),
        ([b"x" * 201, b"\r"], ["1 < " + "x" * 200, "1 < x"]),
        ([b"a'b\\\xe4\r"], ["1 < a'b\\\\\xe4"]),
    ],
)
def test_data_from_a_host_is_logged_by_line(pieces: list[bytes], lines: list[str]) -> None:
    found: list[str] = []
    spy = Spy(found.append)
    for each in pieces:
        spy.sent(1, each)
    assert [each.removesuffix("\n") for each in found] == lines


def test_answers_are_logged_without_prompts() -> None:
    """A remark ends the unfinished lines of its host."""
    found: list[str] = []
    spy = Spy(found.append)
    spy.answered(1, b"\n>")
    spy.answered(1, b"01 0\r\nP>")
    spy.answered(1, b"12>")
    spy.answered(2, b"x>")
    spy.answered(2, b"y")
    spy.sent(1, b">\r")
    spy.sent(1, b"half")
    spy.remark(1, "has left")
    assert found == ["1 > 01 0\n", "1 < >\n", "1 < half\n", "host 1 has left\n"]
    spy.remark(2, "has left")
    assert found[4:] == ["2 > x>y\n", "host 2 has left\n"]


def test_without_traffic_the_log_has_the_remarks() -> None:
    found: list[str] = []
    spy = Spy(found.append, traffic=False)
    spy.sent(1, b"1TP\r")
    spy.answered(1, b"01 0\r\n")
    spy.remark(1, "has left")
    assert found == ["host 1 has left\n"]


# ------------------------------------------------------------------------------------------------ addresses


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("host:4410", ("host", 4410)),
        (":0", ("127.0.0.1", 0)),
        ("4410", ("127.0.0.1", 4410)),
        ("[::1]:65535", ("::1", 65535)),
        ("host:65536", None),
        ("host:", None),
        ("host:-1", None),
        ("host", None),
        ("", None),
    ],
)
def test_an_address_of_the_command_line(text: str, wanted: tuple[str, int] | None) -> None:
    if wanted is not None:
        assert parse(text) == wanted
    else:
        with pytest.raises(BadAddress, match="is not HOST:PORT with a port from 0"):
            parse(text)


def test_how_an_address_is_shown() -> None:
    assert (shown("127.0.0.1", 80), shown("::1", 80)) == ("127.0.0.1:80", "[::1]:80")


@pytest.mark.parametrize(
    ("host", "wanted"),
    [
        ("127.0.0.1", True),
        ("127.9.9.9", True),
        ("::1", True),
        ("::1%lo", True),
        ("0.0.0.0", False),
        ("x", False),
    ],
)
def test_addresses_of_this_computer_alone(host: str, wanted: bool) -> None:
    assert is_loopback(host) is wanted


def test_a_listening_socket_does_not_wait() -> None:
    with listen("127.0.0.1", 0) as listener:
        assert not listener.getblocking()
        with pytest.raises(BlockingIOError):
            listener.accept()


# ------------------------------------------------------------------------------------------------ one host


@dataclass
class Peer:
    """A channel and a port: they offer `data`, and `accepted` is what the board has."""

    data: list[bytes | None] = field(default_factory=list)
    accepted: bytearray = field(default_factory=bytearray)
    room: int = 100
    busy: bool = False
    asked: list[int] = field(default_factory=list)

    def receive(self, most: int) -> bytes | None:
        self.asked.append(most)
        return self.data.pop(0)

    def feed(self, data: bytes) -> int:
        taken = data[: self.room]
        self.accepted += taken
        return len(taken)

    def drop_abandoned(self, data: bytearray) -> None:
        if b"\x1b" in data:
            del data[: data.rfind(b"\x1b")]

    def at_once(self, data: bytearray) -> bytes:
        return bytes(data[:1]) if data.startswith(b"\x1b") else b""

    def next_entry(self, data: bytearray) -> tuple[bytes, bool]:
        end = data.find(b"\r") + 1
        return bytes(data[: end or None]), bool(end)

    def accepts(self, data: bytearray) -> bool:
        return not self.busy

    def take(self) -> bytes:
        return b""


class Pace:
    """A pace that counts the lines that have begun."""

    def __init__(self, by_line: bool) -> None:
        self.by_line, self.lines = by_line, 0

    def entered(self) -> None:
        self.lines += 1


def host_of(peer: Any, **limits: int) -> Host:
    return Host(1, peer, peer, Limits(**limits), None)


def test_a_host_is_read_up_to_the_size_of_its_inbox() -> None:
    """A read has at most `chunk` bytes, and there is none if `inbox` bytes wait."""
    peer = Peer([b"12", b"34", b"5", None])
    host = host_of(peer, chunk=2, inbox=5)
    for waits in (False, True, True):
        assert (host.listens, host.waits) == (True, waits)
        host.receive(7.0)
    assert (host.listens, host.ended, host.last_received) == (False, None, 7.0)
    assert peer.asked == [2, 2, 2]
    host.receive(8.0)
    assert (host.ended, host.last_received, host.listens) == (8.0, 7.0, False)


def test_a_host_that_has_ended_is_done_when_nothing_is_left() -> None:
    peer: Any = Peer([b"1TP\r", None], busy=True)
    host = host_of(peer)
    host.receive(1.0)
    host.receive(2.0)
    pace: Any = Pace(by_line=False)
    assert (host.done, host.is_silent) == (False, False)
    host.feed(pace)
    assert not host.done
    peer.busy = False
    assert (host.done, host.is_silent) == (True, True)
    assert host_of(Peer()).done is False


def test_lines_are_read_one_by_one_in_lock_step_alone() -> None:
    console = Console(Machine(first_axis=1))
    assert [pace.by_line for pace in (RealTime(console), LockStep(console))] == [False, True]


def test_in_real_time_a_host_passes_all_that_the_board_accepts() -> None:
    peer = Peer([b"1TP\r2TP\r"], room=6)
    host, pace = host_of(peer), Pace(by_line=False)
    host.receive(0.0)
    host.feed(pace)  # type: ignore[arg-type]
    assert (bytes(peer.accepted), host.waits, pace.lines) == (b"1TP\r2T", True, 0)
    assert host.can_continue(pace)  # type: ignore[arg-type]
    host.feed(pace)  # type: ignore[arg-type]
    assert (bytes(peer.accepted), host.waits) == (b"1TP\r2TP\r", False)
    assert not host.can_continue(pace)  # type: ignore[arg-type]


def test_in_lock_step_a_host_passes_one_line_and_an_escape_at_any_time() -> None:
    """Only a complete line takes a step; a busy board takes nothing but ESC."""
    peer: Any = Peer([b"1TP\r2T", b"P", b"\x1b"])
    host, pace = host_of(peer), Pace(by_line=True)
    step: Any = pace
    host.receive(0.0)
    host.feed(step)
    assert (bytes(peer.accepted), pace.lines) == (b"1TP\r", 1)
    host.feed(step)
    assert (bytes(peer.accepted), pace.lines) == (b"1TP\r2T", 1)
    peer.busy = True
    host.receive(0.0)
    assert not host.can_continue(step)
    host.feed(step)
    assert bytes(peer.accepted) == b"1TP\r2T"
    host.receive(0.0)
    host.feed(step)
    assert (bytes(peer.accepted), pace.lines) == (b"1TP\r2T\x1b", 1)


# --------------------------------------------------------------------------------------------------- clocks


def idle(factor: float = 1.0) -> tuple[RealTime, Console, Wall]:
    wall, console = Wall(), Console(Machine(first_axis=1))
    return RealTime(console, factor, wall), console, wall


def test_the_time_until_the_next_event_depends_on_the_factor() -> None:
    """A wait of 10 s takes 2.5 s at 4 × real time.

    When it is late, there is no time left.
    """
    pace, console, wall = idle(4.0)
    console.open(echo=False).feed(b"WA10\r")
    pace.work()
    assert pace.timeout() == pytest.approx(2.5, abs=1e-5)
    wall.time += 1.0
    assert pace.timeout() == pytest.approx(1.5, abs=1e-5)
    wall.time += 5.0
    assert pace.timeout() == 0.0
    assert pace.due == pytest.approx(24.0)


def test_real_time_begins_at_the_present_machine_time() -> None:
    """At 4 × real time, 3 s later it is 12 s more."""
    console, wall = Console(Machine(first_axis=1)), Wall()
    console.run(10.0)
    pace = RealTime(console, 4.0, wall)
    assert pace.due == 10.0
    wall.time += 3.0
    assert pace.due == 22.0


def test_a_busy_board_is_polled_each_millisecond() -> None:
    pace, console, _ = idle()
    console.open(echo=False).feed(b"AA1,RP\r")
    pace.work()
    assert pace.timeout() == TICK == 1e-3


@pytest.mark.parametrize(("behind", "late"), [(0.225, 0.0), (0.5, 0.5)])
def test_a_board_may_be_late_by_a_quarter_of_a_second(behind: float, late: float) -> None:
    """Beyond that, the real time that has been lost is not made up for."""
    wall, console = Wall(), Console(Machine(first_axis=1))
    console.open(echo=False).feed(b"AA1,RP\r")
    pace = RealTime(console, wall=wall)
    wall.time += behind
    begin, slow = wall.time, iter([0.0, 0.0, 0.0, 2.0 * BUDGET])
    pace._clock.wall = lambda: begin + next(slow, 2.0 * BUDGET)
    pace.before()
    assert pace.late == pytest.approx(late, abs=0.02)
    assert console.now == pytest.approx(0.002, abs=1e-4)
    if late:
        assert pace.due == pytest.approx(console.now)


def test_slices_grow_again_on_a_computer_that_has_time() -> None:
    """A slice is 2 ms at most, a quarter after each slow one.

    It doubles after each fast one.
    """
    pace, console, wall = idle()
    console.open(echo=False).feed(b"AA1,RP\r")
    wall.time += 1000.0
    ran, real = [], wall
    for seconds in (0.0, 2.0 * BUDGET, 0.0, 0.0, 0.0, 0.5 * BUDGET, 0.0):
        times = iter([wall.time, wall.time, wall.time + seconds])
        pace._clock.wall = lambda times=times: next(times, real.time)  # type: ignore[misc]
        began = console.now
        pace.work()
        ran.append(round((console.now - began) * 1e3, 2))
    assert ran == pytest.approx([2.0, 2.0, 0.5, 1.0, 2.0, 2.0, 2.0], abs=0.03)


@pytest.mark.parametrize(
    ("took", "before", "after"),
    [
        (1.01, 2.0, 0.5),  # a slow one: a quarter
        (1.0, 2.0, 2.0),
        (1.01, 0.06, 0.02),  # not below 20 µs
        (0.25, 0.5, 0.5),
        (0.24, 0.5, 1.0),  # a fast one: twice
        (0.24, 1.5, 2.0),  # not above 2 ms
    ],
)
def test_the_next_slice_depends_on_the_time_that_the_last_one_took(
    took: float, before: float, after: float
) -> None:
    """`took` is in budgets of 5 ms, and slices are in ms."""
    console = Console(Machine(first_axis=1))
    times = iter([0.0, 0.0, took * 5e-3])
    pace = RealTime(console, wall=lambda: next(times))
    pace._slice = before * 1e-3
    ran: list[float] = []
    pace._bounded(ran.append, 1.0)
    assert pace._slice == pytest.approx(after * 1e-3)
    assert ran == [1.0]  # an idle board has no event before


def test_in_lock_step_a_program_may_react_before_the_answer_is_sent() -> None:
    """Each line takes 10 ms, before the next line or `at_once`."""
    for at_once, times in ((False, [0.0, 0.01]), (True, [0.01, 0.02])):
        console = Console(Machine(first_axis=1))
        pace, port = LockStep(console, 0.01, at_once), console.open(echo=False)
        found = []
        for _ in range(2):
            pace.entered()
            port.feed(b"1TP\r")
            pace.work()
            found.append(console.now)
        assert found == pytest.approx(times, abs=1e-4)


def test_lines_that_arrive_together_have_a_step_each() -> None:
    console = Console(Machine(first_axis=1))
    pace = LockStep(console, 0.01, at_once=True)
    for _ in range(3):
        pace.entered()
    pace.work()
    assert console.now == pytest.approx(0.03)


@dataclass
class Board:
    """A console whose `settle` records its limit.

    Its answers, and the times then, are in `settled`.
    """

    settled: list[tuple[bool, float]]
    event: float = INFINITY
    now: float = 1.0
    limits: list[float] = field(default_factory=list)
    runs: list[float] = field(default_factory=list)

    @property
    def working(self) -> bool:
        return bool(self.settled)

    def next_time(self) -> float:
        return self.event

    def settle(self, limit: float) -> bool:
        self.limits.append(limit)
        answer, self.now = self.settled.pop(0)
        return answer

    def run(self, until: float) -> None:
        self.now = until
        self.runs.append(until)


@pytest.mark.parametrize(
    ("behind", "slice_time", "runs"),
    [
        (0.0, 0.0, []),
        (5.0, 1.0, [2.0, 4.0, 5.0]),  # 3 ms are enough
        (10.0, 2.5, [2.0, 4.0]),  # 5 ms are up
        (10.0, 2.4, [2.0, 4.0, 6.0]),
    ],
)
def test_a_board_catches_up_for_five_milliseconds(
    behind: float, slice_time: float, runs: list[float]
) -> None:
    """Times are in ms; a busy board is run in slices of 2 ms.

    Each slice takes `slice_time` of real time.
    """
    wall = Wall()
    wall.time = 0.0
    board: Any = Board([], event=0.0, now=0.0)
    run = board.run

    def slow(until: float) -> None:
        run(until)
        wall.time += slice_time * 1e-3

    board.run = slow
    pace = RealTime(board, wall=wall)
    pace._clock.began = -behind * 1e-3
    pace.before()
    assert board.runs == pytest.approx([each * 1e-3 for each in runs])


@pytest.mark.parametrize(("behind", "late"), [(0.125, 0.0), (0.25, 0.0), (0.5, 0.5)])
def test_the_time_that_a_board_has_lost_is_real_time(behind: float, late: float) -> None:
    """At 4 × real time; a quarter of a second can be made up for."""
    wall = Wall()
    board: Any = Board([], now=0.0)
    pace = RealTime(board, 4.0, wall)
    wall.time += behind
    pace._fall_behind()
    assert (pace.late, pace.due) == (late, 0.0 if late else 4.0 * behind)


@pytest.mark.parametrize(
    ("event", "settled", "limits", "timeout"),
    [
        (INFINITY, [], [], None),
        (3.0, [(True, 3.0), (True, 3.0)], [3.002, 3.002], None),  # until no line is carried out
        (0.0, [(True, 1.5), (True, 1.5)], [1.002, 1.502], None),  # something to do at once
        (3.0, [(False, 3.002), (True, 4.0)], [3.002, 3.004], None),  # a time slice was not enough
        (3.0, [(False, 3.001), (True, 4.0)], [3.002], None),  # nothing advances: it waits for the host
        (INFINITY, [(False, 1.0), (True, 4.0)], [1e300], None),
        (0.0, [(True, 1.0)] * 9, [1.002] * 4, 0.0),  # real time is up
    ],
)
def test_in_lock_step_time_passes_while_a_line_is_carried_out(
    event: float,
    settled: list[tuple[bool, float]],
    limits: list[float],
    timeout: float | None,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It is 1 s; machine time passes to the next event and 2 ms further.

    Each time takes 0.05 ms of the 0.2 ms in which the hosts are not read.
    """
    wall = iter([0.0, *(0.05e-3 * k for k in range(9))])
    monkeypatch.setattr(pace_module, "time", SimpleNamespace(monotonic=lambda: next(wall)))
    board: Any = Board(list(settled), event)
    pace = LockStep(board)
    pace.work()
    assert board.limits == pytest.approx(limits, abs=1e-9)
    assert (pace.timeout(), board.runs) == (timeout, [])


@pytest.mark.parametrize(
    ("settled", "runs"),
    [([], [1.001]), ([(False, 1.0)], [1.001]), ([(True, 1.0)] * 9, []), ([(True, 2.0)], [])],
)
def test_at_once_the_time_of_a_line_passes_when_it_has_ended_or_waits(
    settled: list[tuple[bool, float]], runs: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A line takes 1 ms.

    One has not ended when real time is up, and another one has taken longer.
    """
    wall = iter([0.0, *(0.1e-3 * k for k in range(9))])
    monkeypatch.setattr(pace_module, "time", SimpleNamespace(monotonic=lambda: next(wall)))
    board: Any = Board(list(settled))
    pace = LockStep(board, at_once=True)
    pace.entered()
    pace.work()
    assert board.runs == pytest.approx(runs)


# --------------------------------------------------------------------------------------------------- Modbus


@pytest.mark.parametrize(
    ("request_", "spans"),
    [
        ("03 0007 0002", ((7, 2),)),
        ("06 0007 0001", ((7, 1),)),
        ("10 0007 0002 04 0001 0002", ((7, 2),)),
        ("16 0007 0000 0000", ((7, 1),)),
        ("17 0003 0005 0007 0001 02 0009", ((3, 5), (7, 1))),
    ],
)
def test_the_registers_that_a_request_accesses(request_: str, spans: tuple[tuple[int, int], ...]) -> None:
    assert parse_request(bytes.fromhex(request_)).spans == spans


def test_bounds_of_quantities() -> None:
    """125 registers are read, 123 are written, 121 are written and read."""
    assert parse_request(bytes.fromhex("10 0000 007b f6" + "0001" * 123)) == Request(16, values=(1,) * 123)
    wrong = ("10 0000 007c f8" + "0001" * 124, "17 0000 0001 0000 007a f4" + "0001" * 122, "10 0000 0001")
    for each in wrong:
        with pytest.raises(Rejected) as caught:
            parse_request(bytes.fromhex(each))
        assert caught.value.code == 3


def test_a_text_of_the_identification_has_60_characters_of_ascii() -> None:
    identity = Identity("ä" * 70, "p", "v")
    assert identity.objects == {0: b"?" * 60, 1: b"p", 2: b"v", 4: b"p"}
    answer = identity.answer(bytes.fromhex("2b 0e 03 04"))
    assert answer == bytes.fromhex("2b 0e 03 82 00 00 01 04 01") + b"p"
    for data, code in (
        ("2b", 1),
        ("2b 0e", 3),
        ("2b 0e 00 00", 3),
        ("2b 0e 01 00 00", 3),
        ("2b 0f 01 00", 1),
    ):
        with pytest.raises(Rejected) as caught:
            identity.answer(bytes.fromhex(data))
        assert caught.value.code == code
