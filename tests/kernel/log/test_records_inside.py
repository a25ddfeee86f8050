"""Seen from inside: records, moves and profiles of a log, by hand."""

from __future__ import annotations

from math import inf

import pytest

from motionlang.kernel import Controller
from motionlang.kernel.log.log import LoggedMoves
from motionlang.kernel.log.records import TimeSlices
from motionlang.kernel.log.stream import Budget
from motionlang.kernel.log.time_slices import TimeSliceStream
from motionlang.kernel.planners import hold
from tests.kernel.log.test_records import filled, shuttled
from tests.proof.order import Order, PathOrder, Tie


@pytest.mark.parametrize(("moves", "left"), [(9, 11), (18, 20), (19, 10), (30, 10)])
def test_a_log_that_forgets_drops_the_oldest_profiles(moves: int, left: int) -> None:
    """A controller that retains one record of a kind retains ten profiles if there are more than twenty."""
    controller = shuttled(moves)
    controller.forget_history(1)
    assert [move.line for move in controller.log.moves] == [moves]
    a = controller.axes[0]
    assert (len(a.starts), len(a.profiles)) == (left, left)


@pytest.mark.parametrize("index", range(3))
def test_a_move_continues_as_another_entry(index: int) -> None:
    moves = LoggedMoves(Budget())
    for k in range(3):
        moves.add(filled(line=k, start_time=1.0, offset=5.0))
    move, done = moves[index], hold(4.0)
    moves.split(move, done, 3.0)
    assert (len(moves), moves[3]) == (4, move)
    assert (moves[index].ended, moves[index].profile, moves[index].start_time) == ("continued", done, 1.0)
    assert (moves[3] is move, move.start_time, move.offset, moves[index].offset) == (True, 3.0, 0.0, 5.0)
    moves.split(move, done, 4.0)
    assert [each.line for each in moves] == [0, 1, 2, index, index]
    moves.forget(0)
    moves.split(move, done, 5.0)
    assert list(moves) == [move]


def test_time_slices_without_a_wait_are_one_record() -> None:
    slices = TimeSliceStream(Budget())
    slices.took("one", 1.0, 2.5, True)
    slices.took("one", 3.0, 4.0, False)
    slices.took("two", 4.0, 4.25, False)
    slices.took("one", 4.25, 6.25, True)
    slices.took("two", 7.0, 7.5, False)
    slices.close(8.0)
    slices.took("two", 9.0, 9.5, True)
    assert list(slices) == [
        TimeSlices(1.0, 2.5, ("one",), (1.5,)),
        TimeSlices(3.0, 6.25, ("one", "two"), (3.0, 0.25)),
        TimeSlices(7.0, 8.0, ("two",), (0.5,)),
        TimeSlices(9.0, 9.5, ("two",), (0.5,)),
    ]


PATH = PathOrder(
    *((0, 1), (1.0, 1.0), 2.0, 3, True, (3.0, 4.0), (0.0, 0.0), 0.0, (), (0, 1), 5.0),
    *((10.0, 11.0), (12.0, 13.0), (14.0, 15.0), 0.0),
    entry=6,
)


@pytest.mark.parametrize(
    ("order", "settings"),
    [
        (Order("jog", 7, 5.0, (1.0, 2.0), goal=-5.0), ("jog", 5.0, -5.0, (1.0, 2.0), None)),
        (
            Order("Gear", 7, tie=Tie(Controller(1).axes[0], 2.5)),
            ("Gear", inf, 0.0, (inf, inf), 2.5),
        ),
        (
            Order("path", 7, 5.0, (1.0, 2.0), path=PATH),
            ("path", 6, 5.0, (1.0, 2.0), ((10.0, 11.0), (12.0, 13.0), (14.0, 15.0)), False),
        ),
    ],
)
def test_the_settings_that_affect_a_motion_in_progress(order: Order, settings: tuple[object, ...]) -> None:
    assert order.settings == settings


@pytest.mark.parametrize(
    ("shape", "jerk", "bends"),
    [("trapezoid", inf, False), ("trapezoid", 1e9, True), ("scurve", inf, True), ("sinusoidal", inf, True)],
)
def test_an_order_whose_acceleration_is_continuous(shape: str, jerk: float, bends: bool) -> None:
    assert Order("move", 7, jerks=(jerk, inf), shape=shape).bends is bends
