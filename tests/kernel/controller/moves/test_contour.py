"""Contours that end in a short path or in a stop; random ones are in `tests/metamorphic`."""

from __future__ import annotations

from motionlang.kernel import Controller
from tests.kernel.controller.machines import until
from tests.kernel.controller.moves.test_path import plane, positions

# Paths may be as short as this, in user units.
SHORT = 1e-6


def check_arrival(c: Controller) -> None:
    """Run all loaded paths; check that each takes time and ends exactly as programmed."""
    entries = list(c.axes[0].buffer)
    ends = [c.axes[axis].buffer[-1].target for axis in (0, 1)]
    c.go([0])
    until(c, 1e6)
    assert [c.is_idle(axis) for axis in (0, 1)] == [True, True]
    assert [c.position(axis) for axis in (0, 1)] == ends
    assert [move for move in c.log.moves if move.axis == 0] == entries
    times = [move.profile.duration for move in c.log.moves if move.profile is not None]
    assert len(times) == 2 * len(entries)
    assert min(times) > SHORT / 1000.0


def test_a_short_path_at_the_end_of_long_ones_is_run_to_its_end() -> None:
    c = plane(contour_mode=True)
    for length in (1000.0, 333.3, 777.7, SHORT):
        c.load_line_by([0, 1], [100.0 * length, 0.0])
    check_arrival(c)


def test_a_stop_that_needs_more_room_than_there_is_leaves_the_run_as_it_was_planned() -> None:
    """Axis 0 brakes so slowly that it can only stop on the path after the corner."""
    c = plane(contour_mode=True, contour_angle=180.0, feedrate_mode=1)
    c.configure(0, "max_decel", 100.0 * 10.0)
    for speed, distances in ((2000.0, [4000.0, 0.0]), (1500.0, [0.0, 125.0])):
        c.configure(0, "speed", speed)
        c.load_line_by([0, 1], distances)
    c.go([0])
    until(c, 2.1).stop(0)
    until(c, 99.0)
    assert c.is_idle(0)
    assert positions(c) == [40.0, 2.5]
    assert [move.ended for move in c.log.moves] == ["", "", "stop", "stop"]
