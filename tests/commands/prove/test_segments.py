"""The proof's arithmetic of segments by hand: derivatives, roots, waves and sums."""

from __future__ import annotations

from math import pi, sqrt
from typing import TYPE_CHECKING

import pytest

from motionlang.commands.prove.segments import (
    Span,
    _angles,
    _quarters,
    _roots,
    combined,
    derivatives,
    half_angle,
    rotation,
    spans,
)
from motionlang.kernel.planners import plan_trapezoid, plan_velocity

if TYPE_CHECKING:
    from motionlang.kernel.planners import Piece

CUBIC: Piece = (1.0, 2.0, 3.0, 4.0, 0.0, 0.0, 0.0)
WAVE: Piece = (0.0, 0.0, 0.0, 0.0, 3.0, 2.0, pi / 6.0)


@pytest.mark.parametrize(
    ("piece", "x", "expected"),
    [
        (CUBIC, 0.0, (1.0, 2.0, 6.0, 24.0)),
        (CUBIC, 2.0, (49.0, 62.0, 54.0, 24.0)),
        (WAVE, 0.0, (1.5, 3.0 * sqrt(3.0), -6.0, -12.0 * sqrt(3.0))),  # sin 30° and cos 30°
        (WAVE, pi / 6.0, (3.0, 0.0, -12.0, 0.0)),  # its crest
        (
            (1.0, 0.0, 1.0, 2.0, 3.0, 2.0, pi / 6.0),
            0.0,
            (2.5, 3.0 * sqrt(3.0), -4.0, 12.0 - 12.0 * sqrt(3.0)),
        ),
    ],
)
def test_the_derivatives_of_a_piece(piece: Piece, x: float, expected: tuple[float, ...]) -> None:
    """1 + 2x + 3x² + 4x³ has 2 + 6x + 12x², 6 + 24x, 24; a wave gains a factor of 2."""
    assert derivatives(piece, x) == pytest.approx(expected, abs=1e-9)
    assert Span(7.0, 9.0, piece).at(x) == derivatives(piece, x)


@pytest.mark.parametrize(
    ("a", "b", "c", "roots"),
    [
        (1.0, -3.0, 2.0, [1.0, 2.0]),
        (-1.0, 3.0, -2.0, [1.0, 2.0]),
        (2.0, 4.0, 2.0, [-1.0, -1.0]),
        (1.0, 0.0, -4.0, [-2.0, 2.0]),
        (1.0, 0.0, 1.0, []),
        (1.0, 0.0, 0.0, [0.0]),
        (1.0, 5.0, 0.0, [-5.0, 0.0]),
        (0.0, 2.0, -3.0, [1.5]),
        (0.0, 0.0, 3.0, []),
    ],
)
def test_the_roots_of_a_quadratic(a: float, b: float, c: float, roots: list[float]) -> None:
    assert sorted(_roots(a, b, c)) == pytest.approx(roots)


@pytest.mark.parametrize(
    ("phase", "length", "degrees"),
    [
        (0.0, pi, [0.0, 90.0, 180.0, 270.0, 360.0]),
        (pi / 6.0, 1.2 * pi, [90.0, 180.0, 270.0, 360.0, 450.0]),  # 30° to 462°
        (-0.6 * pi, 0.2 * pi, [-90.0]),  # -108° to -36°
        (0.1 * pi, 0.1 * pi, []),
    ],
)
def test_the_quarters_of_a_wave(phase: float, length: float, degrees: list[float]) -> None:
    """With 2 radians per second; the angles at the times that are found."""
    found = _quarters(2.0, phase, length)
    assert [(2.0 * time + phase) * 180.0 / pi for time in found] == pytest.approx(degrees)


@pytest.mark.parametrize("phase", [0.0, 2.0, -9.0, 7.5])
def test_all_times_at_which_a_wave_has_an_angle_are_found(phase: float) -> None:
    """In 4 s the wave advances 10 radians; its cosine is 0.5 at 60° from whole turns."""
    inside = [time for time in _angles(pi / 3.0, 2.5, phase, 4.0) if 0.0 <= time <= 4.0]
    turns = [2.0 * pi * k + side * pi / 3.0 for k in range(-9, 9) for side in (1.0, -1.0)]
    assert sorted(inside) == pytest.approx(
        sorted((angle - phase) / 2.5 for angle in turns if 0.0 <= angle - phase <= 10.0)
    )


