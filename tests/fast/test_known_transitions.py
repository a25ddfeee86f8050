"""Ticks and WAITs are skipped along known transitions, step by step."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from random import Random
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.fast.polled_ticks import TICK, PolledTicks, Transition, _Checkpoint, _first, _Node, _Walk
from motionlang.lang.statement_time import StatementTime
from tests.cases import cases

HANDLER = (("handler", "timer"),)


def transition(state: int, length: float, proved: bool = True, **given: Any) -> Transition:
    """Return a transition to a state, with a handler unless `given` has other effects."""
    effects: dict[str, Any] = {
        "handler": HANDLER,
        "switches": (),
        "waits": (),
        "open": frozenset(),
        "steps": (),
        "seconds": {},
    }
    made = Transition(state, length, **(effects | given))
    made.is_proved = proved
    return made


def polled(*idle: bool, period: float = 10.0, cost: float = 1e-5, most: int = 10**9) -> Any:
    """Return the search of a program with a tick every `period` ms since 0 s.

    `idle` are its states: true if all tasks wait. In the others the task "main" polls. The counters may advance `most`
    times.
    """
    made: Any = PolledTicks.__new__(PolledTicks)
    environment: Any = SimpleNamespace(statements=StatementTime(cost), clock=SimpleNamespace(now=0.0))
    events: Any = SimpleNamespace(started=0.0, timer=period, tick_time=lambda number: number * period / 1000)
    counters: Any = SimpleNamespace(most_recorded=lambda values: most)
    made._environment, made._events, made._counters = environment, events, counters
    made._cost_units = round(cost * 1e11)
    made._known, made._alone, made._gaps, made._periods = {}, {}, {}, {}
    made._are_idle = list(idle)
    made._polling = ["" if each else "main" for each in idle]
    return made


def learn(made: Any, state: int, step: Transition, *path: tuple[int, float]) -> None:
    """Make a transition known.

    Its path has the index and the statement of each tick and end.
    """
    node = made._known.setdefault(state, _Node())
    for each in path:
        node = node.next.setdefault(each, _Node())
    node.transition = step


@cases(
    "moment, index, statement",
    (
        (2.0, TICK, 2.0),
        (1.75, TICK, 2.0),
        (2.0 + 1e-12, TICK, 3.0),
        (1.0, TICK, 0.0),
        (2.0, 0, 2.0),
        (2.0 + 0.5e-10, 0, 2.0),
        (2.0 - 0.5e-10, 0, 2.0),
        (2.0 + 1.5e-10, 0, None),
        (2.0 - 1.5e-10, 0, None),
        (2.0 + 1.9e-9, 1, None),
        (2.0 - 1.9e-9, 1, None),
        (2.0 + 2.1e-9, 1, 3.0),
        (2.0 - 2.1e-9, 1, 2.0),
        (2.2, 1, 3.0),
        (2.3, 1, 3.0),
    ),
)
def test_the_first_statement_after_a_tick_or_the_end_of_a_wait(
    moment: float, index: int, statement: float | None
) -> None:
    """Statements take 0.5 s and begin at 1 s, so number 2 is at 2 s.

    A WAIT may end 1 ns early. If it ends 0.1 to 2 ns from a statement, rounding might decide.
    """
    assert _first((moment, index, 0.0), 1.0, 0.5) == statement


def test_the_first_statement_after_a_tick_is_the_least_that_is_not_before_it() -> None:
    """Products of ticks and of statements round differently, in both directions."""
    assert (
        _first((3.0030300000000003, TICK, 0.0), 0.25003, 4e-5) == 68_826.0
    )  # 68 825 * 40 µs are just before it
    assert _first((0.539, TICK, 0.0), 0.5, 3e-6) == 13_000.0
    random = Random(1)
    for _ in range(400):
        base, cost = random.choice((0.0, 3e-5, 0.1)), random.choice((1e-5, 3e-6, 0.7310585e-5))
        moment = base + random.randint(1, 5000) * cost
        count = _first((moment, TICK, 0.0), base, cost)
        assert count is not None
        assert base + (count - 1.0) * cost < moment <= base + count * cost


@pytest.mark.parametrize(
    "other",
    [
        {"state": 2},
        {"length": 4.0},
        {"handler": None},
        {"switches": ((1.0, (3, 1)),)},
        {"waits": ((0, 1.0, 500),)},
        {"steps": (1.0,)},
    ],
)
def test_transitions_with_other_effects_are_not_equal(other: dict[str, Any]) -> None:
    one = transition(1, 3.0)
    assert one.equals(transition(1, 3.0, proved=False, open=frozenset({1}), seconds={"main": 1.0}))
    assert not one.equals(transition(**{"state": 1, "length": 3.0, **other}))


@cases(
    "idle, by_tick, period, due, origin",
    (
        # All tasks wait: the statements count from the tick.
        (True, False, None, (3.0, TICK, 0.0), (3.0, 0.0)),
        (True, False, None, (2.0 + 3e-9, TICK, 0.0), (2.0 + 3e-9, 0.0)),
        (True, False, None, (2.0 + 1e-9, TICK, 0.0), None),
        (True, False, None, (2.0, TICK, 0.0), (1.0, 2.0)),
        (True, False, None, (1.5, TICK, 0.0), (1.0, 2.0)),
        # A task polls: they count from the checkpoint, or from its last iteration. Iterations of 7 statements begin
        # with the third one after the checkpoint; 0.5 s is a statement.
        (False, False, None, (30.0, TICK, 0.0), (1.0, 2.0)),
        (False, True, (3.0, 7.0), (30.0, TICK, 0.0), (1.0, 2.0)),
        (False, False, (3.0, 7.0), (1.0 + 0.5 * (2 + 3 + 13), TICK, 0.0), (1.0, 2.0 + 7)),
        (False, False, (3.0, 7.0), (1.0 + 0.5 * (2 + 3 + 14), TICK, 0.0), (1.0, 2.0 + 14)),
        (False, False, (3.0, 7.0), (1.0 + 0.5 * (2 + 3 + 6), TICK, 0.0), (1.0, 2.0)),
        (False, False, (3.0, 7.0), (1.0 + 0.5 * (2 + 1), TICK, 0.0), (1.0, 2.0)),
        (False, False, (3.0, 7.0), (1.0 + 0.5 * (2 + 3 + 14) + 1.5e-10, 1, 0.0), None),
    ),
)
def test_the_origin_of_a_transition(
    idle: bool,
    by_tick: bool,
    period: tuple[float, float] | None,
    due: tuple[float, int, float],
    origin: tuple[float, float] | None,
) -> None:
    """The checkpoint is statement 2 of those from 1 s on, at 2 s."""
    made = polled(idle, cost=0.5)
    if period is not None:
        made._periods[0] = period
    assert made._origin(0, 1.0, 2.0, due, by_tick) == origin


# The number of the state, its transition, and the ticks and ends in its path with their statements.
Known = tuple[int, Transition, tuple[tuple[int, float], ...]]
ONE, TWO, LONG = transition(1, 4.0), transition(2, 9.0), transition(3, 30.0)
NO_DUE = (inf, TICK, 0.0)


@cases(
    "known, dues, found",
    (
        # The next tick, at 5 s, comes before, at and after the end of 4 statements from 2 s on.
        (((0, ONE, ()),), ((5.0, TICK, 0.0),), (ONE, 1.0, 2.0, 0)),
        (((0, ONE, ()),), ((4.0, TICK, 0.0),), None),
        (((0, ONE, ()),), ((4.0 + 1.9e-9, TICK, 0.0),), None),
        (((0, ONE, ()),), ((4.0 + 2.1e-9, TICK, 0.0),), (ONE, 1.0, 2.0, 0)),
        (((1, ONE, ()),), ((5.0, TICK, 0.0),), None),
        # A tick 6 statements after the checkpoint, and one after 7.
        (((0, TWO, ((TICK, 6.0),)),), ((5.0, TICK, 0.0),), (TWO, 1.0, 2.0, 1)),
        (((0, TWO, ((TICK, 7.0),)),), ((5.0, TICK, 0.0),), None),
        (((0, TWO, ((1, 6.0),)),), ((5.0, TICK, 0.0),), None),
        # It comes before the end of the transition without it.
        (((0, ONE, ()), (0, TWO, ((TICK, 3.0),))), ((3.5, TICK, 0.0),), (TWO, 1.0, 2.0, 1)),
        (((0, ONE, ()), (0, TWO, ((TICK, 3.0),))), ((4.5, TICK, 0.0),), (ONE, 1.0, 2.0, 0)),
        # A WAIT ends 2 statements after the tick, at the end of the transition, and rather later.
        (
            ((0, TWO, ((TICK, 6.0),)), (0, LONG, ((TICK, 6.0), (1, 8.0)))),
            ((5.0, TICK, 0.0), (6.0, 1, 0.0)),
            (LONG, 1.0, 2.0, 2),
        ),
        (
            ((0, TWO, ((TICK, 6.0),)), (0, LONG, ((TICK, 6.0), (1, 9.0)))),
            ((5.0, TICK, 0.0), (6.5 + 1.9e-9, 1, 0.0)),
            None,
        ),
        (
            ((0, TWO, ((TICK, 6.0),)), (0, LONG, ((TICK, 6.0), (1, 9.0)))),
            ((5.0, TICK, 0.0), (6.5, 1, 0.0)),
            (LONG, 1.0, 2.0, 2),
        ),
        (
            ((0, TWO, ((TICK, 6.0),)), (0, LONG, ((TICK, 6.0), (1, 9.0)))),
            ((5.0, TICK, 0.0), (6.6, 1, 0.0)),
            (TWO, 1.0, 2.0, 1),
        ),
        (((0, TWO, ((TICK, 6.0), (1, 7.0))),), ((5.0, TICK, 0.0), (5.5, 1, 0.0)), (TWO, 1.0, 2.0, 2)),
    ),
)
def test_the_next_transition(
    known: tuple[Known, ...],
    dues: tuple[tuple[float, int, float], ...],
    found: tuple[Transition, float, float, int] | None,
) -> None:
    """A task polls in state 0.

    The checkpoint is statement 2 of those of 0.5 s from 1 s on.
    """
    made = polled(False, cost=0.5)
    for state, step, path in known:
        learn(made, state, step, *path)
    assert made._next(0, 1.0, 2.0, [*dues, NO_DUE]) == found


@cases(
    "due, path, found",
    (
        ((5.0, TICK, 0.0), ((TICK, 0.0),), (5.0, 0.0, 1)),
        ((5.0, TICK, 0.0), ((TICK, 6.0),), None),
        ((2.0 + 1e-9, TICK, 0.0), ((TICK, 0.0),), None),
        ((2.0, TICK, 0.0), ((TICK, 0.0),), (1.0, 2.0, 1)),
    ),
)
def test_the_next_transition_while_all_tasks_wait(
    due: tuple[float, int, float],
    path: tuple[tuple[int, float], ...],
    found: tuple[float, float, int] | None,
) -> None:
    """The statements count from the tick, unless it is due already."""
    made = polled(True, cost=0.5)
    learn(made, 0, ONE, *path)
    assert made._next(0, 1.0, 2.0, [due, NO_DUE]) == (None if found is None else (ONE, *found))
    assert made._next(1, 1.0, 2.0, [due, NO_DUE]) is None


def test_the_next_transition_counts_from_the_last_iteration_of_a_poll() -> None:
    """Iterations of 7 statements begin 3 after the checkpoint.

    The tick comes 22 after the checkpoint, 8 after two iterations, and another end makes the period count.
    """
    made = polled(False, cost=0.5)
    made._periods[0] = 3.0, 7.0
    learn(made, 0, ONE, (TICK, 8.0))
    learn(made, 0, TWO, (TICK, 22.0))
    tick, end = (1.0 + 0.5 * (2 + 22), TICK, 0.0), (90.0, 1, 0.0)
    assert made._next(0, 1.0, 2.0, [tick, end, NO_DUE]) == (ONE, 1.0, 2.0 + 14, 1)
    assert made._next(0, 1.0, 2.0, [tick, NO_DUE]) == (TWO, 1.0, 2.0, 1)
    direct = transition(0, 22.0)  # without a tick
    learn(made, 0, direct)
    assert made._next(0, 1.0, 2.0, [tick, end, NO_DUE]) == (ONE, 1.0, 2.0 + 14, 1)
    assert made._next(0, 1.0, 2.0, [(tick[0] + 3e-9, *tick[1:]), end, NO_DUE]) == (direct, 1.0, 2.0, 0)
    learn(made, 0, TWO, (TICK, 9.0))
    assert made._next(0, 1.0, 2.0, [(tick[0] + 1e-9, *tick[1:]), end, NO_DUE]) == (TWO, 1.0, 2.0 + 14, 1)


def walked(made: Any, end: float, own: _Checkpoint, by_tick: bool = False) -> tuple[object, ...] | None:
    """Return a walk as plain data.

    It has its states, how many transitions are good, what it has reached, and its switches and polls.
    """
    walk = (made._walk_ticks if by_tick else made._walk)(own, end)
    if walk is None:
        return None
    states = tuple(step.state for step in walk.steps)
    return states, walk.good, walk.reached, walk.switching, walk.polling


def checkpoint(
    *dues: tuple[float, int, float], base: float = 0.0, count: float = 3.0, number: int = 1
) -> _Checkpoint:
    return _Checkpoint(0, base, count, list(dues), number, ())


@cases(
    "end, most, good",
    (
        (1.0, 10**9, 98),
        (0.02003 - 1e-9, 10**9, 0),
        (0.02003 + 1e-9, 10**9, 1),
        (0.03003 - 1e-9, 10**9, 1),
        (0.05, 10**9, 3),
        (0.0501, 10**9, 4),
        (1.0, 1, 1),
        (1.0, 2, 2),
        (1.0, 7, 7),
        (100.0, 10**9, 4096),
    ),
)
def test_a_tick_that_returns_to_its_state_is_repeated(end: float, most: int, good: int) -> None:
    """All tasks wait, and each handler takes 3 statements.

    Tick 2 is the first one, at 20 ms. The last good one ends before `end`, after 30 µs.
    """
    made = polled(True, most=most)
    step = transition(0, 3.0)
    made._alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    found = walked(made, end, checkpoint((0.02, TICK, 0.0), base=0.01, number=2))
    if not good:
        assert found is None
        return
    last, period = 2 + good - 1, 10 / 1000.0
    reached = last * period, 3.0, [((last + 1) * period, TICK, 0.0)], last + 1
    assert found == ((0,) * good, good, reached, [], [])


@cases("switches, proved, good", (((), True, 8), (((1.0, (3, 1)),), True, 8), ((), False, None)))
def test_a_tick_that_switches_is_repeated_one_by_one(switches: Any, proved: bool, good: int | None) -> None:
    """The number, base and origin of each transition with switches are recorded."""
    made = polled(True)
    step = transition(0, 3.0, proved, switches=switches)
    made._alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    found = walked(made, 0.1, checkpoint((0.02, TICK, 0.0), base=0.01, number=2))
    if good is None:
        assert found is None
        return
    assert found is not None
    expected = [(k, (k + 2) * (10 / 1000.0), 0.0) for k in range(8)] if switches else []
    assert found[1:] == (good, (0.09, 3.0, [(0.1, TICK, 0.0)], 10), expected, [])


def test_a_wait_that_begins_again_is_repeated_up_to_the_tick() -> None:
    """A loop polls every millisecond, and its iteration has 5 statements.

    The tick ends in another state. The WAIT that ends at 2 ms begins again 20 µs later, and ends 1 ms after that:
    7 times before the tick at 10 ms.
    """
    made = polled(True, True)
    again = transition(0, 5.0, handler=None, waits=((0, 2.0, 102_000_000),))
    made._alone[0, 0] = again
    learn(made, 0, again, (0, 0.0))
    found = walked(made, 1.0, checkpoint((0.002, 0, 0.001), (0.01, TICK, 0.0), base=0.001))
    assert found is not None
    states, good, reached, *rest = found
    assert (states, good, rest) == ((0,) * 8, 8, [[], []])
    assert reached == (0.00914, 5.0, [(0.01, TICK, 0.0), (0.01016, 0, 0.00914 + 2 * 1e-5)], 1)


def test_ticks_and_ends_of_waits_alternate() -> None:
    """WAITs of 6 ms begin 10 µs after their ends, and a tick comes every 10 ms.

    The states are 1 after a tick and 0 after the end of a WAIT; the tick at 10 ms falls between the ends at 5.01 ms
    and at 11.02 ms.
    """
    made = polled(True, True)
    tick, back = transition(1, 2.0), transition(0, 3.0, handler=None, waits=((0, 1.0, 601_000_000),))
    for state in (0, 1):
        for step, index in ((tick, TICK), (back, 0)):
            made._alone[state, index] = step
            learn(made, state, step, (index, 0.0))
    found = walked(made, 0.04, checkpoint((0.00501, 0, 0.0), (0.01, TICK, 0.0)))
    assert found is not None
    states, good, reached, *rest = found
    assert (states, good, rest) == ((0, 1, 0, 0, 1, 0, 0, 1, 0), 9, [[], []])
    assert reached == (0.03506, 3.0, [(0.04, TICK, 0.0), (0.04107, 0, 0.03506 + 1e-5)], 4)


def test_an_end_that_falls_into_a_handler_begins_no_wait() -> None:
    """The handler takes 30 µs.

    The WAIT that ends 20 µs after the tick is over only behind the handler. It stays open in a transition that
    has it in its path. The state after that is not known.
    """
    made = polled(True, True)
    both = transition(1, 5.0, open=frozenset({0}))
    learn(made, 0, transition(0, 3.0), (TICK, 0.0))
    learn(made, 0, both, (TICK, 0.0), (0, 2.0))
    made._alone[0, TICK] = transition(0, 3.0)
    end = (0.01 + 2e-5, 0, 0.004)
    walk = made._walk(checkpoint(end, (0.01, TICK, 0.0)), 1.0)
    assert walk is None
    both.state = 0
    walked_once = walked(made, 0.0101, checkpoint((0.01, TICK, 0.0), end))
    assert walked_once == ((0,), 1, (0.01, 5.0, [end, (0.02, TICK, 0.0)], 2), [], [])


def test_a_task_that_polls_adds_the_iterations_before_a_tick() -> None:
    """Iterations of 7 statements of 10 µs begin with the checkpoint.

    The WAIT ends at 0.9 s. The tick at 10 ms comes 997 statements after statement 3, and 3 after 142 iterations.
    The next one comes 998 after statement 997 + 5, and 4 after 142 iterations. The third one comes 996 after
    statement 1996 + 8, and 2 after 142 iterations, which is not known.
    """
    made, end = polled(False), (0.9, 1, 0.1)
    made._periods[0] = 0.0, 7.0
    learn(made, 0, transition(0, 5.0, switches=((4.0, (3, 1)),)), (TICK, 3.0))
    learn(made, 0, transition(0, 8.0), (TICK, 4.0))
    reached = 0.0, 1996.0 + 8, [(0.03, TICK, 0.0), end], 3
    polls = [(0, "main", 994.0), (1, "main", 994.0)]
    found = walked(made, 0.5, checkpoint((0.01, TICK, 0.0), end))
    assert found == ((0, 0), 2, reached, [(0, 0.0, 997.0)], polls)


@cases(
    "other, count, good",
    (
        ((0.02003 + 1e-9, 1, 0.0), 3.0, False),
        ((0.02003 + 3e-9, 1, 0.0), 3.0, True),
        (None, 1000.0 - 1e-4, False),
        (None, 1000.0 - 3e-4, True),
        (None, 1001.0, False),
    ),
)
def test_a_tick_that_comes_next_but_not_alone_is_another_transition(
    other: tuple[float, int, float] | None, count: float, good: bool
) -> None:
    """The tick is at 20 ms, and its handler takes 30 µs.

    Statement 1000 from 10 ms on is at 20 ms, too. Rounding might decide within 2 ns of the end of the handler, or
    of the present statement.
    """
    made = polled(True)
    step = transition(0, 3.0)
    made._alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    dues = ((0.02, TICK, 0.0), *((other,) if other is not None else ()))
    found = walked(made, 0.025, checkpoint(*dues, base=0.01, count=count, number=2))
    assert (found is not None) == good


def test_ticks_that_lead_to_two_states_in_turn_are_not_repeated() -> None:
    made = polled(True, True)
    for state in (0, 1):
        step = transition(1 - state, 3.0)
        made._alone[state, TICK] = step
        learn(made, state, step, (TICK, 0.0))
    found = walked(made, 0.0755, checkpoint((0.02, TICK, 0.0), base=0.01, number=2))
    reached = 0.07, 3.0, [(0.08, TICK, 0.0)], 8
    assert found == ((1, 0, 1, 0, 1, 0), 6, reached, [], [])


def test_a_handler_of_more_than_half_a_period_is_repeated_up_to_the_end_of_a_wait() -> None:
    """It takes 0.6 ms of 1 ms.

    The WAIT ends at 10.5 ms, in the handler of the tick at 10 ms.
    """
    made = polled(True, period=1.0)
    step, end = transition(0, 60.0), (0.0105, 0, 0.001)
    made._alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    found = walked(made, 1.0, checkpoint((0.001, TICK, 0.0), end, count=0.0))
    assert found == ((0,) * 9, 9, (9 * 0.001, 60.0, [(0.01, TICK, 0.0), end], 10), [], [])


def test_a_tick_of_two_seconds_is_repeated() -> None:
    made = polled(True, period=2000.0)
    step = transition(0, 3.0)
    made._alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    found = walked(made, 20.0, checkpoint((4.0, TICK, 0.0), base=2.0, number=2))
    assert found == ((0,) * 8, 8, (18.0, 3.0, [(20.0, TICK, 0.0)], 10), [], [])


def test_a_walk_has_at_most_as_many_transitions_as_counters_may_advance() -> None:
    """The end of a WAIT that does not begin again precedes the ticks."""
    made = polled(True, most=5)
    for index, step in ((TICK, transition(0, 3.0)), (0, transition(0, 2.0, handler=None))):
        made._alone[0, index] = step
        learn(made, 0, step, (index, 0.0))
    found = walked(made, 9.0, checkpoint((0.015, 0, 0.0), (0.02, TICK, 0.0), base=0.01, number=2))
    assert found == ((0,) * 5, 5, (0.05, 3.0, [(0.06, TICK, 0.0)], 6), [], [])


@cases("end, good", ((9.0, False), (9.5, True)))
def test_a_walk_ends_before_a_time(end: float, good: bool) -> None:
    """The tick at 8 s and two statements of 0.5 s end at 9 s."""
    made = polled(True, period=8000.0, cost=0.5)
    step = transition(0, 2.0)
    made._alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    assert (walked(made, end, checkpoint((8.0, TICK, 0.0), count=0.0)) is not None) == good


def test_a_wait_that_begins_while_another_task_polls() -> None:
    """Statements count from the checkpoint, which is statement 3 from 0 s on.

    The WAIT begins with statement 1005 and lasts 15 ms. No iteration is left out.
    """
    made = polled(False)
    begins = transition(0, 1007.0, waits=((1, 1002.0, 1005_000_000 - 3_000_000 + 1_500_000_000),))
    learn(made, 0, begins, (TICK, 997.0))
    found = walked(made, 0.011, checkpoint((0.01, TICK, 0.0)))
    dues = [(0.02, TICK, 0.0), (0.02505, 1, 1005 * 1e-5)]
    assert found == ((0,), 1, (0.0, 1010.0, dues, 2), [], [])


def ticks(*gaps: tuple[int, float, int, float], most: int = 10**9, period: float = 10.0) -> Any:
    """Return transitions by state and gap: the next state and the length."""
    made = polled(*[False] * 3, most=most, period=period)
    for state, gap, after, length in gaps:
        switches = ((1.0, (3, 1)),) if after == 2 else ()
        made._gaps.setdefault(state, {})[gap] = transition(after, length, switches=switches)
    return made


@cases(
    "gaps, end, most, states, good, count, switching",
    (
        # The ticks are 1000 statements apart. From statement 3 the first one comes after 997.
        (((0, 997.0, 0, 1002.0), (0, 995.0, 0, 1000.0)), 0.0301, 99, (0, 0, 0), 3, 3005.0, []),
        (((0, 997.0, 0, 1002.0), (0, 995.0, 0, 1000.0)), 0.0301, 2, (0, 0), 2, 2005.0, []),
        # A transition that ends with statement 3005, at 30.05 ms, is none before 30.05 ms.
        (((0, 997.0, 0, 1002.0), (0, 995.0, 0, 1000.0)), 0.03005, 99, (0, 0), 2, 2005.0, []),
        (((0, 997.0, 0, 1002.0), (0, 995.0, 0, 1000.0)), 0.03006, 99, (0, 0, 0), 3, 3005.0, []),
        (((0, 997.0, 0, 1002.0), (0, 995.0, 1, 1000.0)), 0.5, 99, (0, 1), 1, 1005.0, []),
        (((0, 997.0, 0, 1002.0),), 0.5, 99, (0,), 1, 1005.0, []),
        (((0, 997.0, 2, 1001.0), (2, 996.0, 0, 1003.0)), 0.5, 99, (2, 0), 2, 2007.0, [(0, 0.0, 3.0)]),
        (((0, 997.0, 2, 1001.0), (2, 997.0, 0, 1003.0)), 0.5, 99, None, 0, 0.0, []),
        (((0, 996.0, 0, 1001.0), (0, 998.0, 0, 1001.0)), 0.5, 99, None, 0, 0.0, []),
        (((1, 997.0, 0, 1002.0),), 0.5, 99, None, 0, 0.0, []),
    ),
)
def test_a_walk_along_ticks_between_which_a_task_polls(
    gaps: tuple[tuple[int, float, int, float], ...],
    end: float,
    most: int,
    states: tuple[int, ...] | None,
    good: int,
    count: float,
    switching: list[tuple[int, float, float]],
) -> None:
    """The present state is 0, at statement 3 of 10 µs. The first tick comes at 10 ms."""
    found = walked(ticks(*gaps, most=most), end, checkpoint((0.01, TICK, 0.0)), by_tick=True)
    reached = 0.0, count, [((good + 1) * (10 / 1000.0), TICK, 0.0)], good + 1
    assert found == (None if states is None else (states, good, reached, switching, []))


def test_a_walk_ends_before_a_transition_that_is_not_proved() -> None:
    made = ticks((0, 997.0, 0, 1002.0), (0, 995.0, 0, 1000.0))
    made._gaps[0][995.0].is_proved = False
    found = walked(made, 0.5, checkpoint((0.01, TICK, 0.0)), by_tick=True)
    assert found == ((0,), 1, (0.0, 1005.0, [(0.02, TICK, 0.0)], 2), [], [])


@pytest.mark.parametrize(("cost", "period"), [(1e-5, 1.0), (0.7310585e-5, 1.0), (3e-6, 2.0), (4e-5, 33.0)])
def test_a_walk_finds_the_statement_of_each_tick(cost: float, period: float) -> None:
    """The gap to a tick ends with the least statement that is not before it.

    Each handler takes 2 statements, and each gap is known.
    """
    made = polled(False, cost=cost, period=period)
    most = round(period / 1000 / cost)
    made._gaps[0] = {float(gap): transition(0, gap + 2.0) for gap in range(most - 4, most + 3)}
    count, lengths = 0.0, []
    for number in range(1, 301):
        moment = number * (period / 1000.0)
        first = next(each for each in range(int(moment / cost) - 2, 10**9) if each * cost >= moment)
        lengths.append(first - count + 2.0)
        count = first + 2.0
    walk = made._walk_ticks(checkpoint((period / 1000.0, TICK, 0.0), count=0.0), (period * 300.5) / 1000.0)
    assert walk is not None
    assert [step.length for step in walk.steps] == lengths


@cases(
    "known, first, last, base, dues, counts, periods",
    (
        ((), 10.0, 17.0, 0.0, 2, False, {0: (7.0, 7.0)}),
        ((), 3.0, 17.0, 0.0, 2, False, {0: (0.0, 14.0)}),
        ((), 2.0, 17.0, 0.0, 2, False, {}),
        ((), 10.0, 17.0, 1e-5, 2, False, {}),
        ((), 10.0, 17.0, 0.0, 1, False, {}),
        ((), 10.0, 1000.0, 0.0, 2, False, {0: (7.0, 990.0)}),
        ((), 10.0, 1001.0, 0.0, 2, False, {}),
        (((5.0, 2.0),), 10.0, 17.0, 0.0, 2, False, {0: (5.0, 2.0)}),
        (((7.0, 3.0),), 10.0, 17.0, 0.0, 2, False, {0: (7.0, 3.0)}),
        (((8.0, 3.0),), 10.0, 17.0, 0.0, 2, False, {0: (7.0, 7.0)}),
        ((), 10.0, 17.0, 0.0, 2, True, {0: None}),
        ((None,), 10.0, 17.0, 0.0, 2, False, {0: None}),
    ),
)
def test_the_earliest_period_of_a_task_that_polls_is_stored(
    known: tuple[tuple[float, float] | None, ...],
    first: float,
    last: float,
    base: float,
    dues: int,
    counts: bool,
    periods: dict[int, tuple[float, float] | None],
) -> None:
    """It lies between statement 3, the checkpoint, and statement 1000, the tick.

    Another task must be in a WAIT. A loop that counts has no period.
    """
    made = polled(False)
    made._periods.update(enumerate(known))
    made._counters.loops_count = lambda steps: counts
    before = checkpoint(*((0.01, TICK, 0.0), (0.9, 1, 0.1))[:dues])
    made._learn_period(before, (), base, first, last)
    assert made._periods == periods


def test_two_tasks_that_poll_have_no_period() -> None:
    made = polled(True)
    made._learn_period(checkpoint((0.01, TICK, 0.0), (0.9, 1, 0.1)), (), 0.0, 10.0, 17.0)
    assert made._periods == {}


@cases(
    "dues, base, origin, path",
    (
        ((0.01,), 0.0, 3.0, [1000.0]),
        ((0.01, 0.01005), 0.0, 3.0, [1000.0, 1005.0]),
        ((0.01, 0.0101 + 1.9e-9), 0.0, 3.0, None),
        ((0.01, 0.0101 + 2.1e-9), 0.0, 3.0, [1000.0]),
        ((0.01, 0.0101, 0.0102), 0.0, 1010.0, [1000.0, 1010.0]),
        ((0.01,), 0.0, 1011.0, None),
        ((0.01,), 1e-5, 3.0, None),
    ),
)
def test_the_path_of_a_transition_has_the_ticks_and_ends_in_it(
    dues: tuple[float, ...], base: float, origin: float, path: list[float] | None
) -> None:
    """The transition ends with statement 1010, at 10.1 ms.

    The first of `dues` is a tick, the others ends.
    """
    given = [(moment, TICK if k == 0 else k, 0.0) for k, moment in enumerate(dues)]
    after = checkpoint((0.02, TICK, 0.0), count=1010.0, number=2)
    found = polled(False)._path(checkpoint(*given), after, base, origin)
    assert found == (None if path is None else list(zip(given, path, strict=False)))


def learned(
    dues: tuple[tuple[float, int, float], ...] = ((0.01, TICK, 0.0),),
    later: tuple[tuple[float, int, float], ...] = ((0.02, TICK, 0.0),),
    handlers: tuple[float, ...] = (0.01,),
    outputs: tuple[float, ...] = (),
    slices: tuple[tuple[tuple[str, ...], tuple[float, ...]], ...] = (),
    ticks: int = 1,
    origin: float = 997.0,
    cost_units: int = 1_000_000,
    path: int | None = None,
) -> tuple[object, ...] | None:
    """Return the fields of the transition from statement 3 to statement 1010.

    Each stream has a record from before it. `handlers` and `outputs` are the times of further ones.
    """
    made = polled(False)
    made._cost_units = cost_units
    streams: Any = (
        [(0.0, "event")] + [(time, *HANDLER) for time in handlers],
        [(0.0, 1, 0)] + [(time, 3, 1) for time in outputs],
        [(0.0, 0.5, ("main",), (9.0,))] + [(0.0, 0.5, *each) for each in slices],
    )
    made._streams = streams
    before = checkpoint(*dues)
    before.lengths = [1, 1, 1]
    after = _Checkpoint(4, 0.0, 1010.0, list(later), 1 + ticks, ())
    passed = [(due, 0.0) for due in dues[:path]]
    step = made._transition(before, after, origin, passed, (0.0, 2.0))
    if step is None:
        return None
    assert (step.state, step.length, step.steps, step.is_proved) == (4, 1010.0 - origin, (0.0, 2.0), False)
    return step.handler, step.switches, step.waits, set(step.open), step.seconds


END, NEW = (0.01002, 1, 0.004), (0.02505, 1, 1005 * 1e-5)
NEXT = (0.02, TICK, 0.0)


@cases(
    "given, effects",
    (
        ({}, (HANDLER, (), (), set(), {})),
        ({"handlers": ()}, None),
        ({"handlers": (0.01, 0.01)}, None),
        ({"handlers": (0.010000001,)}, None),
        ({"handlers": (0.01, 0.02), "ticks": 2}, None),
        ({"handlers": (), "ticks": 0, "dues": (NEXT,), "path": 0}, (None, (), (), set(), {})),
        # Outputs are switched by statements 997, 1001 and 996.
        (
            {"outputs": (997 * 1e-5, 1001 * 1e-5)},
            (HANDLER, ((0.0, (3, 1)), (4.0, (3, 1))), (), set(), {}),
        ),
        ({"outputs": (996 * 1e-5,)}, None),
        ({"outputs": (0.010005,)}, None),
        ({"outputs": (0.01,) * 64}, (HANDLER, ((3.0, (3, 1)),) * 64, (), set(), {})),
        ({"outputs": (0.01,) * 65}, None),
        # A WAIT of 15 ms begins with statement 1005, 8 after the origin; the statements before take 997 * 10 µs.
        (
            {"dues": ((0.01, TICK, 0.0), END), "later": (NEXT, NEW)},
            (HANDLER, (), ((1, 8.0, 2_505_000_000 - 997_000_000),), set(), {}),
        ),
        ({"later": (NEXT, NEW)}, (HANDLER, (), ((1, 8.0, 2_505_000_000 - 997_000_000),), set(), {})),
        ({"later": (NEXT, NEW), "cost_units": 0}, None),
        ({"later": (NEXT, NEW), "origin": 1005.0}, (HANDLER, (), ((1, 0.0, 1_500_000_000),), set(), {})),
        ({"later": (NEXT, NEW), "origin": 1006.0}, None),
        ({"later": (NEXT, (0.02505, 1, 0.0100503))}, None),
        ({"later": (NEXT, (0.02 + 1e-6 / 3, 1, 1005 * 1e-5))}, None),
        # A WAIT that has ended in the handler and is not over, one that goes on, and one that ended elsewhere.
        ({"dues": ((0.01, TICK, 0.0), END), "later": (NEXT, END)}, (HANDLER, (), (), {1}, {})),
        (
            {"dues": ((0.01, TICK, 0.0), (0.3, 1, 0.0)), "later": (NEXT, (0.3, 1, 0.0)), "path": 1},
            (HANDLER, (), (), set(), {}),
        ),
        ({"dues": ((0.01, TICK, 0.0), END), "later": (NEXT,)}, (HANDLER, (), (), set(), {})),
        ({"dues": ((0.01, TICK, 0.0), END), "later": (NEXT,), "path": 1}, None),
        ({"dues": ((0.01, TICK, 0.0), END), "later": (NEXT, NEW), "path": 1}, None),
        ({"dues": ((0.01, TICK, 0.0),), "path": 0}, None),
        # The task that polls has computed from the checkpoint on, 994 statements before the origin.
        (
            {"slices": ((("main", "T1"), (0.02, 0.5)), (("T1",), (0.25,)))},
            (HANDLER, (), (), set(), {"main": 0.02 - 994 * 1e-5, "T1": 0.75}),
        ),
        ({"slices": ((("T1",), (0.25,)),)}, (HANDLER, (), (), set(), {"T1": 0.25})),
    ),
)
def test_the_effects_between_two_checkpoints(
    given: dict[str, Any], effects: tuple[object, ...] | None
) -> None:
    """None if they cannot be repeated.

    This may be an inexact time, two ticks, too many switches or an unexpected end.
    """
    assert learned(**given) == effects


def test_a_wait_after_a_tick_while_all_tasks_wait() -> None:
    """The tick at 10 ms is the base. The WAIT of 15 ms begins 2 statements later."""
    made = polled(True)
    streams: Any = ([(0.01, *HANDLER)], [], [])
    made._streams, made._environment.statements.base = streams, 0.01
    tick, begun = (0.01, TICK, 0.0), (0.02502, 1, 0.01 + 2 * 1e-5)
    before, after = checkpoint(tick), checkpoint(NEXT, begun, base=0.01, count=5.0, number=2)
    before.lengths = [0, 0, 0]
    step = made._transition(before, after, 0.0, [(tick, 0.0)], ())
    assert step is not None
    assert (step.waits, step.length) == (((1, 2.0, 1_502_000_000),), 5.0)


def test_a_transition_without_counts_advances_no_counter() -> None:
    made = polled(False)
    streams: Any = ([(0.01, *HANDLER)], [], [])
    made._streams = streams
    before, after = checkpoint((0.01, TICK, 0.0)), checkpoint(NEXT, count=1010.0, number=2)
    before.lengths = [0, 0, 0]
    step = made._transition(before, after, 3.0, [((0.01, TICK, 0.0), 1000.0)], (0.0, 0.0))
    assert step is not None
    assert step.steps == ()


class Stream(list[Any]):
    """A stream of a log; a template is stored as it is given."""

    add = list.append

    def repeat(self, shape: object, pace: object) -> None:
        self.append((shape, pace))


class Passed:
    """A program before a walk, and everything that the walk has set.

    Task 0 polls. Task 1 has been in a WAIT of 5 ms since 4 ms. The timer has had 3 ticks, and has a period of 10
    ms.
    """

    def __init__(self, names: tuple[str, ...] = ("main", "T1")) -> None:
        self.reached, self.scheduled, self.counted = list[object](), list[int](), list[object]()
        self.made = made = polled(False)
        environment, events, counters = self.parts()
        made._environment, made._events, made._counters = environment, events, counters
        made._log = self.log = SimpleNamespace(events=Stream(), outputs=Stream(), slices=Stream())
        made._streams = self.log.events, self.log.outputs, self.log.slices
        made._others = []
        made._observed, made._back_off = 20, 8
        made._last = _Checkpoint(0, 0.0, 3.0, [(0.009, 1, 0.004), (0.04, TICK, 0.0)], 4, (5.0, 7.0))
        wait: Any = SimpleNamespace(since=0.004, ends=0.009)
        tasks = [SimpleNamespace(name="main", wait=None), SimpleNamespace(name="T1", wait=wait)][: len(names)]
        self.scheduler: Any = SimpleNamespace(tasks=tasks)

    def parts(self) -> tuple[Any, Any, Any]:
        clock = SimpleNamespace(now=0.0305, leaps=4, fired=77, reach=self.reached.append)
        statements = StatementTime(1e-5)
        statements.leave(3.0)
        environment = SimpleNamespace(
            statements=statements, clock=clock, fired=0, acts=50, switches=11, copies=3, midways=4
        )
        events = SimpleNamespace(
            started=0.0,
            timer=10.0,
            ticks=4,
            tick_event="tick",
            schedule_tick=self.scheduled.append,
            environment=environment,
        )
        counters = SimpleNamespace(set=self.counted.append, sides=lambda: [1, -1])
        return environment, events, counters


def walk_of(*steps: Transition, good: int, reached: Any, switching: Any = (), polling: Any = ()) -> _Walk:
    walk = _Walk()
    walk.steps, walk.good, walk.reached = list(steps), good, reached
    walk.switching, walk.polling = list(switching), list(polling)
    return walk


def test_a_walk_passes_with_all_its_effects() -> None:
    """Two ticks, at 40 ms and 50 ms, and a WAIT pass.

    The third tick of the walk is not good. The first transition adds 2 to the first counter, and the third one,
    which is the same, too. It switches output 3 after 4 statements, and takes 10 µs of task T1. Task "other"
    polls for 900 statements before the second transition, and "main" for 100 before the third one.
    """
    program = Passed()
    tick = transition(0, 9.0, switches=((4.0, (3, 1)),), steps=(2.0, 0.0), seconds={"T1": 1e-5, "main": 5e-5})
    wait = transition(0, 9.0, handler=None, waits=((1, 2.0, 500),), seconds={"main": 2e-5})
    dues = [(0.052, 1, 0.047), (0.06, TICK, 0.0)]
    walk = walk_of(
        *(tick, wait, tick, tick),
        good=3,
        reached=(0.05, 12.0, dues, 6),
        switching=[(0, 0.04, 2.0), (2, 0.05, 1.0), (3, 0.06, 1.0)],
        polling=[(1, "other", 900.0), (2, "main", 100.0), (3, "main", 77.0)],
    )
    program.made._pass(walk, program.scheduler)
    made, clock, log = program.made, program.made._environment.clock, program.log
    now = 0.05 + 12 * 1e-5
    assert (clock.now, clock.leaps, made._environment.fired) == (now, 5, 77)
    statements = made._environment.statements
    assert (statements.base, statements.count, statements.reached) == (0.05, 12.0, now)
    assert (program.reached, program.scheduled, program.counted) == (["tick"], [6], [(9.0, 7.0)])
    assert log.events == [(4 * 0.01, *HANDLER), (5 * 0.01, *HANDLER)]
    assert log.outputs == [(0.04 + 6 * 1e-5, 3, 1), (0.05 + 5 * 1e-5, 3, 1)]
    ((since, until, tasks, seconds),) = log.slices
    assert (since, until, tasks) == (0.0305, now, ("T1", "main", "other"))
    assert seconds == pytest.approx((2e-5, 2 * 5e-5 + 2e-5 + 100 * 1e-5, 900 * 1e-5), rel=1e-12)
    waiting = program.scheduler.tasks[1].wait
    assert (waiting.since, waiting.ends) == (0.047, 0.052)
    last = made._last
    assert last is not None
    assert (last.state, last.base, last.count, last.dues, last.number) == (0, 0.05, 12.0, dues, 6)
    assert (last.values, last.lengths) == ((9.0, 7.0), [2, 2, 1])
    assert (made._observed, made._back_off) == (17, 8)
    # Events, acts less switches less ticks, copies, interrupted expressions, the timer, the tasks and the counters.
    assert made._since == (77 - 2 * 4, 50 - 11 - 4, 3, 4, 0.0, 10.0, 2, 1, -1)


def test_a_task_alone_has_no_time_slices() -> None:
    program = Passed(("main",))
    step = transition(0, 9.0, handler=None, seconds={"main": 1e-5})
    program.made._pass(walk_of(*[step] * 20, good=20, reached=(0.0, 12.0, [NEXT], 4)), program.scheduler)
    assert (program.log.events, program.log.outputs, program.log.slices) == ([], [], [])
    assert (program.reached, program.scheduled) == ([], [])
    assert program.counted == [(5.0, 7.0)]
    assert (program.made._observed, program.made._back_off) == (0, 1)


def test_tasks_that_have_not_computed_have_no_time_slices() -> None:
    program = Passed()
    program.made._pass(walk_of(transition(0, 9.0), good=1, reached=(0.04, 9.0, [NEXT], 5)), program.scheduler)
    assert program.log.slices == []
    assert program.log.events == [(0.04, *HANDLER)]


@pytest.mark.parametrize("count", [1, 15, 16, 40])
def test_sixteen_equal_handlers_in_a_row_are_a_template(count: int) -> None:
    """One of another position precedes them, and two follow.

    The first one is that of tick 4.
    """
    program = Passed()
    one, other = (("handler", 1),), (("handler", 2),)
    program.made._log_handlers([other, *[one] * count, other, other])
    plain = [(4 * 0.01, *other)]
    after = [((5 + count) * 0.01, *other), ((6 + count) * 0.01, *other)]
    if count < 16:
        assert program.log.events == plain + [((5 + k) * 0.01, *one) for k in range(count)] + after
    else:
        template = ([(0, (0.0,), one)], count, 1, 0.0), (0.0, 5, 0.01, 1e-5)
        assert program.log.events == [*plain, template, *after]


# What allows a search, and what ends it.
REGULAR: dict[str, Any] = {
    "events.active": [], "events.pending": [], "events.tick_event": "tick",
    "scheduler.interrupts": [], "scheduler.pace": None, "scheduler.outside": None, "task.busy": 0.0,
    "task.suspended": False, "machine.hook": None, "machine.assumptions": {}, "clock.now": 1.0, "outputs.listeners": [],
}  # fmt: skip
IRREGULAR: dict[str, Any] = {
    "events.active": [1], "events.pending": [1], "events.tick_event": None,
    "scheduler.interrupts": [1], "scheduler.pace": print, "scheduler.outside": print, "task.busy": 0.5,
    "task.suspended": True, "machine.hook": print, "machine.assumptions": {"a": 1}, "clock.now": 1.5,
    "outputs.listeners": [1],
}  # fmt: skip


@pytest.mark.parametrize("name", ["nothing", *IRREGULAR])
def test_what_may_act_from_outside_ends_the_search(name: str) -> None:
    given = {**REGULAR, name: IRREGULAR[name]} if name in IRREGULAR else REGULAR
    parts: dict[str, Any] = {}
    for key, value in given.items():
        owner, _, field = key.partition(".")
        setattr(parts.setdefault(owner, SimpleNamespace()), field, value)
    plain = SimpleNamespace(busy=0.0, suspended=False)
    made, scheduler = polled(False), parts["scheduler"]
    scheduler.tasks = [plain, parts["task"]]
    statements: Any = SimpleNamespace(reached=1.0)
    controller = SimpleNamespace(outputs=parts["outputs"])
    made._events = parts["events"]
    made._environment = SimpleNamespace(
        machine=parts["machine"], statements=statements, clock=parts["clock"], controller=controller
    )
    assert made._is_regular(scheduler) == (name == "nothing")


class Search:
    """A search whose steps are recorded instead of executed, and its scheduler."""

    def __init__(self, **given: Any) -> None:
        self.calls = list[object]()
        self.made = made = polled(False)
        read = {1}
        self.environment: Any = SimpleNamespace(dependencies=SimpleNamespace(read=read))
        made._environment = self.environment
        made._left = made._observed = 0
        made._since, made._read, made._numbers = (7,), read, {}
        made._last, made._has_waits, made._back_off = checkpoint(NEXT), False, 4
        self.is_regular, self.scheduler = True, SimpleNamespace(is_observed=True)
        made._is_regular = lambda scheduler: self.is_regular
        made._marks = lambda scheduler: (7,)
        for name in ("forget", "begin", "observe", "skip"):
            setattr(made, f"_{name}", lambda given, name=name: self.calls.append(name))
        for name, value in given.items():
            setattr(made, name, value)

    def reach(self, by_tick: bool = True, polls: bool = True) -> list[object]:
        self.made.reached(self.scheduler, by_tick, polls)
        return self.calls


def test_ticks_of_a_pause_are_executed() -> None:
    """A WAIT that begins is no tick, and nothing is observed."""
    search = Search(_left=2)
    for by_tick, left in ((False, 2), (True, 1), (True, 0)):
        assert search.reach(by_tick) == []
        assert (search.made._left, search.made.is_searching) == (left, left == 0)
        assert not search.scheduler.is_observed
    assert search.reach() == ["observe", "skip"]


def test_a_search_needs_tasks_that_poll_and_nothing_else() -> None:
    assert Search().reach(polls=False) == ["forget"]
    search = Search()
    search.is_regular = False
    assert search.reach() == ["forget"]
    assert search.made._observed == 0


@pytest.mark.parametrize(
    ("given", "begins"),
    [
        ({}, False),
        ({"_since": (8,)}, True),
        ({"_read": {1}}, True),
        ({"_numbers": dict.fromkeys(range(1000))}, False),
        ({"_numbers": dict.fromkeys(range(1001))}, True),
    ],
)
def test_what_else_has_changed_begins_another_search(given: dict[str, Any], begins: bool) -> None:
    assert Search(**given).reach() == [*["begin"] * begins, "observe", "skip"]


@cases(
    "dues, has_waits, is_observed",
    (
        ((NEXT,), False, False),
        ((NEXT, END), False, True),
        ((NEXT,), True, True),
        (None, True, True),
    ),
)
def test_waits_are_observed_once_a_task_has_been_in_one(
    dues: tuple[tuple[float, int, float], ...] | None, has_waits: bool, is_observed: bool
) -> None:
    """If a state cannot be compared, nothing changes."""
    search = Search(_last=dues and checkpoint(*dues), _has_waits=has_waits)
    assert search.reach() == (["observe"] if dues is None else ["observe", "skip"])
    assert (search.scheduler.is_observed, search.made._has_waits) == (is_observed, is_observed)


@cases("back_off, after", ((1, 2), (4, 8), (256, 512), (512, 512)))
def test_after_48_checkpoints_without_a_skip_the_search_pauses(back_off: int, after: int) -> None:
    search = Search(_observed=47, _back_off=back_off)
    assert search.reach() == ["observe", "skip"]
    assert search.reach() == ["observe", "skip", "forget"]
    assert (search.made._observed, search.made._left, search.made._back_off) == (0, back_off, after)


def test_states_are_forgotten_once() -> None:
    made, ended = polled(False), list[object]()
    made._environment.dependencies = SimpleNamespace(end_longest=ended.append)
    made._read, made._since, made._last = {1}, (7,), checkpoint(NEXT)
    scheduler = SimpleNamespace(is_observed=True)
    for _ in range(2):
        made._forget(scheduler)
        assert (made._read, made._since, made._last, scheduler.is_observed) == (None, (), None, False)
    assert ended == [{1}]


class Program:
    """Two tasks, one with a WAIT, and the states that are found."""

    def __init__(self, *waits: Any) -> None:
        self.made = made = polled()
        made._alive, made._numbers = {}, {}
        made._streams = [1, 2], [1], []
        self.environment: Any = made._environment
        self.environment.statements.base, self.environment.statements.count = 0.5, 12.0
        self.outputs = SimpleNamespace(values=((1, 1.0),))
        self.environment.controller = SimpleNamespace(outputs=self.outputs)
        self.environment.state = lambda alive: b"shared"
        self.hidden = list[object]()
        made._counters = SimpleNamespace(hide=lambda: (5.0, 7.0), set=self.hidden.append)
        made._events.ticks = 3
        self.tasks = [self.task(f"T{k}", wait) for k, wait in enumerate(waits)]
        self.scheduler = SimpleNamespace(tasks=self.tasks, current=self.tasks[0], next_index=1)

    @staticmethod
    def task(name: str, wait: Any) -> Any:
        return SimpleNamespace(
            name=name, wait=wait, delay=wait, priority=0, max_slice=0.5, state=lambda alive: b"own"
        )

    def state(self) -> int | None:
        found = self.made._checkpoint(self.scheduler)
        return None if found is None else found.state


def delay(end: float, since: float) -> Any:
    return SimpleNamespace(ends=end, since=since)


def test_a_checkpoint_has_its_state_and_its_times() -> None:
    """Tick 3 of 10 ms is the next one; the WAIT of task T1 ends before it."""
    program = Program(None, delay(0.025, 0.005), None)
    found = program.made._checkpoint(program.scheduler)
    assert found is not None
    assert (found.state, found.base, found.count, found.number) == (0, 0.5, 12.0, 3)
    assert found.dues == [(0.025, 1, 0.005), (0.03, TICK, 0.0)]
    assert (found.values, found.lengths, program.hidden) == ((5.0, 7.0), [2, 1, 0], [(5.0, 7.0)])
    assert (program.made._are_idle, program.made._polling) == ([False], [""])


@cases(
    "waits, is_idle, polling",
    (
        ((None, delay(0.9, 0.1)), False, "T0"),
        ((delay(0.9, 0.1), None), False, "T1"),
        ((None, None), False, ""),
        ((delay(0.9, 0.1), delay(0.8, 0.1)), True, ""),
    ),
)
def test_a_state_knows_the_task_that_polls(waits: tuple[Any, ...], is_idle: bool, polling: str) -> None:
    program = Program(*waits)
    assert [program.state() for _ in range(3)] == [0, 0, 0]
    assert (program.made._are_idle, program.made._polling) == ([is_idle], [polling])


def no_state(program: Program) -> None:
    program.tasks[1].state = lambda alive: None


def other_current(program: Program) -> None:
    program.scheduler.current = program.tasks[1]


def handler_current(program: Program) -> None:
    program.scheduler.current = "a handler"


def other_next(program: Program) -> None:
    program.scheduler.next_index = 0


def switched(program: Program) -> None:
    program.outputs.values = ((1, 0.0),)


def assigned(program: Program) -> None:
    program.environment.state = lambda alive: b"others"


def moved(program: Program) -> None:
    program.tasks[1].state = lambda alive: b"another line"


def raised(program: Program) -> None:
    program.tasks[1].priority = 1


def shortened(program: Program) -> None:
    program.tasks[0].max_slice = 0.25


def waiting(program: Program) -> None:
    program.tasks[0].wait = program.tasks[0].delay = delay(0.9, 0.1)


def paused(program: Program) -> None:
    program.tasks[1].delay = None


def later(program: Program) -> None:
    program.tasks[1].wait.ends, program.tasks[1].wait.since = 0.95, 0.15


@cases(
    "change, states",
    (
        (later, [0, 0]),
        (no_state, [0, None]),
        *(
            (each, [0, 1])
            for each in (
                *(other_current, handler_current, other_next, switched, assigned, moved, raised, shortened),
                *(waiting, paused),
            )
        ),
    ),
)
def test_states_differ_in_all_that_decides_what_follows(
    change: Callable[[Program], None], states: list[int | None]
) -> None:
    """The end of a WAIT is no part of the state."""
    program = Program(None, delay(0.9, 0.1))
    found = [program.state()]
    change(program)
    assert [*found, program.state()] == states


def test_another_wait_is_part_of_the_state_with_its_end() -> None:
    """The wait for a condition is the same object as long as it lasts."""
    program = Program(None, SimpleNamespace(ends=None))
    program.tasks[1].delay = None
    assert [program.state(), program.state()] == [0, 0]
    assert program.tasks[1].wait in program.made._alive.values()
    program.tasks[1].wait.ends = 0.5
    assert program.state() == 1
    program.tasks[1].wait = SimpleNamespace(ends=0.5)
    assert program.state() == 2


class Observed:
    """A search that observes given checkpoints and transitions."""

    def __init__(self, *idle: bool, set_steps: Callable[[tuple[float, ...]], list[float]] = list) -> None:
        self.made = made = polled(*idle)
        made._last, made._advance = None, None
        self.recorded, self.loops = list[object](), False
        made._counters = SimpleNamespace(
            steps_of_set=set_steps,
            loops_count=lambda steps: self.loops,
            record=self.recorded.append,
        )

    def observe(self, after: _Checkpoint | None, step: Transition | None) -> None:
        made = self.made
        made._checkpoint = lambda scheduler: after
        made._transition = lambda *given: step
        if after is not None:
            made._environment.clock.now = after.base + after.count * 1e-5
        made._observe(None)


def at(
    state: int, count: float, *dues: tuple[float, int, float], base: float = 0.0, number: int = 1
) -> _Checkpoint:
    return _Checkpoint(state, base, count, list(dues), number, ())


def test_a_transition_between_ticks_is_known_by_its_state_and_gap() -> None:
    """From statement 3 the tick at 10 ms comes after 997 statements.

    The task polls without a WAIT.
    """
    search, step = Observed(False), transition(0, 1002.0)
    made = search.made
    search.observe(at(0, 3.0, (0.01, TICK, 0.0)), None)
    assert (made._known, search.recorded) == ({}, [])
    search.observe(at(0, 1005.0, NEXT, number=2), step)
    assert made._gaps == {0: {997.0: step}}
    assert made._known[0].transition is None
    assert made._known[0].next[TICK, 997.0].transition is step
    assert (made._alone, step.is_proved, search.recorded) == ({}, True, [()])


def test_a_tick_while_all_tasks_wait_is_known_by_its_state_alone() -> None:
    """It is not if the statements count from before it."""
    for base, alone in ((0.01, True), (0.0, False)):
        search, step = Observed(True), transition(0, 3.0)
        search.observe(at(0, 3.0, (0.01, TICK, 0.0)), None)
        if not alone:
            search.made._origin = lambda *given: (0.0, 3.0)
        search.observe(at(0, 3.0 if alone else 1005.0, NEXT, base=base, number=2), step)
        assert search.made._alone == ({(0, TICK): step} if alone else {})
        assert search.made._gaps == {}


def test_a_wait_that_begins_before_the_tick_has_an_empty_path() -> None:
    """Statement 500 is at 5 ms, the tick at 10 ms.

    So no iteration of 7 statements is left out.
    """
    search, step = Observed(False), transition(0, 497.0, handler=None)
    search.made._periods[0] = 0.0, 7.0
    dues = (0.01, TICK, 0.0), (0.9, 1, 0.1)
    search.observe(at(0, 3.0, *dues), None)
    search.observe(at(0, 500.0, *dues), step)
    assert search.made._known[0].transition is step
    assert search.made._known[0].next == {}
    assert (search.made._gaps, search.made._alone) == ({}, {})


def test_a_tick_within_rounding_is_in_the_path() -> None:
    """Statement 1000 is 1 ns before the tick.

    Iterations of 7 statements leave 4 up to statement 1001.
    """
    search = Observed(False)
    search.made._periods[0] = 0.0, 7.0
    dues = (0.01 + 1e-9, TICK, 0.0), (0.9, 1, 0.1)
    search.observe(at(0, 3.0, *dues), None)
    search.observe(at(0, 1000.0, *dues), transition(0, 3.0))
    assert [*search.made._known[0].next] == [(TICK, 4.0)]


def test_the_steps_of_counters_are_recorded() -> None:
    search = Observed(False)
    before, after = at(0, 3.0, (0.01, TICK, 0.0)), at(0, 1005.0, NEXT, number=2)
    before.values, after.values = (5.0, 7.0), (8.0, 7.0)
    search.observe(before, None)
    search.observe(after, transition(0, 1002.0))
    assert search.recorded == [(3.0, 0.0)]


def test_a_transition_with_a_wait_is_no_gap() -> None:
    search, step = Observed(False), transition(0, 1002.0)
    search.observe(at(0, 3.0, (0.01, TICK, 0.0)), None)
    search.observe(at(0, 1005.0, NEXT, (0.5, 1, 0.1), number=2), step)
    assert search.made._gaps == {}
    search.observe(at(0, 2005.0, (0.03, TICK, 0.0), number=3), step)
    assert search.made._gaps == {}
    assert len(search.made._known[0].next) == 2


def test_a_transition_that_cannot_be_recorded_is_left_out() -> None:
    search, step = Observed(False), transition(0, 1002.0)
    search.observe(at(0, 3.0, (0.01, TICK, 0.0)), step)
    search.observe(None, step)  # a state that cannot be compared
    search.observe(at(0, 3.0, (0.01, TICK, 0.0)), step)
    search.observe(at(0, 1005.0, NEXT, base=0.5, number=2), step)
    search.observe(at(0, 2005.0, NEXT, base=0.5, number=2), None)
    assert (search.made._known, search.recorded) == ({}, [])


def test_a_loop_that_counts_has_no_transition_from_its_last_iteration() -> None:
    """142 iterations of 7 statements, which are 994, are left out."""
    for loops in (False, True):
        search = Observed(False)
        search.made._periods[0], search.loops = (0.0, 7.0), loops
        search.observe(at(0, 3.0, (0.01, TICK, 0.0), (0.9, 1, 0.1)), None)
        search.observe(at(0, 1005.0, NEXT, (0.9, 1, 0.1), number=2), transition(0, 8.0))
        assert [*search.made._known] == [] if loops else [0]
        if not loops:
            assert [*search.made._known[0].next] == [(TICK, 3.0)]
    search = Observed(False)
    search.loops = True
    search.observe(at(0, 3.0, (0.01, TICK, 0.0)), None)
    search.observe(at(0, 1005.0, NEXT, number=2), transition(0, 1002.0))
    assert [*search.made._known[0].next] == [(TICK, 997.0)]  # no iteration is left out


def seen_in_turn(*steps: Transition, gaps: tuple[float, ...], **given: Any) -> Observed:
    """Observe transitions from state 0 to itself.

    `gaps` are the statements up to the next tick; a period has 1000.
    """
    search = Observed(False, **given)
    for number, (gap, step) in enumerate(zip(gaps, (None, *steps), strict=False)):
        moment = (number + 1) * 0.01
        count = 1000.0 * (number + 1) - gap
        search.observe(at(0, count, (moment, TICK, 0.0), number=number + 1), step)
    return search


def test_a_counter_that_the_handler_sets_must_advance_equally() -> None:
    """A transition is proved when it has been executed twice.

    If no such counter advances, it is proved at once.
    """
    one, again = (transition(0, 1000.0, steps=(1.0,)) for _ in range(2))
    search = seen_in_turn(one, gaps=(997.0, 997.0))
    assert (one.is_proved, search.made._advance) == (False, [1.0])
    search = seen_in_turn(one, again, gaps=(997.0, 997.0, 997.0))
    assert (one.is_proved, search.made._advance) == (True, [1.0])
    assert (search.made._gaps, search.recorded) == ({0: {997.0: one}}, [()])
    search = seen_in_turn(transition(0, 1000.0, steps=(0.0,)), gaps=(997.0, 997.0))
    assert search.made._gaps[0][997.0].is_proved


@cases(
    "other, gap, is_known, advance",
    (
        (transition(0, 1001.0, steps=(1.0,)), 996.0, True, [1.0]),
        (transition(0, 1001.0, steps=(2.0,)), 996.0, False, None),
        (transition(0, 1001.0, steps=()), 996.0, False, None),
        (transition(0, 1001.0, steps=(2.0,), handler=None), 996.0, True, [1.0]),
        # Another effect of the same gap.
        (transition(0, 999.0, steps=(1.0,)), 997.0, False, None),
    ),
)
def test_ticks_that_advance_a_counter_differently_are_dropped(
    other: Transition, gap: float, is_known: bool, advance: list[float] | None
) -> None:
    """The first tick adds 1 to a counter that the handler also sets."""
    first = transition(0, 1000.0 + 997.0 - gap, steps=(1.0,))
    search = seen_in_turn(
        first, other, gaps=(997.0, gap, 997.0), set_steps=lambda steps: list(steps) or [0.0]
    )
    made = search.made
    assert (bool(made._known), bool(made._gaps), made._advance) == (is_known, is_known, advance)
    assert made._alone == {}


class Skipping:
    """A program whose walks are given.

    It is 12 ms. Task main polls, and T1 waits as given.
    """

    def __init__(self, wait: Any = None, delay: Any = None, read: Any = (), level: float = inf) -> None:
        self.made = made = polled(False, True)
        self.walks, self.calls = list[Any](), list[object]()
        self.since = list[float]()

        def until(since: float, read: Any) -> float:
            self.since.append(since)
            return level

        self.clock = SimpleNamespace(now=0.012, horizon=0.02, next_time=lambda: 0.02, second_time=lambda: 0.6)
        environment: Any = made._environment
        environment.clock, environment.dependencies = self.clock, SimpleNamespace(until=until)
        made._events.tick_event = SimpleNamespace(time=0.02)
        made._read, made._begun, made._since, made._observed = set(read), 0.001, (7,), 1
        made._last = checkpoint((0.02, TICK, 0.0))
        learn(made, 0, ONE, (TICK, 1997.0))
        self.scheduler: Any = SimpleNamespace(
            until=1.0,
            tasks=[SimpleNamespace(wait=None, delay=None), SimpleNamespace(wait=wait, delay=delay)],
        )
        made._walk = lambda last, end: self.walk("walk", end)
        made._walk_ticks = lambda last, end: self.walk("ticks", end)
        made._pass = lambda walk, scheduler: self.calls.append("pass")
        made._begin = lambda since: self.calls.append(("begin", since))

    def walk(self, name: str, end: float) -> Any:
        self.calls.append((name, round(end, 12)))
        return self.walks.pop() if self.walks else None

    def skip(self) -> list[object]:
        self.made._skip(self.scheduler)
        return self.calls


# A walk ends 0.2 µs before anything else.
MARGIN = 2e-7


def test_walks_follow_one_another_while_there_are_any() -> None:
    """The event after the tick comes at 0.6 s."""
    program = Skipping()
    program.walks = ["one", "other"]
    end = ("ticks", round(0.6 - MARGIN, 12))
    assert program.skip() == [end, "pass", end, "pass", end]
    assert program.since == [0.001 - 1e-7]


def test_a_walk_of_waits_is_that_of_a_state_with_one() -> None:
    program = Skipping()
    program.made._are_idle[0] = True
    program.made._known[0].next[TICK, 0.0] = program.made._known[0].next[TICK, 1997.0]
    assert program.skip() == [("walk", round(0.6 - MARGIN, 12))]
    program = Skipping()
    program.made._last = checkpoint((0.02, TICK, 0.0), (0.5, 1, 0.1))
    assert program.skip() == [("walk", round(0.6 - MARGIN, 12))]


def test_no_walk_begins_where_nothing_is_known() -> None:
    program = Skipping()
    program.made._known = {}
    assert program.skip() == []


@cases(
    "level, calls, observed",
    (
        (0.3, [("ticks", round(0.3 - 1e-7 - MARGIN, 12))], 1),
        (0.0120002, [("ticks", round(0.0120001 - MARGIN, 12))], 1),
        (0.012, [("begin", (7,))], 13),
        (0.01205 - 5e-5 + 1e-7, [("begin", (7,))], 13),
    ),
)
def test_a_reading_that_changes_ends_the_walk(level: float, calls: list[object], observed: int) -> None:
    """If it may have changed already, another search begins after 12 checkpoints."""
    program = Skipping(level=level)
    assert program.skip() == calls
    assert program.made._observed == observed


@cases(
    "event, horizon, second, until, end",
    (
        (0.02, 0.02, 0.6, 1.0, 0.6),
        (0.02, 0.02, 0.6, 0.5, 0.5),
        (0.02, 0.015, 0.6, 1.0, 0.015),
        (0.02, 0.02, inf, 0.9, 0.9),
    ),
)
def test_a_walk_ends_before_another_event(
    event: float, horizon: float, second: float, until: float, end: float
) -> None:
    program = Skipping()
    program.clock.horizon, program.clock.next_time = horizon, lambda: horizon
    program.clock.second_time = lambda: second
    program.scheduler.until = until
    assert program.skip() == [("ticks", round(end - MARGIN, 12))]


@cases(
    "ends, ignores_data, is_over, due, end",
    (
        (None, True, False, 0.4, 0.4),
        (0.3, False, True, 0.4, 0.3),  # its end is known, so nothing is called
        (None, True, True, 0.4, None),
        (None, False, False, 0.4, None),
    ),
)
def test_a_walk_ends_before_a_wait_for_something_else(
    ends: float | None, ignores_data: bool, is_over: bool, due: float, end: float | None
) -> None:
    """A condition of variables may be true within a walk."""
    wait = SimpleNamespace(ends=ends, ignores_data=ignores_data, ready=lambda: is_over, due=lambda: due)
    assert Skipping(wait).skip() == ([] if end is None else [("ticks", round(end - MARGIN, 12))])
    own = SimpleNamespace(ends=0.3)
    assert Skipping(own, own).skip() == [("ticks", round(0.6 - MARGIN, 12))]  # a WAIT is part of the walk


def test_another_search_collects_all_readings_from_now_on() -> None:
    made = polled(False)
    begun, forgotten = {1}, list[str]()
    made._environment.clock.now = 0.25
    made._environment.dependencies = SimpleNamespace(begin_longest=lambda: begun)
    made._counters = SimpleNamespace(forget=lambda: forgotten.append("forget"))
    made._known, made._alone, made._periods = {0: _Node()}, {(0, 0): ONE}, {0: None}
    made._gaps, made._alive, made._numbers = {0: {}}, {1: 1}, {b"": 0}
    made._last, made._has_waits, made._advance = checkpoint(NEXT), True, [1.0]
    made._begin((7,))
    assert (made._since, made._begun, made._last, forgotten) == ((7,), 0.25, None, ["forget"])
    assert made._read is begun
    assert not any((made._known, made._alone, made._periods, made._gaps, made._alive, made._numbers))
    assert (made._are_idle, made._polling, made._has_waits, made._advance) == ([], [], False, None)


@cases(
    "cost, cost_units",
    (
        (1e-5, 1_000_000),
        (0.7310585e-5, 0),
        (0.73106e-5, 731_060),
        (1e-6 / 3, 0),
    ),
)
def test_a_search_begins_empty(cost: float, cost_units: int) -> None:
    """Only streams in which a tick may write, and WAITs, can have new records.

    Times are whole units of 10 ps.
    """
    events, outputs, slices, waits, prints, moves = ([k] for k in range(6))
    log: Any = SimpleNamespace(events=events, outputs=outputs, slices=slices, waits=waits)
    log.streams = lambda: [events, prints, outputs, slices, waits, moves]
    counted = SimpleNamespace(
        statements=StatementTime(cost), machine=SimpleNamespace(log=log), blocks={}, handler_counters={}
    )
    given: Any = SimpleNamespace(environment=counted, handler=lambda kind: None)
    made: Any = PolledTicks(given, "timer")
    assert made._cost_units == cost_units
    assert (made._streams, made._others) == ((events, outputs, slices), [prints, moves])
    assert (made._observed, made._left, made._back_off, made._begun) == (0, 0, 1, 0.0)
    assert (made._has_waits, made._last, made._read, made.is_searching) == (False, None, None, True)
