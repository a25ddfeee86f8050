"""Fit of any motion by PVT points: within tolerance, on the grid, fewest segments."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel.planners import Profile, hold, plan, plan_trapezoid
from motionlang.lab.pvt.fit import Fit, OutOfTolerance, fit_track, least_tolerance
from motionlang.lab.pvt.points import plan_points
from tests.cases import examples

LIMITS = (40_000.0, 100_000.0, 100_000.0)
SHAPES = {
    "trapezoid": plan_trapezoid(0.0, 40_000.0, *LIMITS),
    "sinusoidal": plan("sinusoidal", 0.0, 40_000.0, *LIMITS),
    "parabolic": plan("parabolic", 0.0, 40_000.0, *LIMITS),
    "scurve": plan("scurve", 0.0, -40_000.0, *LIMITS, accel_jerk=1e6),
}


def fit_profile(profile: Profile, tolerance: float) -> Fit:
    return fit_track([0.0], [profile], tolerance, 0.0, profile.duration)


def error_of(fit_points: Profile, motion: Profile, span: float) -> float:
    """Return the largest difference, at other times than those that the fit checks."""
    times = np.linspace(0.0, span, 1999)
    return max(abs(fit_points.position(float(t)) - motion.position(float(t))) for t in times)


@pytest.mark.parametrize("name", list(SHAPES))
@pytest.mark.parametrize("tolerance", [0.6, 2.0, 20.0])
def test_the_fit_stays_within_its_tolerance(name: str, tolerance: float) -> None:
    motion = SHAPES[name]
    fit = fit_profile(motion, tolerance)
    assert fit.error <= tolerance
    seen = error_of(plan_points(fit.points), motion, sum(p.time for p in fit.points))
    assert seen <= tolerance * (1 + 1e-3)
    assert seen >= fit.error * 0.99 or fit.error < 1e-6


@pytest.mark.parametrize("name", list(SHAPES))
def test_the_points_are_what_the_wire_can_say(name: str) -> None:
    fit = fit_profile(SHAPES[name], 1.0)
    for point in fit.points:
        assert point.velocity is not None
        assert point.position == round(point.position)
        assert point.velocity * 10 == pytest.approx(round(point.velocity * 10), abs=1e-6)
        assert point.time * 1000 == pytest.approx(round(point.time * 1000), abs=1e-9)
    assert all(0.001 <= point.time <= 0.2551 for point in fit.points[:-1])
    assert fit.points[-1].time == 0.0
    assert fit.points[-1].position == round(SHAPES[name].end)


def test_a_looser_tolerance_never_takes_more_segments() -> None:
    counts = [
        len(fit_profile(SHAPES["sinusoidal"], tolerance).points) - 1 for tolerance in (0.6, 1.0, 5.0, 50.0)
    ]
    assert counts == sorted(counts, reverse=True)
    assert counts[0] > counts[-1]


def fewest_by_trial(motion: Profile, tolerance: float, milliseconds: int) -> int:
    """Return the fewest segments, by exhaustive search."""
    position = [round(motion.position(k / 1000)) for k in range(milliseconds + 1)]
    velocity = [round(motion.velocity(k / 1000), 1) for k in range(milliseconds + 1)]
    velocity[-1] = 0.0
    hops = [0] + [10**9] * milliseconds
    for j in range(1, milliseconds + 1):
        for i in range(j):
            if hops[i] + 1 < hops[j] and _close(motion, position, velocity, i, j, tolerance):
                hops[j] = hops[i] + 1
    return hops[-1]


def _close(motion: Profile, p: list[int], v: list[float], i: int, j: int, tolerance: float) -> bool:
    t = (j - i) / 1000
    b2 = 3 * (p[j] - p[i]) / t**2 - (2 * v[i] + v[j]) / t
    b3 = (v[j] + v[i]) / t**2 + 2 * (p[i] - p[j]) / t**3
    for k in range(4 * (j - i) + 1):
        x = k / 4000
        if abs(p[i] + x * (v[i] + x * (b2 + x * b3)) - motion.position(i / 1000 + x)) > tolerance:
            return False
    return True


@settings(max_examples=examples(12))
@given(st.floats(30.0, 400.0), st.floats(0.51, 3.0), st.floats(1e5, 4e5))
def test_no_choice_of_knots_takes_fewer_segments(distance: float, tolerance: float, accel: float) -> None:
    motion = plan("sinusoidal", 0.0, distance, 1e5, accel, accel)
    milliseconds = int(np.ceil(motion.duration * 1000 - 1e-6))
    try:
        found = len(fit_profile(motion, tolerance).points) - 1
    except OutOfTolerance:
        found = 10**9
    assert found == fewest_by_trial(motion, tolerance, milliseconds)


def test_a_history_is_followed_through_its_pauses() -> None:
    first, second = (
        plan_trapezoid(0.0, 1000.0, 5000.0, 5e4, 5e4),
        plan_trapezoid(1000.0, 0.0, 5000.0, 5e4, 5e4),
    )
    starts = [0.0, 0.00005, 0.00005 + first.duration, 1.0]
    history = [hold(0.0), first, hold(1000.0), second]
    fit = fit_track(starts, history, 1.0, starts[1], 1.0 + second.duration)
    assert fit.error <= 1.0
    assert plan_points(fit.points).position(0.6) == pytest.approx(1000.0, abs=1.0)
    assert fit.points[-1].position == 0.0


def test_a_motion_as_fast_as_the_wire_allows_is_exact_at_its_knots() -> None:
    motion = SHAPES["trapezoid"]
    fit, time = fit_profile(motion, 0.6), 0.0
    for point, following in pairwise(fit.points):
        assert point.position == pytest.approx(motion.position(time), abs=0.5)
        time += point.time
        assert following.position == pytest.approx(motion.position(time), abs=0.5)


def test_rounding_alone_can_be_too_much() -> None:
    motion = plan("sinusoidal", 0.3, 777.7, 5000.0, 20_000.0, 20_000.0)
    with pytest.raises(OutOfTolerance, match=r"to 0.2 counts beyond 0.000 s"):
        fit_profile(motion, 0.2)
    least = least_tolerance([0.0], [motion], 0.2, 0.0, motion.duration)
    assert least is not None
    assert fit_profile(motion, least * 1.001).error <= least * 1.001


def test_a_jump_cannot_be_followed() -> None:
    with pytest.raises(OutOfTolerance, match=r"beyond 0\.\d+ s"):
        fit_track([0.0, 0.1], [hold(0.0), hold(50.0)], 1.0, 0.0, 0.2)


@pytest.mark.parametrize("tolerance", [0.0, -1.0, float("nan"), float("inf")])
def test_impossible_tolerances_are_refused(tolerance: float) -> None:
    with pytest.raises(ValueError, match="tolerance"):
        fit_profile(SHAPES["trapezoid"], tolerance)


@pytest.mark.parametrize("end", [0.0, -1.0, 4000.0])
def test_impossible_spans_are_refused(end: float) -> None:
    with pytest.raises(ValueError, match="a fit needs a motion of more than 0"):
        fit_track([0.0], [hold(0.0)], 1.0, 0.0, end)
