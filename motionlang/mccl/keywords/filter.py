"""Setting up the servo loop. Without a simulated motor the values are kept and reported; motion is ideal."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("servo filter")
_row = _G.row

ROWS = (
    _row("SG", "setting", "W", "axes", "number", "kept_gain", "Set the proportional gain.",
         "1SG0.01", default=0, low=0, tunes="proportional"),
    _row("SI", "setting", "W", "axes", "number", "kept_integral", "Set the integral gain.",
         "1SI0.000001", default=0, low=0, tunes="integral"),
    _row("IL", "setting", "W", "axes", "number", "kept_integral_limit", "Set the limit of the integral term.",
         "1IL1000", default=0, low=0, tunes="integral_limit"),
    _row("SD", "setting", "W", "axes", "number", "kept_derivative", "Set the derivative gain.",
         "1SD0.25", default=0, low=0, tunes="derivative"),
    _row("SE", "setting", "W", "axes", "counts", "kept_error_limit",
         "Set the largest following error; beyond it the motor is switched off. 0 means no check.",
         "1SE2500", default=1024, low=0),
    _row("FR", "setting", "W", "axes", "number", "kept_derivative_period",
         "Set the sampling period of the derivative term.", "1FR3", default=0, low=0, tunes="derivative_every"),
    _row("VG", "setting", "W", "axes", "number", "kept_velocity_gain", "Set the velocity feed-forward gain.",
         "1VG0.5", default=0, tunes="velocity_ff", family="feed-forward"),
    _row("AG", "setting", "W", "axes", "number", "kept_accel_gain", "Set the acceleration feed-forward gain.",
         "1AG0.1", default=0, tunes="accel_ff", family="feed-forward"),
    _row("DG", "setting", "W", "axes", "number", "kept_decel_gain", "Set the deceleration feed-forward gain.",
         "1DG0.1", default=0, tunes="decel_ff", family="feed-forward"),
    _row("DB", "setting", "W", "axes", "uu", "deadband",
         "Set the band round the target in which the axis is at target.",
         "1DB10", default=0, low=0),
    _row("DT", "setting", "W", "axes", "s", "deadband_delay",
         "Set how long the axis must stay in the deadband to be at target.", "1DT0.05", default=0, low=0),
    _row("OB", "setting", "W", "axes", "number", "kept_output_deadband", "Set the deadband of the output, volts.",
         "1OB0.1", default=0, low=0, high=10, tunes="output_deadband", family="output control"),
    _row("OO", "setting", "W", "axes", "number", "kept_output_offset", "Set the offset of the output, volts.",
         "1OO0.05", default=0, low=-10, high=10, tunes="output_offset", family="output control"),
    _row("PH", "setting", "W", "axes", "bool", "output_phase", "Output phase: 0 standard, 1 reversed.",
         "1PH0", default=0, low=0, high=1, tunes="reversed"),
    _row("OM", "setting", "W", "axes", "number", "output_mode",
         "Output mode: 0 bipolar, 1 unipolar, 2 and 3 the same as PWM, 4 piezo, 32768 and 49152 sine without and with "
         "encoder; stepper 0 pulse and direction, 1 CW and CCW. Kept, told as the variable OUTPUTMODE.",
         '1OM2,LU"OUTPUTMODE",1RL@0,TR0', default=0, low=0, high=0xC000),
    _row("IM", "setting", "W", "axes", "bool", "input_mode",
         "Input mode of a stepper: 0 open loop, 1 closed loop. Kept, told as the variable INPUTMODE; a stepper here "
         "loses no steps.", '1IM1,LU"INPUTMODE",1RL@0,TR0', default=0, low=0, high=1),
    _row("ES", "setting", "W", "axes", "number", "encoder_scaling",
         "Encoder counts per step of a closed-loop stepper. Kept, told as the variable ENCODERSCALE.",
         '1ES2.5,LU"ENCODERSCALE",1RV@0,TR0', default=1, low=-1e6, high=1e6),
)  # fmt: skip
