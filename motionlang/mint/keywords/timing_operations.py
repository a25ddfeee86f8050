"""The millisecond count of a task."""

from __future__ import annotations

from motionlang.mint.runtime.binding import of, unchecked
from motionlang.mint.runtime.environment import Environment


def read_time(environment: Environment, level: float | None = None) -> int:
    return environment.elapsed(environment.task.timer[0], level)


def write_time(environment: Environment, value: int) -> None:
    environment.task.timer[0] = environment.since(value)


OPERATIONS = {
    "time": {"read": of(Environment, read_time), "write": unchecked(of(Environment, write_time))},
}
