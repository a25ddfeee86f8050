"""Turns of wrapped positions, and the motion words of older controllers."""

from __future__ import annotations

from math import floor

from motionlang.controller.moves import buffer
from motionlang.mint.keywords.homing_operations import write_home
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import moving

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

NEGATIVE_INDEX = 4


def _turns(environment: Environment, counts: Callable[[int], float]) -> Operation:
    """The number of turns of a position in counts; where that has no end, of the axis as it stands."""

    def read(axis: int) -> int:
        scale, wrap = scale_of(environment, axis), environment.wraps.get(axis)
        if not wrap:
            return 0
        place = counts(axis)
        if not abs(place) < 1e300:
            place = environment.controller.position(axis)
        return floor(scale.position_to_user(place) / wrap + 1e-12)

    return read


@moving
def read_demand(environment: Environment, row: Row) -> Operation:
    controller = environment.controller
    return _turns(environment, controller.demand)


@moving
def read_target(environment: Environment, row: Row) -> Operation:
    return _turns(environment, environment.controller.target)


@moving
def read_last_target(environment: Environment, row: Row) -> Operation:
    axes = environment.controller.axes
    return _turns(environment, lambda axis: buffer.end(axes[axis]))


def do_datum(environment: Environment, row: Row) -> Operation:
    """DATUM: HOME of type _hmNEGATIVE_INDEX."""
    home = write_home(environment, row)

    def do(axes: tuple[int, ...], line: int) -> None:
        for axis in [axis_of(environment, axis) for axis in axes]:
            home(axis, NEGATIVE_INDEX, line)

    return do


def write_frequency(environment: Environment, row: Row) -> Operation:
    """FREQ, pulses a second; 0 ends it, as it ends a jog."""
    controller = environment.controller

    def write(axis: int, pulses: float, line: int) -> None:
        row.check(pulses)
        controller.jog(axis_of(environment, axis), pulses, row.name, line, None, not pulses)

    return write


@moving
def read_frequency(environment: Environment, row: Row) -> Operation:
    """Pulses a second as they are demanded now."""
    axes, clock = environment.controller.axes, environment.clock
    return lambda axis: axes[axis_of(environment, axis)].velocity(clock.now)


OPERATIONS = {
    "encoder_wrap.demand": {"read": read_demand},
    "encoder_wrap.target": {"read": read_target},
    "encoder_wrap.last_target": {"read": read_last_target},
    "encoder_wrap.datum": {"do": do_datum},
    "encoder_wrap.frequency": {"read": read_frequency, "write": write_frequency},
}
