"""Stretches of a motion: which of them may be above a limit, by hand."""

from __future__ import annotations

from math import inf, sqrt

import pytest

from motionlang.commands.prove.axes import check_bounds
from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.order import Order, PathOrder
from motionlang.commands.prove.path_bounds import check_along, could_stop
from motionlang.commands.prove.path_layout import PathLayout
from motionlang.commands.prove.segments import Span, spans
from motionlang.commands.prove.stretches import stopping_distance, stretches, unavoidable_speed
from motionlang.kernel.planners import Profile, plan_jerk, plan_trapezoid
from tests.cases import cases

FLAT = Order("move", 3, 10.0, (10.0, 20.0), shape="trapezoid")
SMOOTH = FLAT._replace(rates=(10.0, 10.0), shape="scurve", jerks=(20.0, 10.0))
SHAPED = FLAT._replace(shape="sinusoidal")
FREE = (inf,)
LINE = PathOrder(
    (0,), (1.0,), 0.0, 0, True, (100.0,), (0.0, 0.0), 0.0, (), (0, 1), None, FREE, FREE, FREE, 0.0
)
PATH = FLAT._replace(kind="path", rates=(10.0, 10.0), path=LINE)
LAYOUT = PathLayout(LINE, [0.0])


def span(begin: float, length: float, velocity: float, acceleration: float = 0.0, jerk: float = 0.0) -> Span:
    return Span(begin, length, (0.0, velocity, 0.5 * acceleration, jerk / 6.0, 0.0, 0.0, 0.0))


# Velocity, acceleration and jerk of pieces of 1 s, and which of their stretches slow down without a break, and ease.
@cases(
    "pieces, slows, eases",
    [
        ([(20.0, -5.0, 0.0), (15.0, 0.0, 0.0), (15.0, -5.0, 0.0)], [True, False, False], [False] * 3),
        ([(20.0, 3.0, -3.0), (21.5, 0.0, -3.0)], [True, True], [True, False]),
        ([(-20.0, 5.0, 0.0)], [True], [False]),
        ([(5.0, 5.0, 0.0)], [False], [False]),
        # It comes to rest after 1/2 s, and then speeds up in the other direction.
        ([(5.0, -10.0, 0.0)], [True, False], [False, False]),
        ([(1.0, -4.0, 4.0)], [True, True], [True, True]),
    ],
)  # fmt: skip
def test_a_motion_may_slow_down_to_its_limits(
    pieces: list[tuple[float, float, float]], slows: list[bool], eases: list[bool]
) -> None:
    found = list(stretches(span(float(k), 1.0, *each) for k, each in enumerate(pieces)))
    assert [each.slows for each in found] == slows
    assert [each.eases for each in found] == eases
    assert not any(each.slows for each in stretches([span(0.0, 1.0, 20.0, -5.0)], slows=False))


def test_a_moment_at_one_speed_is_rounding() -> None:
    pieces = [span(0.0, 1.0, 20.0, -5.0), span(1.0, 1e-10, 15.0), span(1.0, 1.0, 15.0, -5.0)]
    assert all(each.slows for each in stretches(pieces))


@cases(
    "order, velocity, acceleration, expected",
    [
        (FLAT, -5.0, 9.0, 5.0),
        (SMOOTH, 5.0, 0.0, 5.0),
        (SMOOTH, 5.0, 10.0, 7.5),
        (SMOOTH, -5.0, -10.0, 7.5),
        (SMOOTH, 5.0, -5.0, 5.0),
        (SMOOTH, 1.0, -10.0, 4.0),
        (SHAPED, 5.0, 0.0, 5.0),
        (SHAPED, 5.0, 1.0, inf),
    ],
)  # fmt: skip
def test_an_acceleration_makes_a_speed_unavoidable(
    order: Order, velocity: float, acceleration: float, expected: float
) -> None:
    assert unavoidable_speed(order, velocity, acceleration) == expected


@cases(
    "order, velocity, acceleration, expected",
    [
        (FLAT, 10.0, 0.0, 2.5),
        (FLAT._replace(rates=(10.0, 0.0)), 10.0, 0.0, inf),
        (SHAPED, 10.0, 0.0, inf),
        (SMOOTH, 10.0, 0.0, 0.5 * 10.0 * (1.0 + 1.0)),
        (SMOOTH, 1.0, -sqrt(20.0), inf),  # its deceleration lasts until rest
    ],
)  # fmt: skip
def test_a_distance_that_suffices_for_a_stop(
    order: Order, velocity: float, acceleration: float, expected: float
) -> None:
    assert stopping_distance(order, velocity, acceleration) == expected


