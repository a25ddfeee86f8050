"""The log of a run, and the motion that is read from it: streams, tracks, trace, figures."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lazy import lazy_names

if TYPE_CHECKING:
    from motionlang.kernel.log.history import chunks as chunks
    from motionlang.kernel.log.history import servo_trace as servo_trace
    from motionlang.kernel.log.history import servo_traces as servo_traces
    from motionlang.kernel.log.log import Log as Log
    from motionlang.kernel.log.records import GRAVE as GRAVE
    from motionlang.kernel.log.records import Changed as Changed
    from motionlang.kernel.log.records import Event as Event
    from motionlang.kernel.log.records import Switched as Switched
    from motionlang.kernel.log.records import Waited as Waited
    from motionlang.kernel.log.stream import Store as Store
    from motionlang.kernel.log.stream import Stream as Stream
    from motionlang.kernel.log.trace import MOTOR as MOTOR
    from motionlang.kernel.log.trace import UNITS as UNITS
    from motionlang.kernel.log.trace import Array as Array
    from motionlang.kernel.log.trace import Column as Column
    from motionlang.kernel.log.trace import Samples as Samples
    from motionlang.kernel.log.trace import quantity_of as quantity_of
    from motionlang.kernel.log.track import Recorded as Recorded
    from motionlang.kernel.log.track import axes_of as axes_of

PUBLIC = {
    "trace": "Samples Column Array UNITS MOTOR quantity_of",
    "track": "Recorded axes_of",
    "history": "chunks servo_trace servo_traces",
    "log": "Log",
    "records": "Event Waited Switched Changed GRAVE",
    "stream": "Stream Store",
}

if not TYPE_CHECKING:
    __getattr__ = lazy_names(__name__, PUBLIC)
