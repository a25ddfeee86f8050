"""Slip of a load, computed by hand.

With a friction of 0.5 at a gravity of 10 the limit is 5.
"""

from __future__ import annotations

from math import asin, pi, sin
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from motionlang.kernel.planners import hold, plan
from tests.lab.notes.vendor.slip import Slip, check_profile, check_trace

# A sine ramp to 5 at 10 takes (π/2) 5/10 s: its acceleration is 10 sin(4 t), above 5 where sin(4 t) exceeds 0.5.
SINE = plan("sinusoidal", 0.0, 10.0, 5.0, 10.0, 10.0)
RAMP, RISE = pi / 4.0, asin(0.5) / 4.0
# The acceleration of an S-ramp of a fifth rises by 80/s: it is above 5 from 1/16 s on, of 5/8 s.
RISING = plan("scurve", 0.0, 10.0, 5.0, 10.0, 10.0, ramp=0.2)


def test_a_sine_slips_around_the_crests_of_both_ramps() -> None:
    found = check_profile(SINE, 0.5, 10.0)
    assert (found.limit, found.peak, found.peak_time) == pytest.approx((5.0, 10.0, RAMP / 2.0))
    slowing = 10.0 / 5.0
    expected = [(RISE, RAMP - RISE), (slowing + RISE, slowing + RAMP - RISE)]
    assert np.array(found.spans) == pytest.approx(np.array(expected))
    assert found.slips
    assert found.margin == pytest.approx(-1.0)


@pytest.mark.parametrize(("cut", "peak_time"), [(0.1, RAMP / 2.0 - 0.1), (0.5, 0.0)])
def test_the_rest_of_a_sine_slips_earlier(cut: float, peak_time: float) -> None:
    """After 0.5 s its crest, at 0.39 s, is over: 10 sin(4 * 0.5) is the peak."""
    found = check_profile(SINE.after(cut), 0.5, 10.0)
    assert found.spans[0] == pytest.approx((max(RISE - cut, 0.0), RAMP - RISE - cut))
    slowing = 10.0 / 5.0 - cut
    assert found.spans[1] == pytest.approx((slowing + RISE, slowing + RAMP - RISE))
    assert found.peak == pytest.approx(10.0)
    assert found.peak_time == pytest.approx(peak_time if cut < 0.39 else slowing + RAMP / 2.0)


@pytest.mark.parametrize("direction", [1.0, -1.0])
@pytest.mark.parametrize("scale", [1.0, 4.0])
def test_both_ramps_slip_in_both_directions(direction: float, scale: float) -> None:
    """In counts, `scale` to the unit, everything is that much larger."""
    size = direction * scale
    profile = plan("scurve", 0.0, 10.0 * size, 5.0 * scale, 10.0 * scale, 10.0 * scale, ramp=0.2)
    found = check_profile(profile, 0.5, 10.0, scale)
    assert found.peak == pytest.approx(10.0)
    assert np.array(found.spans) == pytest.approx(np.array([(0.0625, 0.5625), (2.0625, 2.5625)]))


@pytest.mark.parametrize(("until", "end"), [(0.5, 0.5), (0.59, 0.5625), (5.0, 0.5625), (0.05, None)])
def test_a_linear_acceleration_slips_between_the_times_at_the_limit(until: float, end: float | None) -> None:
    found = check_profile(RISING.cut(until), 0.5, 10.0)
    if end is None:
        assert found.spans == ()
        assert found.peak == pytest.approx(80.0 * 0.05)
    else:
        assert found.spans[0] == pytest.approx((0.0625, end))
        assert found.peak == pytest.approx(10.0)


def test_the_larger_of_two_peaks_has_the_time() -> None:
    found = check_profile(plan("trapezoid", 0.0, 10.0, 5.0, 2.0, 8.0), 0.5, 10.0)
    slowing = 2.5 + (10.0 - 0.5 * 5.0 * (2.5 + 0.625)) / 5.0
    assert (found.peak, found.peak_time) == pytest.approx((8.0, slowing))
    (span,) = found.spans
    assert span == pytest.approx((slowing, slowing + 0.625))


def test_ramps_that_touch_are_one_slip() -> None:
    """Without a stretch at speed, 2.5 at 10 takes 0.5 s up and 0.5 s down."""
    found = check_profile(plan("trapezoid", 0.0, 2.5, 5.0, 10.0, 10.0), 0.5, 10.0)
    (span,) = found.spans
    assert span == pytest.approx((0.0, 1.0))


