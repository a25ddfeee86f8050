"""Walks along known transitions: their steps, their times and where they end."""

from __future__ import annotations

from math import inf
from random import Random
from typing import Any

import pytest

from motionlang.fast.rounds import Rounds
from motionlang.fast.transitions import TICK, Checkpoint, Known, Transition, first_statement
from motionlang.fast.walk import Pace
from motionlang.fast.walker import Walker
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


def walker(*idle: bool, period: float = 10.0, cost: float = 1e-5) -> Walker:
    """Return a walker in a program with a tick every `period` ms since 0 s.

    `idle` are its states: true if all tasks wait. In the others the task "main" polls.
    """
    known = Known(0)
    for number, is_idle in enumerate(idle):
        known.number((number,), [] if is_idle else ["main"])
    return Walker(known, Pace(0.0, period / 1000.0, StatementTime(cost)))


def learn(made: Walker, state: int, step: Transition, *path: tuple[int, float]) -> None:
    """Make a transition known.

    Its path has the index and the statement of each tick and end.
    """
    made._known.node(state, list(path)).transition = step


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
    assert first_statement((moment, index, 0.0), 1.0, 0.5) == statement


def test_the_first_statement_after_a_tick_is_the_least_that_is_not_before_it() -> None:
    """Products of ticks and of statements round differently, in both directions."""
    assert (
        first_statement((3.0030300000000003, TICK, 0.0), 0.25003, 4e-5) == 68_826.0
    )  # 68 825 * 40 µs are just before it
    assert first_statement((0.539, TICK, 0.0), 0.5, 3e-6) == 13_000.0
    random = Random(1)
    for _ in range(400):
        base, cost = random.choice((0.0, 3e-5, 0.1)), random.choice((1e-5, 3e-6, 0.7310585e-5))
        moment = base + random.randint(1, 5000) * cost
        count = first_statement((moment, TICK, 0.0), base, cost)
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
    made = walker(idle, cost=0.5)
    if period is not None:
        made._known.periods[0] = period
    found = made.origin(0, 1.0, 2.0, due, by_tick)
    assert (None if found is None else found[:2]) == origin


# The number of the state, its transition, and the ticks and ends in its path with their statements.
Entry = tuple[int, Transition, tuple[tuple[int, float], ...]]
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
    known: tuple[Entry, ...],
    dues: tuple[tuple[float, int, float], ...],
    found: tuple[Transition, float, float, int] | None,
) -> None:
    """A task polls in state 0.

    The checkpoint is statement 2 of those of 0.5 s from 1 s on.
    """
    made = walker(False, cost=0.5)
    for state, step, path in known:
        learn(made, state, step, *path)
    assert made.next(0, 1.0, 2.0, [*dues, NO_DUE]) == found


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
    made = walker(True, cost=0.5)
    learn(made, 0, ONE, *path)
    assert made.next(0, 1.0, 2.0, [due, NO_DUE]) == (None if found is None else (ONE, *found))
    assert made.next(1, 1.0, 2.0, [due, NO_DUE]) is None


def test_the_next_transition_counts_from_the_last_iteration_of_a_poll() -> None:
    """Iterations of 7 statements begin 3 after the checkpoint.

    The tick comes 22 after the checkpoint, 8 after two iterations, and another end makes the period count.
    """
    made = walker(False, cost=0.5)
    made._known.periods[0] = 3.0, 7.0
    learn(made, 0, ONE, (TICK, 8.0))
    learn(made, 0, TWO, (TICK, 22.0))
    tick, end = (1.0 + 0.5 * (2 + 22), TICK, 0.0), (90.0, 1, 0.0)
    assert made.next(0, 1.0, 2.0, [tick, end, NO_DUE]) == (ONE, 1.0, 2.0 + 14, 1)
    assert made.next(0, 1.0, 2.0, [tick, NO_DUE]) == (TWO, 1.0, 2.0, 1)
    direct = transition(0, 22.0)  # without a tick
    learn(made, 0, direct)
    assert made.next(0, 1.0, 2.0, [tick, end, NO_DUE]) == (ONE, 1.0, 2.0 + 14, 1)
    assert made.next(0, 1.0, 2.0, [(tick[0] + 3e-9, *tick[1:]), end, NO_DUE]) == (direct, 1.0, 2.0, 0)
    learn(made, 0, TWO, (TICK, 9.0))
    assert made.next(0, 1.0, 2.0, [(tick[0] + 1e-9, *tick[1:]), end, NO_DUE]) == (TWO, 1.0, 2.0 + 14, 1)