@pytest.mark.parametrize(("position", "room"), [(94.9, True), (95.0, False)])
def test_a_path_with_room_for_a_stop(position: float, room: bool) -> None:
    along = [Span(0.0, 1.0, (position, 10.0, 0.0, 0.0, 0.0, 0.0, 0.0))]
    assert could_stop(PATH, LAYOUT, along) is room


EVEN = SMOOTH._replace(jerks=(20.0, 20.0))
EASING = plan_jerk(0.0, 100.0, 10.0, 20.0, 10.0, 20.0, 20.0, 5.0, 15.0)
# A motion, the state that it takes over, and what it exceeds.
MOTIONS: dict[str, tuple[Order, Profile, tuple[float, float], list[str]]] = {
    "within its limits": (FLAT, plan_trapezoid(0.0, 100.0, 10.0, 10.0, 20.0), (0.0, 0.0), []),
    "too fast at first": (FLAT, plan_trapezoid(0.0, 100.0, 10.0, 10.0, 20.0, 15.0), (15.0, 0.0), []),
    "too fast, then faster": (FLAT, plan_trapezoid(0.0, 100.0, 16.0, 10.0, 20.0, 15.0), (15.0, 0.0), ["speed"]),
    "too fast, and so on": (FLAT, plan_trapezoid(0.0, 100.0, 15.0, 10.0, 20.0, 15.0), (15.0, 0.0), ["speed"]),
    "with the acceleration that it had": (
        EVEN, EASING, (5.0, 15.0),
        [],
    ),
    "with more than it had": (
        EVEN, EASING, (5.0, 0.0),
        ["speed", "acceleration"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", MOTIONS)
def test_a_motion_observes_its_limits(name: str) -> None:
    order, profile, entry, expected = MOTIONS[name]
    proof = Proof()
    check_bounds(proof, order, spans(profile, 0.0, profile.duration), entry, "here")
    assert [each.message.split()[2] for each in proof.violations] == expected


ALONG: dict[str, tuple[Order, list[Span], bool, list[str]]] = {
    "at its speed": (PATH, [span(0.0, 1.0, 10.0)], True, []),
    "too fast": (PATH, [span(0.0, 1.0, 11.0)], False, ["path speed reaches 11, above 10"]),
    "slowing down from a higher speed": (PATH, [span(0.0, 1.0, 11.0, -5.0)], False, []),
    "the same on a fresh path": (
        PATH, [span(0.0, 1.0, 11.0, -5.0)], True, ["path speed reaches 11, above 10"],
    ),
    "slowing down too hard": (PATH, [span(0.0, 1.0, 11.0, -11.0)], False, ["path deceleration reaches 11, above 10"]),
    "stopping": (PATH._replace(path=LINE._replace(comes_to_rest=True)), [span(0.0, 1.0, 10.0, -10.0)], False, []),
    "running on": (
        PATH._replace(path=LINE._replace(comes_to_rest=True)), [span(0.0, 1.0, 10.0)], False,
        ["path speed reaches 10, above 0"],
    ),
    "running on to the next path": (
        PATH._replace(path=LINE._replace(comes_to_rest=True, leads_on=True)), [span(0.0, 1.0, 10.0)], False, [],
    ),
    "too fast for an axis": (
        PATH._replace(path=LINE._replace(most=(8.0,))), [span(0.0, 1.0, 9.0)], False,
        ["speed on paths of axis 0 reaches 9, above 8"],
    ),
    "slowing down for an axis": (
        PATH._replace(path=LINE._replace(most=(8.0,))), [span(0.0, 1.0, 9.0, -2.0)], False, [],
    ),
    "slowing down too hard for an axis": (
        PATH._replace(path=LINE._replace(most_decel=(5.0,))), [span(0.0, 1.0, 9.0, -6.0)], False,
        ["rate on paths of axis 0 reaches 6, above 5"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", ALONG)
def test_a_path_observes_its_limits(name: str) -> None:
    order, along, fresh, expected = ALONG[name]
    proof = Proof()
    check_along(proof, order, order, LAYOUT, along, "here", fresh)
    assert [each.message.removeprefix("here: the ") for each in proof.violations] == expected


def test_a_path_may_not_run_back() -> None:
    proof = Proof()
    check_along(proof, PATH, PATH, LAYOUT, [span(0.0, 1.0, -1.0)], "here")
    assert [each.message for each in proof.violations] == ["here: it runs back along the path, at 1"]
