"""PMC TN1069: the worked example, exact and as printed."""

from __future__ import annotations

from math import cos, pi, sin

import pytest

from tests.lab.notes.vendor import tn1069

# During acceleration, by the note: the profile, the time in cycles, and A, V and S in counts and cycles.
TRAPEZOID, SINUSOID, S_CURVE, PARABOLA = range(4)
ACC, VEL, T_S, T_1 = 0.1, 40.0, 200 * pi, 400 / 9
RAMPS = {
    "trapezoid": (TRAPEZOID, 100.0, ACC, ACC * 100, 0.5 * ACC * 100**2),
    "sinusoid": (
        SINUSOID,
        100.0,
        ACC * sin(pi * 100 / T_S),
        VEL / 2 * (1 - cos(pi * 100 / T_S)),
        VEL / 2 * 100 - VEL * T_S / (2 * pi) * sin(pi * 100 / T_S),  # the erratum: the print adds the sine
    ),
    "trapezoidal S-curve": (
        S_CURVE,
        30.0,
        ACC * 30 / T_1,
        ACC * 30 * (30 / (2 * T_1)),
        ACC * 0.5 * 30**2 * (30 / (3 * T_1)),
    ),
}


@pytest.mark.parametrize("name", RAMPS)
def test_the_formulas_of_the_acceleration_phase(name: str) -> None:
    """With t = T/N, ACC = A/N² and VEL = V/N for N = 1000."""
    column, cycles, acceleration, velocity, position = RAMPS[name]
    profile, t = tn1069.profiles()[column], cycles / 1000
    assert profile.acceleration(t) / 1000**2 == pytest.approx(acceleration, rel=1e-9)
    assert profile.velocity(t) / 1000 == pytest.approx(velocity, rel=1e-9)
    assert profile.position(t) == pytest.approx(position, rel=1e-9)


def test_the_ramp_is_the_share_of_the_acceleration_time_in_which_acceleration_rises() -> None:
    """RAMP = T_1/T_A = 0.1: the acceleration rises until T_1 and is then at its peak."""
    profile = tn1069.profiles()[S_CURVE]
    rise = 0.1 * profile.phases[0].duration
    assert rise * 1000 == pytest.approx(T_1, rel=1e-12)
    assert profile.acceleration(0.5 * rise) == pytest.approx(50e3, rel=1e-9)
    assert profile.acceleration(1.5 * rise) == pytest.approx(100e3, rel=1e-12)


def test_the_parabola_begins_with_a_jump_of_acceleration() -> None:
    """The note calls the parabola the smoothest, but only the S-curves begin smoothly."""
    starts = [profile.acceleration(1e-9) for profile in tn1069.profiles()]
    assert starts == pytest.approx([100e3, 0.0, 0.0, 100e3], rel=1e-6, abs=1.0)


def test_the_printed_sinusoidal_position_has_a_wrong_sign() -> None:
    """The integral of V/2 (1 - cos(pi t/T_A)) is 533.84 counts at 0.3 T_A.

    The printed formula gives 7005.98.
    """
    steps, ramp = 100_000, 0.6283185307179586
    width = 0.3 * ramp / steps
    area = sum(20e3 * (1.0 - cos(pi * (i + 0.5) * width / ramp)) for i in range(steps)) * width
    exact = tn1069.profiles()[1].position(0.3 * ramp)
    printed = 20e3 * 0.3 * ramp + 40e3 * ramp / (2.0 * pi) * sin(pi * 0.3)
    assert exact == pytest.approx(area, rel=1e-8)
    assert f"{printed:.2f} {exact:.2f}" == "7005.98 533.84"
