"""The servo loop of an axis: its gains, its time, its following-error limit, and torque without a loop.

They act on the motor that the machine file simulates. Without one they are kept and read back, and the report says
that they had no effect.
"""

from __future__ import annotations

from motionlang.lang.keyword import Keyword
from motionlang.mint.keywords.defaults import FATAL_ERROR, GAINS, LOOP_TIME


def _gain(name: str, short: str, tunes: str, help: str, high: float, unit: str = "number") -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, f"servo.gain.{tunes}", help,
                   f"{name}(0) = 2\nPRINT {name}(0)", default=GAINS[tunes], low=0.0, high=high, group="servo",
                   tunes=tunes)  # fmt: skip


ROWS = (
    _gain("KPROP", "kp", "proportional",
          "Proportional gain: DAC steps (2048 for 10 V) for each count of following error.", 1e9),
    _gain("KINT", "ki", "integral",
          "Integral gain: DAC steps for each count of following error summed over servo loops.", 1e9),
    _gain("KINTLIMIT", "kil", "integral_limit",
          "The most that the integral contributes, percent of full scale.", 100.0),
    _gain("KINTMODE", "kim", "integral_mode",
          "When the integral acts: 0 never, 1 always, 2 at steady or zero demanded speed, 3 at zero demanded speed.",
          3.0, "integer"),
    _gain("KDERIV", "kd", "derivative",
          "Derivative gain: DAC steps for each count by which the error changes in a servo loop.", 1e9),
    _gain("KVEL", "", "velocity_feedback",
          "Velocity feedback: DAC steps for each count that the motor moves in a servo loop.", 1e9),
    _gain("KVELFF", "", "velocity_ff",
          "Velocity feed-forward: DAC steps for each count of demanded motion in a servo loop.", 1e9),
    _gain("KACCEL", "", "accel_ff",
          "Acceleration feed-forward: DAC steps for each count by which that changes in a servo loop.",
          1e9),
    Keyword("LOOPTIME", "lt", "setting", "RW", "none", "integer", "servo.loop_time",
            "The time of one servo loop in microseconds; it can be set until the first motion.",
            "LOOPTIME = 500\nPRINT LOOPTIME", default=LOOP_TIME, low=50.0, high=100000.0, group="servo",
            tunes="period"),
    Keyword("FOLERRORFATAL", "", "setting", "RW", "axis", "uu", "servo.fatal_error",
            "The following error beyond which the axis does what FOLERRORMODE says.",
            "FOLERRORFATAL(0) = 2\nPRINT FOLERRORFATAL(0)", default=FATAL_ERROR, low=0.0, high=8388607.0,
            group="servo"),
    Keyword("TORQUE", "", "setting", "RW", "axis", "%", "servo.torque",
            "Give the motor a constant output, percent of full scale, in place of its servo loop, until CANCEL, STOP, "
            "RESET or a move closes the loop again. It needs a simulated motor.",
            "PRINT TORQUE(0)", default=0.0, low=-100.0, high=100.0, group="servo", effect="act"),
)  # fmt: skip
