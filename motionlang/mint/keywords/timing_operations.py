"""The millisecond count of a task."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment


def read_time(environment: Environment, row: Row) -> Operation:
    return lambda level=None: environment.elapsed(environment.task.timer[0], level)


def write_time(environment: Environment, row: Row) -> Operation:
    def write(value: int) -> None:
        environment.task.timer[0] = environment.since(value)

    return write


OPERATIONS = {
    "time": {"read": read_time, "write": write_time},
}
