"""What the records of a log are, kind by kind: their fields in the order in which they are written.

A run writes plain tuples; a stream of the log gives them as these to whoever reads it. Times are seconds of the
machine's clock. `at` is a place in the program, a token number, of which the dialect's `locate` makes line and column;
`line` is a line.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from motionlang.log.written_waits import whole


class Changed(NamedTuple):
    """A channel has another value: an output that the program set, an input that the world did."""

    time: float
    channel: int
    value: float


class Printed(NamedTuple):
    """A whole line that was printed."""

    time: float
    text: str


# What a task may wait for: a time, axes, channels, whoever types, another task, a host, or any of these in a condition
# such as that of PAUSE.
CAUSES = ("time", "axis", "input", "operator", "task", "host", "condition")


class Waited(NamedTuple):
    """A task has waited, from `since` to `until`.

    `cause` is one of `CAUSES`, `what` the numbers of its axes or channels, `why` how a person would say it ("" for a
    time). `callers` are the places of the calls that led there, the outermost first.
    """

    task: str
    at: int
    since: float
    until: float
    cause: str
    what: tuple[int, ...]
    why: str
    callers: tuple[int, ...] = ()


class Looped(NamedTuple):
    """A loop of a task has run from `since` to `until`, with everything that it called.

    A loop within another one comes before it. `callers` are as in `Waited`.
    """

    task: str
    at: int
    since: float
    until: float
    callers: tuple[int, ...] = ()


class Turns(NamedTuple):
    """The tasks that have computed from `time` to `until`, in turn, while none of them began or ended a wait.

    `seconds` says how long each of `tasks` had the machine. What the sum lacks of the whole were skipped polls.
    """

    time: float
    until: float
    tasks: tuple[str, ...]
    seconds: tuple[float, ...]


# What an event may be: what `value` and `limit` are is in docs/events.md.
EVENTS = (
    "limit",
    "soft limit",
    "following error",
    "fault",
    "e-stop",
    "abort",
    "cleared",
    "clamp",
    "velocity jump",
    "stop",
    "cancel",
    "override",
    "handler",
    "buffer full",
    "wait",
)
# Those that a machine should not have.
GRAVE = ("limit", "soft limit", "following error", "fault", "e-stop", "abort", "velocity jump")


class Event(NamedTuple):
    """Something happened that a person wants to be told of: `kind` is one of `EVENTS`, `axis` None where it has none.

    `value` and `limit` are in user units of that moment, None where there is none; the program stood `at` that place
    (-1: it stood nowhere), and `ordered` is the line that ordered the motion, 0 where the axis stood.
    """

    time: float
    kind: str
    axis: int | None
    value: float | None
    limit: float | None
    at: int
    ordered: int
    text: str


class Setting(NamedTuple):
    """A setting of an axis has another value, in counts and seconds, by the controller's name for it."""

    time: float
    axis: int
    name: str
    value: object


# What makes a record of a kind of what was written.
makers: Mapping[str, Callable[[Any], Any]] = {
    kind.__name__: kind._make for kind in (Changed, Printed, Looped, Turns, Event, Setting)
} | {"Waited": lambda wait: Waited._make(whole(wait))}
