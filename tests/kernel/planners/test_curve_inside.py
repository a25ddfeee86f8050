"""Seen from inside: a profile as a function of time: values, crossings, cutting and joining."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners import Profile, plan
from motionlang.kernel.planners.curve import relabelled
from motionlang.kernel.planners.table_motion import table_curve
from tests.kernel.planners.cases import quick
from tests.kernel.planners.splines import cubic_table
from tests.kernel.planners.test_curve import fractions


@quick
@given(
    st.lists(st.floats(-100.0, 100.0), min_size=3, max_size=30),
    st.sampled_from((table_curve, cubic_table)),
    fractions,
)
def test_no_crossing_of_a_table_is_missed(
    values: list[float], make: Callable[..., Profile], fraction: float
) -> None:
    made = make([float(n) for n in range(len(values))], values)
    reached = fraction * made.duration
    wanted = made.position(reached)
    time = made.crossing(wanted)
    assert time is not None
    assert time <= reached + 1e-9
    assert made.position(time) == pytest.approx(wanted, rel=1e-9, abs=1e-9)


def test_a_profile_with_another_name_makes_its_pieces_when_they_are_needed() -> None:
    made = relabelled(plan("trapezoid", 0.0, 40.0, 10.0, 50.0, 50.0), "follow")
    assert not hasattr(made, "_curve")
    assert made.shape == "follow"
    assert made.duration == pytest.approx(4.2)
    assert made.position(2.1) == pytest.approx(20.0)
    again = relabelled(made, "gear")
    assert again.curve is made.curve
