"""Accelerators: faster replacements of engine components, with equal results.

The results are the same bytes, but for `closed_form.py`: a linear motor's are equal to 1e-9.

`motionlang.execution` reads the switch and passes them to a machine; nothing else imports this package. The
head of each module states what it replaces, its hook, its gain and the test that checks equality.
"""

from __future__ import annotations

from motionlang.controller.accelerators import Accelerators
from motionlang.fast.time_slices import TimeSlices

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def everything() -> Accelerators:
    """Return all accelerators; those that few programs need are imported on first use."""
    return Accelerators(
        axes=_axes,
        counted=_counted,
        ranges=_ranges,
        scheduler=TimeSlices,
        servo=_servo,
        switches=_switches,
    )


def _counted(*given: Any) -> float:
    from motionlang.fast.loop_counters import counted

    return counted(*given)


def _axes(numbers: Any) -> Any:
    from motionlang.fast.moves import FastAxis

    return [FastAxis(number) for number in numbers]


def _ranges(function: Any) -> Any:
    from motionlang.fast.ranges import ranges

    return ranges(function)


def _servo(*given: Any, **columns: Any) -> Any:
    from motionlang.fast.closed_form import ClosedFormServo

    return ClosedFormServo(*given, **columns)


def _switches(environment: Any) -> Any:
    from motionlang.fast.loop_switches import LoopSwitches

    return LoopSwitches(environment)
