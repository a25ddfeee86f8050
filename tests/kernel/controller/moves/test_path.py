"""Paths of several axes: figures, joins, blends, and their exact geometry."""

from __future__ import annotations

import math
from typing import Any

import pytest

from motionlang.kernel import Controller
from tests.kernel.controller.machines import until


def plane(axes: int = 2, **settings: float | str) -> Controller:
    """Return axes with 100, 50 and 200 counts per unit.

    Each has 10 units/s and 100 units/s².
    """
    c = Controller(axes)
    for axis, counts in zip(c.axes, (100.0, 50.0, 200.0), strict=False):
        c.set_scale(axis, counts)
        for name, value in {"speed": 10.0, "accel": 100.0, "decel": 100.0}.items():
            c.configure(axis, name, value * counts)
        for name, value in {"buffer_size": 20, **settings}.items():  # type: ignore[assignment]
            c.configure(axis, name, value)
    return c


def positions(c: Controller, time: float | None = None) -> list[float]:
    """Return the positions of the axes, user units."""
    now = c.clock.now if time is None else time
    return [a.position(now) / a.scale.counts for a in c.axes.values()]


def path_speed(c: Controller, time: float) -> float:
    return math.hypot(*(a.velocity(time) / a.scale.counts for a in c.axes.values()))


# ------------------------------------------------------------------------------------------------- lines


# --------------------------------------------------------------------------------------------------- arcs


def test_a_full_circle_ends_where_it_began_to_the_last_bit() -> None:
    c = plane()
    until(c, 0.0).define_position(0, 12.3)
    c.load_arc([0, 1], [200.0, 77.0], 360.0, (), True)
    c.go([0])
    assert [until(c, 5.0).position(axis) for axis in (0, 1)] == [12.3, 0.0]


# ------------------------------------------------------------------------------- stop, suspend, abort, faults


# ------------------------------------------------------------------------------------------------ contours


def test_stop_runs_on_over_the_join_where_it_must() -> None:
    c = plane(contour_mode=True, contour_angle=1.0)
    c.load_line_by([0, 1], [400.0, 0.0])
    c.load_line_by([0, 1], [400.0, 0.0])
    c.go([0])
    until(c, 0.43).stop(0)  # at 3.8, half a unit from rest
    until(c, 9.0)
    assert positions(c) == pytest.approx([4.3, 0.0])
    assert [move.ended for move in c.log.moves] == ["", "", "stop", "stop"]
    assert len(c.log.dropped) == 0


# ------------------------------------------------------------------------------------------------- blends


def contour() -> Controller:
    """Return a contour of three paths of 3 by 4 units, at 10, 5 and 10 units/s."""
    c = plane(contour_mode=True, contour_angle=10.0, feedrate_mode=3)
    for line, speed in enumerate((1000.0, 500.0, 1000.0), 1):
        c.configure(0, "speed", speed)
        c.load_line_by([0, 1], [300.0, 200.0], "VECTORR", line)
    c.go([0])
    return c


# Line, start, duration, distance along the path and the cause of an early end.
Row = tuple[int, float, float, float, str]


def rows(c: Controller) -> list[Any]:
    """Return the entries of the log, which are the same for both axes."""
    found: list[list[Row]] = [[], []]
    for move in c.log.moves:
        assert move.profile is not None
        distance = move.profile.distance / (60.0, 40.0)[move.axis]
        found[move.axis].append((move.line, move.start_time, move.profile.duration, distance, move.ended))
    assert found[1] == [(row[0], *(pytest.approx(each) for each in row[1:4]), row[4]) for row in found[0]]
    return found[0]


CHANGES: dict[str, tuple[list[tuple[float, str, tuple[object, ...]]], list[Row], float]] = {
    "none": (
        [], [(1, 0.0, 0.5625, 5.0, ""), (2, 0.5625, 1.0, 5.0, ""), (3, 1.5625, 0.5625, 5.0, "")], 15.0,
    ),
    "a stop that rests in the next path": (
        [(0.5125, "stop", (1,))], [(1, 0.0, 0.5625, 5.0, ""), (2, 0.5625, 0.05, 0.125, "stop")], 5.125,
    ),
    "a stop in the second path": (
        [(1.0, "stop", (0,))],
        [(1, 0.0, 0.5625, 5.0, ""), (2, 0.5625, 0.4875, 0.4375 * 5.0 + 0.125, "stop")], 7.3125,
    ),
    "an abort in the second path": (
        [(0.7, "abort", (1,))], [(1, 0.0, 0.5625, 5.0, ""), (2, 0.5625, 0.1375, 0.6875, "cancel")], 5.6875,
    ),
    # From rest at 5.125, 0.125 up to 5 units/s, and 4.75 at it.
    "a suspension that rests in the next path": (
        [(0.5125, "suspend", (0,)), (1.0, "resume", (0,))],
        [(1, 0.0, 0.5625, 5.0, ""), (2, 0.5625, 1.4375, 5.0, ""), (3, 2.0, 0.5625, 5.0, "")], 15.0,
    ),
    # At 2.5 the speed halves: 0.05 s over 0.375, 0.40625 s at 5, and 0.025 s down to 2.5 units/s.
    "half of all speeds": (
        [(0.3, "configure", (0, "override", 0.5))],
        [(1, 0.0, 0.78125, 5.0, ""), (2, 0.78125, 2.0, 5.0, ""), (3, 2.78125, 1.03125, 5.0, "")], 15.0,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CHANGES)
def test_a_contour_and_its_log_after_a_change(name: str) -> None:
    """At 100 units/s² a change from 10 to 5 units/s takes 0.05 s over 0.375.

    A change from 10 to 0 takes 0.1 s over 0.5. So the first path takes 0.1 + 4.125/10 + 0.05 s, the second 5/5 s, and
    the third as long as the first.
    """
    changes, wanted, end = CHANGES[name]
    c = contour()
    for time, verb, arguments in changes:
        getattr(until(c, time), verb)(*arguments)
    until(c, 9.0)
    assert rows(c) == [(row[0], *(pytest.approx(each) for each in row[1:4]), row[4]) for row in wanted]
    assert (c.position(0), c.position(1)) == pytest.approx((end * 60.0, end * 40.0))
    assert (c.target(0), c.target(1)) == (c.position(0), c.position(1))
    assert (c.is_idle(0), c.is_idle(1), c.room(0)) == (True, True, 20)
