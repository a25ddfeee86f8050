"""The factors of positions, speeds and accelerations; settings made before keep their counts."""

from __future__ import annotations

from motionlang.mint.runtime.binding import scale_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

POSITION, SPEED, ACCELERATION = range(3)


def _read(environment: Environment, power: int) -> Operation:
    return lambda axis: float(scale_of(environment, axis).per_unit(power))


def read_position(environment: Environment, row: Row) -> Operation:
    return _read(environment, POSITION)


def read_speed(environment: Environment, row: Row) -> Operation:
    return _read(environment, SPEED)


def read_acceleration(environment: Environment, row: Row) -> Operation:
    return _read(environment, ACCELERATION)


def write_position(environment: Environment, row: Row) -> Operation:
    """POSSCALEFACTOR, counts; the factors of speeds and accelerations stay."""

    def write(axis: int, value: float) -> None:
        row.check(value)
        scale = scale_of(environment, axis)
        speed, acceleration = scale.speed, scale.acceleration
        environment.controller.set_scale(axis, value)
        scale.speed, scale.acceleration = speed, acceleration

    return write


def write_speed(environment: Environment, row: Row) -> Operation:
    def write(axis: int, value: float) -> None:
        row.check(value)
        scale_of(environment, axis).speed = value

    return write


def write_acceleration(environment: Environment, row: Row) -> Operation:
    def write(axis: int, value: float) -> None:
        row.check(value)
        scale_of(environment, axis).acceleration = value

    return write


OPERATIONS = {
    "units.position": {"read": read_position, "write": write_position},
    "units.speed": {"read": read_speed, "write": write_speed},
    "units.acceleration": {"read": read_acceleration, "write": write_acceleration},
}
