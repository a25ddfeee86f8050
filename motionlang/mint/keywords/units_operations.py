"""The factors of positions, speeds and accelerations; settings made before keep their counts."""

from __future__ import annotations

from motionlang.mint.runtime.binding import scale_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment

POSITION, SPEED, ACCELERATION = range(3)


def _read(environment: Environment, power: int) -> Operation:
    return lambda axis: float(scale_of(environment, axis).factors[power][1])


def read_position(environment: Environment, row: Row) -> Operation:
    return _read(environment, POSITION)


def read_speed(environment: Environment, row: Row) -> Operation:
    return _read(environment, SPEED)


def read_acceleration(environment: Environment, row: Row) -> Operation:
    return _read(environment, ACCELERATION)


def write_position(environment: Environment, row: Row) -> Operation:
    """POSSCALEFACTOR, counts; the factors of speeds and accelerations stay."""

    def write(axis: int, value: float) -> None:
        scale = scale_of(environment, axis)
        speed, acceleration = scale.speed, scale.acceleration
        environment.controller.set_scale(axis, value)
        environment.controller.set_units(axis, speed, acceleration)

    return write


def write_speed(environment: Environment, row: Row) -> Operation:
    """VELSCALEFACTOR, counts in the unit of length of speeds."""

    def write(axis: int, value: float) -> None:
        scale = scale_of(environment, axis)
        environment.controller.set_units(axis, value, scale.acceleration)

    return write


def write_acceleration(environment: Environment, row: Row) -> Operation:
    """ACCELSCALEFACTOR, counts in the unit of length of accelerations and jerks."""

    def write(axis: int, value: float) -> None:
        scale = scale_of(environment, axis)
        environment.controller.set_units(axis, scale.speed, value)

    return write


OPERATIONS = {
    "units.position": {"read": read_position, "write": write_position},
    "units.speed": {"read": read_speed, "write": write_speed},
    "units.acceleration": {"read": read_acceleration, "write": write_acceleration},
}
