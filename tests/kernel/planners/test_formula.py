"""Profiles that are formulas: crossings, extrema and peaks of sin t and of t²."""

from __future__ import annotations

from collections.abc import Callable
from math import asin, cos, inf, pi, sin

import pytest

from motionlang.kernel.planners import MotionState, summit
from motionlang.kernel.planners.formula import FormulaProfile


class Made(FormulaProfile):
    """A formula given as position, velocity and acceleration."""

    __slots__ = ("_knots", "_values")

    def __init__(
        self, knots: tuple[float, ...], *values: Callable[[float], float], end_velocity: float = 0.0
    ) -> None:
        end = inf if knots[-1] == inf else values[0](knots[-1])
        super().__init__("made", values[0](0.0), end, knots[-1], values[1](0.0), end_velocity)
        self._knots, self._values = knots, values

    def state(self, time: float) -> MotionState:
        position, velocity, acceleration = (each(time) for each in self._values)
        return MotionState(position, velocity, acceleration, 0.0)

    @property
    def knots(self) -> tuple[float, ...]:
        return self._knots


def wave(*knots: float) -> Made:
    """Return sin t, which runs on at velocity 1 from 2 pi."""
    return Made(
        (0.0, *knots, 2.0 * pi), sin, lambda t: 1.0 if t in (0.0, 2.0 * pi) else cos(t), lambda t: -sin(t),
        end_velocity=1.0,
    )  # fmt: skip


def parabola() -> Made:
    """Return t² up to 2 s, which runs on at velocity 4 without an end."""
    return Made(
        (0.0, 2.0, inf),
        lambda t: t * t if t < 2.0 else 4.0 + 4.0 * (t - 2.0),
        lambda t: min(2.0 * t, 4.0),
        lambda t: 2.0 if t < 2.0 else 0.0,
        end_velocity=4.0,
    )


@pytest.mark.parametrize("knots", [(), (pi,), (1.0, 4.5)])
@pytest.mark.parametrize(
    ("position", "after", "time"),
    [
        (0.0, 0.0, 0.0),
        (0.5, 0.0, pi / 6.0),
        (0.5, -9.0, pi / 6.0),
        (0.5, 1.0, 5.0 * pi / 6.0),
        (0.5, 3.0, 2.0 * pi + 0.5),
        (0.5, 6.75, 2.0 * pi + 0.5),
        (0.5, 7.0, None),
        (-0.5, 0.0, 7.0 * pi / 6.0),
        (-0.5, 4.0, 11.0 * pi / 6.0),
        (-0.5, 6.0, None),
        (1.5, 0.0, 2.0 * pi + 1.5),
        (-1.5, 0.0, None),
        (0.75, 0.0, asin(0.75)),
    ],
)
def test_the_first_crossing_of_a_position(
    knots: tuple[float, ...], position: float, after: float, time: float | None
) -> None:
    found = wave(*knots).crossing(position, after)
    assert found == (None if time is None else pytest.approx(time, abs=1e-9))


@pytest.mark.parametrize(
    ("velocity", "after", "time"),
    [
        (0.5, 0.0, pi / 3.0),
        (0.5, 2.0, 5.0 * pi / 3.0),
        (0.5, 6.0, None),
        (-0.5, 0.0, 2.0 * pi / 3.0),
        (1.0, -9.0, 0.0),
        (1.0, 1.0, 2.0 * pi),
        (1.0, 9.0, 9.0),
        (1.5, 0.0, None),
    ],
)
def test_the_first_crossing_of_a_velocity(velocity: float, after: float, time: float | None) -> None:
    found = wave().velocity_crossing(velocity, after)
    assert found == (None if time is None else pytest.approx(time, abs=1e-9))


def test_a_formula_without_an_end() -> None:
    made = parabola()
    assert [made.crossing(each) for each in (2.25, 12.0, -1.0)] == [pytest.approx(1.5), 4.0, None]
    assert made.crossing(12.0, 3.0) == 4.0
    assert made.crossing(12.0, 4.5) is None
    assert made.velocity_crossing(3.0) == pytest.approx(1.5)
    assert made.velocity_crossing(5.0) is None
    sections = list(made.stretches(1.0))
    assert sum(travel for _, travel in sections[:-1]) == pytest.approx(3.0)
    assert (sections[0][0], sections[-1]) == (1.0, (2.0, inf))
    assert list(made.stretches(3.0)) == [(3.0, inf)]
    assert (made.peak_speed, made.peak_acceleration) == (4.0, 2.0)


