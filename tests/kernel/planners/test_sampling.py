"""The sampling kernels equal the profile itself, point by point."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motionlang.kernel.planners import (
    ORDERS,
    PieceTable,
    Profile,
    hold,
    pieces_of,
    plan,
    plan_trapezoid,
    plan_velocity,
)
from tests.kernel.planners.cases import Move, moves, plan_jerk, quick


def by_hand(profile: Profile, times: list[float], order: int) -> list[float]:
    read = (profile.position, profile.velocity, profile.acceleration)[order]
    return [read(t) for t in times]


@quick
@given(moves(), st.sampled_from([0, 1]), st.integers(1, 400))
def test_a_profile_sampled_is_the_profile(move: Move, order: int, n: int) -> None:
    made = move.planned()
    dt = 1.1 * made.duration / n + 1e-9
    expected = by_hand(made, [i * dt for i in range(n)], order)
    size = max(abs(x) for x in made.extrema()) if order == 0 else made.peak_speed
    assert (
        np.abs(PieceTable((0.0,), (made,)).sample(0.0, dt, n, order) - expected).max() <= 1e-9 * size + 1e-12
    )


@pytest.mark.parametrize("shape", ["trapezoid", "sinusoidal", "scurve", "parabolic"])
@pytest.mark.parametrize("order", [0, 1, 2])
def test_long_pieces(shape: str, order: int) -> None:
    made = plan(shape, 3.0, -97.0, 10.0, 20.0, 40.0, ramp=0.2)
    n, dt = 50_000, made.duration / 49_990
    picked = np.arange(7, n, 331)
    expected = by_hand(made, [i * dt for i in picked.tolist()], order)
    scale = (100.0, 10.0, 40.0)[order]
    assert (
        np.abs(PieceTable((0.0,), (made,)).sample(0.0, dt, n, order)[picked] - expected).max() <= 1e-9 * scale
    )


def track() -> tuple[list[float], list[Profile]]:
    """Return moves of two shapes with pauses; one is cut short, a jog is the last."""
    first = plan_trapezoid(0.0, 12.0, 8.0, 16.0, 16.0)
    second = plan_jerk(12.0, -5.0, 8.0, 16.0, 16.0, 100.0, 100.0)
    position = second.position(0.9)
    third = plan("sinusoidal", position, 4.0, 8.0, 16.0, 16.0, second.velocity(0.9))
    jog = plan_velocity("trapezoid", third.end, 0.0, 3.0, 16.0, 16.0)
    return [1.0, 3.5, 4.4, 11.0], [first, second, third, jog]


def in_track(starts: list[float], profiles: list[Profile], t: float, quantity: str) -> float:
    index = max(i for i, start in enumerate(starts) if i == 0 or t >= start)
    local = t - starts[index]
    if local < 0.0:
        return profiles[0].start if quantity == "position" else 0.0
    return float(getattr(profiles[index], quantity)(local))


@pytest.mark.parametrize("quantity", ["position", "velocity", "acceleration"])
@pytest.mark.parametrize(("t0", "dt", "n"), [(0.0, 0.00137, 12_000), (0.5, 0.11, 140), (4.0, 1e-5, 30_000)])
def test_a_track_of_moves(quantity: str, t0: float, dt: float, n: int) -> None:
    starts, profiles = track()
    found = PieceTable(starts, profiles).sample(t0, dt, n, ORDERS[quantity])
    for i in range(0, n, max(1, n // 400)):
        assert found[i] == pytest.approx(in_track(starts, profiles, t0 + i * dt, quantity), abs=1e-8)


def test_nothing_to_sample() -> None:
    assert PieceTable([], []).sample(0.0, 0.1, 3).tolist() == [0.0, 0.0, 0.0]
    assert PieceTable(*track()).sample(0.0, 0.1, 0).shape == (0,)
    still = plan_trapezoid(2.0, 2.0, 1.0, 1.0, 1.0)
    assert PieceTable((0.0,), (still,)).sample(0.0, 0.1, 3).tolist() == [2.0, 2.0, 2.0]


def test_the_pieces_after_the_end_of_a_profile() -> None:
    """A profile ends at 3 s, at 4 uu/s, and continues until another begins."""
    one = Profile("jog", 0.0, 6.0, 2.0, (2.0, 2.0, 0.0, 4.0))
    profiles = [one, hold(14.0)]
    begins, pieces = pieces_of([1.0, 5.0], profiles)
    assert begins == [1.0, 1.0, 3.0, 5.0]
    assert pieces == [
        (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        (0.0, 2.0, 0.5, 0.0, 0.0, 0.0, 0.0),
        (6.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        (14.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    ]
    assert pieces_of([1.0, 3.0], profiles)[0] == [1.0, 1.0, 3.0]
    assert pieces_of([1.0, 2.0], profiles)[0] == [1.0, 1.0, 2.0]
