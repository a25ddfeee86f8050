"""Ticks and WAITs are skipped along known transitions, step by step."""

from __future__ import annotations

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


def polled(*idle: bool, period: float = 10.0, cost: float = 1e-5, most: int = 10**9) -> PolledTicks:
    """Return the search of a program with a tick every `period` ms since 0 s.

    `idle` are its states: true if all tasks wait. In the others the task "main" polls. The counters may advance `most`
    times.
    """
    made = PolledTicks.__new__(PolledTicks)
    environment: Any = SimpleNamespace(statements=StatementTime(cost), clock=SimpleNamespace(now=0.0))
    events: Any = SimpleNamespace(started=0.0, timer=period, tick_time=lambda number: number * period / 1000)
    counters: Any = SimpleNamespace(most_recorded=lambda values: most)
    made._environment, made._events, made._counters = environment, events, counters
    made._cost_units = round(cost * 1e11)
    made._known, made._alone, made._gaps, made._periods = {}, {}, {}, {}
    made._are_idle = list(idle)
    made._polling = ["" if each else "main" for each in idle]
    return made


def learn(made: PolledTicks, state: int, step: Transition, *path: tuple[int, float]) -> None:
    """Make a transition known after the ticks and ends of its path: the index and the statement of each."""
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
    """A task polls in state 0. The checkpoint is statement 2 of those of 0.5 s from 1 s on."""
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


def walked(
    made: PolledTicks, end: float, own: _Checkpoint, by_tick: bool = False
) -> tuple[object, ...] | None:
    """Return a walk: its states, how many transitions are good, what it has reached, and its switches and polls."""
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
    """All tasks wait, and each handler takes 3 statements. Tick 2 is the first one, at 20 ms.

    The last good one ends before `end`, after 30 µs.
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
    """A loop polls every millisecond, which is 100 units of 10 µs and 5 statements; the tick ends in another state.

    The WAIT that ends at 2 ms begins again 20 µs later, and ends 1 ms after that: 7 times before the tick at 10 ms.
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
    """The handler takes 30 µs. The WAIT that ends 20 µs after the tick is over only behind the handler.

    It stays open in a transition that has it in its path. The state after that is not known.
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
    """Iterations of 7 statements of 10 µs begin with the checkpoint; the WAIT ends at 0.9 s.

    The tick at 10 ms comes 997 statements after statement 3, and 3 after 142 iterations. The next one comes 998 after
    statement 997 + 5, and 4 after 142 iterations. The third one comes 996 after statement 1996 + 8, and 2 after 142
    iterations, which is not known.
    """
    made, end = polled(False), (0.9, 1, 0.1)
    made._periods[0] = 0.0, 7.0
    learn(made, 0, transition(0, 5.0, switches=((4.0, (3, 1)),)), (TICK, 3.0))
    learn(made, 0, transition(0, 8.0), (TICK, 4.0))
    reached = 0.0, 1996.0 + 8, [(0.03, TICK, 0.0), end], 3
    polls = [(0, "main", 994.0), (1, "main", 994.0)]
    found = walked(made, 0.5, checkpoint((0.01, TICK, 0.0), end))
    assert found == ((0, 0), 2, reached, [(0, 0.0, 997.0)], polls)


def ticks(*gaps: tuple[int, float, int, float], most: int = 10**9, period: float = 10.0) -> PolledTicks:
    """Return transitions by state and statements up to the tick: the next state and the length."""
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


@pytest.mark.parametrize(("cost", "period"), [(1e-5, 1.0), (0.7310585e-5, 1.0), (3e-6, 7.0), (4e-5, 33.0)])
def test_a_walk_finds_the_statement_of_each_tick(cost: float, period: float) -> None:
    """The gap to a tick is that to the least statement that is not before it, whatever the rounding.

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
    """It lies between statement 3, the checkpoint, and the tick at 10 ms, which is statement 1000.

    Another task must be in a WAIT. A loop that counts has no period.
    """
    made = polled(False)
    made._periods.update(enumerate(known))
    made._counters.loops_count = lambda steps: counts  # type: ignore[method-assign]
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
    """The transition ends with statement 1010, at 10.1 ms. The first of `dues` is a tick, the others ends."""
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
    """Return the fields of the transition from statement 3 to statement 1010, which is at 10.1 ms.

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
    """None if they cannot be repeated: an inexact time, two ticks, too many switches or an unexpected end."""
    assert learned(**given) == effects


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
    """A program whose walk has passed: its state before, and everything that the walk has set.

    Task 0 polls. Task 1 has been in a WAIT of 5 ms since 4 ms. The timer has had 3 ticks, and has a period of 10 ms.
    """

    def __init__(self, names: tuple[str, ...] = ("main", "T1")) -> None:
        self.reached, self.scheduled, self.counted = list[object](), list[int](), list[object]()
        self.made = made = polled(False)
        environment, events, counters = self.parts()
        made._environment, made._events, made._counters = environment, events, counters
        made._log = self.log = SimpleNamespace(events=Stream(), outputs=Stream(), slices=Stream())  # type: ignore[assignment]
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
    """Two ticks, at 40 ms and 50 ms, and a WAIT pass; the third tick of the walk is not good.

    The first transition adds 2 to the first counter, and the third one, which is the same, too. It switches output 3
    after 4 statements, and takes 10 µs of task T1. Task "main" polls for 900 statements before the second transition.
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
        polling=[(1, "main", 900.0), (3, "main", 77.0)],
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
    assert (since, until, tasks) == (0.0305, now, ("T1", "main"))
    assert seconds == pytest.approx((2e-5, 2 * 5e-5 + 2e-5 + 900 * 1e-5), rel=1e-12)
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
    """One of another position precedes them, and two follow. The first one is that of tick 4."""
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
    made._environment = SimpleNamespace(  # type: ignore[assignment]
        machine=parts["machine"], statements=statements, clock=parts["clock"], controller=controller
    )
    assert made._is_regular(scheduler) == (name == "nothing")
