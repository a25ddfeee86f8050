"""The servo behind the profile: a loop, a motor, and what the motor makes of a demanded track.

`Loop` and its forms say how the error becomes a voltage, `Motor` and `Drive` what the voltage does; `simulate`
runs a whole track, `Servo` the same thing as far as a clock has come. Nothing here is imported by a run without a
motor, and NumPy only by what is long enough to need it, or is asked for columns.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.controller.servo.demand import Track
from motionlang.controller.servo.loop import Loop, Override
from motionlang.controller.servo.plant import Drive, Motor
from motionlang.controller.servo.servo import Servo, simulate

if TYPE_CHECKING:
    from motionlang.controller.servo.trace import ServoTrace

__all__ = ["Drive", "Loop", "Motor", "Override", "Servo", "ServoTrace", "Track", "simulate"]


def __getattr__(name: str) -> object:
    if name != "ServoTrace":
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from motionlang.controller.servo.trace import ServoTrace

    return ServoTrace
