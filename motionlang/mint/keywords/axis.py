"""Settings of an axis: scale, speeds, rates, jerks, the profile's shape, enabling."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0
_LONGEST = 2147483647.0

ROWS = (
    Keyword("AXES", "", "command", "C", "axes", "", "default_axes",
            "Which axes a keyword without brackets means, in this task; axis 0 until it is said.",
            "AXES[0, 1]\nSPEED = 10, 20\nPRINT SPEED(1)", group="axis"),
    Keyword("SCALEFACTOR", "SCALE", "setting", "RW", "axis", "number", "scale",
            "Encoder counts per user unit; every distance, speed and rate of the axis is in that unit.",
            "SCALEFACTOR(0) = 1200\nPRINT SCALEFACTOR(0)",
            default=1.0, low=1e-6, high=1e12, group="axis", effect="scale"),
    Keyword("SPEED", "SP", "setting", "RW", "axis", "uu/s", "speed",
            "Slew speed of moves; a change acts at once on the move in progress.",
            "SPEED(0) = 250\nPRINT SPEED(0)", default=40000.0, low=0.0, high=_LARGEST, group="axis", gives="speed"),
    Keyword("ACCEL", "AC", "setting", "RW", "axis", "uu/s2", "accel",
            "Acceleration of moves; replaces an ACCELTIME set before.",
            "ACCEL(0) = 1250\nPRINT ACCEL(0)", default=100000.0, low=0.0, high=1e12, group="axis", gives="accel"),
    Keyword("DECEL", "", "setting", "RW", "axis", "uu/s2", "decel",
            "Deceleration of moves; replaces a DECELTIME set before.",
            "DECEL(0) = 1250\nPRINT DECEL(0)", default=100000.0, low=0.0, high=1e12, group="axis", gives="decel"),
    Keyword("ACCELTIME", "", "setting", "RW", "axis", "ms", "accel_time",
            "Acceleration given as the time from rest to SPEED; replaces ACCEL.",
            "SPEED(0) = 50\nACCELTIME(0) = 200\nPRINT ACCELTIME(0)",
            low=1e-3, high=_LONGEST, group="axis", gives="accel"),
    Keyword("DECELTIME", "", "setting", "RW", "axis", "ms", "decel_time",
            "Deceleration given as the time from SPEED to rest; replaces DECEL.",
            "SPEED(0) = 50\nDECELTIME(0) = 200\nPRINT DECELTIME(0)",
            low=1e-3, high=_LONGEST, group="axis", gives="decel"),
    Keyword("ACCELJERK", "", "setting", "RW", "axis", "uu/s3", "accel_jerk",
            "Rate at which acceleration builds up and falls in an S-ramp.",
            "PROFILEMODE(0) = 1\nACCELJERK(0) = 5000\nPRINT ACCELJERK(0)",
            default=1e6, low=0.0, high=1e15, group="axis", gives="accel jerk"),
    Keyword("DECELJERK", "", "setting", "RW", "axis", "uu/s3", "decel_jerk",
            "Rate at which deceleration builds up and falls in an S-ramp.",
            "PROFILEMODE(0) = 1\nDECELJERK(0) = 5000\nPRINT DECELJERK(0)",
            default=1e6, low=0.0, high=1e15, group="axis", gives="decel jerk"),
    Keyword("PROFILEMODE", "", "setting", "RW", "axis", "integer", "profile_mode",
            "Shape of moves: _pmTRAPEZOIDAL or _pmSRAMP, seven sections with ACCEL as the peak.",
            "PROFILEMODE(0) = _pmSRAMP\nPRINT PROFILEMODE(0)", default=0.0, low=0, high=1, group="axis", gives="shape"),
    Keyword("MOVEBUFFERSIZE", "MB", "setting", "RW", "axis", "integer", "buffer_size",
            "How many moves the buffer of the axis can hold, the one being executed not counted.",
            "MOVEBUFFERSIZE(0) = 10\nPRINT MOVEBUFFERSIZE(0)", default=2.0, low=2, high=100, group="axis"),
    Keyword("DRIVEENABLE", "DE", "setting", "RW", "axis", "bool", "enabled",
            "Whether the drive of the axis is on; a move on a disabled axis is refused.",
            "DRIVEENABLE(0) = _TRUE\nPRINT DRIVEENABLE(0)", default=1.0, low=0, high=1, group="axis", effect="switch"),
)  # fmt: skip
