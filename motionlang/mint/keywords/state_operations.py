"""What an axis tells about itself: at rest, and where."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.binding import by_axis, of_word, scale_of
from motionlang.mint.runtime.changes import Changes
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row


@by_axis
def read_is_idle(environment: Environment, row: Row, axis: int) -> Operation:
    """IDLE and POSACHIEVED: at rest, and settled where the program asks for that too."""
    is_idle = environment.controller.reader("is_idle", axis)
    return lambda: int(is_idle() and (environment.settled is None or environment.settled(axis)))


@by_axis
def read_position(environment: Environment, row: Row, axis: int) -> Operation:
    """POS, within the turn where the axis has one."""
    changes = environment.part(Changes)
    hearing = changes.hearing(axis, changes.passing("position"), environment.wraps)
    return environment.controller.reader("position", axis, "place", hearing)


@by_axis
def read_demand(environment: Environment, row: Row, axis: int) -> Operation:
    """POSDEMAND, within the turn where the axis has one."""
    changes = environment.part(Changes)
    hearing = changes.hearing(axis, changes.passing("demand"), environment.wraps)
    return environment.controller.reader("demand", axis, "place", hearing)


def write_position(environment: Environment, row: Row, axis: int, value: float) -> None:
    """POS: the present position gets a new value."""
    counts = scale_of(environment, axis).position_to_counts(value)
    if not -1e300 < counts < 1e300:
        raise Refusal("range", f"{row.name} cannot be {value:g}", "a position is finite, in counts too")
    environment.controller.define_position(axis, counts)


OPERATIONS = {
    "is_idle": {"read": read_is_idle},
    "position": {"read": read_position, "write": of_word(Environment, write_position)},
    "demand": {"read": read_demand},
}