def walked(made: Walker, end: float, own: Checkpoint, most: int = 10**9) -> tuple[object, ...] | None:
    """Return a walk as plain data, with each round in full.

    It has its states, how many transitions are good, what it has reached, and its switches and polls.
    """
    walk = made.walk(own, end, most)
    if walk is None:
        return None
    states, switching, more = [], [], 0
    for number, step in enumerate(walk.steps):
        states.append(step.state)
        switching += [(each + more, *rest[:2]) for each, *rest in walk.switching if each == number]
        for each in walk.rounds:
            if each.past != number + 1:
                continue
            length = each.past - each.first
            repeated = iter(each.repeated(made._pace))
            for k in range(1, each.times + 1):
                for _ in each.switching:
                    at, base, origin, _source = next(repeated)
                    switching.append((k * length + at + more, base, origin))
                states += [step.state for step in walk.steps[each.first : each.past]]
            more += each.total
    return tuple(states), walk.good + more, walk.reached, switching, walk.polling


def checkpoint(
    *dues: tuple[float, int, float], base: float = 0.0, count: float = 3.0, number: int = 1
) -> Checkpoint:
    return Checkpoint(0, base, count, list(dues), number, ())


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
    made = walker(True)
    step = transition(0, 3.0)
    made._known.alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    found = walked(made, end, checkpoint((0.02, TICK, 0.0), base=0.01, number=2), most)
    if not good:
        assert found is None
        return
    last, period = 2 + good - 1, 10 / 1000.0
    reached = last * period, 3.0, [((last + 1) * period, TICK, 0.0)], last + 1
    assert found == ((0,) * good, good, reached, [], [])


@cases("switches, proved, good", (((), True, 8), (((1.0, (3, 1)),), True, 8), ((), False, None)))
def test_a_tick_that_switches_is_repeated_one_by_one(switches: Any, proved: bool, good: int | None) -> None:
    """The number, base and origin of each transition with switches are recorded."""
    made = walker(True)
    step = transition(0, 3.0, proved, switches=switches)
    made._known.alone[0, TICK] = step
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
    made = walker(True, True)
    again = transition(0, 5.0, handler=None, waits=((0, 2.0, 102_000_000),))
    made._known.alone[0, 0] = again
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
    made = walker(True, True)
    tick, back = transition(1, 2.0), transition(0, 3.0, handler=None, waits=((0, 1.0, 601_000_000),))
    for state in (0, 1):
        for step, index in ((tick, TICK), (back, 0)):
            made._known.alone[state, index] = step
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
    made = walker(True, True)
    both = transition(1, 5.0, open=frozenset({0}))
    learn(made, 0, transition(0, 3.0), (TICK, 0.0))
    learn(made, 0, both, (TICK, 0.0), (0, 2.0))
    made._known.alone[0, TICK] = transition(0, 3.0)
    end = (0.01 + 2e-5, 0, 0.004)
    assert walked(made, 1.0, checkpoint(end, (0.01, TICK, 0.0))) is None
    both.state = 0
    walked_once = walked(made, 0.0101, checkpoint((0.01, TICK, 0.0), end))
    assert walked_once == ((0,), 1, (0.01, 5.0, [end, (0.02, TICK, 0.0)], 2), [], [])


def test_a_task_that_polls_adds_the_iterations_before_a_tick() -> None:
    """Iterations of 7 statements of 10 µs begin with the checkpoint.

    The WAIT ends at 0.9 s. The tick at 10 ms comes 997 statements after statement 3, and 3 after 142 iterations.
    The next one comes 998 after statement 997 + 5, and 4 after 142 iterations. The third one comes 996 after
    statement 1996 + 8, and 2 after 142 iterations, which is not known.
    """
    made, end = walker(False), (0.9, 1, 0.1)
    made._known.periods[0] = 0.0, 7.0
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
    made = walker(True)
    step = transition(0, 3.0)
    made._known.alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    dues = ((0.02, TICK, 0.0), *((other,) if other is not None else ()))
    found = walked(made, 0.025, checkpoint(*dues, base=0.01, count=count, number=2))
    assert (found is not None) == good


