"""Any verbs in any order: positions never jump, time passes, and nothing is raised but a Refusal."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.controller.controller import Controller
from motionlang.controller.faults import Refusal
from tests.controller.machines import machine, until

AXES = st.integers(0, 2)
TIMES = st.integers(0, 96).map(lambda k: k / 64.0)
PAIR = st.sampled_from([[0, 1], [1, 0], [1, 2], [0, 1, 2]])
WAY = st.floats(-20.0, 20.0)
TURN = st.floats(-500.0, 500.0)
TABLE = ([0.0, 3.0, 7.0, 9.0], [0.0, 4.0, -2.0, 1.0])

STEPS = st.one_of(
    st.tuples(st.just("wait"), TIMES),
    st.tuples(st.just("wait"), TIMES),
    st.tuples(st.just("go"), st.just([0, 1, 2])),
    st.tuples(st.just("go"), st.just([0, 1, 2])),
    st.tuples(st.sampled_from(["load_by", "load_to", "move_to", "move_by", "retarget_to", "offset"]), AXES, WAY),
    st.tuples(st.just("jog"), AXES, st.floats(-15.0, 15.0)),
    st.tuples(st.just("load_line_by"), PAIR, st.lists(WAY, min_size=3, max_size=3)),
    st.tuples(st.just("load_arc"), st.just([0, 1]), st.tuples(WAY, WAY), TURN, st.just(()), st.booleans()),
    st.tuples(st.just("load_dwell"), AXES, TIMES),
    st.tuples(st.just("load_fly"), AXES, AXES, WAY, st.floats(1.0, 9.0)),
    st.tuples(st.sampled_from(["stop", "suspend", "resume", "blend", "abort", "disable", "enable"]), AXES),
    st.tuples(st.just("gear"), AXES, AXES, st.floats(-2.0, 2.0), st.booleans()),
    st.tuples(st.just("cam"), AXES, AXES, st.sampled_from(["linear", "cubic"]), st.booleans()),
    st.tuples(st.just("define_position"), AXES, WAY),
    st.tuples(st.just("configure"), AXES, st.sampled_from(["speed", "accel", "decel"]), st.floats(1.0, 200.0)),
    st.tuples(st.just("configure"), AXES, st.just("override"), st.sampled_from([0.0, 0.5, 1.0, 2.0])),
    st.tuples(st.just("configure"), AXES, st.just("feedrate_mode"), st.integers(0, 3)),
    st.tuples(st.just("configure"), AXES, st.just("contour_mode"), st.booleans()),
    st.tuples(st.just("configure"), AXES, st.just("blend_mode"), st.booleans()),
)  # fmt: skip


def perform(c: Controller, step: tuple[Any, ...]) -> None:
    verb, *rest = step
    if verb == "wait":
        run_on(c, c.clock.now + rest[0])
    elif verb == "cam":
        slave, master, kind, cyclic = rest
        c.cam(slave, master, *TABLE, kind=kind, cyclic=cyclic)
    elif verb == "load_line_by":
        c.load_line_by(rest[0], rest[1][: len(rest[0])])
    else:
        getattr(c, verb)(*rest)


def run_on(c: Controller, time: float) -> None:
    """Let time pass; what an event refuses ends that motion and nothing else."""
    while c.clock.now < time:
        try:
            until(c, time)
        except Refusal:
            pass


def jumps(c: Controller, axis: int) -> float:
    """The largest distance between the end of one profile of the track and the beginning of the next."""
    a = c.axes[axis]
    worst = 0.0
    for k in range(1, len(a.starts)):
        before = a.profiles[k - 1].position(a.starts[k] - a.starts[k - 1])
        worst = max(worst, abs(a.profiles[k].position(0.0) - before))
    return worst


@settings(max_examples=400, derandomize=True, deadline=None, database=None)
@given(
    st.lists(STEPS, min_size=2, max_size=25),
    st.sampled_from(["trapezoid", "sinusoidal", "scurve", "parabolic"]),
)
def test_positions_never_jump(steps: list[tuple[Any, ...]], shape: str) -> None:
    c = machine(3, buffer_size=6, shape=shape, contour_angle=60.0, blend_distance=0.7)
    zeros: dict[int, float] = {}
    for step in steps:
        try:
            perform(c, step)
        except Refusal:
            pass
        if step[0] == "define_position":
            zeros[step[1]] = 1.0
    run_on(c, c.clock.now + 3.0)
    for axis in c.axes:
        if axis not in zeros:
            assert jumps(c, axis) < 1e-6
        c.stop(axis)
    for axis in c.axes:
        c.resume(axis)
    run_on(c, c.clock.now + 1000.0)
    assert c.moving() == []
    for axis in c.axes:
        assert all(math.isfinite(c.axes[axis].position(0.25 * k)) for k in range(40))


@settings(max_examples=100, derandomize=True, deadline=None, database=None)
@given(st.lists(STEPS, min_size=2, max_size=20))
def test_the_trace_and_the_log_are_the_track(steps: list[tuple[Any, ...]]) -> None:
    c = machine(3, buffer_size=6, contour_angle=60.0, blend_distance=0.7)
    for step in steps:
        try:
            perform(c, step)
        except Refusal:
            pass
    run_on(c, c.clock.now + 2.0)
    samples = c.trace.sample(97.0, axes=[0, 1, 2])
    for axis in set(c.axes) - {step[1] for step in steps if step[0] == "define_position"}:
        wanted = [c.axes[axis].position(t) for t in samples.time.tolist()]
        assert np.abs(samples.get(axis, "position") - wanted)[:-1].max(initial=0.0) < 1e-6
    for move in c.moves:
        assert move.profile is not None
        assert move.profile.duration >= 0.0
        assert all(phase.duration >= 0.0 for phase in move.profile.phases)
        assert move.profile.peak_speed >= 0.0
