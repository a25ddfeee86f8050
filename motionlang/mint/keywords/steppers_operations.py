"""Stepper channels: the pulses that the demand of an axis has been made of."""

from __future__ import annotations

from motionlang.mint.keywords.sensing_operations import Encoders
from motionlang.mint.runtime.binding import axis_of
from motionlang.mint.runtime.changes import moving

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]


class Steppers(Encoders):
    """The pulse counters of the axes: channel n counts what axis n is told to do, whatever its motor makes of it."""

    def counts(self, channel: int) -> float:
        return self._controller.demand(channel) - self._controller.axes[channel].datum

    def velocity(self, channel: int) -> float:
        return self._controller.demand_velocity(channel)


# ----------------------------------------------------------------------------------------------- operations


@moving
def read_count(environment: Environment, row: Row) -> Operation:
    steppers = environment.part(Steppers)
    return lambda channel: steppers.read(axis_of(environment, channel))


def write_count(environment: Environment, row: Row) -> Operation:
    """STEPPER: the pulses read as so many user units from now on."""
    steppers = environment.part(Steppers)

    def write(channel: int, value: float) -> None:
        row.check(value)
        steppers.write(axis_of(environment, channel), value)

    return write


@moving
def read_speed(environment: Environment, row: Row) -> Operation:
    steppers = environment.part(Steppers)
    return lambda channel: steppers.speed(axis_of(environment, channel))


def _name(row: Row) -> str:
    return row.name.replace("STEPPER", "ENCODER")


def read_setting(environment: Environment, row: Row) -> Operation:
    steppers, name = environment.part(Steppers), _name(row)
    return lambda channel: steppers.setting(name, axis_of(environment, channel))


def write_setting(environment: Environment, row: Row) -> Operation:
    """STEPPERSCALE and STEPPERWRAP."""
    steppers, name = environment.part(Steppers), _name(row)

    def write(channel: int, value: float) -> None:
        row.check(value)
        steppers.set(name, axis_of(environment, channel), value)

    return write


OPERATIONS = {
    "steppers.count": {"read": read_count, "write": write_count},
    "steppers.speed": {"read": read_speed},
    "steppers.setting": {"read": read_setting, "write": write_setting},
}
