"""Motions by end time: those that ended a wait, lead to a time, are in progress."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.profile.critical_path import Strip, _behind
from motionlang.commands.profile.motions import Motions, _moves
from motionlang.commands.profile.polls import Polls, _by_channel, _innermost, _iterates, _up_to
from motionlang.kernel.lang import ROUNDING
from motionlang.kernel.planners import hold, plan_trapezoid

STILL, MOVED = (0.0, 1.0, 0.0, 0.0), (0.0, 1.0, 0.0, 5.0, 1.0, 0.0, 0.0)
# Axis, begin, duration, line, and shape of each move, in the order of the log.
MOVES = (
    (0, 0.0, 1.0, 1, STILL),
    (1, 0.0, 1.0, 1, MOVED),
    (2, 0.0, 1.0, 9, MOVED),  # on another line, so it is another motion
    (3, 0.5, 0.5, 2, MOVED),
    (0, 2.0, 2.0, 3, MOVED),
    (1, 3.0, 1.25, 4, MOVED),
    (3, 6.0, 9.0, 5, MOVED),  # the run ends at 8 s
)
TOGETHER = (1.0, 0.0, 1, (0, 1), MOVED)
ALONE = (1.0, 0.0, 9, (2,), MOVED)
LATER = (1.0, 0.5, 2, (3,), MOVED)
THIRD = (4.0, 2.0, 3, (0,), MOVED)
FOURTH = (4.25, 3.0, 4, (1,), MOVED)
LAST = (8.0, 6.0, 5, (3,), MOVED)


def motions(moves: Any = MOVES, time: float = 8.0) -> Motions:
    """Return the motions of a run with moves of ramps."""
    made_of = [
        SimpleNamespace(
            axis=axis,
            start_time=begin,
            command="MOVER",
            line=line,
            profile=SimpleNamespace(pieced=True, _recipe=shape, duration=duration),
        )
        for axis, begin, duration, line, shape in moves
    ]
    log = SimpleNamespace(moves=made_of)
    made: Any = SimpleNamespace(time=time, controller=SimpleNamespace(axes=dict.fromkeys(range(4)), log=log))
    return Motions(made)


# After which time, at which time, how near, the axes, and the motion.
ENDED: dict[str, tuple[float, float, float, tuple[int, ...] | None, object]] = {
    "of several, the one that began last": (0.0, 1.0, 0.25, None, LATER),
    "of any axis": (0.0, 1.0, 0.25, (), LATER),
    "of an axis that moves together with another one": (0.0, 1.0, 0.25, (0,), TOGETHER),
    "of two axes, the one that began last": (0.0, 1.0, 0.25, (1, 3), LATER),
    "of two that began together, the first in the log": (0.0, 1.0, 0.25, (1, 2), TOGETHER),
    "just as late as allowed": (0.0, 0.75, 0.25, (2,), ALONE),
    "later than allowed": (0.0, 0.5, 0.25, (2,), None),
    "just as early as allowed": (0.0, 1.25, 0.25, None, LATER),
    "earlier than allowed": (0.0, 1.5, 0.25, None, None),
    "earlier than allowed, of an axis": (0.0, 1.5, 0.25, (1,), TOGETHER),
    "earlier than allowed, of any axis": (0.0, 1.5, 0.25, (), LATER),
    "not after the begin of the wait": (1.0, 1.0, 0.25, (), None),
    "just after the begin of the wait": (0.75, 1.0, 0.25, (), LATER),
    "before the begin of the wait": (1.25, 3.0, 0.25, (1,), None),
    "the nearest of two is not the one that began last": (0.0, 4.25, 0.25, (0,), THIRD),
    "two ends near the wait": (0.0, 4.25, 0.25, None, FOURTH),
    "one end near the wait": (0.0, 4.0, 0.125, None, THIRD),
    "one end near the wait, of another axis": (0.0, 4.0, 0.125, (1,), TOGETHER),
    "cut by the end of the run": (0.0, 8.0, 0.0, None, LAST),
    "before all motion": (0.0, 0.25, 0.125, (), None),
}


@pytest.mark.parametrize("name", ENDED)
def test_the_motion_that_ended_a_wait(name: str) -> None:
    since, time, near, axes, motion = ENDED[name]
    assert motions().that_ended(since, time, near, axes) == motion


def test_of_motions_that_began_together_the_one_that_ended_last_has_ended_the_wait() -> None:
    """Both moves begin at 0.5 s and end within 1 s of 3 s; the shorter one is last."""
    made = motions([(0, 0.5, 2.5, 1, MOVED), (1, 0.5, 2.0, 2, MOVED)])
    assert made.that_ended(0.0, 3.0, 1.0) == (3.0, 0.5, 1, (0,), MOVED)


# The axes, the start, how near, and the motion.
BEFORE: dict[str, tuple[tuple[int, ...], float, float, object]] = {
    "ended just as early as allowed": ((1,), 1.25, 0.25, TOGETHER),
    "ended too early": ((1,), 1.5, 0.25, None),
    "ended just as late as allowed": ((3,), 0.75, 0.25, LATER),
    "under way at the begin": ((0,), 3.0, 0.25, THIRD),
    "began at the same time": ((1,), 3.0, 0.25, None),
    "of another axis": ((2,), 4.25, 0.25, None),
    "the last of two": ((0, 1), 4.25, 0.25, FOURTH),
    "begins later than that": ((3,), 5.5, 0.25, None),
}


@pytest.mark.parametrize("name", BEFORE)
def test_the_motion_that_leads_up_to_another_one(name: str) -> None:
    axes, begin, near, motion = BEFORE[name]
    assert motions().before(axes, begin, near) == motion


def test_the_last_motion_of_an_interval() -> None:
    made = motions()
    found = [made.last(after, time) for after, time in ((0.0, 4.25), (0.0, 4.125), (4.0, 4.125), (0.0, 0.5))]
    assert found == [FOURTH, THIRD, None, None]
    ends = [(None, 0.0, 4.25), (0, 0.0, 4.25), (0, 1.0, 4.25), (0, 4.0, 9.0), (1, 1.0, 4.25), (2, 0.0, 9.0)]
    assert [made.last_end(*each) for each in ends] == [4.25, 4.0, 4.0, None, 4.25, 1.0]


def test_the_motion_under_way_at_a_time() -> None:
    made = motions()
    times = [(None, 0.25), (0, 2.0), (0, 2.5), (1, 2.5), (1, 4.0), (None, 4.25), (None, 7.0), (None, 8.0)]
    assert [made.moving_at(*each) for each in times] == [0, None, 0, None, 1, None, 3, None]
    assert made.crossing(None, 0.75) == (0.75, *TOGETHER[1:])
    assert made.crossing(3, 0.75) == (0.75, *LATER[1:])
    assert made.crossing(0, 4.0) is None


def test_a_log_out_of_order_has_its_motions_in_order() -> None:
    """A path of two axes, begun at 2 s, is in the log before a move of 0 s to 1 s."""
    made = motions([(0, 2.0, 1.0, 7, MOVED), (1, 2.0, 1.0, 7, MOVED), (2, 0.0, 1.0, 8, MOVED)])
    assert made.ends == [1.0, 3.0, 3.0]
    assert [move.axes for move in made.moves] == [(2,), (0,), (1,)]
    assert made.together() == [made.moves[1:]]


@pytest.mark.parametrize(
    ("shape", "moves"),
    [
        (STILL, False),
        (MOVED, True),
        ((5.0, 1.0, 0.0, 0.0), True),
        (hold(3.0), False),
        (plan_trapezoid(0.0, 4.0, 10.0, 10.0, 10.0), True),
        (plan_trapezoid(0.0, 4.0, 10.0, 10.0, 10.0).then(plan_trapezoid(4.0, 0.0, 10.0, 10.0, 10.0)), True),
    ],
)
def test_an_axis_of_a_path_that_does_not_move_it_is_at_rest(shape: Any, moves: bool) -> None:
    assert _moves(shape) is moves


PHASES = (("accelerating", 0.5), ("at speed", 2.0), ("decelerating", 0.25))


@pytest.mark.parametrize(
    ("seconds", "left"),
    [
        (0.0, PHASES),
        (0.25, (("accelerating", 0.25), *PHASES[1:])),
        (0.5, PHASES[1:]),
        (1.5, (("at speed", 1.0), PHASES[2])),
        (2.5, PHASES[2:]),
        (2.625, PHASES[2:]),  # the last phase extends to the end of the link
        (9.0, PHASES[2:]),
    ],
)
def test_the_phases_behind_a_time(seconds: float, left: object) -> None:
    assert _behind(PHASES, seconds) == left


def test_the_phases_of_links_end_with_them() -> None:
    """One link takes the complete move, one ends at speed, one while it speeds up."""
    strip = Strip(SimpleNamespace(), "main", PHASES, 3)  # type: ignore[arg-type]
    for begin, end in ((0.0, 3.0), (4.0, 5.0), (6.0, 6.25)):
        strip.add(begin, end)
    assert list(strip.by_phase()) == [
        ("accelerating", [0.0, 4.0, 6.0], [0.5, 4.5, 6.25]),
        ("at speed", [0.5, 4.5, 6.25], [2.5, 5.0, 6.25]),
        ("decelerating", [2.5, 5.0, 6.25], [3.0, 5.0, 6.25]),
    ]


# Nested spans, outer ones first, and each instant of them once.
SPANS: dict[str, tuple[list[tuple[float, float, int]], list[tuple[float, float, int]]]] = {
    "none": ([], []),
    "one": ([(1.0, 2.0, 7)], [(1.0, 2.0, 7)]),
    "one after the other": ([(1.0, 2.0, 7), (2.0, 3.0, 8)], [(1.0, 2.0, 7), (2.0, 3.0, 8)]),
    "a gap": ([(1.0, 2.0, 7), (4.0, 5.0, 8)], [(1.0, 2.0, 7), (4.0, 5.0, 8)]),
    "one inside": ([(1.0, 5.0, 7), (2.0, 3.0, 8)], [(1.0, 2.0, 7), (2.0, 3.0, 8), (3.0, 5.0, 7)]),
    "one at the start": ([(1.0, 5.0, 7), (1.0, 3.0, 8)], [(1.0, 3.0, 8), (3.0, 5.0, 7)]),
    "one at the end": ([(1.0, 5.0, 7), (3.0, 5.0, 8)], [(1.0, 3.0, 7), (3.0, 5.0, 8)]),
    "three deep, and another one": (
        [(0.0, 9.0, 6), (1.0, 5.0, 7), (2.0, 3.0, 8), (4.0, 5.0, 9), (6.0, 7.0, 5)],
        [(0.0, 1.0, 6), (1.0, 2.0, 7), (2.0, 3.0, 8), (3.0, 4.0, 7), (4.0, 5.0, 9), (5.0, 6.0, 6), (6.0, 7.0, 5),
         (7.0, 9.0, 6)],
    ),
    "the end of one is the start of the next by rounding": (
        [(1.0, 2.0, 7), (2.0 - 0.5 * ROUNDING, 3.0, 8)], [(1.0, 2.0, 7), (2.0, 3.0, 8)],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", SPANS)
def test_an_instant_belongs_to_the_innermost_span(name: str) -> None:
    spans, expected = SPANS[name]
    found = list(_innermost([(begin, end, at, ()) for begin, end, at in spans]))
    assert found == [(begin, end, at, ()) for begin, end, at in expected]


@pytest.mark.parametrize(
    ("ats", "loops", "iterates"),
    [
        ([], [], True),
        ([5], [], False),
        ([5, 5], [], True),
        ([5, 5, 6], [], False),
        ([5, 6, 5, 6], [], True),
        ([], [(0.0, 4.0)], True),
        ([], [(0.0, 5.0)], False),
        ([], [(0.0, 3.0), (4.0, 6.0)], False),
        ([], [(6.0, 99.0)], True),  # 4 s of it are before 10 s
        ([], [(5.0, 99.0)], False),
    ],
)
def test_a_single_wait_or_an_inner_loop_is_no_iteration(
    ats: list[int], loops: list[tuple[float, float]], iterates: bool
) -> None:
    waits: list[Any] = [("main", at) for at in ats]
    assert _iterates(waits, loops, 0.0, 10.0) is iterates


def test_changes_by_channel_and_rows_by_time() -> None:
    changes = [SimpleNamespace(time=time, channel=n) for time, n in ((1.0, 4), (2.0, 5), (3.0, 4))]
    assert _by_channel(changes) == {None: [1.0, 2.0, 3.0], 4: [1.0, 3.0], 5: [2.0]}
    rows = [1.0, 2.0, 2.0, 3.0]
    found = [
        _up_to(rows, index, time, float) for index, time in ((0, 2.0), (2, 2.0), (1, 2.5), (0, 9.0), (3, 0.0))
    ]
    assert found == [1, 2, 3, 4, 3]


def test_motion_that_a_loop_starts_begins_within_it() -> None:
    """Motion that begins with the loop, or as it ends, was not started by it."""
    polls: Any = SimpleNamespace(_started=[(1.0, 5), (2.0, 5), (2.5, 6), (3.0, 5)])
    lines = frozenset((5, 7))
    times = [(1.0, 3.0), (0.9, 3.1), (1.0 - 2 * ROUNDING, 3.0), (2.0, 2.9), (3.1, 9.0)]
    found = [Polls._starts(polls, lines, begin, end) for begin, end in times]
    assert found == [[2.0], [1.0, 2.0, 3.0], [1.0, 2.0], [], []]


def test_the_last_change_of_an_input_within_a_wait() -> None:
    """A change with the start of the wait came before it; one at its end counts."""
    log = SimpleNamespace(
        inputs=[SimpleNamespace(time=time, channel=n) for time, n in ((1.0, 4), (2.0, 5), (3.0, 4))],
        analogue_inputs=[SimpleNamespace(time=2.5, channel=4)],
    )
    polls: Any = SimpleNamespace(
        _changes=None,
        _run=SimpleNamespace(controller=SimpleNamespace(log=log)),
        _motions=SimpleNamespace(last_end=lambda number, begin, end: (number, begin, end)),
    )
    asked = [
        ("input", 4, 0.0, 3.0), ("input", 4, 1.0, 2.9), ("input", 4, 0.9, 2.9), ("input", None, 0.0, 2.5),
        ("input", 9, 0.0, 9.0), ("analogue", 4, 0.0, 9.0), ("analogue", 5, 0.0, 9.0), ("axis", 2, 0.5, 0.7),
        ("position", 2, 0.5, 0.7), ("time", None, 0.0, 9.0),
    ]  # fmt: skip
    found = [Polls._changed(polls, *each) for each in asked]
    assert found == [3.0, None, 1.0, 2.0, None, 2.5, None, (2, 0.5, 0.7), (2, 0.5, 0.7), None]
