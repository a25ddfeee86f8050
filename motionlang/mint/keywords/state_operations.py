"""What an axis tells about itself: at rest, and where."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.binding import scale_of
from motionlang.mint.runtime.changes import Changes, comparable, note

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
    return _wrapped(environment, environment.controller.position, environment.part(Changes).position)


def read_demand(environment: Environment, row: Row) -> Operation:
    return _wrapped(environment, environment.controller.demand, environment.part(Changes).demand)


def read_remaining(environment: Environment, row: Row) -> Operation:
    """POSREMAINING: what is left of the way to the target."""
    remaining = environment.controller.remaining

    def read(axis: int) -> float:
        return scale_of(environment, axis).to_user(float(remaining(axis)), row.unit)

    return comparable(environment, read, environment.part(Changes).remaining)


def _wrapped(
    environment: Environment, position: Callable[[int], float], until: Callable[[int, float], float]
) -> Operation:
    """Reads a position in user units, within the turn where the axis has one; may be told what it is compared with."""
    wraps, attention, moving = environment.wraps, environment.attention, environment.part(Changes).moving

    def read(axis: int, level: float | None = None) -> float:
        if attention.notes is not None:
            note(attention, moving, until, axis, level)
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
    "remaining": {"read": read_remaining},
}
