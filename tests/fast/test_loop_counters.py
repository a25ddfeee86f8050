"""The number of iterations that a loop with counters may skip."""

from __future__ import annotations

from types import CellType

import pytest

from motionlang.fast.handler_counters import HandlerCounters
from motionlang.fast.loop_counters import counted
from motionlang.fast.transitions import Known


# A counter, its step, the constant that it is compared with, and the iterations in which it does not pass it.
@pytest.mark.parametrize(
    ("counter", "step", "level", "iterations"),
    [
        (0, 1, 10, 9),
        (0, -1, -10, 9),
        (0, 4, 10, 2),
        (0, -4, -10, 2),
        (10, 1, 10, 0),  # it may have passed the constant in the last iteration
        (11, 1, 10, 0),
        (12, 1, 10, 2147483647 - 12),
    ],
)
def test_a_counter_advances_until_it_reaches_a_level(
    counter: int, step: int, level: int, iterations: int
) -> None:
    assert counted([counter], [step], [[level]]) == iterations


@pytest.mark.parametrize(
    ("counters", "steps", "levels", "iterations"),
    [
        ([0, 0], [1, 2], [[10], [10]], 4),  # the second one reaches 8 in four steps, and 10 in the fifth
        ([0, 0], [1, 2], [[10]], 9),  # the second one is not compared
        ([0, 0], [1, 2], [[], [7, 5]], 2),
        ([0, 5], [1, 0], [[], [5]], 2147483647),  # it does not count
        ([0, 0], [0, 0], [[1], [1]], float("inf")),
        ([-7], [-2], [[]], (2147483647 - 7) // 2),
        ([0], [4], [[11]], 2),
        ([0], [4], [[12]], 2),
        ([0], [4], [[13]], 3),
        ([14], [4], [[10]], 0),
        ([15], [4], [[10]], (2147483647 - 15) // 4),
        ([-14], [-4], [[-10]], 0),
        ([-15], [-4], [[-10]], (2147483647 - 15) // 4),
        ([0.5], [1], [[10]], 0),
        ([0], [0.5], [[10]], 0),
        ([2147483647], [1], [[]], 0),
    ],
)
def test_several_counters_advance_until_the_first_one_reaches_a_level(
    counters: list[float], steps: list[float], levels: list[list[float]], iterations: float
) -> None:
    assert counted(counters, steps, levels) == iterations


def cells(*values: float) -> list[CellType]:
    return [CellType(value) for value in values]


def counters_of(
    values: list[CellType], levels: list[list[float]], are_set: list[bool], are_of_loops: list[bool]
) -> HandlerCounters:
    made = HandlerCounters.__new__(HandlerCounters)
    made._cells, made._levels = values, levels  # type: ignore[assignment]
    made._are_set, made._are_of_loops = are_set, are_of_loops
    return made


def test_the_counters_of_a_handler() -> None:
    """One of a loop is between 3 and 10; one that is set is at 7."""
    found = counters_of(cells(5.0, 7.0), [[10.0, 3.0], [7.0]], [False, True], [True, False])
    assert found.sides() == [-1, 1, 0]
    assert found.steps_of_set([2.0, 3.0]) == [3.0]
    assert found.steps_of_set([]) == [0.0]
    assert [found.loops_count(steps) for steps in ([0.0, 3.0], [2.0, 0.0], [])] == [False, True, False]
    found.advance([2.0, -3.0], 4)
    assert list(found.values()) == [13.0, -5.0]
    found.set([1.0, 2.0])
    assert list(found.values()) == [1.0, 2.0]
    assert found.most([1.0, 0.0]) == 1.0  # 2, since 3 is a level


def test_a_range_of_steps_bounds_how_often_counters_advance() -> None:
    """A counter stays below 10 three times by 3, above -8 three times by -2."""
    found = counters_of(cells(0.0), [[10.0, -8.0]], [False], [False])
    assert found.most_in(([0.0], [0.0]), [0.0]) == 10**9
    assert found.most_in(([0.0], [1.0]), [0.0]) == 9
    assert found.most_in(([0.0], [3.0]), [0.0]) == 3
    assert found.most_in(([-2.0], [3.0]), [0.0]) == 3
    assert found.most_in(([-4.0], [3.0]), [0.0]) == 1


def test_a_range_has_the_least_and_the_greatest_steps() -> None:
    known = Known(2)
    for steps in ((1.0, -3.0), (3.0, 0.0), (-2.0, 1.0)):
        known.widen(steps)
    assert known.range == ([-2.0, -3.0], [3.0, 1.0])
    known.forget_transitions()
    assert known.range == ([0.0, 0.0], [0.0, 0.0])
