"""The scale factors of positions, speeds and accelerations.

Settings made before a change of a factor keep their counts.
"""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import Maker, of, scale_of
from motionlang.kernel.mint.runtime.environment import Environment

POSITION, SPEED, ACCELERATION = range(3)


def factor(power: int) -> Maker:
    """Make an operation that reads one of the scale factors."""
    return of(Environment, lambda e, axis: float(scale_of(e, axis).factors[power][1]))


def write_position(environment: Environment, axis: int, value: float) -> None:
    """POSSCALEFACTOR: set the counts per user unit of positions only.

    The factors of speeds and accelerations do not change.
    """
    scale = scale_of(environment, axis)
    speed, acceleration = scale.speed, scale.acceleration
    environment.controller.set_scale(axis, value)
    environment.controller.set_units(axis, speed, acceleration)


def write_speed(environment: Environment, axis: int, value: float) -> None:
    """VELSCALEFACTOR: set the counts per length unit of speeds."""
    environment.controller.set_units(axis, value, scale_of(environment, axis).acceleration)


def write_acceleration(environment: Environment, axis: int, value: float) -> None:
    """ACCELSCALEFACTOR: set the counts per length unit of accelerations and jerks."""
    environment.controller.set_units(axis, scale_of(environment, axis).speed, value)


# ------------------------------------------------------------------------------------------------- keywords

_RPM = "POSSCALEFACTOR(0) = 4000\nVELSCALEFACTOR(0) = 4000 / 60\nACCELSCALEFACTOR(0) = 4000\nPRINT {}(0)"


def _factor(name: str, actions: Actions, help: str, effect: str = "") -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "number", actions, help, _RPM.format(name), default=1.0,
                   low=1e-6, high=1e12, group="axis", effect=effect)  # fmt: skip


ROWS = (
    _factor("POSSCALEFACTOR", Actions(read=factor(POSITION), write=of(Environment, write_position)),
            "Counts per user unit of positions and distances. SCALEFACTOR writes it too.", "scale"),
    _factor("VELSCALEFACTOR", Actions(read=factor(SPEED), write=of(Environment, write_speed)),
            "Counts a second per user unit of speed: 4000 / 60 makes revolutions per minute at 4000 counts per "
            "revolution. Follows POSSCALEFACTOR until it is set, and again from SCALEFACTOR on."),
    _factor("ACCELSCALEFACTOR", Actions(read=factor(ACCELERATION), write=of(Environment, write_acceleration)),
            "Counts a second² per user unit of acceleration, and likewise of jerk. Follows POSSCALEFACTOR until it "
            "is set, and again from SCALEFACTOR on."),
)  # fmt: skip
