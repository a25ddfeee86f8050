"""What an axis tells about itself: at rest, and where."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.binding import scale_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]


def read_is_idle(environment: Environment, row: Row) -> Operation:
    """IDLE and POSACHIEVED: at rest, and settled where the program asks for that too."""
    is_idle = environment.controller.is_idle

    def read(axis: int) -> int:
        scale_of(environment, axis)
        return int(is_idle(axis) and (environment.settled is None or environment.settled(axis)))

    return read


def read_position(environment: Environment, row: Row) -> Operation:
    return _wrapped(environment, environment.controller.position)


def read_demand(environment: Environment, row: Row) -> Operation:
    return _wrapped(environment, environment.controller.demand)


def _wrapped(environment: Environment, position: Callable[[int], float]) -> Operation:
    """Reads a position in user units, within the turn where the axis has one."""
    wraps = environment.wraps

    def read(axis: int) -> float:
        found = scale_of(environment, axis).position_to_user(position(axis))
        wrap = wraps.get(axis)
        return found % wrap if wrap else found

    return read


def write_position(environment: Environment, row: Row) -> Operation:
    """POS: the present position gets a new value."""

    def write(axis: int, value: float) -> None:
        counts = scale_of(environment, axis).position_to_counts(value)
        if not -1e300 < counts < 1e300:
            raise Refusal("range", f"{row.name} cannot be {value:g}", "a position is finite, in counts too")
        environment.controller.define_position(axis, counts)

    return write


OPERATIONS = {
    "is_idle": {"read": read_is_idle},
    "position": {"read": read_position, "write": write_position},
    "demand": {"read": read_demand},
}
