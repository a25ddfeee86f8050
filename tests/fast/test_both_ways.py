"""An axis with a linear motor: the closed form agrees with plain steps."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import motionlang
from motionlang.controller.controller import Controller
from motionlang.controller.faults import FOLLOWING_ERROR, Rejected
from motionlang.controller.feedback import Feedback
from motionlang.fast.closed_form import ClosedFormServo
from motionlang.servo.speculative import SpeculativeServo
from motionlang.source import Source
from tests.cases import examples

if TYPE_CHECKING:
    Act = Callable[[Controller], object]
    Reading = tuple[float, ...]

PLANTS: tuple[dict[str, object], ...] = (
    {"load_inertia": 4e-5, "viscous": 2e-5},
    {"load_inertia": 4e-5, "load_torque": 0.01},
    {"load_inertia": 4e-5, "resonance": 150.0, "resonance_damping": 0.3},
    {"kind": "drive", "speed_per_volt": 5000.0, "time_constant": 4e-3},
)
SECTIONS: tuple[dict[str, object], ...] = (
    {"proportional": 0.02, "integral": 2e-5, "derivative": 0.5},
    {"proportional": 0.008, "derivative": 0.15, "output_limit": 1.5},
    {"bandwidth": 20.0, "servo_rate": 4000.0, "trajectory_rate": 1000.0},
    {"bandwidth": 30.0},
)
# Seconds: many of them are a sample or less.
PAUSES = st.one_of(st.sampled_from([2e-4, 1e-3, 1.3e-3, 0.007]), st.floats(0.0, 0.4))
FASTER = {"proportional": (2.0, "KPROP"), "derivative": (60.0, "KDERIV"), "velocity_ff": (0.1, "KVELFF")}


def _tune(controller: Controller) -> None:
    feedback = controller.axes[0].feedback
    assert feedback is not None
    feedback.tune(FASTER)


ACTS: dict[str, Act] = {
    "far": lambda c: c.move_to(0, 4000.0),
    "near": lambda c: c.move_by(0, -35.0),
    "back": lambda c: c.move_to(0, -700.0),
    "jog": lambda c: c.jog(0, 3000.0),
    "stop": lambda c: c.stop(0),
    "abort": lambda c: c.abort(0),
    "rename": lambda c: c.define_position(0, 100.0),
    "off": lambda c: c.disable(0),
    "on": lambda c: c.enable(0),
    "torque": lambda c: c.open_loop(0, 0.7),
    "tune": _tune,
    "wait": lambda c: None,
}


def responses(
    plant: dict[str, object],
    section: dict[str, object],
    limit: float,
    acts: list[tuple[str, float]],
    servo: Callable[..., SpeculativeServo],
) -> tuple[list[Reading], list[float]]:
    """Return the readings after each pause, and the times of error limit violations."""
    controller, trips = Controller(1), list[float]()
    a, clock = controller.axes[0], controller.clock
    a.feedback = feedback = Feedback(a, clock, plant, section, servo)

    def trip() -> None:
        trips.append(clock.now)
        a.faults |= FOLLOWING_ERROR

    feedback.tripped = trip
    feedback.set_error_limit(limit)
    seen: list[Reading] = []
    for name, pause in acts:
        try:
            ACTS[name](controller)
        except Rejected:
            pass  # a jog of a disabled axis
        clock.advance(clock.now + pause)
        seen.append((controller.position(0), controller.velocity(0), feedback.error, feedback.output))
    return seen, trips


@given(
    plant=st.sampled_from(PLANTS),
    section=st.sampled_from(SECTIONS),
    limit=st.sampled_from([3.0, 40.0, float("inf")]),
    acts=st.lists(st.tuples(st.sampled_from(sorted(ACTS)), PAUSES), min_size=1, max_size=14),
)
# A cleared fault trips again at the next sample, and one of the last sample of a block is not passed over.
@example(plant=PLANTS[0], section=SECTIONS[0], limit=3.0, acts=[("far", 0.25), ("on", 0.25)])
@example(
    plant=PLANTS[0],
    section=SECTIONS[2],
    limit=3.0,
    acts=[
        ("wait", 0.0013),
        ("torque", 2e-4),
        ("tune", 1e-3),
        ("abort", 2e-4),
        ("abort", 2e-4),
        ("far", 0.25),
    ],
)
@settings(max_examples=examples(60))
def test_values_are_equal_and_trips_occur_at_the_same_sample(
    plant: dict[str, object], section: dict[str, object], limit: float, acts: list[tuple[str, float]]
) -> None:
    """Values agree to a ten-millionth of a count, of a count/s and of a volt."""
    seen, trips = responses(plant, section, limit, acts, ClosedFormServo)
    stepped, plain_trips = responses(plant, section, limit, acts, SpeculativeServo)
    for one, other in zip(seen, stepped, strict=True):
        assert one == pytest.approx(other, rel=1e-7, abs=1e-7)
    assert trips == plain_trips


def test_program_waits_as_long_with_both(monkeypatch: pytest.MonkeyPatch) -> None:
    """Positions, windows and limits are detected at their samples, not at block ends."""
    text = """
SCALE(0) = 100 : SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
FOLERRORFATAL(0) = 1.2 : IDLEMODE(0) = 1 : IDLEPOS(0) = 0.002 : IDLETIME(0) = 5
MOVER(0) = 20 : GO(0)
PAUSE POS(0) > 7.5
PRINT TIME : PAUSE VEL(0) < 50
PRINT TIME : PAUSE IDLE(0)
PRINT TIME : JOG(0) = 300
PAUSE AXISERROR(0)
PRINT TIME
"""
    machine = {
        "axis.0.plant.load_inertia": 4e-5,
        "axis.0.servo.proportional": 0.008,
        "axis.0.servo.derivative": 0.15,
    }

    def printed(fast: bool) -> list[str]:
        source = Source("x", text)
        return motionlang.run(source, dialect="mint", machine=machine, cache=False, fast=fast).output

    seen = printed(True)
    assert len(seen) == 4
    assert printed(False) == seen
