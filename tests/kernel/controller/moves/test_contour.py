"""Random contours: every path is run, takes time, and ends as commanded."""

from __future__ import annotations

import math
from random import Random

import pytest

from motionlang.kernel import Controller
from tests.cases import examples
from tests.kernel.controller.machines import machine, until
from tests.kernel.controller.moves.test_path import plane, positions

# Paths may be as short as this, in user units.
SHORT = 1e-6


def load_straight(c: Controller, random: Random) -> None:
    """Load paths with two to five different speeds on one straight line."""
    for _ in range(random.randint(2, 5)):
        c.configure(0, "speed", float(random.choice([5, 10, 20, 30, 45, 60])))
        c.load_line_by([0, 1], [float(random.choice([10, 30, 50, 80])), 0.0])


def load_bent(c: Controller, random: Random) -> None:
    """Load two to eight lines and arcs of any speed and rates, most with slight bends."""
    heading = random.uniform(0.0, 2.0 * math.pi)
    for _ in range(random.randint(2, 8)):
        c.configure(0, "speed", 100.0 * random.choice([5, 10, 20, 30, 45, random.uniform(1, 60)]))
        for name in ("accel", "decel"):
            c.configure(0, name, 100.0 * random.uniform(30, 200))
        heading += math.radians(random.choice([0.0, 0.0, 0.1, 3.0, random.uniform(-40, 40)]))
        if random.random() < 0.2:
            radius, angle = random.uniform(1, 30), random.uniform(5, 200)
            centre = [-100.0 * radius * math.sin(heading), 50.0 * radius * math.cos(heading)]
            c.load_arc([0, 1], centre, angle, (), True)
            heading += math.radians(angle)
        else:
            length = random.choice([10.0, 80.0, random.uniform(0.01, 100), random.choice([1e-3, SHORT])])
            c.load_line_by([0, 1], [100.0 * length * math.cos(heading), 50.0 * length * math.sin(heading)])


def limited(c: Controller, random: Random) -> None:
    """Give each axis no limit, a limit of speed, limits of rates, or both."""
    which = random.choice(["", "speed", "rates", "both"])
    for axis, counts in ((0, 100.0), (1, 50.0)):
        if which in ("speed", "both"):
            c.configure(axis, "max_speed", counts * random.uniform(5, 40))
        if which in ("rates", "both"):
            c.configure(axis, "max_accel", counts * random.uniform(20, 200))
            c.configure(axis, "max_decel", counts * random.uniform(20, 200))


def bent(seed: int) -> Controller:
    """Return a contour with slight bends, or separate paths, in any feed rate mode."""
    random = Random(seed)
    shapes = ["trapezoid", "trapezoid", "scurve", "sinusoidal", "parabolic"]
    c = plane(
        contour_mode=random.random() < 0.8,
        contour_angle=random.choice([0.5, 5.0, 30.0, 180.0]),
        feedrate_mode=random.randrange(4),
        shape=random.choice(shapes),
    )
    limited(c, random)
    load_bent(c, random)
    return c


def straight(seed: int) -> Controller:
    c = machine(2, buffer_size=9, accel=90.0, decel=60.0, contour_mode=True, feedrate_mode=1)
    load_straight(c, Random(seed))
    return c


def check_arrival(c: Controller) -> None:
    """Run all loaded paths; check that each takes time and ends exactly as programmed."""
    entries = list(c.axes[0].buffer)
    ends = [c.axes[axis].buffer[-1].target for axis in (0, 1)]
    c.go([0])
    until(c, 1e6)
    assert [c.is_idle(axis) for axis in (0, 1)] == [True, True]
    assert [c.position(axis) for axis in (0, 1)] == ends
    assert [move for move in c.log.moves if move.axis == 0] == entries
    times = [move.profile.duration for move in c.log.moves if move.profile is not None]
    assert len(times) == 2 * len(entries)
    assert min(times) > SHORT / 1000.0


def test_a_contour_at_three_speeds_arrives() -> None:
    c = machine(2, buffer_size=3, accel=90.0, decel=60.0, contour_mode=True, feedrate_mode=1)
    for speed, length in ((20.0, 80.0), (30.0, 30.0), (45.0, 80.0)):
        c.configure(0, "speed", speed)
        c.load_line_by([0, 1], [length, 0.0])
    check_arrival(c)
    assert c.position(0) == 190.0
    assert c.axes[0].starts[-1] == pytest.approx(74.0 / 18.0 + 1.1 / 1.08 + 157.0 / 72.0)


@pytest.mark.parametrize("first", range(0, 400, 50))
def test_straight_contours_arrive(first: int) -> None:
    for seed in range(first, first + examples(50)):
        check_arrival(straight(seed))


@pytest.mark.parametrize("first", range(0, 800, 50))
def test_bent_contours_arrive(first: int) -> None:
    for seed in range(first, first + examples(50)):
        check_arrival(bent(seed))


@pytest.mark.long
def test_many_contours_arrive() -> None:
    for seed in range(1000, 60_000):
        check_arrival(straight(seed))
        check_arrival(bent(seed))


def test_a_short_path_at_the_end_of_long_ones_is_run_to_its_end() -> None:
    c = plane(contour_mode=True)
    for length in (1000.0, 333.3, 777.7, SHORT):
        c.load_line_by([0, 1], [100.0 * length, 0.0])
    check_arrival(c)


def test_a_stop_that_needs_more_room_than_there_is_leaves_the_run_as_it_was_planned() -> None:
    """Axis 0 brakes so slowly that it can only stop on the path after the corner.

    That path is along axis 1.
    """
    c = plane(contour_mode=True, contour_angle=180.0, feedrate_mode=1)
    c.configure(0, "max_decel", 100.0 * 10.0)
    for speed, distances in ((2000.0, [4000.0, 0.0]), (1500.0, [0.0, 125.0])):
        c.configure(0, "speed", speed)
        c.load_line_by([0, 1], distances)
    c.go([0])
    until(c, 2.1).stop(0)
    until(c, 99.0)
    assert c.is_idle(0)
    assert positions(c) == [40.0, 2.5]
    assert [move.ended for move in c.log.moves] == ["", "", "stop", "stop"]
