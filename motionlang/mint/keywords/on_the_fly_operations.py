"""INCA, INCR and SUSPEND: what changes the motion in progress."""

from __future__ import annotations

from motionlang.mint.keywords.motion_operations import finite
from motionlang.mint.runtime.binding import Row, of, of_word, scale_of
from motionlang.mint.runtime.environment import Environment


def write_by(environment: Environment, row: Row, axis: int, value: float, line: int) -> None:
    """INCR: the target moves by user units, of a move under way too."""
    finite(row, value)
    counts = scale_of(environment, axis).to_counts(value)
    environment.controller.retarget_by(axis, counts, row.name, line)


def write_to(environment: Environment, row: Row, axis: int, value: float, line: int) -> None:
    """INCA: a new target, user units, of a move under way too."""
    finite(row, value)
    counts = scale_of(environment, axis).position_to_counts(value + environment.turn(axis))
    environment.controller.retarget_to(axis, counts, row.name, line)


def write_suspend(environment: Environment, axis: int, value: int, line: int) -> None:
    """SUSPEND: 1 rests, 0 goes on."""
    controller = environment.controller
    (controller.suspend if value else controller.resume)(axis)


OPERATIONS = {
    "on_the_fly.by": {"write": of_word(Environment, write_by)},
    "on_the_fly.to": {"write": of_word(Environment, write_to)},
    "on_the_fly.suspend": {
        "read": of(Environment, lambda e, axis: int(e.controller.is_suspended(axis))),
        "write": of(Environment, write_suspend),
    },
}
