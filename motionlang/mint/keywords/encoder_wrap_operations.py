"""Turns of wrapped positions, and the motion words of older controllers."""

from __future__ import annotations

from math import floor

from motionlang.controller.moves import buffer
from motionlang.mint.keywords.homing_operations import Homes
from motionlang.mint.runtime.binding import Row, axis_of, of, of_word
from motionlang.mint.runtime.changes import moving
from motionlang.mint.runtime.environment import Environment

NEGATIVE_INDEX = 4


def _turns(environment: Environment, axis: int, place: float) -> int:
    """The number of turns of a position in counts; where that has no end, of the axis as it stands."""
    wrap = environment.wraps.get(axis)
    if not wrap:
        return 0
    if not abs(place) < 1e300:
        place = environment.controller.position(axis)
    return floor(environment.controller.axes[axis].scale.position_to_user(place) / wrap + 1e-12)


def do_datum(environment: Environment, row: Row, axes: tuple[int, ...], line: int) -> None:
    """DATUM: HOME of type _hmNEGATIVE_INDEX."""
    homes = environment.part(Homes)
    for axis in [axis_of(environment, axis) for axis in axes]:
        homes.begin(axis, NEGATIVE_INDEX, line)


def write_frequency(environment: Environment, row: Row, axis: int, pulses: float, line: int) -> None:
    """FREQ, pulses a second; 0 ends it, as it ends a jog."""
    environment.controller.jog(axis, pulses, row.name, line, None, not pulses)


OPERATIONS = {
    "encoder_wrap.demand": {
        "read": moving(of(Environment, lambda e, axis: _turns(e, axis, e.controller.demand(axis))))
    },
    "encoder_wrap.target": {
        "read": moving(of(Environment, lambda e, axis: _turns(e, axis, e.controller.target(axis))))
    },
    "encoder_wrap.last_target": {
        "read": moving(of(Environment, lambda e, axis: _turns(e, axis, buffer.end(e.controller.axes[axis]))))
    },
    "encoder_wrap.datum": {"do": of_word(Environment, do_datum)},
    "encoder_wrap.frequency": {
        "read": moving(of(Environment, lambda e, axis: e.controller.axes[axis].velocity(e.clock.now))),
        "write": of_word(Environment, write_frequency),
    },
}
