"""INCA, INCR and SUSPEND: what changes the motion in progress."""

from __future__ import annotations

from motionlang.mint.keywords.motion_operations import finite
from motionlang.mint.runtime.binding import axis_of, scale_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment


def write_by(environment: Environment, row: Row) -> Operation:
    """INCR: the target moves by user units, of a move under way too."""

    def write(axis: int, value: float, line: int) -> None:
        finite(row, value)
        counts = scale_of(environment, axis).to_counts(value)
        environment.controller.retarget_by(axis, counts, row.name, line)

    return write


def write_to(environment: Environment, row: Row) -> Operation:
    """INCA: a new target, user units, of a move under way too."""

    def write(axis: int, value: float, line: int) -> None:
        finite(row, value)
        counts = scale_of(environment, axis).position_to_counts(value + environment.turn(axis))
        environment.controller.retarget_to(axis, counts, row.name, line)

    return write


def read_suspend(environment: Environment, row: Row) -> Operation:
    controller = environment.controller
    return lambda axis: int(controller.is_suspended(axis_of(environment, axis)))


def write_suspend(environment: Environment, row: Row) -> Operation:
    """SUSPEND: 1 rests, 0 goes on."""
    controller = environment.controller

    def write(axis: int, value: int, line: int) -> None:
        (controller.suspend if value else controller.resume)(axis_of(environment, axis))

    return write


OPERATIONS = {
    "on_the_fly.by": {"write": write_by},
    "on_the_fly.to": {"write": write_to},
    "on_the_fly.suspend": {"read": read_suspend, "write": write_suspend},
}
