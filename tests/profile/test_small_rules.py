"""Small rules of the motion mathematics by their figures, each where nothing else would tell it from another."""

from __future__ import annotations

import pytest

from motionlang.profile.dissect import s_curve_times, slip_acceleration, trapezoid_times
from motionlang.profile.solve import solve_move


def test_a_load_slips_beyond_friction_times_gravity() -> None:
    assert slip_acceleration(0.4, 9.81) == pytest.approx(3.924)


def test_the_distances_of_ramps_go_by_the_square_of_the_speed() -> None:
    assert trapezoid_times(1000.0, 200.0, 400.0).accel_distance == pytest.approx(50.0)
    assert s_curve_times(1000.0, 200.0, 400.0).accel_distance == pytest.approx(100.0)


@pytest.mark.parametrize("given", [{"time": 1.0}, {"time": 1.0, "distance": 200.0}, {"distance": 200.0}])
def test_equal_ramps_need_the_speed_too(given: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="equal ramps need distance, speed and time"):
        solve_move("equal", **given)
