"""Plans of single axes from random states: bounds, joins, arrival.

Some are checked by the arithmetic of the proof, and many by a separate integrator (`many.py`).
`MOTIONLANG_LONG=5000000` runs 5 million of each shape; the worst figures are printed (`pytest -s`).
"""

from __future__ import annotations

import os
from itertools import pairwise
from random import Random

import numpy as np
import pytest

from motionlang.planners import Profile, plan
from tests.planners.many import BATCH, drawn, integrated

COUNT = int(os.environ.get("MOTIONLANG_LONG", "20000"))
SINGLE = 1000
SHAPES = ("trapezoid", "scurve")


class State:
    """A random state and target, over orders of magnitude.

    The acceleration is one that occurs in a ramp.
    """

    def __init__(self, choose: Random, shape: str) -> None:
        self.shape = shape
        self.speed = 10.0 ** choose.uniform(-1.0, 4.0)
        self.rates = [self.speed * 10.0 ** choose.uniform(-1.0, 2.0) for _ in range(2)]
        self.jerks = [rate * 10.0 ** choose.uniform(-0.5, 2.5) for rate in self.rates]
        self.v0 = choose.uniform(-1.5, 1.5) * self.speed * (choose.random() < 0.8)
        self.a0 = 0.0
        if shape == "scurve" and choose.random() < 0.7:
            self.a0 = choose.choice((-1.0, 1.0)) * choose.random() * min(self.rates)
            # Less than would carry the velocity through rest.
            jerk = self.jerks[self.a0 * self.v0 < 0.0]
            if self.a0 * self.v0 < 0.0 and self.a0 * self.a0 > 2.0 * jerk * abs(self.v0):
                self.a0 = 0.0
        self.start = choose.uniform(-1.0, 1.0) * self.speed
        self.target = self.start + choose.choice((1.0, 10.0, 0.01)) * choose.uniform(-3.0, 3.0) * self.speed

    def planned(self) -> Profile:
        jerks = self.jerks if self.shape == "scurve" else [float("inf")] * 2
        rates, numbers = self.rates, (self.start, self.target, self.speed)
        return plan(self.shape, *numbers, rates[0], rates[1], self.v0, 0.0, jerks[0], jerks[1], self.a0)

    def shares(self, made: Profile) -> dict[str, float]:
        """Return the used fraction of each bound of a plan, and the relative gaps."""
        from motionlang.analysis.proof.segments import spans  # collecting the tests does not load the proof

        smooth = self.shape == "scurve"
        came = abs(self.v0) + (
            0.5 * self.a0**2 / self.jerks[0] if self.a0 * self.v0 >= 0.0 and smooth else 0.0
        )
        fastest, size = (
            max(self.speed, came),
            max(abs(self.start), abs(self.target), abs(made.distance), self.speed),
        )
        segments = spans(made, 0.0, made.duration)
        found = {"speed": 0.0, "acceleration": 0.0, "deceleration": 0.0, "jerk": 0.0, "gap": 0.0, "end": 0.0}
        for span in segments:
            found["speed"] = max(found["speed"], span.peak(1) / fastest)
            sides = list(span.sides())
            for power, left, right in sides:
                if not power or max(abs(left[1]), abs(right[1])) <= 1e-9 * fastest:
                    continue
                side = 0 if power > 0.0 else 1
                name = ("acceleration", "deceleration")[side]
                bound = max(self.rates[side], abs(self.a0))
                found[name] = max(found[name], max(abs(left[2]), abs(right[2])) / bound)
                if smooth:
                    jerk = self.jerks[side] if len(sides) == 1 else max(self.jerks)
                    found["jerk"] = max(found["jerk"], abs(left[3]) / jerk)
        rates = max(self.rates)
        for before, after in pairwise(segments):
            gaps = [abs(x - y) for x, y in zip(before.at(before.length), after.at(0.0), strict=True)]
            late = 1e-15 * (1.0 + made.duration)
            scaled = [gaps[0] / size, (gaps[1] - 2.0 * late * rates) / fastest, 0.0]
            if smooth:
                scaled[2] = (gaps[2] - 2.0 * late * max(self.jerks)) / rates
            found["gap"] = max(found["gap"], *scaled)
        if segments:
            end = segments[-1].at(segments[-1].length)
            found["end"] = abs(end[0] - self.target) / size
        return found


@pytest.mark.parametrize("shape", SHAPES)
def test_plans_from_random_states_keep_their_bounds_and_arrive(shape: str) -> None:
    choose, worst = Random(11), dict[str, float]()
    for number in range(SINGLE):
        state = State(choose, shape)
        for name, share in state.shares(state.planned()).items():
            worst[name] = max(worst.get(name, 0.0), share)
            most = 1e-9 if name in ("gap", "end") else 1.0 + 1e-9
            assert share <= most, f"{name} {share!r} of number {number}: {vars(state)}"


@pytest.mark.parametrize("shape", SHAPES)
def test_integrated_plans_from_random_states_keep_their_bounds_and_arrive(shape: str) -> None:
    choose, worst = np.random.default_rng(12), dict[str, float]()
    for first in range(0, COUNT, BATCH):
        states = drawn(choose, min(BATCH, COUNT - first), shape)
        for name, shares in integrated(states, shape).items():
            which = int(shares.argmax())
            worst[name] = max(worst.get(name, 0.0), float(shares[which]))
            most = 1e-9 if name in ("gap", "end", "rest") else 1.0 + 1e-9
            state = {field: each[..., which].tolist() for field, each in states._asdict().items()}
            assert shares[which] <= most, f"{name} {shares[which]!r} of number {first + which}: {state}"
    print(shape, COUNT, worst)
