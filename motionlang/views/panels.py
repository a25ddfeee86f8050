"""The content of a picture of a run, before drawing: panels and curves per axis."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel import Trace
from motionlang.kernel.servo import ServoTrace
from motionlang.views.figure import Curve, Panel
from motionlang.views.formatting import peak_of
from motionlang.views.outline import outline, thinned
from motionlang.views.quantities import COLOURS, UNITS

Array = NDArray[np.float64]

# The usual height of a panel in points, and that of each quantity's panel relative to it.
HEIGHT = 137.0
HEIGHTS = {
    "position": 1.0,
    "velocity": 1.0,
    "acceleration": 0.8,
    "jerk": 0.7,
    "following error": 0.8,
    "output": 0.8,
}


def panels(
    trace: Trace, axis: int, servo: ServoTrace | None = None, span: tuple[float, float] | None = None
) -> list[Panel]:
    """Return the panels of an axis, from top to bottom.

    Jerk is included unless the acceleration changes only in jumps, and servo panels if a motor was simulated. The
    panels cover the whole run, or a `span` of it (s).
    """
    span = span or (0.0, trace.end)
    made = [_panel(name, unit, *outline(trace, axis, name, span)) for name, unit in UNITS.items()]
    if not any(made[-1].curves[0].y):
        made.pop()  # the acceleration changes only in jumps
    if servo is not None and len(servo):
        made[0] = _with_motor(made[0], trace, axis, servo, span)
        made += _servo_panels(trace, axis, servo, span)
    return made


def _panel(quantity: str, unit: str, times: Array, values: Array) -> Panel:
    is_position = quantity == "position"
    return Panel(
        [Curve(times.tolist(), values.tolist(), COLOURS[quantity])],
        label=quantity,
        unit=unit,
        remark="" if is_position else f"peak {peak_of(float(np.abs(values).max()))} {unit}",
        height=HEIGHT * HEIGHTS[quantity],
        has_zero=not is_position,
    )


def _with_motor(
    position: Panel, trace: Trace, axis: int, servo: ServoTrace, span: tuple[float, float]
) -> Panel:
    (demand,) = position.curves
    times, values = thinned(servo.time, servo.position, span)
    trace.to_user(axis, "position", times, values)
    motor = Curve(times.tolist(), values.tolist(), COLOURS["motor"], "motor")
    return replace(position, curves=[motor, replace(demand, name="demand")])


def _servo_panels(trace: Trace, axis: int, servo: ServoTrace, span: tuple[float, float]) -> Iterator[Panel]:
    times, error = thinned(servo.time, servo.error, span)
    trace.to_user(axis, "velocity", times, error)  # a difference of positions: the zero does not apply
    yield _panel("following error", "uu", times, error)
    has_dac = servo.loop.dac_bits > 0
    output = servo.dac_steps if has_dac else servo.output
    yield _panel("output", "DAC steps" if has_dac else "V", *thinned(servo.time, output, span))
