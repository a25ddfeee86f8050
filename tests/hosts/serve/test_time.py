"""The advance of machine time: with real time, or by the hosts' requests."""

from __future__ import annotations

import pytest

from motionlang.hosts.mccl.console import Console
from motionlang.hosts.serve import LockStep, RealTime
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
    """Commands take machine time, but a host does not wait for that."""
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
    assert console.now <= 2e-3 + 1e-9


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
    assert pace.late > 0.25


def test_many_loops_do_not_keep_a_new_host_waiting() -> None:
    """On a slow computer the board runs for shorter intervals between two polls."""
    wall = Wall()
    console = Console(Machine(first_axis=1))

    def slow() -> float:
        wall.time += 10e-3
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
    assert ran[0] <= 2.1e-3
    assert 0.0 < ran[-1] < 0.4e-3


def test_time_stands_still_in_lock_step_unless_a_host_waits(serve: Serve) -> None:
    board = serve()
    wire = board.connect()
    assert board.console.now == 0.0
    wire.ask(b"1MN,1MR100000")
    began = board.console.now
    for _ in range(3):
        wire.send(b"1T\x081")
    assert board.console.now == began
    wire.send(b"\x1b")
    wire.until(b">")  # Escape has a prompt of its own, which may come before the time has passed
    wire.ask(b"WA2")
    assert board.console.now == pytest.approx(began + 2.0, abs=0.01)


def test_the_same_lines_are_answered_the_same_in_lock_step(serve: Serve) -> None:
    """A client that polls a move reads reproducible positions."""

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


def idle(factor: float = 1.0) -> tuple[RealTime, Console, Wall]:
    wall, console = Wall(), Console(Machine(first_axis=1))
    return RealTime(console, factor, wall), console, wall


def test_the_time_until_the_next_event_depends_on_the_factor() -> None:
    """A wait of 10 s takes 2.5 s at 4 × real time."""
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
    assert pace.timeout() == 1e-3


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


@pytest.mark.parametrize(("behind", "ran"), [(4e-3, 4e-3), (0.2, 6e-3), (0.5, 6e-3)])
def test_a_board_that_is_late_catches_up_for_five_milliseconds(behind: float, ran: float) -> None:
    """Each slice of 2 ms takes 2 ms of real time; what is later than a quarter of a second is lost."""
    wall = Wall()
    console = Console(Machine(first_axis=1))
    console.open(echo=False).feed(b"AA1,RP\r")
    pace = RealTime(console, wall=wall)
    wall.time += behind
    run = console.run

    def slow(until: float) -> None:
        run(until)
        wall.time += 2e-3

    console.run = slow  # type: ignore[method-assign]
    pace.before()
    assert console.now == pytest.approx(ran, abs=1e-3)
    assert (pace.late > 0.0) is (behind > 0.25)
