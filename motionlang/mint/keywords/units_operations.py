"""The factors of positions, speeds and accelerations; settings made before keep their counts."""

from __future__ import annotations

from motionlang.mint.runtime.binding import of, scale_of
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Maker

POSITION, SPEED, ACCELERATION = range(3)


def factor(power: int) -> Maker:
    """What reads one of the factors."""
    return of(Environment, lambda e, axis: float(scale_of(e, axis).factors[power][1]))


def write_position(environment: Environment, axis: int, value: float) -> None:
    """POSSCALEFACTOR, counts; the factors of speeds and accelerations stay."""
    scale = scale_of(environment, axis)
    speed, acceleration = scale.speed, scale.acceleration
    environment.controller.set_scale(axis, value)
    environment.controller.set_units(axis, speed, acceleration)


def write_speed(environment: Environment, axis: int, value: float) -> None:
    """VELSCALEFACTOR, counts in the unit of length of speeds."""
    environment.controller.set_units(axis, value, scale_of(environment, axis).acceleration)


def write_acceleration(environment: Environment, axis: int, value: float) -> None:
    """ACCELSCALEFACTOR, counts in the unit of length of accelerations and jerks."""
    environment.controller.set_units(axis, scale_of(environment, axis).speed, value)


OPERATIONS = {
    "units.position": {"read": factor(POSITION), "write": of(Environment, write_position)},
    "units.speed": {"read": factor(SPEED), "write": of(Environment, write_speed)},
    "units.acceleration": {"read": factor(ACCELERATION), "write": of(Environment, write_acceleration)},
}
