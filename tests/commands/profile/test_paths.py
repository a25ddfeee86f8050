"""The figures of paths, measured on motions whose length and direction are known."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, radians, sin, tau
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from motionlang.commands.profile.paths import paths
from motionlang.kernel.log.move import Action

# The position of each axis at a time, and its velocity.
Motion = dict[int, tuple[Callable[[Any], Any], Callable[[Any], Any]]]


def traced(motion: Motion, moves: list[Any], end: float = 100.0) -> Any:
    """Return a trace of a motion, with the moves of its log."""

    def at(axis: int, quantity: str, times: Any) -> Any:
        return motion[axis][("position", "velocity").index(quantity)](times) + np.zeros(len(times))

    return SimpleNamespace(controller=SimpleNamespace(log=SimpleNamespace(moves=moves)), end=end, at=at)


def entries(
    begin: float,
    duration: float,
    line: int = 3,
    axes: tuple[int, ...] = (0, 1),
    ended: str = "",
    command: str = "VECTORR",
) -> list[Any]:
    return [
        SimpleNamespace(
            axis=axis,
            line=line,
            command=command,
            start_time=begin,
            profile=SimpleNamespace(duration=duration),
            action=Action(),
            ended=ended,
        )
        for axis in axes
    ]


def straight(degrees: float, speed: float = 5.0) -> Motion:
    x, y = cos(radians(degrees)) * speed, sin(radians(degrees)) * speed
    return {0: (lambda t: x * t, lambda t: x), 1: (lambda t: y * t, lambda t: y)}


def test_a_line_at_speed() -> None:
    """From 1 s to 3 s at 5 uu/s; each of the other entries is no path."""
    alone = entries(5.0, 1.0, axes=(2,))
    never_begun, single = entries(6.0, 1.0), entries(7.0, 1.0)
    empty = entries(8.0, 0.0)
    for move in never_begun:
        move.profile = None
    for move in single:
        move.action = None
    begun = entries(1.0, 2.0, ended="stop")
    begun[1].ended = "cancel"  # that of the first axis counts
    (row,) = paths(traced(straight(30.0), begun + alone + never_begun + single + empty))
    assert row[:5] == (3, "VECTORR", (0, 1), 1.0, 2.0)
    assert row[5:9] == pytest.approx((10.0, 5.0, 5.0, 5.0))
    assert row[9:] == (None, "stop")


def test_a_path_is_over_at_the_end_of_the_run() -> None:
    (row,) = paths(traced(straight(0.0), entries(1.0, 99.0), end=3.0))
    assert (row.start_time, row.duration, row.length) == pytest.approx((1.0, 2.0, 10.0))


def on_circle(angle: Callable[[Any], Any], rate: Callable[[Any], Any], radius: float = 10.0) -> Motion:
    """Return the motion on a circle around 0, 0 from an angle (radians) and its rate."""
    return {
        0: (lambda t: radius * np.cos(angle(t)), lambda t: -radius * np.sin(angle(t)) * rate(t)),
        1: (lambda t: radius * np.sin(angle(t)), lambda t: radius * np.cos(angle(t)) * rate(t)),
    }


def turning(begin: float, duration: float, sweep: float) -> Motion:
    """Return an arc of `sweep` radians from rest to rest, fastest in the middle."""

    def share(t: Any) -> Any:
        return np.clip((t - begin) / duration, 0.0, 1.0)

    return on_circle(
        lambda t: sweep * (share(t) - np.sin(tau * share(t)) / tau),
        lambda t: sweep / duration * (1.0 - np.cos(tau * share(t))),
    )


def test_a_quarter_circle_from_rest_to_rest() -> None:
    """Of radius 10 in 4 s: the mean speed is 5 pi / 4, and the peak is twice that."""
    (row,) = paths(traced(turning(2.0, 4.0, pi / 2), entries(2.0, 4.0)))
    assert row.length == pytest.approx(5 * pi, rel=1e-12)
    assert (row.entry_speed, row.peak_speed, row.exit_speed) == pytest.approx((0.0, 2.5 * pi, 0.0))
    assert row.entry_speed == row.exit_speed == 0.0


def test_a_whole_circle_is_as_long_as_its_circumference() -> None:
    """Its ends are at one position."""
    (row,) = paths(traced(turning(0.0, 4.0, tau), entries(0.0, 4.0)))
    assert row.length == pytest.approx(20 * pi, rel=1e-12)


def test_an_arc_that_speeds_up() -> None:
    """The angle is t² in rad: after 1 s the speed is 20 and the length is 10.

    Simpson's rule has no error for a speed that is linear in time.
    """
    (row,) = paths(traced(on_circle(lambda t: t * t, lambda t: 2.0 * t), entries(0.0, 1.0)))
    assert (row.length, row.peak_speed, row.exit_speed) == pytest.approx((10.0, 20.0, 20.0))
    (cubic,) = paths(traced(on_circle(lambda t: t**4, lambda t: 4.0 * t**3), entries(0.0, 1.0)))
    assert cubic.length == pytest.approx(10.0, rel=1e-12)


@pytest.mark.parametrize(
    ("gap", "axes", "has_corner"),
    [
        (0.0, (0, 1), True),
        (0.0009, (1, 0), True),
        (0.001, (0, 1), True),
        (0.0011, (0, 1), False),
        (0.0, (0, 2), False),
        (0.0, (0, 1, 2), False),
    ],
)
def test_the_corner_to_the_path_that_follows_directly(
    gap: float, axes: tuple[int, ...], has_corner: bool
) -> None:
    """Straight ahead for 1 s, then to the left by 30 degrees."""
    left, up = cos(radians(30.0)), sin(radians(30.0))

    def after(t: Any) -> Any:
        return np.maximum(t - 1.0, 0.0)

    motion: Motion = {
        0: (lambda t: np.minimum(t, 1.0) + left * after(t), lambda t: np.where(t < 1.0, 1.0, left)),
        1: (lambda t: up * after(t), lambda t: np.where(t < 1.0, 0.0, up)),
        2: (lambda t: 0.0, lambda t: 0.0),
    }
    first, second = paths(traced(motion, entries(0.0, 1.0) + entries(1.0 + gap, 2.0, 4, axes)))
    assert first.corner == (pytest.approx(30.0, abs=1e-9) if has_corner else None)
    assert (first.line, second.line, second.corner) == (3, 4, None)


def test_a_line_has_the_distance_of_its_ends() -> None:
    """It speeds up for 1 s to 5 uu/s, and is 2.5 + 10 long.

    By samples the length would be inexact, since none is where the acceleration ends.
    """

    def position(t: Any) -> Any:
        return np.where(t < 1.0, 2.5 * t * t, 5.0 * t - 2.5)

    def speed(t: Any) -> Any:
        return np.minimum(5.0 * t, 5.0)

    motion: Motion = {
        0: (lambda t: 0.6 * position(t), lambda t: 0.6 * speed(t)),
        1: (lambda t: 0.8 * position(t), lambda t: 0.8 * speed(t)),
    }
    (row,) = paths(traced(motion, entries(0.0, 3.0)))
    assert row.length == pytest.approx(12.5, rel=1e-14)


@pytest.mark.parametrize("degrees", range(0, 90, 7))
@pytest.mark.parametrize("back", [False, True])
def test_a_corner_of_0_or_180_degrees(degrees: float, back: bool) -> None:
    """The product of two equal directions may exceed 1 by rounding."""
    x, y = straight(degrees)[0][0], straight(degrees)[1][0]

    def along(t: Any) -> Any:
        return 1.0 - abs(t - 1.0) if back else t

    motion: Motion = {
        0: (lambda t: x(along(t)), lambda t: 1.0),
        1: (lambda t: y(along(t)), lambda t: 1.0),
    }
    first, _ = paths(traced(motion, entries(0.0, 1.0) + entries(1.0, 1.0, 4)))
    assert first.corner == pytest.approx(180.0 if back else 0.0, abs=1e-4)


def test_a_path_of_other_axes_between_two_does_not_hide_the_corner() -> None:
    motion = straight(0.0) | {2: (lambda t: 0.0, lambda t: 0.0), 3: (lambda t: t, lambda t: 1.0)}
    others = entries(0.9999, 5.0, 4, (2, 3))
    first, second, third = paths(traced(motion, entries(0.0, 1.0) + others + entries(1.0, 2.0, 5)))
    assert first.corner == pytest.approx(0.0, abs=1e-5)
    assert (second.corner, third.corner) == (None, None)


@pytest.mark.parametrize(
    ("turn", "begin"), [(-90.0, 0.0), (0.0, 0.0), (45.0, 0.0), (170.0, 0.0), (45.0, 9000.0)]
)
def test_the_corner_between_arcs_from_rest_is_that_of_their_tangents(turn: float, begin: float) -> None:
    """The second arc begins `turn` degrees off the end of the first one.

    At rest there is no direction. A distance of a ten-millionth of the coordinates has one, within 0.01 degrees.
    """
    one, other = turning(begin, 4.0, pi / 2), turning(begin + 4.0, 4.0, pi / 2)
    end = begin + 4.0
    by = radians(90.0 + turn)

    def turned(t: Any) -> tuple[Any, Any]:
        x, y = other[0][0](t) - 10.0, other[1][0](t)
        return cos(by) * x - sin(by) * y, sin(by) * x + cos(by) * y + 10.0

    motion: Motion = {
        0: (lambda t: np.where(t <= end, one[0][0](t), turned(t)[0]), one[0][1]),
        1: (lambda t: np.where(t <= end, one[1][0](t), turned(t)[1]), one[1][1]),
    }
    first, _ = paths(traced(motion, entries(begin, 4.0) + entries(end, 4.0, 4), end=1e5))
    assert first.corner == pytest.approx(abs(turn), abs=0.05)


def test_a_path_that_does_not_move_has_a_right_angle() -> None:
    """Without a direction its tangent is 0."""
    motion: Motion = {0: (lambda t: np.minimum(t, 1.0), lambda t: 1.0), 1: (lambda t: 0.0, lambda t: 0.0)}
    first, second = paths(traced(motion, entries(0.0, 1.0) + entries(1.0, 1.0, 4)))
    assert (first.corner, second.length) == (90.0, 0.0)
