"""Planners at the limits of the floating-point range.

An extreme figure is named in an error; all other moves arrive.
"""

from __future__ import annotations

import math
import random

import pytest

from motionlang.kernel.planners import Profile, plan, plan_stop, plan_velocity

SHAPES = ("trapezoid", "sinusoidal", "scurve", "ratio", "parabolic")
SIZES = (1e-300, 1e-100, 1e-60, 1e-45, 1e-30, 1e-11, 1e-6, 1.0, 1e3, 1e11, 1e30, 1e45, 1e59, 1e100, 1e300)


def arrives(made: Profile) -> bool:
    """True if the last piece ends at the profile's end and time never decreases.

    The tolerance is a millionth of the distance.
    """
    assert 0.0 <= made.duration < math.inf
    assert all(a <= b for a, b in zip(made.knots, made.knots[1:], strict=False))
    if not made.pieces:
        return True
    x = made.knots[-1] - made.knots[-2]
    c0, c1, c2, c3, amplitude, omega, phase = made.drawn[1][-1]
    end = c0 + x * (c1 + x * (c2 + x * c3)) + amplitude * math.sin(omega * x + phase)
    low, high = made.extrema()
    return abs(end - made.end) <= 1e-6 * max(abs(low), abs(high), 1e-40)  # shorter distances are rest


@pytest.mark.parametrize("shape", SHAPES)
def test_any_figures_are_planned_or_refused(shape: str) -> None:
    choose = random.Random(1)
    name, jerked = "scurve" if shape == "ratio" else shape, shape == "scurve"
    planned, refusals = 0, []
    for _ in range(4000):
        target, speed, accel, decel, up, down = (choose.choice(SIZES) for _ in range(6))
        v0 = choose.choice((0.0, *SIZES)) * choose.choice((1.0, -1.0))
        a0 = choose.choice((0.0, *SIZES)) * jerked
        jerks = (up, down) if jerked else (math.inf, math.inf)
        try:
            assert arrives(plan(name, 0.0, target, speed, accel, decel, v0, 0.2, *jerks, a0))
            planned += 1
        except ValueError as rejected:
            refusals.append(str(rejected))
        for stops in (True, False):
            try:
                made = (
                    plan_stop(name, 0.0, v0, decel, 0.2, jerks[1], a0)
                    if stops
                    else plan_velocity(name, 0.0, v0, speed, accel, decel, 0.2, *jerks, a0)
                )
                assert all(a <= b for a, b in zip(made.knots, made.knots[1:], strict=False))
            except ValueError as rejected:
                refusals.append(str(rejected))
    assert planned > 100
    assert all("must" in each or "too large" in each for each in refusals)


def test_an_s_ramp_whose_rates_are_eleven_orders_apart_arrives() -> None:
    figures = (1.4387825727183687, 64173.010904578776, 0.0005777507437060507, 21760.24809664754)
    moving = (59.37637028175413, 0.0, 4.828478582080218e-06, 228561.47941781947, -11.894882508279176)
    assert arrives(plan("scurve", 0.0, *figures, *moving))


def test_a_peak_is_not_below_the_speed_at_the_start_by_rounding() -> None:
    made = plan("trapezoid", 1e-60, 2e-60, 1e-06, 1e-30, 1.0, 1e-30)
    assert made.duration >= 0.0
