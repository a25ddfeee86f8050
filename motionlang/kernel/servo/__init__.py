"""The servo behind the profile: control loops, motors, and their simulation.

`Loop` and its forms define how the error becomes a voltage, `Motor` and `Drive` the effect of the voltage.
`simulate` runs a complete track, `Servo` runs it up to a clock's time. A run without a motor imports nothing
of this package; NumPy is imported only for columns.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.servo.loop import Loop, Override
from motionlang.kernel.servo.plant import Drive, Motor

if TYPE_CHECKING:
    from motionlang.kernel.servo.demand import Track
    from motionlang.kernel.servo.servo import Servo, simulate
    from motionlang.kernel.servo.trace import ServoTrace

__all__ = ["Drive", "Loop", "Motor", "Override", "Servo", "ServoTrace", "Track", "simulate"]

# The modules that run a loop are imported on first use: checking the keys of a machine file needs only those
# that describe one.
_HOMES = {"Track": "demand", "Servo": "servo", "simulate": "servo", "ServoTrace": "trace"}


def __getattr__(name: str) -> object:
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{home}"), name)
