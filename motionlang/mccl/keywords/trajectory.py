"""Setting up the trajectory."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("trajectory")
_row = _G.row

ROWS = (
    _row("SA", "setting", "W", "axes", "uu/s2", "accel", "Set the acceleration.",
         "1SA100000", default=100000, low=0, meant="ACCEL"),
    _row("DS", "setting", "W", "axes", "uu/s2", "decel", "Set the deceleration.", "1DS100000", default=100000, low=0,
         meant="DECEL", family="deceleration"),
    _row("SV", "setting", "W", "axes", "uu/s", "speed",
         "Set the velocity of moves; in velocity mode a running axis changes to it at once.",
         "1SV40000", default=40000, low=0, meant="SPEED VEL"),
    _row("MV", "setting", "W", "axes", "uu/s", "minimum_speed",
         "Set the minimum velocity, at which a stepper starts and stops at once: trapezoidal moves begin and end with "
         "it; 0 for none.", "1MN,1MV1000,1MR5000,1WS,1TP", default=0, low=0),
    _row("VO", "setting", "W", "axes", "number", "override",
         "Velocity override of contour paths: the vector velocity is multiplied by it.",
         "1VO0.5", default=1, low=0, high=10, family="contours"),
    _row("PT", "setting", "C", "axes", "", "shape_trapezoid",
         "Trapezoidal profile: constant acceleration, the fastest to velocity.", "1PT"),
    _row("PS", "setting", "W", "axes", "number", "shape_scurve",
         "S-curve: without a number the sinusoidal one; with n between 0 and 0.5 the trapezoidal one, whose "
         "acceleration rises over the part n of the acceleration time.",
         "1PS0.1", default=0, low=0, high=0.5, family="profiles"),
    _row("PP", "setting", "C", "axes", "", "shape_parabolic",
         "Parabolic profile: the acceleration falls linearly from its peak to zero.", "1PP", family="profiles"),
    _row("SQ", "setting", "W", "axes", "number", "kept_torque",
         "Set the torque limit, the largest output in volts; kept and told as it is written, though no output exceeds "
         "10.",
         "1SQ3.5,1TQ", default=10, low=0, tunes="output_limit"),
    _row("VV", "setting", "W", "axis", "uu/s", "vector_velocity",
         "Vector velocity of contour paths, on the controlling axis.", "1VV20000", default=40000, low=0,
         family="contours"),
    _row("VA", "setting", "W", "axis", "uu/s2", "vector_accel",
         "Vector acceleration of contour paths, on the controlling axis.", "1VA100000", default=100000, low=0,
         family="contours"),
    _row("VD", "setting", "W", "axis", "uu/s2", "vector_decel",
         "Vector deceleration of contour paths, on the controlling axis.", "1VD100000", default=100000, low=0,
         family="contours"),
    _row("HS", "setting", "C", "axes", "", "high_rate",
         "High speed: the servo loop of a simulated motor runs at 4 kHz; profiles are exact and have no rate.", "1HS",
         family="rates"),
    _row("MS", "setting", "C", "axes", "", "medium_rate",
         "Medium speed: the servo loop of a simulated motor runs at 2 kHz.", "1MS", family="rates"),
    _row("LS", "setting", "C", "axes", "", "low_rate",
         "Low speed: the servo loop of a simulated motor runs at 1 kHz.", "1LS", family="rates"),
    _row("FC", "setting", "C", "axes", "", "full_current",
         "Full motor current (stepper): kept, told as the variable CURRENT.", '1FC,LU"CURRENT",1RV@0,TR0'),
    _row("HC", "setting", "C", "axes", "", "half_current",
         "Half motor current (stepper): kept, told as the variable CURRENT.", '1HC,LU"CURRENT",1RV@0,TR0'),
    _row("FS", "setting", "C", "axes", "", "full_step", "Full steps (stepper); shows in the status.", "1FS"),
    _row("SH", "setting", "C", "axes", "", "half_step", "Half steps (stepper); shows in the status.", "1SH"),
    _row("BD", "setting", "W", "axes", "uu", "backlash_distance",
         "Set half the backlash: how far the motor goes ahead of the load from BN on.", "1BD10", default=0, low=0),
    _row("BN", "command", "C", "axes", "", "backlash_on",
         "Compensate backlash, from the middle of it: TT tells the target of the load, TP where the motor is.",
         "1MN,1BD10,1BN,1MR500,1WS,1TP"),
    _row("BF", "command", "C", "axes", "", "backlash_off", "Compensate backlash no longer.", "1BF"),
)  # fmt: skip
