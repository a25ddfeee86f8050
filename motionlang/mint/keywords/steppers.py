"""The pulses of stepper channels."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_MOVE = "MOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\nPRINT {}(0)"
# The readings have units of an axis, as they change while it moves and nothing else happens.
ROWS = (
    Keyword("STEPPER", "", "reading", "RW", "channel", "uu", "steppers.count",
            "Pulses that a stepper channel has given out, in units of STEPPERSCALE; POS = 0 does not change it.",
            _MOVE.format("STEPPER"), default=0.0, low=-8388607.0, high=8388607.0, group="encoders"),
    Keyword("STEPPERVEL", "", "reading", "R", "channel", "uu/s", "steppers.speed",
            "Pulses a second of a stepper channel, in units of STEPPERSCALE.",
            "JOG(0) = 100\nWAIT = 500\nPRINT STEPPERVEL(0)\nCANCEL(0)", default=0.0, group="encoders"),
    Keyword("STEPPERSCALE", "", "setting", "RW", "channel", "number", "steppers.setting",
            "Pulses in one unit of STEPPER.", "STEPPERSCALE(0) = 4\nPRINT STEPPERSCALE(0)", default=1.0, low=1e-9,
            high=8388607.0, group="encoders"),
    Keyword("STEPPERWRAP", "", "setting", "RW", "channel", "number", "steppers.setting",
            "Where STEPPER begins again at 0; 0: it never does.", "STEPPERWRAP(0) = 360\nPRINT STEPPERWRAP(0)",
            default=0.0, low=0.0, high=8388607.0, group="encoders"),
)  # fmt: skip
