"""Velocities at points: the note's worked examples, and general properties."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners import compare_velocities, knot_accelerations, pvt_velocities

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