# TRIANGLE reaches 20 after 0.5 s, and rests after 1 s.
TRIANGLE = plan_trapezoid(0.0, 10.0, 50.0, 40.0, 40.0)


@pytest.mark.parametrize(
    ("begin", "length", "expected"),
    [
        (0.0, 1.0, [(0.0, 0.5, 0.0, 0.0), (0.5, 0.5, 5.0, 20.0)]),
        (0.25, 0.5, [(0.0, 0.25, 1.25, 10.0), (0.25, 0.25, 5.0, 20.0)]),
        (0.25, 0.25, [(0.0, 0.25, 1.25, 10.0)]),
        (0.5, 0.25, [(0.0, 0.25, 5.0, 20.0)]),
        (0.75, 9.0, [(0.0, 0.25, 8.75, 10.0)]),
        (1.0, 1.0, []),
    ],
)
def test_the_segments_of_a_profile(
    begin: float, length: float, expected: list[tuple[float, float, float, float]]
) -> None:
    """Each has its start, its length, and the position and velocity there."""
    found = [(span.begin, span.length, *span.at(0.0)[:2]) for span in spans(TRIANGLE, begin, length)]
    assert found == [pytest.approx(each) for each in expected]


def test_a_segment_without_an_end_is_none() -> None:
    jog = plan_velocity("trapezoid", 0.0, 0.0, 20.0, 40.0, 40.0)
    assert [(each.begin, each.length) for each in spans(jog, 0.0, float("inf"))] == [(0.0, 0.5)]
    assert [(each.begin, each.length) for each in spans(jog, 0.25, 1.0)] == [(0.0, 0.25), (0.25, 0.75)]


def test_a_sum_of_segments_has_the_wave_that_they_share() -> None:
    """0.5 of the first and 2 of the second one, 7 from the origin."""
    parts = [Span(1.0, 2.0, CUBIC), Span(1.0, 2.0, (10.0, 0.0, 0.0, 1.0, 3.0, 2.0, 0.5))]
    both = combined(parts, [0.5, 2.0], 7.0)
    assert (both.begin, both.length, both.piece) == (1.0, 2.0, (13.5, 1.0, 1.5, 4.0, 6.0, 2.0, 0.5))
    assert combined(parts[:1], [2.0], 0.0).piece == (2.0, 4.0, 6.0, 8.0, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("piece", "length", "peaks"),
    [
        (CUBIC, 2.0, (62.0, 54.0, 24.0)),
        ((0.0, 4.0, -3.0, 0.0, 0.0, 0.0, 0.0), 1.0, (4.0, 6.0, 0.0)),
        ((0.0, -6.0, 0.0, 2.0, 0.0, 0.0, 0.0), 1.5, (7.5, 18.0, 12.0)),
        ((0.0, -3.0, 6.0, -3.0, 0.0, 0.0, 0.0), 1.0, (3.0, 12.0, 18.0)),
        ((0.0, 0.0, 0.0, 0.0, 3.0, 2.0, 0.0), 9.0, (6.0, 12.0, 24.0)),
        ((0.0, 1.0, 0.0, 0.0, 3.0, 2.0, 0.0), 9.0, (7.0, 12.0, 24.0)),
        ((0.0, -1.0, 0.0, 0.0, 3.0, 2.0, 0.0), 9.0, (7.0, 12.0, 24.0)),
    ],
)
def test_the_peaks_of_a_segment(piece: Piece, length: float, peaks: tuple[float, ...]) -> None:
    """4x - 3x² has 4 - 6x; 2x³ - 6x has 6x² - 6; -3x³ + 6x² - 3x has -9x² + 12x - 3."""
    span = Span(0.0, length, piece)
    assert [span.peak(order) for order in (1, 2, 3)] == pytest.approx(peaks)


def test_a_vector_is_rotated_counterclockwise() -> None:
    assert rotation(3.0, 1.0, 90.0) == pytest.approx((-1.0, 3.0))
    assert rotation(2.0, 0.0, -60.0) == pytest.approx((1.0, -sqrt(3.0)))


@pytest.mark.parametrize(
    ("chord", "angle"), [(0.0, 0.0), (1.0, 60.0), (sqrt(2.0), 90.0), (2.0, 180.0), (2.1, 180.0)]
)
def test_the_angle_over_a_chord(chord: float, angle: float) -> None:
    assert half_angle(chord) == pytest.approx(angle)
