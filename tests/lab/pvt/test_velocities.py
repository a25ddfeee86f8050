"""Velocities at points: the note's worked examples, and general properties."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners import compare_velocities, knot_accelerations, pvt_velocities
from motionlang.kernel.planners.pvt.velocities import (
    average_velocities,
    largest_jump,
    refined_velocities,
    smooth_velocities,
)

TEN_POINTS = [0, 100, 150, 200, 300, 240, 0, -100, -50, 40]
FOUR_POINTS = [0, 5000, 15000, 20000]
T = 0.01

NOTE = {
    "average": ([7500, 5000, 7500, 2000, -15000, -17000, -2500, 7000], 3.3e6),
    "1 sweep": ([10500, 2333.33, 9577.78, 5512.59, -18836.69, -20710.22, -1277.28, 10819.32], 2.31e5),
    "2 sweeps": ([10638.52, 2530.57, 9269.40, 5347.48, -18711.15, -20489.07, -1336.25, 10834.06], 1.69e4),
    "exact": (
        [10618.5720, 2525.7122, 9278.5794, 5359.9704, -18718.4610, -20486.1265, -1337.0329, 10834.2582],
        0.0,
    ),
}

points = st.lists(st.integers(-100_000, 100_000).map(float), min_size=3, max_size=12)


def moves() -> st.SearchStrategy[tuple[list[float], list[float]]]:
    """Return points, and a time of 1 to 255 ms for each segment."""
    return points.flatmap(
        lambda p: st.tuples(
            st.just(p),
            st.lists(st.integers(1, 255), min_size=len(p) - 1, max_size=len(p) - 1).map(
                lambda times: [t / 1000 for t in times]
            ),
        )
    )


@pytest.mark.parametrize("name", list(NOTE))
def test_the_ten_points_of_the_note(name: str) -> None:
    rows = {row[0]: row for row in compare_velocities(TEN_POINTS, T)}
    velocities, jump = NOTE[name]
    _, found, found_jump = rows[name]
    assert found[1:-1] == pytest.approx(velocities, abs=0.005 if name != "exact" else 5e-5)
    assert found_jump == pytest.approx(jump, rel=0.005, abs=1e-6)


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


@given(moves())
def test_the_exact_velocities_leave_no_jump(move: tuple[list[float], list[float]]) -> None:
    positions, times = move
    velocities = smooth_velocities(positions, times)
    scale = max(map(abs, positions)) / min(times) ** 2
    assert largest_jump(positions, velocities, times) <= 1e-12 * scale


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


@given(moves())
def test_sweeps_converge_on_the_exact_velocities(move: tuple[list[float], list[float]]) -> None:
    positions, times = move
    exact = pvt_velocities("exact", positions, times)
    refined = pvt_velocities("refine", positions, times, sweeps=40)
    assert refined == pytest.approx(exact, rel=1e-6, abs=1e-6 * max(map(abs, positions)) / min(times) + 1e-6)


@given(moves())
def test_equal_times_are_a_case_of_unequal_ones(move: tuple[list[float], list[float]]) -> None:
    positions, times = move
    for method in ("zero", "average", "refine", "exact"):
        one = pvt_velocities(method, positions, times[0])
        many = pvt_velocities(method, positions, [times[0]] * (len(positions) - 1))
        assert one == many


def test_average_of_unequal_times_is_the_mean_velocity() -> None:
    assert average_velocities([0, 10, 40], [0.01, 0.02]) == pytest.approx([0, 40 / 0.03, 0])


def test_without_velocities_the_accelerations_jump_most() -> None:
    assert largest_jump(FOUR_POINTS, pvt_velocities("zero", FOUR_POINTS, T), T) == pytest.approx(9e8)
    assert largest_jump(FOUR_POINTS, pvt_velocities("average", FOUR_POINTS, T), T) == pytest.approx(1.5e8)


@pytest.mark.parametrize(
    ("positions", "times", "message"),
    [
        ([1.0], T, "at least two points"),
        ([0, 1, 2], [T], "3 points have 2 segments between them, not 1"),
        ([0, 1, 2], [T, 0.0], "segment time must be greater than zero"),
        ([0, float("nan"), 2], T, "position is not a number"),
        ([0, float("inf"), 2], T, "position must be finite"),
    ],
)
def test_impossible_points_are_refused(
    positions: list[float], times: float | list[float], message: str
) -> None:
    for method in ("zero", "average", "refine", "exact"):
        with pytest.raises(ValueError, match=message):
            pvt_velocities(method, positions, times)


def test_an_unknown_method_is_refused_with_the_known_ones() -> None:
    with pytest.raises(ValueError, match="zero, average, refine, exact"):
        pvt_velocities("guess", FOUR_POINTS, T)


def test_outside_the_move_there_is_no_acceleration() -> None:
    """From rest to 10 in the first second: 6 * 10 - 2 * 10 = 40, then 4 * 10 - 6 * 10."""
    sides = knot_accelerations([0.0, 10.0, 20.0], [0.0, 10.0, 0.0], 1.0)
    assert sides == [(0.0, 40.0), (-20.0, 20.0), (-40.0, 0.0)]
