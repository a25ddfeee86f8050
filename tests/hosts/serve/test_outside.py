"""Questions to a running program."""

from __future__ import annotations

import pytest

from motionlang.hosts.serve.outside import InTurn, LockStepQueue, QuestionQueue, RealTimeQueue
from motionlang.kernel import INFINITY, Machine
from tests.hosts.serve.test_time import Wall


def started(outside: QuestionQueue) -> list[float]:
    """Start a machine; return the list of the times of questions that `ask` fills."""
    outside.start(Machine(first_axis=1))
    return []


def ask(outside: QuestionQueue, times: list[float]) -> None:
    outside.ask(lambda: times.append(outside.clock.now))


@pytest.mark.parametrize(("factor", "sleeps"), [(1.0, [2.0]), (4.0, [0.5])])
def test_a_wait_takes_real_time(factor: float, sleeps: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    """2 machine seconds take 2 s, or 0.5 s at 4 × real time.

    The real time before the first wait does not count.
    """
    wall, slept = Wall(), list[float]()
    outside = RealTimeQueue(factor, wall)
    started(outside)

    def sleep(seconds: float) -> None:
        slept.append(seconds)
        wall.time += seconds

    monkeypatch.setattr(outside, "_sleep", sleep)
    wall.time += 100.0
    outside.advance(2.0)
    assert (outside.clock.now, slept) == (2.0, sleeps)
    wall.time += 1.0
    outside.advance(2.0 + factor / 2.0)  # its time has passed already
    assert len(slept) == 1
    assert outside.clock.now == 2.0 + factor / 2.0


def test_real_time_goes_on_from_the_time_of_the_first_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    """At 4 × real time, the waits from 4 to 8 s and on to 10 s take 1 s and 0.5 s."""
    wall, slept = Wall(), list[float]()
    outside = RealTimeQueue(4.0, wall)
    started(outside)

    def sleep(seconds: float) -> None:
        slept.append(seconds)
        wall.time += seconds

    monkeypatch.setattr(outside, "_sleep", sleep)
    outside.clock.advance(4.0)
    outside.advance(8.0)
    outside.advance(10.0)
    assert (outside.clock.now, slept) == (10.0, [1.0, 0.5])


def test_an_answer_ends_a_wait_in_real_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """All waiting questions are answered at the present time."""
    wall = Wall()
    outside = RealTimeQueue(1.0, wall)
    times = started(outside)

    def sleep(seconds: float) -> None:
        wall.time += 0.5
        ask(outside, times)
        ask(outside, times)

    monkeypatch.setattr(outside, "_sleep", sleep)
    outside.advance(2.0)
    assert (outside.clock.now, times) == (0.5, [0.5, 0.5])
    outside.advance(0.5)
    assert times == [0.5, 0.5]


def test_in_lock_step_each_question_grants_a_step(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first step of 10 ms is free; a wait of 25 ms needs two questions more."""
    outside = LockStepQueue()
    times, slept = started(outside), list[float]()

    def sleep(seconds: float) -> None:
        slept.append(seconds)
        ask(outside, times)

    monkeypatch.setattr(outside, "_sleep", sleep)
    outside.advance(0.01)
    assert (outside.clock.now, times) == (0.01, [])
    outside.advance(0.025)
    assert outside.clock.now == pytest.approx(0.025)
    assert times == pytest.approx([0.01, 0.02])
    assert slept == [INFINITY, INFINITY]


def test_in_lock_step_an_event_or_an_endless_wait_ends_with_the_question(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """An answer may make an event that comes before the end of the wait."""
    outside = LockStepQueue(0.01)
    times = started(outside)
    monkeypatch.setattr(outside, "_sleep", lambda seconds: ask(outside, times))
    outside.advance(INFINITY)
    assert (outside.clock.now, len(times)) == (0.01, 1)
    outside.clock.at(0.5, lambda: None)
    outside.advance(1.0)
    assert (outside.clock.now, len(times)) == pytest.approx((0.02, 2))
    outside.advance(0.5)  # the event at the end is none before it
    assert outside.clock.now == 0.5


def test_a_question_fails_with_its_exception_and_after_the_end() -> None:
    outside = LockStepQueue(0.01)
    started(outside)
    assert outside.may_act()
    wrong, right, late = outside.ask(lambda: 1 / 0), outside.ask(lambda: 7), outside.ask(lambda: 8)
    assert [outside._answer() for _ in range(2)] == [True, True]
    assert isinstance(wrong.exception(0), ZeroDivisionError)
    assert right.result(0) == 7
    outside.close()
    assert "Closed" in repr(late.exception(0))
    assert "Closed" in repr(outside.ask(lambda: 9).exception(0))
    assert outside._answer() is False


@pytest.mark.parametrize(("seconds", "waited"), [(0.25, [0.25]), (0.5, [0.5]), (INFINITY, [0.5])])
def test_a_thread_sleeps_half_a_second_at_most_and_not_if_a_question_waits(
    seconds: float, waited: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    outside, found = LockStepQueue(0.01), list[float]()
    times = started(outside)
    monkeypatch.setattr(outside._changed, "wait", found.append)
    outside._sleep(seconds)
    assert found == waited
    ask(outside, times)
    outside._sleep(seconds)
    assert found == waited


def test_a_server_answers_one_question_in_each_iteration() -> None:
    """A question that is left over wakes the server, and time passes before its answer."""
    calls: list[str] = []
    outside = InTurn(lambda: calls.append("wake"), lambda: calls.append("entered"))
    times = started(outside)
    for _ in range(2):
        ask(outside, times)
    assert (calls, times) == (["wake", "wake"], [])
    calls.clear()
    outside.answer_next()
    assert (calls, times) == (["entered", "wake"], [0.0])
    outside.clock.advance(0.01)
    calls.clear()
    outside.answer_next()
    outside.answer_next()
    assert (calls, times) == (["entered"], [0.0, 0.01])
