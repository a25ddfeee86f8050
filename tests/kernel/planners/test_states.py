"""Plans of single axes from random states: bounds, joins, arrival.

A separate integrator (`many.py`) checks them.
`MOTIONLANG_LONG=5000000` runs 5 million of each shape; the worst figures are printed (`pytest -s`).
"""

from __future__ import annotations

import os

import numpy as np
import pytest

from tests.cases import examples
from tests.kernel.planners.many import BATCH, drawn, integrated

COUNT = int(os.environ.get("MOTIONLANG_LONG") or examples(20_000))
SHAPES = ("trapezoid", "scurve")


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
