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