def test_a_formula_at_rest_for_ever_travels_nothing() -> None:
    made = Made((0.0, 2.0, inf), lambda t: 7.0, lambda t: 0.0, lambda t: 0.0)
    assert list(made.stretches(3.0)) == [(3.0, 0.0)]
    assert (made.crossing(7.0, 3.0), made.crossing(8.0)) == (3.0, None)


@pytest.mark.parametrize(
    ("after", "begins", "travel", "distance"),
    [
        (0.0, [0.0, 0.5 * pi, 1.5 * pi], 4.0, 0.0),
        (0.5 * pi, [0.5 * pi, 1.5 * pi], 3.0, -1.0),
        (pi, [pi, 1.5 * pi], 2.0, 0.0),
        (5.5, [5.5], -sin(5.5), -sin(5.5)),
        (2.0 * pi, [], 0.0, 0.0),
    ],
)
def test_the_monotone_sections_of_a_formula(
    after: float, begins: list[float], travel: float, distance: float
) -> None:
    """Out to 1, back to -1, and out to 0; a section may consist of several."""
    found = list(wave().stretches(after))
    assert [begin for begin, _ in found] == sorted(begin for begin, _ in found)
    assert all(any(begin == pytest.approx(each) for begin, _ in found) for each in begins)
    assert sum(abs(each) for _, each in found) == pytest.approx(travel)
    assert sum(each for _, each in found) == pytest.approx(distance, abs=1e-9)


def test_the_extrema_of_a_formula_are_inside_it() -> None:
    assert wave(1.0).extrema() == pytest.approx((-1.0, 1.0))
    assert Made((0.0, 1.0), sin, cos, lambda t: -sin(t)).extrema() == pytest.approx((0.0, sin(1.0)))
    fall = Made((0.0, 4.0), cos, lambda t: -sin(t), lambda t: -cos(t))
    assert fall.extrema() == pytest.approx((-1.0, 1.0))


def test_the_figures_of_a_formula_at_a_time() -> None:
    made = wave()
    assert [made.position(time) for time in (-1.0, 0.0, 1.0)] == [0.0, 0.0, sin(1.0)]
    assert made.position(2.0 * pi + 3.0) == pytest.approx(3.0)
    assert [made.velocity(time) for time in (-1.0, 0.0, 1.0, 9.0)] == [1.0, 1.0, cos(1.0), 1.0]
    assert [made.acceleration(time) for time in (-1.0, 0.0, 1.0, 2.0 * pi, 9.0)] == [0, 0, -sin(1.0), 0, 0]
    (phase,) = made.phases
    assert (phase.name, phase.duration, phase.end_velocity) == ("made", 2.0 * pi, 1.0)
    assert Made((0.0, 0.0), sin, cos, sin).phases == ()


@pytest.mark.parametrize("height", [1.002, 0.998, 0.95, 1.5])
def test_the_peak_between_two_values_of_the_grid_is_found(height: float) -> None:
    """The crest of the first wave is on the grid, which has 0.9975 of the second one."""

    def bend(t: float) -> float:
        return sin(t) if t < pi else -height * sin(t - pi)

    made = Made((0.0, pi, pi + 3.0), lambda t: 0.0, lambda t: 0.0, bend)
    assert made.peak_acceleration == pytest.approx(max(1.0, height), rel=1e-9)
    assert made.peak_speed == 0.0


@pytest.mark.parametrize("end_velocity", [3.0, -3.0])
def test_the_speed_after_a_formula_is_among_its_peaks(end_velocity: float) -> None:
    made = Made((0.0, 1.0), sin, cos, lambda t: -sin(t), end_velocity=end_velocity)
    assert (made.peak_speed, made.peak_acceleration) == pytest.approx((3.0, sin(1.0)))


@pytest.mark.parametrize("crest", [0.0, 0.3, 1.0, 2.5, 3.0])
def test_the_summit_of_a_function(crest: float) -> None:
    assert summit(lambda t: -((t - crest) ** 2), 0.0, 3.0) == pytest.approx(crest, abs=1e-6)
