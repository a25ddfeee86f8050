"""MV: the trapezoid between two steps of velocity, judged by its pieces."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.mccl.axis.launch import _stepped
from motionlang.profile.verify import verify

rates = st.floats(100.0, 1e5)


@settings(max_examples=300)
@given(
    st.integers(-(10**6), 10**6),
    st.integers(1, 10**6),
    st.booleans(),
    st.floats(0.01, 1.0),
    rates,
    rates,
    rates,
)
def test_it_is_a_sound_profile_that_keeps_its_limits(
    start: int, distance: int, back: bool, part: float, speed: float, accel: float, decel: float
) -> None:
    target = float(start + (-distance if back else distance))
    low = part * speed
    profile = _stepped(float(start), target, low, speed, accel, decel)
    complaints = verify(profile, speed=speed, accel=accel, decel=decel, end=target, tolerance=1e-6)
    # The two steps are what a curve of this judge has not; there is nothing else to complain of.
    assert [each for each in complaints if not each.startswith(("the curve starts", "the curve ends"))] == []
    assert len(complaints) == 2
    assert profile.peak_speed >= low * (1 - 1e-9)
    assert profile.velocity(0.0) == 0.0
    assert abs(profile.phases[0].start_velocity) == pytest.approx(low)
    assert abs(profile.phases[-1].end_velocity) == pytest.approx(low)
    assert profile.velocity(profile.duration) == 0.0


def test_it_is_faster_than_from_rest_by_what_is_left_out() -> None:
    """1000 counts at 3000 counts/s2 with 1000 counts/s at either end: v = sqrt(1e6 + 3e6) = 2000, 2 x 1/3 s."""
    profile = _stepped(0.0, 1000.0, 1000.0, 5000.0, 3000.0, 3000.0)
    assert profile.peak_speed == pytest.approx(2000.0)
    assert profile.duration == pytest.approx(2.0 / 3.0)