def test_ticks_that_lead_to_two_states_in_turn_are_not_repeated() -> None:
    made = walker(True, True)
    for state in (0, 1):
        step = transition(1 - state, 3.0)
        made._known.alone[state, TICK] = step
        learn(made, state, step, (TICK, 0.0))
    found = walked(made, 0.0755, checkpoint((0.02, TICK, 0.0), base=0.01, number=2))
    reached = 0.07, 3.0, [(0.08, TICK, 0.0)], 8
    assert found == ((1, 0, 1, 0, 1, 0), 6, reached, [], [])


def test_a_handler_of_more_than_half_a_period_is_repeated_up_to_the_end_of_a_wait() -> None:
    """It takes 0.6 ms of 1 ms.

    The WAIT ends at 10.5 ms, in the handler of the tick at 10 ms.
    """
    made = walker(True, period=1.0)
    step, end = transition(0, 60.0), (0.0105, 0, 0.001)
    made._known.alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    found = walked(made, 1.0, checkpoint((0.001, TICK, 0.0), end, count=0.0))
    assert found == ((0,) * 9, 9, (9 * 0.001, 60.0, [(0.01, TICK, 0.0), end], 10), [], [])


def test_a_tick_of_two_seconds_is_repeated() -> None:
    made = walker(True, period=2000.0)
    step = transition(0, 3.0)
    made._known.alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    found = walked(made, 20.0, checkpoint((4.0, TICK, 0.0), base=2.0, number=2))
    assert found == ((0,) * 8, 8, (18.0, 3.0, [(20.0, TICK, 0.0)], 10), [], [])


def test_a_walk_has_at_most_as_many_transitions_as_counters_may_advance() -> None:
    """The end of a WAIT that does not begin again precedes the ticks."""
    made = walker(True)
    for index, step in ((TICK, transition(0, 3.0)), (0, transition(0, 2.0, handler=None))):
        made._known.alone[0, index] = step
        learn(made, 0, step, (index, 0.0))
    found = walked(made, 9.0, checkpoint((0.015, 0, 0.0), (0.02, TICK, 0.0), base=0.01, number=2), 5)
    assert found == ((0,) * 5, 5, (0.05, 3.0, [(0.06, TICK, 0.0)], 6), [], [])


@cases("end, good", ((9.0, False), (9.5, True)))
def test_a_walk_ends_before_a_time(end: float, good: bool) -> None:
    """The tick at 8 s and two statements of 0.5 s end at 9 s."""
    made = walker(True, period=8000.0, cost=0.5)
    step = transition(0, 2.0)
    made._known.alone[0, TICK] = step
    learn(made, 0, step, (TICK, 0.0))
    assert (walked(made, end, checkpoint((8.0, TICK, 0.0), count=0.0)) is not None) == good


def test_a_wait_that_begins_while_another_task_polls() -> None:
    """Statements count from the checkpoint, which is statement 3 from 0 s on.

    The WAIT begins with statement 1005 and lasts 15 ms. No iteration is left out.
    """
    made = walker(False)
    begins = transition(0, 1007.0, waits=((1, 1002.0, 1005_000_000 - 3_000_000 + 1_500_000_000),))
    learn(made, 0, begins, (TICK, 997.0))
    walk = made.walk_all(checkpoint((0.01, TICK, 0.0)), 0.011, 9)
    assert walk is not None
    assert walk.reached == (0.0, 1010.0, [(0.02, TICK, 0.0), (0.02505, 1, 1005 * 1e-5)], 2)


def ticks(*gaps: tuple[int, float, int, float], period: float = 10.0) -> Walker:
    """Return transitions by state and gap: the next state and the length."""
    made = walker(*[False] * 3, period=period)
    for state, gap, after, length in gaps:
        switches = ((1.0, (3, 1)),) if after == 2 else ()
        made._known.gaps.setdefault(state, {})[gap] = transition(after, length, switches=switches)
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
    found = walked(ticks(*gaps), end, checkpoint((0.01, TICK, 0.0)), most)
    reached = 0.0, count, [((good + 1) * (10 / 1000.0), TICK, 0.0)], good + 1
    assert found == (None if states is None else (states, good, reached, switching, []))


