"""Offsets on a slave at 10 counts/s: duration, status and what is left, by hand.

The rates of the slave are 100 counts/s2, so a change of its speed by 10 takes 0.1 s and 0.5 counts.
"""

from __future__ import annotations

from math import inf

import pytest

from motionlang.kernel import Controller
from tests.cases import cases
from tests.kernel.controller.machines import machine, offset, until

# Bits of the status.
FAST, SLOW, ACCEL, DECEL, PROFILE = 1, 2, 4, 8, 16


def moving(settings: dict[str, float] | None = None, back: bool = False) -> Controller:
    """Return a slave that follows its master from 0 s on, both at speed from 0.1 s on."""
    c = machine()
    for name, value in (settings or {}).items():
        c.configure(1, name, value)
    c.gear(1, 0, 1.0)
    c.jog(0, -10.0 if back else 10.0)
    return until(c, 1.0)


@cases(
    "distance, mode, over, settings, duration, status",
    [
        # Mode 0 at the speed of the axis; mode 1 up to MAXSPEED, and no slower than standstill.
        (5.0, 0, 0.0, {}, 0.6, 0),
        (-5.0, 0, 0.0, {"max_speed": 12.0}, 0.6, 0),
        (5.0, 1, 0.0, {}, 0.6, 0),
        (5.0, 1, 0.0, {"max_speed": 21.0}, 0.6, 0),
        (5.0, 1, 0.0, {"max_speed": 15.0}, 1.05, FAST),
        (5.0, 1, 0.0, {"speed": 4.0}, 5.0 / 4.0 + 0.04, 0),
        (-5.0, 1, 0.0, {"speed": 9.0}, 5.0 / 9.0 + 0.09, 0),
        (-5.0, 1, 0.0, {"speed": 20.0}, 0.6, SLOW),
        (-5.0, 1, 0.0, {"speed": 20.0, "max_speed": 11.0}, 0.6, SLOW),
        # Mode 2: a triangle in the time in which the master goes so far, or a trapezoid below MAXSPEED.
        (5.0, 2, 20.0, {}, 2.0, 0),
        (5.0, 2, -20.0, {}, 2.0, 0),
        (-5.0, 2, 20.0, {}, 2.0, 0),
        (5.0, 2, 20.0, {"max_speed": 13.0}, 2.0, FAST),
        (-15.0, 2, 20.0, {}, 2.0, SLOW),
        (5.0, 2, 20.0, {"max_accel": 5.0, "max_decel": 5.0}, 2.0, 0),
        # Mode 3: a trapezoid at the rates of the axis.
        (5.0, 3, 20.0, {}, 2.0, 0),
        (-5.0, 3, 20.0, {}, 2.0, 0),
        (5.0, 3, 20.0, {"max_speed": 12.0}, 5.0 / 2.0 + 0.02, FAST),
    ],
)
def test_the_duration_of_an_offset(
    distance: float, mode: int, over: float, settings: dict[str, float], duration: float, status: int
) -> None:
    for back in (False, True):
        sign = -1.0 if back else 1.0
        c = moving(settings, back)
        offset(c, 1, sign * distance, mode, over)
        assert c.offset_status(1) == 0
        assert c.offset_remaining(1) == pytest.approx(sign * distance)
        assert c.offset_crossing_time(1, 0.5 * sign * distance) == pytest.approx(1.0 + 0.5 * duration)
        assert c.log.moves[-1].profile.duration == pytest.approx(duration)  # type: ignore[union-attr]
        until(c, 1.0 + 0.5 * duration)
        assert c.offset_status(1) == status
        assert c.offset_remaining(1) == pytest.approx(0.5 * sign * distance)
        assert c.position(1) - c.position(0) == pytest.approx(0.5 * sign * distance)
        until(c, 1.001 + duration)
        assert c.position(1) - c.position(0) == pytest.approx(sign * distance)
        assert c.offset_remaining(1) == 0.0


@cases(
    "distance, mode, over, settings, status",
    [
        (5.0, 1, 0.0, {"max_speed": 10.0}, FAST),
        (5.0, 1, 0.0, {"max_speed": 8.0}, FAST),
        (5.0, 2, 20.0, {"max_speed": 12.0}, FAST | PROFILE),
        (5.0, 2, 20.0, {"max_speed": 12.5}, FAST | PROFILE),
        (-25.0, 2, 20.0, {}, SLOW | PROFILE),
        (5.0, 2, 20.0, {"max_accel": 4.9}, ACCEL),
        (5.0, 2, 20.0, {"max_decel": 4.9}, DECEL),
        (5.0, 2, 20.0, {"max_accel": 4.9, "max_decel": 4.9}, ACCEL | DECEL),
        (5.0, 2, 0.0, {}, PROFILE),
        (5.0, 3, 0.0, {}, PROFILE),
        # 4 counts in 0.4 s need the rates of 100 counts/s2; a hundredth more is impossible.
        (4.04, 3, 4.0, {}, ACCEL | DECEL),
    ],
)
def test_an_offset_that_is_impossible_has_no_effect(
    distance: float, mode: int, over: float, settings: dict[str, float], status: int
) -> None:
    c = moving(settings)
    offset(c, 1, distance, mode, over)
    assert c.offset_status(1) == status
    assert c.offset_remaining(1) == 0.0
    assert c.offset_crossing_time(1, 1.0) == inf
    until(c, 9.0)
    assert c.position(1) == pytest.approx(c.position(0))


def test_an_offset_too_short_for_the_bound_reports_success() -> None:
    """0.25 counts reach 5 counts/s at 100 counts/s2 after 0.05 s; 0.2 do not."""
    c = moving({"max_speed": 15.0})
    offset(c, 1, 0.2, 1)
    until(c, 2.0)
    assert c.offset_status(1) == 0
    offset(c, 1, 0.3, 1)
    until(c, 2.049)
    assert c.offset_status(1) == 0
    until(c, 2.051)
    assert c.offset_status(1) == FAST


def test_times_at_which_so_much_is_left() -> None:
    """Of 5 counts 0.5 are covered in the first 0.1 s, then 10 a second."""
    c = moving()
    assert c.offset_status(0) == c.offset_status(1) == 0
    offset(c, 1, 5.0)
    for left, time in ((4.5, 1.1), (2.5, 1.3), (0.5, 1.5), (0.0, 1.6), (6.0, inf), (inf, inf)):
        assert c.offset_crossing_time(1, left) == pytest.approx(time)
    until(c, 1.2)
    assert c.offset_crossing_time(1, 2.5) == pytest.approx(1.3)
    assert c.offset_crossing_time(1, 4.5) == inf
