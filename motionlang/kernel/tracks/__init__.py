"""Readers of the tracks of the axes: trace and motors."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lazy import lazy_names

if TYPE_CHECKING:
    from motionlang.kernel.tracks.axes import axes_of as axes_of
    from motionlang.kernel.tracks.history import chunks as chunks
    from motionlang.kernel.tracks.history import recall as recall
    from motionlang.kernel.tracks.history import servo_trace as servo_trace
    from motionlang.kernel.tracks.history import servo_traces as servo_traces
    from motionlang.kernel.tracks.trace import MOTOR as MOTOR
    from motionlang.kernel.tracks.trace import UNITS as UNITS
    from motionlang.kernel.tracks.trace import Array as Array
    from motionlang.kernel.tracks.trace import Samples as Samples
    from motionlang.kernel.tracks.trace import TraceColumn as TraceColumn
    from motionlang.kernel.tracks.trace import quantity_of as quantity_of
    from motionlang.kernel.tracks.trace import units_at as units_at

PUBLIC = {
    "trace": "Samples TraceColumn Array UNITS MOTOR quantity_of units_at",
    "axes": "axes_of",
    "history": "recall chunks servo_trace servo_traces",
}

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)
