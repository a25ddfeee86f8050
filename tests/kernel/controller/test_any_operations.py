"""Any verbs in any order: no position jumps, time advances, only Rejected rises."""

from __future__ import annotations

import math
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.kernel import Controller, Rejected, Trace
from tests.cases import examples
from tests.kernel.controller.machines import machine
from tests.kernel.controller.motions import RECORDED, SHAPES, differences, lines, perform, run_on, steps_of

SEEDS = st.integers(0, 2**32)


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


def test_motion_has_the_figures_that_were_recorded(request: pytest.FixtureRequest) -> None:
    now = list(lines(range(45)))
    if request.config.getoption("--update"):
        RECORDED.write_text("\n".join([*now, ""]), encoding="utf-8")
    assert list(differences(now, RECORDED.read_text(encoding="utf-8").splitlines())) == []


def test_a_figure_differs_by_more_than_rounding() -> None:
    assert list(differences(["a 1.0 x"], ["a 1.0000000001 x"])) == []
    assert list(differences(["a 1.0", " 0 2"], ["a 1.0", " 0 3"])) == ["a:\n   0 2\n   0 3"]
    assert list(differences(["a x"], ["a y z", "b"])) == ["a:\n  a x\n  a y z", "a:\n  \n  b"]
