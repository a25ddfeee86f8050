"""Stepper channels: the pulses generated from the demand of an axis."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.sensing import (
    Encoders,
    read_setting,
    read_speed,
    write_encoder,
    write_setting,
)
from motionlang.kernel.mint.runtime.binding import axis_of, of, of_word
from motionlang.kernel.mint.runtime.changes import moving


class Steppers(Encoders):
    """The pulse counters of the axes.

    Channel n counts the demand of axis n, independently of its motor.
    """

    def checked(self, channel: int) -> int:
        return axis_of(self._environment, channel)

    def counts(self, channel: int) -> float:
        return self._controller.demand(channel) - self._controller.axes[channel].datum

    def velocity(self, channel: int) -> float:
        return self._controller.demand_velocity(channel)


def read_count(steppers: Steppers, channel: int) -> float:
    return steppers.read(steppers.checked(channel))


# ------------------------------------------------------------------------------------------------- keywords

_SETTING = Actions(read=of_word(Steppers, read_setting), write=of_word(Steppers, write_setting))

_MOVE = "MOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\nPRINT {}(0)"


ROWS = (
    Keyword("STEPPER", "", "reading", "RW", "channel", "uu",
            Actions(read=moving(of(Steppers, read_count)), write=of(Steppers, write_encoder)),
            "Pulses that a stepper channel has sent, in units of STEPPERSCALE; POS = 0 does not change it.",
            _MOVE.format("STEPPER"), default=0.0, low=-8388607.0, high=8388607.0, group="encoders"),
    Keyword("STEPPERVEL", "", "reading", "R", "channel", "uu/s", Actions(read=moving(of(Steppers, read_speed))),
            "Pulses a second of a stepper channel, in units of STEPPERSCALE.",
            "JOG(0) = 100\nWAIT = 500\nPRINT STEPPERVEL(0)\nCANCEL(0)", default=0.0, group="encoders"),
    Keyword("STEPPERSCALE", "", "setting", "RW", "channel", "number", _SETTING,
            "Pulses in one unit of STEPPER.", "STEPPERSCALE(0) = 4\nPRINT STEPPERSCALE(0)", default=1.0, low=1e-9,
            high=8388607.0, group="encoders"),
    Keyword("STEPPERWRAP", "", "setting", "RW", "channel", "number", _SETTING,
            "Value at which STEPPER wraps to 0; 0: it never does.", "STEPPERWRAP(0) = 360\nPRINT STEPPERWRAP(0)",
            default=0.0, low=0.0, high=8388607.0, group="encoders"),
)  # fmt: skip
