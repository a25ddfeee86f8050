"""Any verbs in any order: no position jumps, time advances, only Rejected rises."""

from __future__ import annotations

import math
from random import Random
from typing import TYPE_CHECKING, Any

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel import Controller, Rejected, Trace
from tests.cases import examples
from tests.kernel.controller.machines import cam, machine, offset, until

if TYPE_CHECKING:
    from collections.abc import Callable

TABLE = ([0.0, 3.0, 7.0, 9.0], [0.0, 4.0, -2.0, 1.0])
SHAPES = ("trapezoid", "sinusoidal", "scurve", "parabolic")
SEEDS = st.integers(0, 2**32)

Step = tuple[Any, ...]


def steps_of(r: Random, most: int) -> list[Step]:
    """Return random verbs with their arguments; the seed defines the complete case."""

    def axis() -> int:
        return r.randrange(3)

    def distance() -> float:
        return r.choice([0.0, 1.0, -1.0, r.uniform(-20.0, 20.0), r.uniform(-20.0, 20.0)])

    makers: list[Callable[[], Step]] = [
        *[lambda: ("wait", r.randrange(97) / 64.0)] * 5,
        *[lambda: ("go", [0, 1, 2])] * 3,
        *[
            lambda: (
                r.choice(["load_by", "load_to", "move_to", "move_by", "retarget_to", "offset"]),
                axis(),
                distance(),
            )
        ]
        * 2,
        lambda: ("jog", axis(), r.uniform(-15.0, 15.0)),
        lambda: (
            "load_line_by",
            r.choice([[0, 1], [1, 0], [1, 2], [0, 1, 2]]),
            [distance(), distance(), distance()],
        ),
        lambda: (
            "load_arc",
            [0, 1],
            (distance(), distance()),
            r.choice([90.0, 360.0, distance() * 25.0]),
            (),
            r.random() < 0.5,
        ),
        lambda: ("load_dwell", axis(), r.randrange(50) / 64.0),
        lambda: ("load_fly", axis(), axis(), distance(), r.uniform(1.0, 9.0)),
        lambda: (r.choice(["stop", "suspend", "resume", "abort", "disable", "enable"]), axis()),
        lambda: ("gear", axis(), axis(), r.uniform(-2.0, 2.0), r.random() < 0.5),
        lambda: ("cam", axis(), axis(), r.random() < 0.5),
        lambda: ("configure", axis(), r.choice(["speed", "accel", "decel"]), r.uniform(1.0, 200.0)),
        lambda: ("configure", axis(), "override", r.choice([0.0, 0.5, 1.0, 2.0])),
        lambda: ("configure", axis(), "feedrate_mode", r.randrange(4)),
        lambda: ("configure", axis(), "contour_mode", r.random() < 0.5),
    ]
    return [r.choice(makers)() for _ in range(r.randrange(2, most))]


def perform(c: Controller, step: tuple[Any, ...]) -> None:
    verb, *rest = step
    if verb == "wait":
        run_on(c, c.clock.now + rest[0])
    elif verb == "cam":
        slave, master, cyclic = rest
        cam(c, slave, master, *TABLE, cyclic=cyclic)
    elif verb == "offset":
        offset(c, *rest)
    elif verb == "load_line_by":
        c.load_line_by(rest[0], rest[1][: len(rest[0])])
    else:
        getattr(c, verb)(*rest)


def run_on(c: Controller, time: float) -> None:
    """Advance the controller to `time`; a motion that an event rejects just ends."""
    while c.clock.now < time:
        try:
            until(c, time)
        except Rejected:
            pass


def jumps(c: Controller, axis: int) -> float:
    """Return the largest gap between consecutive profiles of a track."""
    a = c.axes[axis]
    worst = 0.0
    for k in range(1, len(a.starts)):
        before = a.profiles[k - 1].position(a.starts[k] - a.starts[k - 1])
        worst = max(worst, abs(a.profiles[k].position(0.0) - before))
    return worst


@settings(max_examples=examples(400))
@given(SEEDS)
def test_positions_never_jump(seed: int) -> None:
    r = Random(seed)
    c = machine(3, buffer_size=6, shape=r.choice(SHAPES), contour_angle=60.0)
    for step in steps_of(r, 40):
        try:
            perform(c, step)
        except Rejected:
            pass
    run_on(c, c.clock.now + 3.0)
    for axis in c.axes:
        assert jumps(c, axis) < 1e-6
        c.stop(axis)
    for axis in c.axes:
        c.resume(axis)
    run_on(c, c.clock.now + 1000.0)
    assert c.moving() == []
    for axis in c.axes:
        assert all(math.isfinite(c.axes[axis].position(0.25 * k)) for k in range(40))


@settings(max_examples=examples(100))
@given(SEEDS)
def test_the_trace_and_the_log_are_the_track(seed: int) -> None:
    r = Random(seed)
    c = machine(3, buffer_size=6, shape=r.choice(SHAPES), contour_angle=60.0)
    for step in steps_of(r, 20):
        try:
            perform(c, step)
        except Rejected:
            pass
    run_on(c, c.clock.now + 2.0)
    samples = Trace(c).sample(97.0, axes=[0, 1, 2])
    for axis in c.axes:
        wanted = [c.axes[axis].position(t) for t in samples.time.tolist()]
        assert np.abs(samples.get(axis, "position") - wanted)[:-1].max(initial=0.0) < 1e-6
    for move in c.log.moves:
        assert move.profile is not None
        assert move.profile.duration >= 0.0
        assert all(phase.duration >= 0.0 for phase in move.profile.phases)
        assert move.profile.peak_speed >= 0.0
