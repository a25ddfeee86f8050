"""The paths of which cycles are made: counted, since the same cycles come out of a slow search."""

from __future__ import annotations

from functools import partial
from itertools import pairwise

from motionlang_explore.exploration.changes import Change
from motionlang_explore.exploration.cycles import cycles
from motionlang_explore.exploration.rests import RestState, TaskRest
from motionlang_explore.exploration.states import Effect, StateNode, Transition, Visit
from tests.counted_calls import all_calls

NONE = frozenset[int]()
HERE = Visit((), 0.0)
NOTHING = Effect((), NONE, frozenset())  # type: ignore[arg-type]


def _state(k: int) -> RestState:
    return (TaskRest("", frozenset((k,))),)


def _sequence(count: int) -> dict[RestState | None, StateNode]:
    """Return states of which each leads to the next eight, as each level of the inputs passes some, and none back."""
    nodes: dict[RestState | None, StateNode] = {_state(k): StateNode(_state(k), HERE) for k in range(count)}
    for k in range(count):
        for to in range(k + 1, min(k + 9, count)):
            nodes[_state(k)].transitions.append(
                Transition(
                    _state(k),
                    (Change("input", to, 1.0),),
                    _state(to),
                    1.0,
                    (),
                    NONE,
                    NONE,
                    NONE,
                    (),
                    (),
                    0,
                    0,
                    False,
                    HERE,
                    False,
                    False,
                    NOTHING,
                    NONE,
                )
            )
    return nodes


def test_a_sequence_of_twice_as_many_states_that_never_returns_is_twice_the_work() -> None:
    sequences = [_sequence(count) for count in (125, 250, 500)]
    calls = [all_calls(partial(cycles, nodes, (), 1, NONE)) for nodes in sequences]
    assert all(more <= 2.3 * less for less, more in pairwise(calls)), calls
