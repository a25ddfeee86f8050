"""Contours with events in motion: limits are observed, nothing jumps, all arrive.

The checker is independent of the planners: it samples the tracks of the axes and takes differences. A piece
of a track is a polynomial, whose velocity has its extremes at its ends or inside; samples are taken at both.
"""

from __future__ import annotations

import math
from itertools import pairwise
from random import Random

import pytest

from motionlang.kernel import Controller
from tests.cases import examples
from tests.kernel.controller.machines import until
from tests.kernel.controller.moves.test_path import path_speed, plane, positions

SLACK = 1.0 + 1e-6
JERK = 2000.0
# Samples of a track at equal intervals, in addition to the ends and the middle of each piece.
SAMPLES = 150


def straight(random: Random, shape: str) -> Controller:
    """Return a plane for joined paths on one line, with random rates and jerks."""
    c = plane(contour_mode=True, contour_angle=1.0, feedrate_mode=3, shape=shape)
    for name in ("accel", "decel"):
        c.configure(0, name, 100.0 * random.uniform(40, 200))
    for name in ("accel_jerk", "decel_jerk"):
        c.configure(0, name, 100.0 * random.uniform(0.5, 1.0) * JERK)
    return c


def load(c: Controller, random: Random) -> float:
    """Load one more path and return its length."""
    c.configure(0, "speed", 100.0 * random.choice([5, 10, 20, 40]))
    length = random.choice([1.0, 5.0, random.uniform(0.2, 30)])
    c.load_line_by([0, 1], [60.0 * length, 40.0 * length])
    c.go([0])
    return length


def act(c: Controller, random: Random) -> str:
    """Change the motion in progress at random; return the name of the event."""
    event = random.choice(["override", "more", "more", "suspend", "stop"])
    if event == "override":
        c.configure(0, "override", random.choice([0.3, 0.7, 1.0, 1.5]))
    elif event == "suspend":
        c.suspend(0)
    elif event == "stop":
        c.stop(random.randrange(2))
    return event


def rates(c: Controller, times: list[float], h: float) -> list[tuple[float, float, float]]:
    """Return the speed along the path, and its first and second time derivative.

    They are computed by differences, for a line without corners.
    """
    found = []
    for time in times:
        v = [path_speed(c, time + k * h) for k in (-1, 0, 1)]
        found.append((v[1], (v[2] - v[0]) / (2.0 * h), (v[2] - 2.0 * v[1] + v[0]) / (h * h)))
    return found


def judge(c: Controller, shape: str, end: float) -> None:
    accel, decel = (float(c.setting(0, name) or 0.0) / 100.0 for name in ("accel", "decel"))
    jerk = max(float(c.setting(0, name) or 0.0) for name in ("accel_jerk", "decel_jerk")) / 100.0
    step = end / SAMPLES
    knots = [t for t in c.axes[0].starts if 0.0 < t < end]
    for time in knots:
        jump = abs(path_speed(c, time + 1e-7) - path_speed(c, time - 1e-7))
        assert jump <= 2e-7 * max(accel, decel) * 1.1 + 1e-7, time
    h = min(step, 1e-4)
    bends = []
    even = [step * (k + 0.5) for k in range(SAMPLES)]
    middles = [(before + after) / 2.0 for before, after in pairwise([0.0, *knots, end])]
    for v, a, j in rates(c, sorted([*even, *knots, *middles]), h):
        assert v <= 60.0 * SLACK
        assert -decel * SLACK - 1e-5 <= a <= accel * SLACK + 1e-5
        # a difference across a knot may see both sides
        assert shape != "scurve" or abs(j) <= 2.0 * jerk * SLACK + 1e-2
        bends.append(a)
    for before, after in pairwise(bends):
        assert shape != "scurve" or abs(after - before) <= jerk * (step + 2.0 * h) * SLACK + 1e-4


