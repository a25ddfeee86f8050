"""Times from which a profile moves in a direction, by hand."""

from __future__ import annotations

from math import inf

import pytest

from motionlang.kernel.planners import Profile, from_curve, hold, plan_trapezoid, plan_velocity
from motionlang.kernel.planners.direction import sets_off

# Of each piece its duration, velocity and half of its acceleration.
Section = tuple[float, float, float]


def joined(*sections: Section, end_velocity: float = 0.0) -> Profile:
    knots, position, pieces = [0.0], 0.0, []
    for duration, velocity, half in sections:
        pieces.append((position, velocity, half, 0.0, 0.0, 0.0, 0.0))
        knots.append(knots[-1] + duration)
        if duration < inf:
            position += (velocity + half * duration) * duration
    curve = (tuple(knots), tuple(pieces), (("segment", 0),))
    return from_curve("sections", 0.0, position, curve, sections[0][1], end_velocity)


BACK = joined((4.0, 4.0, -1.0), end_velocity=-4.0)
# It would turn back 3 s after the beginning of its second section, which takes 2 s.
ALWAYS_AHEAD = joined((2.0, 4.0, 0.0), (2.0, 6.0, -1.0), end_velocity=2.0)
LATER = joined((1.0, 0.0, 0.0), (1.0, 2.0, 0.0))
ZIGZAG = joined((1.0, 1.0, 0.0), (1.0, -1.0, 0.0), (1.0, 1.0, 0.0))
# The first 0.4 millionths do not count alone, and 0.4 back begin the count again.
TINY = joined((1.0, 4e-7, 0.0), (1.0, 7e-7, 0.0))
TINY_AND_REST = joined((1.0, 4e-7, 0.0), (1.0, 0.0, 0.0), (1.0, 7e-7, 0.0))
TINY_AND_BACK = joined((1.0, 4e-7, 0.0), (1.0, -4e-7, 0.0), (1.0, 7e-7, 0.0), (1.0, 4e-7, 0.0))
TINY_ALONE = joined((1.0, 4e-7, 0.0), (1.0, 4e-7, 0.0))
REVERSAL = plan_velocity("trapezoid", 0.0, 10.0, -10.0, 100.0, 100.0)
ENDLESS_PARABOLA = joined((inf, -4.0, 1.0))


@pytest.mark.parametrize(
    ("profile", "after", "forward", "backward"),
    [
        (hold(5.0), 0.0, None, None),
        (plan_trapezoid(0.0, 10.0, 10.0, 100.0, 100.0), -1.0, 0.0, None),
        (plan_trapezoid(0.0, 10.0, 10.0, 100.0, 100.0), 0.5, 0.5, None),
        (plan_trapezoid(0.0, 10.0, 10.0, 100.0, 100.0), 5.0, None, None),
        (BACK, -5.0, 0.0, 2.0), (BACK, 0.0, 0.0, 2.0), (BACK, 1.5, 1.5, 2.0), (BACK, 3.0, None, 3.0),
        (BACK, 9.0, None, 9.0),
        (ALWAYS_AHEAD, 0.0, 0.0, None), (ALWAYS_AHEAD, 3.0, 3.0, None), (ALWAYS_AHEAD, 9.0, 9.0, None),
        (LATER, 0.0, 1.0, None),
        (ZIGZAG, 0.0, 0.0, 1.0), (ZIGZAG, 1.5, 2.0, 1.5), (ZIGZAG, 2.5, 2.5, None), (ZIGZAG, 3.5, None, None),
        (TINY, 0.0, 0.0, None), (TINY_AND_REST, 0.0, 0.0, None), (TINY_AND_BACK, 0.0, 2.0, None),
        (TINY_ALONE, 0.0, None, None),
        (REVERSAL, 0.0, 0.0, 0.1), (REVERSAL, 0.15, None, 0.15), (REVERSAL, 5.0, None, 5.0),
        (ENDLESS_PARABOLA, 0.0, 2.0, 0.0), (ENDLESS_PARABOLA, 3.0, 3.0, None),
    ],
)  # fmt: skip
def test_the_time_at_which_a_profile_sets_off(
    profile: Profile, after: float, forward: float | None, backward: float | None
) -> None:
    """A parabola from 4 per second, with an acceleration of -2, turns after 2 s."""
    found = [sets_off(profile, sign, after) for sign in (1, -1)]
    assert found == [None if each is None else pytest.approx(each) for each in (forward, backward)]
