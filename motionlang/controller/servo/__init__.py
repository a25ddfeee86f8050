"""The servo behind the profile: a loop, a motor, and what the motor makes of a demanded track.

`Loop` and its forms say how the error becomes a voltage, `Motor` and `Drive` what the voltage does; `simulate`
runs a whole track, `Servo` the same thing piece by piece. Nothing here is imported by a run without a motor.
"""

from __future__ import annotations

from motionlang.controller.servo.demand import Track
from motionlang.controller.servo.loop import Loop, Override
from motionlang.controller.servo.plant import Drive, Motor
from motionlang.controller.servo.servo import Servo, simulate
from motionlang.controller.servo.trace import ServoTrace

__all__ = ["Drive", "Loop", "Motor", "Override", "Servo", "ServoTrace", "Track", "simulate"]
