"""Extremes of formulas, at joins, and of motors.

A real jump gives an infinite derivative, rounding does not.
"""

from __future__ import annotations

from collections.abc import Callable
from math import e, exp, inf, sqrt
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from motionlang.commands.certify.extremes import extremes, motor_peak, peak_speed
from motionlang.kernel import Source, run
from motionlang.kernel.controller.scale import Scale
from motionlang.kernel.planners import Profile, State, hold, plan_trapezoid
from motionlang.kernel.planners.formula import Formula
from motionlang.kernel.tracks import history

GALLERY = Path(__file__).parents[3] / "scripts"


@pytest.mark.parametrize("axis", [0, 1])
def test_lines_and_arcs_that_join_have_no_infinite_acceleration(axis: int) -> None:
    """At speed 50, arcs of radius 10 need 250 of lateral acceleration, the ramps 500."""
    made = run(GALLERY / "mint" / "laser-contour.mnt")
    found = extremes(made.controller.axes[axis], made.time)
    assert found.acceleration.value == pytest.approx(500.0, rel=1e-4)
    assert found.jerk.value == inf  # a trapezoid has its acceleration at once


def test_a_cancel_has() -> None:
    made = run(Source("jump.mnt", "SPEED(0) = 50 : JOG(0) = 50\nWAIT(1000)\nCANCEL(0)\n"))
    assert extremes(made.controller.axes[0], made.time).acceleration.value == inf


class Smooth(Formula):
    """A formula from a function of the state, with knots inside it."""

    __slots__ = ("_knots", "_state")

    def __init__(self, duration: float, state: Callable[[float], tuple[float, ...]], *inner: float) -> None:
        self._state, self._knots = state, (0.0, *inner, duration)
        (start, v, _, _), (end, w, _, _) = state(0.0), state(duration)
        super().__init__("formula", start, end, duration, v, w)

    def state(self, time: float) -> State:
        return State(*self._state(time))

    @property
    def knots(self) -> tuple[float, ...]:
        return self._knots


def cubic(duration: float, p: float, v: float = 0.0, a: float = 0.0, j: float = 0.0) -> Smooth:
    """Return a motion of constant jerk."""
    return Smooth(
        duration,
        lambda t: (p + v * t + a / 2 * t**2 + j / 6 * t**3, v + a * t + j / 2 * t**2, a + j * t, j),
    )


def axis(*profiles: tuple[float, Profile], scale: float = 1.0, **more: Any) -> Any:
    """Return an axis that has followed some profiles, each from a time on."""
    starts, curves = [start for start, _ in profiles], [profile for _, profile in profiles]
    return SimpleNamespace(index=0, older=None, starts=starts, profiles=curves, scale=Scale(scale), **more)


def bump(t: float, middle: float = 2.0) -> tuple[float, ...]:
    """Return the state of x exp(-x²/2), with x = (t - 2 s) / 0.25 s."""
    x, w = (t - middle) / 0.25, 0.25
    return tuple(
        polynomial * exp(-x * x / 2) / w**k
        for k, polynomial in enumerate((x, 1 - x * x, x**3 - 3 * x, -(x**4) + 6 * x * x - 3))
    )


@pytest.mark.parametrize(("scale", "size"), [(1.0, 1.0), (-4.0, 4.0)])
def test_the_extremes_of_a_formula_are_found_between_its_knots(scale: float, size: float) -> None:
    """The position is e^-½ at x = ±1; velocity and jerk are 1 and -3 at x = 0.

    The acceleration has its extremes where x⁴ - 6 x² + 3 is 0, that is at x² = 3 - √6. Each derivative is divided by
    0.25 s.
    """
    a = axis((0.0, hold(0.0)), (1.0, Smooth(4.5, bump)), scale=scale)
    found = extremes(a, 9.0)
    ends = [(each.value, each.time) for each in (found.highest, found.lowest)]
    times = (2.75, 3.25) if scale < 0.0 else (3.25, 2.75)
    assert [value * size for value, _ in ends] == pytest.approx([e**-0.5, -(e**-0.5)])
    assert [time for _, time in ends] == pytest.approx(times, abs=1e-6)
    assert (found.speed.value * size, found.speed.time) == pytest.approx((4.0, 3.0), abs=1e-6)
    assert (found.jerk.value * size, found.jerk.time) == pytest.approx((3.0 * 64.0, 3.0), abs=1e-6)
    x = sqrt(3.0 - sqrt(6.0))
    assert found.acceleration.value * size == pytest.approx((3 * x - x**3) * exp(-x * x / 2) * 16.0)
    assert abs(found.acceleration.time - 3.0) == pytest.approx(x / 4, abs=1e-6)


