"""PMC's TN1069: a program compares four profiles, checked against its formulas."""

from __future__ import annotations

from math import pi, sqrt
from pathlib import Path
from typing import Any

import pytest

from motionlang import run

SCRIPTS = Path(__file__).parents[3] / "scripts" / "mccl"

# In trajectory cycles of 1 ms and counts: T_A, S_A, T_V, S_V, whole move. ACC = 0.1, VEL = 40, S_TOT = 40000.
PEAK = sqrt(3 * 0.1 * 40000 / 8)
TABLE: dict[str, tuple[float, float, float, float, float]] = {
    "trapezoid": (400, 8000, 600, 24000, 1400),
    "sinusoidal": (200 * pi, 4000 * pi, 1000 - 200 * pi, 40000 - 8000 * pi, 1000 + 200 * pi),
    "scurve": (400 / 0.9, 8000 / 0.9, 1000 - 400 / 0.9, 40000 - 16000 / 0.9, 1000 + 400 / 0.9),
    "parabolic": (20 * PEAK, 20000, 0, 0, 40 * PEAK),
}


def phase(move: dict[str, Any], name: str) -> tuple[float, float]:
    """Return the duration, cycles, and the distance of a phase; 0 if it is missing."""
    for each in move["phases"]:
        if each["name"] == name:
            return each["duration"] * 1000, each["distance"]
    return 0.0, 0.0


@pytest.mark.parametrize("shape", TABLE)
def test_the_comparison_table(shape: str) -> None:
    report: Any = run(SCRIPTS / "tn1069.mcl", dialect="mccl").report
    move = next(each for each in report["moves"] if each["profile"] == shape)
    t_a, s_a, t_v, s_v, whole = TABLE[shape]
    assert phase(move, "accel") == pytest.approx((t_a, s_a), rel=1e-12)
    assert phase(move, "slew") == pytest.approx((t_v, s_v), rel=1e-12, abs=1e-12)
    assert phase(move, "decel") == pytest.approx((t_a, s_a), rel=1e-12)
    assert move["duration"] * 1000 == pytest.approx(whole, rel=1e-12)
    assert move["distance"] == 40000


def test_unequal_rates_keep_their_own_end() -> None:
    report: Any = run(SCRIPTS / "unequal.mcl", dialect="mccl").report
    for move, factor in zip(report["moves"], (1.0, pi / 2, 1 / 0.75, 2.0), strict=True):
        assert phase(move, "accel")[0] == pytest.approx(factor * 20000 / 80000 * 1000, rel=1e-12)
        assert phase(move, "decel")[0] == pytest.approx(factor * 20000 / 20000 * 1000, rel=1e-12)