def test_an_acceleration_at_the_limit_does_not_slip() -> None:
    assert check_profile(plan("trapezoid", 0.0, 10.0, 5.0, 5.0, 5.0), 0.5, 10.0).spans == ()


@pytest.mark.parametrize(("excess", "slips"), [(1e-9, False), (1.001e-9, True)])
def test_a_billionth_of_the_limit_is_rounding(excess: float, slips: bool) -> None:
    """It applies to profiles and to samples."""
    size = 5.0 * (1.0 + excess)
    trapezoid = check_profile(plan("trapezoid", 0.0, 10.0, 5.0, size, size), 0.5, 10.0)
    samples = sampled([0.0, size, -size], [0.0, 1.25, 0.0])
    assert [each.slips for each in (trapezoid, samples)] == [slips] * 2


def test_a_standstill_has_no_peak() -> None:
    assert check_profile(hold(7.0, 1.0), 0.5, 10.0) == Slip(5.0, 0.0, 0.0, (), 0.0)


@pytest.mark.parametrize(
    ("shape", "knot", "after", "peak"),
    [("sinusoidal", -2, 0.2, 10.0 * sin(0.8)), ("scurve", -4, 0.1, 8.0), ("trapezoid", -2, 0.0, 4.0)],
)
def test_an_acceleration_after_the_end_of_a_move_does_not_count(
    shape: str, knot: int, after: float, peak: float
) -> None:
    """The move ends before its ramp down, from `knot` on, reaches 10.

    The sine ramp from 5 has 10 sin(4 t), the S-ramp of a fifth 80 t. The trapezoid ends before its ramp down; the peak
    of its ramp up is 4.
    """
    profile = plan(shape, 0.0, 50.0, 5.0, 4.0, 10.0, ramp=0.2)
    end = profile.knots[knot] + after
    found = check_profile(profile.cut(end), 0.5, 10.0)
    assert (found.peak, found.peak_time) == pytest.approx((peak, end if after else 0.0))


class Trace:
    """A trace with a sample every 0.25 s, as far as slip reads it."""

    def __init__(self, acceleration: list[float], velocity: list[float]) -> None:
        self.loop = SimpleNamespace(period=0.25)
        self.acceleration, self.velocity = np.array(acceleration), np.array(velocity)

    def __len__(self) -> int:
        return len(self.velocity)


def sampled(acceleration: list[float], velocity: list[float], scale: float = 1.0) -> Slip:
    trace: Any = Trace(acceleration, velocity)
    return check_trace(trace, 0.5, 10.0, scale)


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("scale", [1.0, 4.0])
def test_the_load_follows_as_fast_as_friction_allows(sign: float, scale: float) -> None:
    """At 5 a velocity changes by 1.25 in a sample of 0.25 s.

    Of the step from 1 to 4 the load does 1.25 at once, 1.25 in the next sample, and the rest in the third: it is 1.75
    and 0.5 behind, each for 0.25 s.
    """
    velocities = [sign * scale * v for v in (0.0, 1.0, 4.0, 4.0, 4.0, 4.0)]
    accelerations = [sign * scale * a for a in (0.0, 4.0, 6.0, -8.0, 2.0, 7.0)]
    found = sampled(accelerations, velocities, scale)
    assert (found.limit, found.peak, found.peak_time) == pytest.approx((5.0, 8.0, 0.75))
    assert found.spans == ((0.5, 1.0), (1.25, 1.5))
    assert found.distance == pytest.approx((1.75 + 0.5) * 0.25)


def test_a_load_in_motion_begins_at_the_speed_of_its_carrier() -> None:
    """As the carrier goes from 9 to 12, the load reaches 10.25; then both are at 9."""
    assert sampled([5.0, 5.0], [9.0, 10.25]) == Slip(5.0, 5.0, 0.0, (), 0.0)
    assert sampled([0.0, 0.0, 0.0], [9.0, 12.0, 9.0]).distance == pytest.approx(1.75 * 0.25)


def test_a_trace_without_samples_has_no_slip() -> None:
    found = sampled([], [])
    assert found == Slip(5.0, 0.0, 0.0, (), 0.0)
    assert (found.slips, found.margin) == (False, 1.0)
