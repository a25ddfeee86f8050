"""The millisecond count of a task."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import Operation, of, unchecked
from motionlang.kernel.mint.runtime.environment import Environment


def read_time(environment: Environment, row: Keyword) -> Operation:
    """TIME: make an operation that reads the count of the running task."""
    elapsed = environment.elapsed
    return lambda level=None: elapsed(environment.task.timer[0], level)


def write_time(environment: Environment, value: int) -> None:
    environment.task.timer[0] = environment.since(value)


# ------------------------------------------------------------------------------------------------- keywords

_TIME = Actions("time", read=read_time, write=unchecked(of(Environment, write_time)))


ROWS = (
    Keyword("TIME", "", "setting", "RW", "none", "integer", _TIME,
            "Milliseconds that count up by themselves from 0 at the start; each task has its own count.",
            "TIME = 0\nWAIT = 250\nPRINT TIME", default=0.0, low=-2147483648.0, high=2147483647.0,
            group="control", solved=True, reads="time", meant="TICKS MILLIS"),
    Keyword("WAIT", "WT", "setting", "W", "none", "ms", "wait",
            "Let a time pass before the next statement, written WAIT = ms or WAIT(ms).",
            "WAIT = 100\nWAIT(100)\nPRINT TIME", low=0.0, high=2147483647.0, group="control",
            meant="SLEEP DELAY DWELL G4 G04", waits="time"),
)  # fmt: skip
