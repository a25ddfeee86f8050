"""Random inputs of the property tests: moves of every shape, from any speed."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from hypothesis import settings
from hypothesis import strategies as st

from motionlang.kernel.planners import Profile, plan
from tests.cases import examples

quick = settings(max_examples=examples(150))

SHAPES = ("trapezoid", "sinusoidal", "ratio", "jerk", "parabolic")


class Move(NamedTuple):
    """One planning problem: the shape and the arguments of the planner."""

    shape: str
    start: float
    target: float
    speed: float
    accel: float
    decel: float
    v0: float
    ramp: float
    accel_jerk: float
    decel_jerk: float

    def planned(self) -> Profile:
        """Return the profile of this move."""
        shape = "scurve" if self.shape in ("ratio", "jerk") else self.shape
        jerks = (self.accel_jerk, self.decel_jerk) if self.shape == "jerk" else (math.inf, math.inf)
        return plan(
            shape, self.start, self.target, self.speed, self.accel, self.decel, self.v0, self.ramp, *jerks
        )


def sizes(low: float, high: float) -> st.SearchStrategy[float]:
    """Return positive numbers over orders of magnitude, like those of machines."""
    return st.floats(math.log(low), math.log(high)).map(math.exp)


distances = st.one_of(
    st.just(0.0), sizes(1e-3, 1e5), sizes(1e-3, 1e5).map(lambda d: -d), st.integers(-1000, 1000).map(float)
)


@st.composite
def moves(draw: st.DrawFn, shape: str | None = None, moving: bool = True) -> Move:
    """Return a random move of a shape, or of any shape, in either direction.

    With `moving`, it may begin at up to three times its speed.
    """
    start = draw(st.sampled_from([0.0, -250.0, 1000.0]))
    speed = draw(sizes(0.1, 1e4))
    times = st.floats(-3.0, 3.0) if moving else st.just(0.0)
    return Move(
        shape or draw(st.sampled_from(SHAPES)),
        start,
        start + draw(distances),
        speed,
        draw(sizes(1.0, 1e5)),
        draw(sizes(1.0, 1e5)),
        draw(times) * speed if draw(st.booleans()) else 0.0,
        draw(st.floats(0.01, 0.5)),
        draw(sizes(10.0, 1e6)),
        draw(sizes(10.0, 1e6)),
    )


def plan_jerk(
    start: float,
    target: float,
    speed: float,
    accel: float,
    decel: float,
    accel_jerk: float,
    decel_jerk: float,
    v0: float = 0.0,
    a0: float = 0.0,
) -> Profile:
    """Plan a move in S-ramps, with all limits in a row."""
    return plan("scurve", start, target, speed, accel, decel, v0, 0.0, accel_jerk, decel_jerk, a0)


def integrated(profile: Profile) -> float:
    """Return the distance by Gauss-Legendre quadrature of the velocity of each piece."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    total = 0.0
    for begin, finish in zip(profile.knots, profile.knots[1:], strict=False):
        half = 0.5 * (finish - begin)
        times = begin + half * (nodes + 1.0)
        total += half * sum(w * profile.velocity(float(t)) for w, t in zip(weights, times, strict=True))
    return total
