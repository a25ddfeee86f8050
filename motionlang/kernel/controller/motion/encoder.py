"""Encoder channels driven from outside: a conveyor, a hand wheel, a printing web."""

from __future__ import annotations

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.events import BY_DESIGN
from motionlang.kernel.controller.queue.track import extend_track
from motionlang.kernel.errors import Rejected
from motionlang.kernel.planners import hold, plan_velocity
from motionlang.kernel.planners.stop import running

# Auxiliary encoders have the channels from here on.
AUXILIARY = 1000


def turn(encoder: Axis, velocity: float, accel: float) -> None:
    """Run an encoder at `velocity`, counts/s, with a ramp at `accel`; 0 means no ramp."""
    if not (abs(velocity) < 1e300 and 0.0 <= accel < 1e300):
        raise Rejected(
            "range", f"an encoder cannot run at {velocity:.10g} counts/s with a ramp of {accel:.10g}"
        )
    state = encoder.at(encoder.clock.now)
    if state.velocity == velocity == encoder.profiles[-1].end_velocity and not state.acceleration:
        return
    if accel:
        profile = plan_velocity("trapezoid", state.position, state.velocity, velocity, accel, accel)
    else:
        profile = running(state.position, velocity) if velocity else hold(state.position)
    extend_track(encoder, profile, BY_DESIGN)
