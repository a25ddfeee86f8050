"""The content of a picture of a run, before drawing: panels and curves per axis."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.log.trace import Trace
from motionlang.servo.trace import ServoTrace
from motionlang.views.outline import outline, thinned
from motionlang.views.quantities import UNITS

Array = NDArray[np.float64]

COLOURS = {
    "position": "#1f5fae",
    "velocity": "#0b7a5b",
    "acceleration": "#b4490f",
    "jerk": "#8a3b76",
    "following error": "#b3261e",
    "output": "#6b4fa0",
    "motor": "#e08a1e",
}
# The height of each quantity's panel, relative to the usual one.
HEIGHTS = {
    "position": 1.0,
    "velocity": 1.0,
    "acceleration": 0.8,
    "jerk": 0.7,
    "following error": 0.8,
    "output": 0.8,
}


class Curve(NamedTuple):
    """Times (s) and values; `name` is empty if the panel has only one curve."""

    times: Array
    values: Array
    colour: str
    name: str = ""


class Panel(NamedTuple):
    """One quantity of one axis; the last of the curves is the main one."""

    quantity: str
    unit: str
    curves: tuple[Curve, ...]

    @property
    def peak(self) -> float:
        """The largest absolute value of the last curve."""
        return float(np.abs(self.curves[-1].values).max())


def panels(
    trace: Trace, axis: int, servo: ServoTrace | None = None, span: tuple[float, float] | None = None
) -> list[Panel]:
    """Return the panels of an axis, from top to bottom.

    Jerk is included unless the acceleration changes only in jumps, and servo panels if a motor was simulated. The
    panels cover the whole run, or a `span` of it (s).
    """
    span = span or (0.0, trace.end)
    made = [
        Panel(quantity, unit, (Curve(*outline(trace, axis, quantity, span), COLOURS[quantity]),))
        for quantity, unit in UNITS.items()
    ]
    if not made[-1].peak:
        made.pop()
    if servo is not None and len(servo):
        made[0] = _with_motor(made[0], trace, axis, servo, span)
        made += _servo_panels(trace, axis, servo, span)
    return made


def _with_motor(
    position: Panel, trace: Trace, axis: int, servo: ServoTrace, span: tuple[float, float]
) -> Panel:
    (demand,) = position.curves
    times, values = thinned(servo.time, servo.position, span)
    trace.to_user(axis, "position", values)
    motor = Curve(times, values, COLOURS["motor"], "motor")
    return position._replace(curves=(motor, demand._replace(name="demand")))


def _servo_panels(trace: Trace, axis: int, servo: ServoTrace, span: tuple[float, float]) -> Iterator[Panel]:
    times, error = thinned(servo.time, servo.error, span)
    trace.to_user(axis, "velocity", error)  # a difference of positions: the zero does not apply
    yield Panel("following error", "uu", (Curve(times, error, COLOURS["following error"]),))
    has_dac = servo.loop.dac_bits > 0
    output = servo.dac_steps if has_dac else servo.output
    curve = Curve(*thinned(servo.time, output, span), COLOURS["output"])
    yield Panel("output", "DAC steps" if has_dac else "V", (curve,))
