"""Slack between axes that began together, from their ends and the waits, by hand."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.profile.motions import Motions
from motionlang.commands.profile.slacks import Slack, slacks
from tests.cases import cases

# A move: its axis, line and end. A group has moves that began together.
Group = list[tuple[int, int, float]]


# The groups, the ends of the waits for axes, and the slacks: axis, the axis that ended last, seconds.
RUNS: dict[str, tuple[list[Group], list[float], list[tuple[int, int, float]]]] = {
    # 3 - 1 and 6.5 - 5 s.
    "axis 1 always last": (
        [[(0, 9, 1.0), (1, 9, 3.0)], [(0, 9, 5.0), (1, 9, 6.5)]], [3.0, 6.5], [(0, 1, 3.5)],
    ),
    "each last once": (
        [[(0, 9, 1.0), (1, 9, 3.0)], [(0, 9, 7.0), (1, 9, 6.5)]], [3.0, 7.0], [(0, 1, 2.0), (1, 0, 0.5)],
    ),
    "equal slacks in the order of the axes": (
        [[(0, 9, 7.0), (1, 9, 6.5)], [(0, 9, 8.5), (1, 9, 9.0)]], [7.0, 9.0], [(0, 1, 0.5), (1, 0, 0.5)],
    ),
    "one of two that is waited for": (
        [[(0, 9, 1.0), (1, 9, 3.0)], [(0, 9, 5.0), (1, 9, 6.5)]], [6.5], [(0, 1, 1.5)],
    ),
    "none that is waited for": ([[(0, 9, 1.0), (1, 9, 3.0)]], [1.0], []),
    # A wait may end in the next millisecond, not in the one before.
    "a wait that ends just after": ([[(0, 9, 1.0), (1, 9, 2.9996)]], [3.0004], [(0, 1, 1.9996)]),
    "a wait that ends just before": ([[(0, 9, 1.0), (1, 9, 3.0004)]], [2.9996], []),
    "ends together": ([[(0, 9, 3.0), (1, 9, 3.0)]], [3.0], []),
    "two of three end together": ([[(0, 9, 3.0), (1, 9, 3.0), (2, 9, 1.0)]], [3.0], [(2, 0, 2.0)]),
    "together once": (
        [[(0, 9, 3.0), (1, 9, 3.0)], [(0, 9, 4.0), (1, 9, 4.5)]], [3.0, 4.5], [(0, 1, 0.5)],
    ),
    # Axes 0 and 2 are of line 9, axis 1 began by itself.
    "two lines at once": ([[(0, 9, 1.0), (1, 10, 3.0), (2, 9, 2.0)]], [2.0, 3.0], [(0, 2, 1.0)]),
    "other axes": (
        [[(0, 9, 1.0), (1, 9, 3.0)], [(1, 10, 5.0), (2, 10, 6.0)]], [3.0, 6.0], [(0, 1, 2.0), (1, 2, 1.0)],
    ),
    "three axes": (
        [[(0, 9, 1.0), (1, 9, 3.0), (2, 9, 2.5)], [(0, 9, 6.0), (1, 9, 5.0), (2, 9, 4.0)]],
        [3.0, 6.0],
        [(0, 1, 2.0), (2, 0, 2.0), (1, 0, 1.0), (2, 1, 0.5)],
    ),
    "one axis alone": (
        [[(0, 9, 1.0), (1, 9, 3.0)], [(0, 8, 4.0)], [(0, 9, 5.0), (1, 9, 6.0)], [(0, 9, 7.0), (1, 9, 9.0)]],
        [3.0, 4.0, 6.0, 9.0],
        [(0, 1, 5.0)],
    ),
    "two and three": (
        [[(0, 9, 1.0), (1, 9, 3.0)], [(0, 8, 4.0), (1, 8, 4.5), (2, 8, 5.5)]],
        [3.0, 5.5],
        [(0, 1, 2.0), (0, 2, 1.5), (1, 2, 1.0)],
    ),
    "all alone": ([[(0, 9, 1.0)], [(1, 9, 3.0)]], [1.0, 3.0], []),
}  # fmt: skip


def found(groups: list[Group], waits: list[float], cause: str) -> list[Slack]:
    profile = SimpleNamespace(pieced=True, _recipe=(0.0, 1.0, 0.0, 5.0))
    moves = [
        SimpleNamespace(axis=axis, start_time=0.125 * number, command="MOVER", line=line,
                        profile=SimpleNamespace(**vars(profile), duration=end - 0.125 * number))
        for number, group in enumerate(groups)
        for axis, line, end in group
    ]  # fmt: skip
    run: Any = SimpleNamespace(time=99.0, controller=SimpleNamespace(log=SimpleNamespace(moves=moves)))
    log: Any = {"main": [("main", 0, 0.0, until, cause, (), "", ()) for until in waits]}
    return slacks(Motions(run), log)


@cases("name", RUNS)
def test_the_slacks_of_axes_that_began_together(name: str) -> None:
    groups, waits, expected = RUNS[name]
    rows = found(groups, waits, "axis")
    assert [(row.axis, row.other) for row in rows] == [row[:2] for row in expected]
    assert [row.seconds for row in rows] == pytest.approx([row[2] for row in expected])


def test_a_wait_for_a_time_is_no_wait_for_an_axis() -> None:
    groups, waits, _ = RUNS["axis 1 always last"]
    assert found(groups, waits, "time") == []
    assert len(found(groups, waits, "condition")) == 1
