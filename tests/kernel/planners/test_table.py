"""The pieces of a history as columns are those that its profiles make one by one."""

from __future__ import annotations

from math import inf

import numpy as np
import pytest

from motionlang.kernel.planners import (
    Profile,
    hold,
    plan_jerk,
    plan_parabolic,
    plan_sinusoidal,
    plan_trapezoid,
)
from motionlang.kernel.planners.ramps import FALLING, SINE
from motionlang.kernel.planners.table import MIN_PROFILES, piece_columns

LIMITS = (200.0, 400.0, 300.0)
SETTLED = plan_trapezoid(5.0, 105.0, *LIMITS)
KINDS = [
    SETTLED,
    plan_trapezoid(105.0, 5.0, *LIMITS),
    plan_trapezoid(5.0, 25.0, *LIMITS),
    plan_sinusoidal(5.0, 105.0, *LIMITS),
    plan_parabolic(105.0, 5.0, *LIMITS),
    plan_jerk(5.0, 105.0, *LIMITS, 2000.0, 5000.0),
    plan_jerk(5.0, 15.0, *LIMITS, 2000.0, 5000.0),
    plan_jerk(5.0, 105.0, *LIMITS, 2000.0, 5000.0, 250.0),
    Profile("wave", 3.0, 18.0, 3.0, (2.0, 3.0, SINE, 8.0)),
    Profile("falling", 3.0, 21.0, 3.0, (2.0, 3.0, FALLING, 8.0)),
    # A ramp that takes no time, a ramp with a ratio of 0.25, and a slew without an end.
    Profile("jog", 3.0, inf, inf, (1.0, 0.0, 0.5, 0.0, 4.0, 0.25, 12.0, inf, 0.0, 12.0)),
    hold(7.0),
    hold(7.0).cut(0.5),
    SETTLED.cut(0.3),
]


def one_by_one(starts: list[float], profiles: list[Profile]) -> list[tuple[float, tuple[float, ...]]]:
    """Return the time and the coefficients of each piece.

    A profile that is over moves on at its last velocity until the next one begins.
    """
    found: list[tuple[float, tuple[float, ...]]] = []
    for start, following, profile in zip(starts, [*starts[1:], inf], profiles, strict=False):
        made = [(start + knot, piece) for knot, piece in zip(profile.knots, profile.pieces, strict=False)]
        if profile.duration < inf:
            rest = (profile.end, profile.end_velocity, 0.0, 0.0, 0.0, 0.0, 0.0)
            made.append((start + profile.duration, rest))
        found += [each for each in made if each[0] < following]
    return found


@pytest.mark.parametrize("count", [0, 1, 2, MIN_PROFILES - 1, MIN_PROFILES, 3 * len(KINDS)])
@pytest.mark.parametrize("interval", [0.25, 5.0])
@pytest.mark.parametrize("ramps_alone", [False, True])
def test_a_history_as_columns_is_that_of_its_profiles(count: int, interval: float, ramps_alone: bool) -> None:
    """After 0.25 s most moves are cut short; after 5 s all that end are over."""
    kinds = KINDS[:11] if ramps_alone else KINDS
    profiles = [kinds[i % len(kinds)] for i in range(count)]
    starts = [10.0 + interval * i for i in range(count)]
    begins, columns = piece_columns(starts, profiles)
    wanted = one_by_one(starts, profiles)
    assert begins.tolist() == pytest.approx([begin for begin, _ in wanted], rel=1e-12)
    assert columns.shape == (7, len(wanted))
    expected = np.array([piece for _, piece in wanted]).reshape(-1, 7)
    assert np.abs(columns.T - expected).max(initial=0.0) < 1e-9
