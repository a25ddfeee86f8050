"""The servo behind the profile: a loop, a motor, and what the motor makes of a demanded track.

`Loop` and its forms say how the error becomes a voltage, `Motor` and `Drive` what the voltage does; `simulate`
runs a whole track, `Servo` the same thing as far as a clock has come. Nothing here is imported by a run without a
motor, and NumPy only by what is long enough to need it, or is asked for columns.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.servo.loop import Loop, Override
from motionlang.servo.plant import Drive, Motor

if TYPE_CHECKING:
    from motionlang.servo.demand import Track
    from motionlang.servo.servo import Servo, simulate
    from motionlang.servo.trace import ServoTrace

__all__ = ["Drive", "Loop", "Motor", "Override", "Servo", "ServoTrace", "Track", "simulate"]

# What runs a loop comes when it is asked for: checking the keys of a machine file needs only what describes one.
_HOMES = {"Track": "demand", "Servo": "servo", "simulate": "servo", "ServoTrace": "trace"}


def __getattr__(name: str) -> object:
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(f"{__name__}.{home}"), name)
