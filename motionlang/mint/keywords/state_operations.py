"""What an axis tells about itself: at rest, and where."""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.mint.runtime.binding import by_axis, of_word, scale_of
from motionlang.mint.runtime.environment import Environment

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Maker, Operation, Row


@by_axis
def read_is_idle(environment: Environment, row: Row, axis: int) -> Operation:
    """IDLE and POSACHIEVED: at rest, and settled where the program asks for that too."""
    is_idle = environment.controller.reader("is_idle", axis)
    return lambda: int(is_idle() and (environment.settled is None or environment.settled(axis)))


def place(name: str) -> Maker:
    """What reads POS or POSDEMAND, within the turn where the axis has one."""

    def read(environment: Environment, row: Row, axis: int) -> Operation:
        return environment.controller.reader(name, axis, "place", environment)

    return by_axis(read)


def write_position(environment: Environment, row: Row, axis: int, value: float) -> None:
    """POS: the present position gets a new value."""
    counts = scale_of(environment, axis).position_to_counts(value)
    if not -1e300 < counts < 1e300:
        raise Refusal("range", f"{row.name} cannot be {value:g}", "a position is finite, in counts too")
    environment.controller.define_position(axis, counts)


OPERATIONS = {
    "is_idle": {"read": read_is_idle},
    "position": {"read": place("position"), "write": of_word(Environment, write_position)},
    "demand": {"read": place("demand")},
}