@pytest.mark.parametrize("middle", [0.06, 4.44])
def test_an_extreme_next_to_an_end_of_a_formula_is_found(middle: float) -> None:
    """Samples are 0.094 s apart; the velocity has its peak 0.06 s from an end."""
    found = extremes(axis((0.0, Smooth(4.5, lambda t: bump(t, middle)))), 9.0)
    assert (found.speed.value, found.speed.time) == pytest.approx((4.0, middle), abs=1e-6)


def test_an_axis_at_rest_has_its_extremes_at_power_up() -> None:
    found = extremes(axis((0.0, hold(6.0)), scale=2.0), 5.0)
    every = found.lowest, found.highest, found.speed, found.acceleration, found.jerk
    assert list(map(repr, every)) == ["Extreme(3, 0)"] * 2 + ["Extreme(0, 0)"] * 3


def test_a_jump_at_a_knot_inside_a_profile() -> None:
    """From 1 s on the jerk is 2 for 1 s, then the acceleration of 2 ends."""

    def state(t: float) -> tuple[float, ...]:
        return (t**3 / 3, t * t, 2 * t, 2.0) if t < 1.0 else (1 / 3 + (t - 1.0), 1.0, 0.0, 0.0)

    profile = Smooth(3.0, state, 1.0)
    found = extremes(axis((0.0, hold(0.0)), (1.0, profile)), 9.0)
    assert (found.acceleration.value, found.acceleration.time) == pytest.approx((2.0, 2.0))
    assert (found.jerk.value, found.jerk.time) == (inf, 2.0)
    early = extremes(axis((0.0, hold(0.0)), (1.0, profile)), 1.75)
    assert (early.jerk.value, early.jerk.time) == (2.0, 1.0)  # constant, so the first time counts


def test_a_piece_that_begins_as_the_run_ends_does_not_count() -> None:
    """Of 25 in 1 s, 62.5 in 1.25 s and 12.5 in 0.5 s, the last ramp has -100."""
    track = axis((0.0, hold(0.0)), (1.0, plan_trapezoid(0.0, 100.0, 50.0, 50.0, 100.0)))
    assert [extremes(track, until).acceleration.value for until in (3.25, 3.5)] == [50.0, 100.0]


@pytest.mark.parametrize(
    ("until", "position", "speed"), [(1.5, 0.625, 1.5), (3.0, 4.0, 3.0), (6.0, 13.0, 3.0)]
)
def test_a_formula_counts_up_to_the_end_of_the_run(until: float, position: float, speed: float) -> None:
    """From 1 s on an axis has 1 uu/s and 1 uu/s² for 2 s, then its speed of 3 uu/s.

    It covers 0.5 + 0.125 in half a second, 2 + 2 in 2 s, and 9 more in the last 3 s.
    """
    found = extremes(axis((0.0, hold(0.0)), (1.0, cubic(2.0, 0.0, 1.0, 1.0))), until)
    assert (found.highest.value, found.speed.value) == pytest.approx((position, speed))
    assert found.acceleration.value == inf  # a velocity at once


@pytest.mark.parametrize(
    ("jump", "acceleration", "jerk"),
    [
        ((0.0, 0.0), 1.0, 0.0),
        ((2e-9, 0.0), 1.0, 0.0),  # a billionth of a velocity of 3, or an acceleration for 1e-10 s
        ((4e-9, 0.0), inf, inf),
        ((-4e-9, 0.0), inf, inf),
        ((0.0, 9e-10), 1.0, 0.0),
        ((0.0, 1.2e-9), 1.0, inf),
        ((0.0, -1.2e-9), 1.0, inf),
    ],
)
def test_a_jump_that_is_more_than_rounding(
    jump: tuple[float, float], acceleration: float, jerk: float
) -> None:
    """From 1 uu/s to 3 uu/s with 1 uu/s², then with a small change of both."""
    one, other = cubic(2.0, 0.0, 1.0, 1.0), cubic(2.0, 4.0, 3.0 + jump[0], 1.0 + jump[1])
    found = extremes(axis((0.0, one), (2.0, other)), 4.0)
    assert found.acceleration.value == pytest.approx(acceleration, rel=1e-8)
    assert found.jerk.value == jerk
    if jerk == inf:
        assert found.jerk.time == 2.0


