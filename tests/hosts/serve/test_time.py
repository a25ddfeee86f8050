"""The advance of machine time: with real time, or by the hosts' requests."""

from __future__ import annotations

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import LockStep, RealTime
from motionlang.hosts.serve.pace import BUDGET, LATEST, LEAD, SLICE
from motionlang.kernel import Machine
from tests.hosts.serve.conftest import Serve


class Wall:
    """A clock that the test sets."""

    def __init__(self) -> None:
        self.time = 1000.0

    def __call__(self) -> float:
        return self.time


def test_a_move_takes_the_time_that_it_takes() -> None:
    wall = Wall()
    console = Console(Machine(first_axis=1))
    pace = RealTime(console, wall=wall)
    port = console.open(echo=False)
    port.take()
    port.feed(b"1SV10000,1MN,1MR10000,1WS,1TP\r")
    pace.work()
    assert port.take() == b""
    timeout = pace.timeout()
    assert timeout is not None
    assert timeout == pytest.approx(1.1, abs=1e-3)
    wall.time += timeout
    pace.before()
    pace.work()
    assert port.take() == b"01 10000\n>"
    assert pace.timeout() is None


def test_a_factor() -> None:
    wall = Wall()
    console = Console(Machine(first_axis=1))
    pace = RealTime(console, 10.0, wall)
    wall.time += 60.0
    pace.before()
    assert console.now == 600.0


def test_a_long_sleep_is_one_step() -> None:
    """A board that gets no request for a year is up to date at once."""
    wall = Wall()
    console = Console(Machine(first_axis=1))
    pace = RealTime(console, wall=wall)
    console.open()
    wall.time += 365 * 86400.0
    pace.before()
    assert console.now == pytest.approx(365 * 86400.0)


def test_an_answer_comes_a_little_early_and_no_more() -> None:
    """Commands take machine time, but a host does not wait for that.

    A program does not run ahead of real time by more than `LEAD`.
    """
    wall = Wall()
    console = Console(Machine(first_axis=1))
    pace = RealTime(console, wall=wall)
    port = console.open(echo=False)
    port.take()
    port.feed(b"1TP\r")
    pace.work()
    assert port.take() == b"01 0\n>"
    port.feed(b"AA1,RP\r")
    for _ in range(5):
        pace.work()
    assert console.now <= LEAD + 1e-9


def test_answers_are_early_by_real_time() -> None:
    """At 10 × real time, 2 ms of real time are 20 ms of machine time."""
    console = Console(Machine(first_axis=1))
    pace = RealTime(console, 10.0, Wall())
    console.open(echo=False).feed(b"AA1,RP\r")
    for _ in range(20):
        pace.work()
    assert console.now == pytest.approx(0.02, abs=1e-3)


def test_a_board_with_more_to_do_than_can_be_computed_falls_behind() -> None:
    console = Console(Machine(first_axis=1))
    pace = RealTime(console, 1e5)
    console.open(echo=False).feed(b"AA1,RP\r")
    while pace.late == 0.0:
        pace.before()
    assert pace.late > LATEST


def test_many_loops_do_not_keep_a_new_host_waiting() -> None:
    """On a slow computer the board runs for shorter intervals between two polls."""
    wall = Wall()
    console = Console(Machine(first_axis=1))

    def slow() -> float:
        wall.time += 2.0 * BUDGET
        return wall.time

    pace = RealTime(console, wall=slow)
    for _ in range(20):
        console.open(echo=False).feed(b"AA1,RP\r")
    wall.time += 0.2
    ran = []
    for _ in range(6):
        began = console.now
        pace.work()
        ran.append(console.now - began)
    assert ran[0] <= SLICE + 1e-4
    assert 0.0 < ran[-1] < 0.2 * SLICE


def test_time_stands_still_in_lock_step_unless_a_host_waits(serve: Serve) -> None:
    board = serve()
    wire = board.connect()
    assert board.console.now == 0.0
    wire.ask(b"1MN,1MR100000")
    began = board.console.now
    for _ in range(3):
        wire.send(b"1T\x081")
    assert board.console.now == began
    wire.ask(b"\x1bWA2")
    assert board.console.now == pytest.approx(began + 2.0, abs=0.01)


def test_the_same_lines_are_answered_the_same_in_lock_step(serve: Serve) -> None:
    """A client that polls a move reads reproducible positions.

    Each request takes a millisecond.
    """

    def poll() -> list[bytes]:
        wire = serve().connect()
        wire.ask(b"1MN,1MR1000")
        return [wire.ask(b"1TP") for _ in range(300)]

    answers = poll()
    assert answers == poll()
    assert len(set(answers)) > 150
    assert answers[-1] == b"01 1000\n>"


def test_a_line_is_work_to_do_in_lock_step() -> None:
    console = Console(Machine(first_axis=1))
    pace = LockStep(console)
    assert pace.timeout() is None
    console.open(echo=False).feed(b"WA1\r")
    assert pace.timeout() == 0.0


def test_a_step_of_no_time() -> None:
    console = Console(Machine(first_axis=1))
    pace = LockStep(console, 0.0)
    port = console.open(echo=False)
    for _ in range(100):
        pace.entered()
        port.feed(b"1TP\r")
        pace.work()
    assert console.now == pytest.approx(100 * 10e-6)
    assert pace.timeout() is None


def test_a_wait_that_nothing_can_end_does_not_keep_the_server_busy() -> None:
    console = Console(Machine(first_axis=1))
    pace = LockStep(console)
    port = console.open(echo=False)
    pace.entered()
    port.feed(b"WN40\r")
    pace.work()
    assert port.busy
    assert pace.timeout() is None
