"""Virtual time."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel import INFINITY
from motionlang.kernel.controller import Clock
from tests.cases import cases


def test_events_run_at_their_own_time_and_in_their_order() -> None:
    clock = Clock()
    seen: list[tuple[str, float]] = []

    def note(name: str) -> Callable[[], None]:
        return lambda: seen.append((name, clock.now))

    for name, time in (("b", 2.0), ("a", 1.0), ("c", 2.0)):
        clock.at(time, note(name))
    clock.advance(5.0)
    assert seen == [("a", 1.0), ("b", 2.0), ("c", 2.0)]
    assert clock.now == 5.0


def test_a_cancelled_event_does_not_happen_and_is_no_horizon() -> None:
    clock = Clock()
    clock.at(1.0, lambda: None).cancel()
    assert clock.next_time() == INFINITY


def test_an_event_may_make_the_next_one() -> None:
    clock = Clock()
    seen: list[float] = []

    def again() -> None:
        seen.append(clock.now)
        if len(seen) < 3:
            clock.at(clock.now + 1.0, again)

    clock.at(1.0, again)
    clock.advance(10.0)
    assert seen == [1.0, 2.0, 3.0]


def test_horizon_comes_nearer_as_events_are_made() -> None:
    clock = Clock()
    assert clock.horizon == INFINITY
    clock.at(3.0, lambda: None)
    clock.at(2.0, lambda: None)
    assert clock.horizon == 2.0
    clock.advance(2.5)
    assert clock.horizon == 3.0


def test_time_never_runs_back() -> None:
    clock = Clock()
    clock.advance(2.0)
    clock.advance(1.0)
    assert clock.now == 2.0


def test_it_goes_as_far_as_there_is_no_news() -> None:
    clock = Clock()
    calls: list[float] = []

    def happening(time: float, quiet: bool) -> Callable[[], bool]:
        def happen() -> bool:
            calls.append(time)
            return quiet

        return happen

    for time, quiet in ((1.0, True), (2.0, False), (2.0, True), (3.0, True)):
        clock.at(time, happening(time, quiet))
    assert not clock.advance_to_news(5.0)
    assert (clock.now, calls, clock.horizon) == (2.0, [1.0, 2.0, 2.0], 3.0)
    assert clock.advance_to_news(5.0)
    assert (clock.now, calls, clock.horizon) == (5.0, [1.0, 2.0, 2.0, 3.0], float("inf"))


def test_news_at_the_very_end_is_news() -> None:
    clock = Clock()
    clock.at(1.0, lambda: False)
    assert not clock.advance_to_news(1.0)


def test_an_event_may_schedule_itself_again() -> None:
    clock = Clock()
    calls: list[str] = []
    event = clock.at(1.0, lambda: calls.append("again"))
    clock.advance(1.0)
    clock.at(2.0, lambda: calls.append("other"))
    clock.again(event, 2.0)
    clock.advance(2.0)
    assert calls == ["again", "other", "again"]


def names(clock: Clock, seen: list[str], *events: tuple[float, str]) -> None:
    """Schedule events that write their names down, and are quiet."""
    for time, name in events:
        clock.at(time, lambda name=name: seen.append(name) or True)  # type: ignore[misc,func-returns-value]


def test_cancelled_events_behind_the_end_are_no_horizon() -> None:
    for advance in (Clock.advance, Clock.advance_to_news):
        clock = Clock()
        clock.at(2.0, lambda: None).cancel()
        clock.at(3.0, lambda: None)
        advance(clock, 1.0)
        assert (clock.now, clock.horizon, clock.fired) == (1.0, 3.0, 0)


@cases("advance", [Clock.advance, Clock.advance_to_news])
def test_an_overdue_event_does_not_turn_time_back(advance: Callable[[Clock, float], object]) -> None:
    clock, times = Clock(), list[float]()

    def note() -> bool:
        times.append(clock.now)
        return True

    clock.at(1.0, note)
    clock.now = 2.0
    advance(clock, 1.5)
    assert (times, clock.now) == ([2.0], 2.0)