def test_a_velocity_below_one_may_differ_by_a_billionth() -> None:
    for jump, acceleration in ((9e-10, 0.0), (1.2e-9, inf)):
        found = extremes(axis((0.0, cubic(2.0, 0.0, 0.1)), (2.0, cubic(2.0, 0.2, 0.1 + jump))), 4.0)
        assert found.acceleration.value == acceleration


def test_the_time_of_the_first_jump_counts() -> None:
    """The acceleration jumps at 1 s, the velocity at 2 s and at 3 s."""
    track = axis(
        *((0.0, hold(0.0)), (1.0, cubic(1.0, 0.0, 0.0, 4.0)), (2.0, cubic(1.0, 2.0, 1.0))),
        (3.0, cubic(1.0, 3.0, 2.0)),
    )
    found = extremes(track, 9.0)
    assert (found.acceleration.value, found.acceleration.time) == (inf, 2.0)
    assert (found.jerk.value, found.jerk.time) == (inf, 1.0)
    early = extremes(track, 1.5)
    assert (early.acceleration.value, early.speed.value, early.highest.value) == pytest.approx(
        (4.0, 2.0, 0.5)
    )


def test_a_profile_that_was_replaced_at_once_does_not_count() -> None:
    """An axis is given the position 5 at power-up; it had 3 for no time."""
    track = axis((0.0, hold(3.0)), (0.0, hold(5.0)), (1.0, cubic(1.0, 5.0, 0.0, 2.0)), scale=2.0)
    found = extremes(track, 1.5)
    assert (found.lowest.value, found.highest.value) == pytest.approx((2.5, 2.625))
    assert (found.speed.value, peak_speed(track, 1.5)) == pytest.approx((0.5, 0.5))


def block(period: float, **columns: list[float]) -> Any:
    made = {name: np.array(values) for name, values in columns.items()}
    length = len(next(iter(made.values())))
    return type(
        "Block", (), {**made, "loop": SimpleNamespace(period=period), "__len__": lambda self: length}
    )()


@pytest.mark.parametrize(
    ("column", "value", "time", "mean"),
    [("error", 2.5, 3.25, (45.0 / 5.0) ** 0.5 / 2.0), ("torque", 6.0, 1.5, (92.0 / 5.0) ** 0.5)],
)
def test_the_peak_of_a_motor(
    column: str, value: float, time: float, mean: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Samples from 1 s, 3 s and 5 s on, every 0.25 s; an error of -2 counts is 1 uu.

    The squares of the errors are 4, 1, 9, 25 and 6, those of the torques 0, 16, 36, 36 and 4. Of two equal peaks the
    first counts.
    """
    blocks = [
        (1.0, block(0.25, error=[2.0, -1.0, 3.0], torque=[0.0, 4.0, -6.0])),
        (2.0, block(0.25, error=[], torque=[])),
        (3.0, block(0.25, error=[6.0**0.5, -5.0], torque=[6.0, 2.0])),
    ]
    monkeypatch.setattr(history, "chunks", lambda a, until: iter(blocks))
    a = axis((0.0, hold(0.0)), scale=-2.0, feedback=object())
    peak, average = motor_peak(a, 9.0, column), motor_peak(a, 9.0, column, rms=True)
    assert peak is not None
    assert average is not None
    assert (peak.value, peak.time) == (value, time)
    assert (average.value, average.time) == pytest.approx((mean, 9.0))
    blocks[:] = blocks[1:2]
    assert [repr(motor_peak(a, 9.0, column, rms=rms)) for rms in (False, True)] == [
        "Extreme(0, 0)",
        "Extreme(0, 9)",
    ]
