"""Stepper channels: the pulses that the demand of an axis has been made of."""

from __future__ import annotations

from motionlang.mint.keywords.sensing_operations import (
    Encoders,
    read_setting,
    read_speed,
    write_encoder,
    write_setting,
)
from motionlang.mint.runtime.binding import axis_of, of, of_word
from motionlang.mint.runtime.changes import moving


class Steppers(Encoders):
    """The pulse counters of the axes: channel n counts what axis n is told to do, whatever its motor makes of it."""

    def checked(self, channel: int) -> int:
        return axis_of(self._environment, channel)

    def counts(self, channel: int) -> float:
        return self._controller.demand(channel) - self._controller.axes[channel].datum

    def velocity(self, channel: int) -> float:
        return self._controller.demand_velocity(channel)


def read_count(steppers: Steppers, channel: int) -> float:
    return steppers.read(steppers.checked(channel))


OPERATIONS = {
    "steppers.count": {"read": moving(of(Steppers, read_count)), "write": of(Steppers, write_encoder)},
    "steppers.speed": {"read": moving(of(Steppers, read_speed))},
    "steppers.setting": {"read": of_word(Steppers, read_setting), "write": of_word(Steppers, write_setting)},
}
