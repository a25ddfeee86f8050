"""Exact times and positions of Mint's profiles, against hand arithmetic."""

from __future__ import annotations

from math import pi, sin, sqrt

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

RAMPS = "ACCEL(0) = {a} : DECEL(0) = {a} : ACCELJERK(0) = {j} : DECELJERK(0) = {j}\nPROFILEMODE(0) = 1\n"
FIRST = (
    (0.1, 5 / 6, 25.0),
    (0.2, 35 / 6, 75.0),
    (0.3, 15.0, 100.0),
    (0.65, 50.0, 100.0),
    (1.0, 85.0, 100.0),
    (1.1, 565 / 6, 75.0),
    (1.2, 595 / 6, 25.0),
    (1.3, 100.0, 0.0),
)


def ran(text: str) -> Run:
    result = run(Source("a.mnt", text))
    assert [each.message for each in result.diagnostics] == []
    return result


def s_ramp(speed: float, distance: float) -> Run:
    return ran(
        RAMPS.format(a=500, j=5000) + f"SPEED(0) = {speed}\nMOVER(0) = {distance}\nGO(0)\nPAUSE IDLE(0)"
    )


@pytest.mark.parametrize(
    ("speed", "distance", "ramp", "peak_accel", "peak_speed", "time"),
    [
        (100.0, 100.0, 0.3, 500.0, 100.0, 1.3),
        (40.0, 100.0, 2 * sqrt(40 / 5000), sqrt(40 * 5000), 40.0, 2.5 + 2 * sqrt(40 / 5000)),
        (100.0, 10.0, 0.2, 500.0, 50.0, 0.4),
        (100.0, 1.25, 0.1, 250.0, 12.5, 0.2),
    ],
)
def test_the_four_s_ramps(
    speed: float, distance: float, ramp: float, peak_accel: float, peak_speed: float, time: float
) -> None:
    (move,) = s_ramp(speed, distance).controller.log.moves
    profile = move.profile
    assert profile is not None
    assert profile.duration == pytest.approx(time, abs=1e-9)
    assert profile.peak_speed == pytest.approx(peak_speed, abs=1e-9)
    first = profile.phases[0]
    assert first.name == "accel"
    assert [first.duration, first.distance] == pytest.approx([ramp, peak_speed * ramp / 2], abs=1e-9)
    accelerations = [profile.at(k * ramp / 1000).acceleration for k in range(1001)]
    assert max(accelerations) == pytest.approx(peak_accel, rel=1e-9)


def test_the_samples_of_the_first_s_ramp() -> None:
    profile = s_ramp(100.0, 100.0).controller.log.moves[0].profile
    assert profile is not None
    for time, position, velocity in FIRST:
        assert profile.position(time) == pytest.approx(position, abs=1e-9)
        assert profile.velocity(time) == pytest.approx(velocity, abs=1e-9)


def test_a_continuous_spline_goes_over_into_itself() -> None:
    """Four points on a sine: the velocity does not jump where the spline repeats.

    The acceleration jumps only with SPLINE_1.
    """
    values = ", ".join(str(round(10 * sin(2 * pi * k / 8), 6)) for k in range(1, 9))
    result = ran(
        f"Dim way(9) As Float = 8, {values}\nSPLINETABLE(0, way)\nSPLINETIME(0) = 50\n"
        "SPLINE(0) = _spABSOLUTE | _spCONTINUOUS | _spSPLINE_2\nGO(0)\nPAUSE TIME >= 1230\nCANCEL(0)"
    )
    axis = result.controller.axes[0]
    begins = [move.start_time for move in result.controller.log.moves]
    assert len(begins) == 4
    for begin in begins[1:]:
        before, after = axis.at(begin - 1e-9), axis.at(begin + 1e-9)
        assert after.velocity == pytest.approx(before.velocity, abs=1e-5)
        assert after.velocity == pytest.approx(10 * 2 * pi / 0.4, rel=0.01)
