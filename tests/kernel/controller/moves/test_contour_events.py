"""Events on a path in S-ramps, and limits that come in motion; random ones are in `tests/metamorphic`."""

from __future__ import annotations

import pytest

from motionlang.kernel import Controller
from tests.kernel.controller.machines import until
from tests.kernel.controller.moves.test_path import plane, positions


def ramped() -> Controller:
    """Return one path of 40 units with an S-ramp, which follows the override.

    It has 20 units/s, 50 units/s², 400 units/s³.
    """
    c = plane(shape="scurve", feedrate_mode=3)
    for name, value in {"speed": 20.0, "accel": 50.0, "decel": 50.0}.items():
        c.configure(0, name, 100.0 * value)
    for name in ("accel_jerk", "decel_jerk"):
        c.configure(0, name, 100.0 * 400.0)
    c.load_line_by([0, 1], [4000.0, 0.0])
    c.go([0])
    return until(c, 0.35)


@pytest.mark.parametrize("how", ["stop", "suspend"])
def test_what_stops_a_path_takes_its_acceleration_back_first(how: str) -> None:
    """The path has covered 2.099 at a speed of 14.375.

    Its acceleration falls to zero in 0.125 s, which covers 2.057 and leads to a speed of 17.5. From there it
    comes to rest in 0.475 s, at half of that speed on average.
    """
    c = ramped()
    getattr(c, how)(0)
    until(c, 9.0)
    assert positions(c)[0] == pytest.approx(8.3125, rel=1e-12)


@pytest.mark.parametrize("override", [0.0, 0.5])
def test_a_new_override_takes_the_acceleration_of_a_path_back_first(override: float) -> None:
    c = ramped()
    before = c.axes[0].at(c.clock.now).acceleration
    c.configure(0, "override", override)
    assert c.axes[0].at(c.clock.now).acceleration == pytest.approx(before)
    until(c, 2.0)
    assert c.path_speed(0) == pytest.approx(20.0 * override)
    c.configure(0, "override", 1.0)
    until(c, 9.0)
    assert positions(c) == [40.0, 0.0]


@pytest.mark.parametrize("axis", [0, 1])
def test_a_limit_that_comes_in_motion_is_met(axis: int) -> None:
    """From 10 units/s on each of two perpendicular axes, one slows down to 4."""
    c = plane(contour_mode=True)
    c.load_line_by([0, 1], [3000.0, 2000.0])  # 30 by 40 units: 50
    c.go([0])
    until(c, 2.0)
    counts = (100.0, 50.0)[axis]
    c.configure(axis, "max_speed", 4.0 * counts)
    until(c, 2.2)
    assert abs(c.velocity(axis)) == pytest.approx(4.0 * counts)
    c.configure(axis, "max_decel", 2.0 * counts)
    until(c, 99.0)
    assert positions(c) == [30.0, 40.0]
    # 4 units/s at 2 units/s² take two seconds
    last = c.axes[axis].starts[-1]
    assert c.axes[axis].velocity(last - 1.0) == pytest.approx(2.0 * counts)


def test_a_limit_that_comes_in_motion_is_met_by_a_single_axis() -> None:
    c = plane()
    c.load_by(0, 5000.0)
    c.go([0])
    until(c, 2.0)
    c.configure(0, "max_speed", 400.0)
    assert c.velocity(0) == pytest.approx(1000.0)
    until(c, 2.06)
    assert c.velocity(0) == pytest.approx(400.0)
    until(c, 99.0)
    assert c.position(0) == 5000.0