def test_a_walk_ends_before_a_transition_that_is_not_proved() -> None:
    made = ticks((0, 997.0, 0, 1002.0), (0, 995.0, 0, 1000.0))
    made._known.gaps[0][995.0].is_proved = False
    found = walked(made, 0.5, checkpoint((0.01, TICK, 0.0)))
    assert found == ((0,), 1, (0.0, 1005.0, [(0.02, TICK, 0.0)], 2), [], [])


@pytest.mark.parametrize(("cost", "period"), [(1e-5, 1.0), (0.7310585e-5, 1.0), (3e-6, 2.0), (4e-5, 33.0)])
def test_a_walk_finds_the_statement_of_each_tick(cost: float, period: float) -> None:
    """The gap to a tick ends with the least statement that is not before it.

    Each handler takes 2 statements, and each gap is known.
    """
    made = walker(False, cost=cost, period=period)
    most = round(period / 1000 / cost)
    made._known.gaps[0] = {float(gap): transition(0, gap + 2.0) for gap in range(most - 4, most + 3)}
    count, lengths = 0.0, []
    for number in range(1, 301):
        moment = number * (period / 1000.0)
        first = next(each for each in range(int(moment / cost) - 2, 10**9) if each * cost >= moment)
        lengths.append(first - count + 2.0)
        count = first + 2.0
    own = checkpoint((period / 1000.0, TICK, 0.0), count=0.0)
    walk = made.walk_ticks(own, (period * 300.5) / 1000.0, 10**9)
    assert walk is not None
    assert [step.length for step in walk.steps] == lengths


def polls_beside_ticks(period: float, wait: float, cost: float, toggles: bool) -> Walker:
    """Return a walker in a program with a TIMER and a loop with a WAIT, in ms.

    The tick toggles an output, which is off in states 0 and 2. Their checkpoint is the beginning of the WAIT, that of
    1 and 3 the end of the handler.
    """
    made = walker(*[True] * 4, period=period, cost=cost)
    units_of_wait = round(wait * 1e8) + 2 * made._pace.statements.cost_units
    for state in range(4):
        is_on = state % 2
        switches = ((1.0, (3, 1 - is_on)),) if toggles else ()
        tick = transition(2 + (1 - is_on if toggles else is_on), 2.0, switches=switches)
        again = transition(is_on, 3.0, handler=None, waits=((0, 2.0, units_of_wait),))
        for index, step in ((TICK, tick), (0, again)):
            made._known.alone[state, index] = step
            learn(made, state, step, (index, 0.0))
            for later in (0.0, 1.0, 2.0, 3.0):  # the other one comes while statements are executed
                both = transition(
                    tick.state, 5.0, open=frozenset() if index else frozenset({0}), switches=switches
                )
                learn(made, state, both, (index, 0.0), (TICK if index == 0 else 0, later))
    return made


@pytest.mark.parametrize("toggles", [True, False])
@pytest.mark.parametrize("cost", [1e-5, 4e-5, 3e-6])
@pytest.mark.parametrize(
    ("period", "wait"), [(1.0, 5.0), (1.0, 1.0), (10.0, 3.0), (10.0, 10.0), (7.0, 30.0), (5.0, 1.0)]
)
def test_rounds_are_the_transitions_that_follow_one_another(
    period: float, wait: float, cost: float, toggles: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A walk with rounds and one without go the same way, to the last bit.

    It ends where a tick falls between two statements of the loop, which is not known here.
    """
    made = polls_beside_ticks(period, wait, cost, toggles)
    dues = sorted([(period / 1000.0, TICK, 0.0), (0.0005 + wait / 1000.0, 0, 0.0005)])
    own = checkpoint(*dues, base=0.0005, count=0.0)
    found = walked(made, 0.9, own)
    assert found is not None
    monkeypatch.setattr(Rounds, "found", lambda *given: False)
    assert walked(made, 0.9, own) == found


def test_most_of_a_walk_is_rounds() -> None:
    """A WAIT of 5 ms next to a tick of 1 ms, which overtakes its end after 50 rounds."""
    made = polls_beside_ticks(1.0, 5.0, 1e-5, True)
    walk = made.walk(checkpoint((0.001, TICK, 0.0), (0.0055, 0, 0.0005), base=0.0005, count=0.0), 0.9, 10**9)
    assert walk is not None
    assert sum(each.total for each in walk.rounds) > 3 * len(walk.steps)
