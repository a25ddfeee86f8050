"""Seen from inside: velocities at points: the note's worked examples, and general properties."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners.pvt.velocities import (
    average_velocities,
    refined_velocities,
    smooth_velocities,
)
from tests.lab.pvt.test_velocities import FOUR_POINTS, TEN_POINTS, T, moves


def test_the_four_points_of_the_note() -> None:
    assert average_velocities(FOUR_POINTS, T)[1:-1] == [750_000, 750_000]
    assert smooth_velocities(FOUR_POINTS, T) == pytest.approx([0, 900_000, 900_000, 0])
    # F2 is exact for four points, for any initial values
    assert refined_velocities(FOUR_POINTS, [0, 1, 2, 0], T) == pytest.approx([0, 900_000, 900_000, 0])


def test_f1_and_f2_are_the_formulas_of_the_note() -> None:
    p, v = TEN_POINTS, [3.0, 1.0, 4.0, 1.0, 5.0, 9.0, 2.0, 6.0, 5.0, 3.0]
    expected = list(v)
    for n in range(1, 8):
        # V1 = (12(P2-P0)/T - 4 V0 + 3(P1-P3)/T + V3) / 15
        expected[n] = (
            12 * (p[n + 1] - p[n - 1]) / T - 4 * expected[n - 1] + 3 * (p[n] - p[n + 2]) / T + expected[n + 2]
        ) / 15
    # V1 = (-3/T (P0-P2) - V0 - V2) / 4
    expected[8] = (-3 / T * (p[7] - p[9]) - expected[7] - expected[9]) / 4
    assert refined_velocities(p, v, T) == pytest.approx(expected, rel=1e-12)


@given(moves(), st.floats(-1e5, 1e5), st.floats(-1e5, 1e5))
def test_the_exact_velocities_solve_the_spline(
    move: tuple[list[float], list[float]], first: float, last: float
) -> None:
    """They equal the solution of the same system by NumPy's dense solver."""
    p, h = move
    n = len(p)
    matrix, right = np.eye(n), np.zeros(n)
    right[0], right[-1] = first, last
    for i in range(1, n - 1):
        matrix[i, i - 1 : i + 2] = 1 / h[i - 1], 2 / h[i - 1] + 2 / h[i], 1 / h[i]
        right[i] = 3 * ((p[i] - p[i - 1]) / h[i - 1] ** 2 + (p[i + 1] - p[i]) / h[i] ** 2)
    expected = np.linalg.solve(matrix, right)
    found = smooth_velocities(p, h, first, last)
    assert found == pytest.approx(list(expected), rel=1e-9, abs=1e-12 * max(map(abs, p)) / min(h) + 1e-6)


def test_average_of_unequal_times_is_the_mean_velocity() -> None:
    assert average_velocities([0, 10, 40], [0.01, 0.02]) == pytest.approx([0, 40 / 0.03, 0])