def run(seed: int) -> None:
    random = Random(seed)
    shape = random.choice(["trapezoid", "scurve"])
    c = straight(random, shape)
    length, stopped, loaded = 0.0, False, random.randint(1, 6)
    for _ in range(loaded):
        length += load(c, random)
    for _ in range(random.randint(1, 6)):
        until(c, c.clock.now + random.uniform(0.01, 0.8))
        if c.is_idle(0):
            break
        event = act(c, random)
        if event == "more" and loaded < 12:
            length, loaded = length + load(c, random), loaded + 1
        elif event == "suspend":
            until(c, c.clock.now + random.choice([0.05, 0.3, 3.0]))
            c.resume(0)
        elif event == "stop":
            stopped = True
            break
    until(c, 1e4)
    assert c.is_idle(0)
    assert c.is_idle(1)
    x, y = positions(c)
    assert y == pytest.approx(x * 0.8 / 0.6, rel=1e-12)
    if not stopped:
        assert math.hypot(x, y) == pytest.approx(length, rel=1e-12)
    judge(c, shape, c.axes[0].starts[-1])


@pytest.mark.parametrize("first", range(0, 200, 25))
def test_contours_with_events_keep_their_limits_and_arrive(first: int) -> None:
    for seed in range(first, first + examples(25)):
        run(seed)


@pytest.mark.long
def test_many_contours_with_events() -> None:
    for seed in range(1000, 3000):
        run(seed)


def ramped() -> Controller:
    """Return one path of 40 units with an S-ramp, which follows the override.

    It has 20 units/s, 50 units/s², 400 units/s³.
    """
    c = plane(shape="scurve", feedrate_mode=3)
    for name, value in {"speed": 20.0, "accel": 50.0, "decel": 50.0}.items():
        c.configure(0, name, 100.0 * value)
    for name in ("accel_jerk", "decel_jerk"):
        c.configure(0, name, 100.0 * 400.0)
    c.load_line_by([0, 1], [4000.0, 0.0])
    c.go([0])
    return until(c, 0.35)


@pytest.mark.parametrize("how", ["stop", "suspend"])
def test_what_stops_a_path_takes_its_acceleration_back_first(how: str) -> None:
    """The path has covered 2.099 at a speed of 14.375.

    Its acceleration falls to zero in 0.125 s, which covers 2.057 and leads to a speed of 17.5. From there it
    comes to rest in 0.475 s, at half of that speed on average.
    """
    c = ramped()
    getattr(c, how)(0)
    until(c, 9.0)
    assert positions(c)[0] == pytest.approx(8.3125, rel=1e-12)


@pytest.mark.parametrize("override", [0.0, 0.5])
def test_a_new_override_takes_the_acceleration_of_a_path_back_first(override: float) -> None:
    c = ramped()
    before = c.axes[0].at(c.clock.now).acceleration
    c.configure(0, "override", override)
    assert c.axes[0].at(c.clock.now).acceleration == pytest.approx(before)
    until(c, 2.0)
    assert c.path_speed(0) == pytest.approx(20.0 * override)
    c.configure(0, "override", 1.0)
    until(c, 9.0)
    assert positions(c) == [40.0, 0.0]
    judge(c, "scurve", c.axes[0].starts[-1])


@pytest.mark.parametrize("axis", [0, 1])
def test_a_limit_that_comes_in_motion_is_met(axis: int) -> None:
    """From 10 units/s on each of two perpendicular axes, one slows down to 4."""
    c = plane(contour_mode=True)
    c.load_line_by([0, 1], [3000.0, 2000.0])  # 30 by 40 units: 50
    c.go([0])
    until(c, 2.0)
    counts = (100.0, 50.0)[axis]
    c.configure(axis, "max_speed", 4.0 * counts)
    until(c, 2.2)
    assert abs(c.velocity(axis)) == pytest.approx(4.0 * counts)
    c.configure(axis, "max_decel", 2.0 * counts)
    until(c, 99.0)
    assert positions(c) == [30.0, 40.0]
    # 4 units/s at 2 units/s² take two seconds
    last = c.axes[axis].starts[-1]
    assert c.axes[axis].velocity(last - 1.0) == pytest.approx(2.0 * counts)


def test_a_limit_that_comes_in_motion_is_met_by_a_single_axis() -> None:
    c = plane()
    c.load_by(0, 5000.0)
    c.go([0])
    until(c, 2.0)
    c.configure(0, "max_speed", 400.0)
    assert c.velocity(0) == pytest.approx(1000.0)
    until(c, 2.06)
    assert c.velocity(0) == pytest.approx(400.0)
    until(c, 99.0)
    assert c.position(0) == 5000.0
