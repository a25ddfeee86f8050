"""The records of a log, by kind: their fields in the order of writing.

A run writes plain tuples; a stream of the log stores them as columns (`columns.py`) and returns them as these types.
Times are seconds of the machine's clock. `at` is a source position, an offset that the dialect's `locate` converts to
line and column; `line` is a line.
"""

from typing import Annotated, NamedTuple

from motionlang.kernel.log.columns import ColumnOfTexts, Numbers, Values


class Changed(NamedTuple):
    """An input changed its value."""

    time: float
    channel: int
    value: Annotated[float, Values]


class Switched(NamedTuple):
    """An output changed its value; `at` is -1 if no program ran. `chain` is as in `MoveRow`."""

    time: float
    channel: int
    value: Annotated[float, Values]
    at: int
    chain: int


class Sampled(NamedTuple):
    """A channel was sampled at the ticks `first` to `past` (exclusive) along the profile that began at `start`.

    A sample is `value` plus `per_unit` for each user unit beyond `origin`, a machine position. `datum` is the machine's
    zero in counts, `factors` are those of lengths in the scale of the axis.
    """

    channel: int
    axis: int
    first: int
    past: int
    start: float
    value: float
    per_unit: float
    origin: float
    datum: float
    factors: tuple[float, float]


class Printed(NamedTuple):
    """A complete line that was printed; `at` is -1 if no program ran. `chain` is as in `MoveRow`."""

    time: float
    text: Annotated[str, ColumnOfTexts]
    at: int
    chain: int


# The causes of a wait: a time, axes, channels, the operator, another task, a host, or any of these in a
# condition such as that of PAUSE.
CAUSES = ("time", "axis", "input", "operator", "task", "host", "condition")


class Waited(NamedTuple):
    """A task waited from `since` to `until`.

    `cause` is one of `CAUSES`, `what` the numbers of its axes or channels, `why` a description ("" for a
    time). `callers` are the source positions of the calls that led there, the outermost first.
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
    """A loop of a task ran from `since` to `until`, including everything it called.

    A loop within another one precedes it. `callers` are as in `Waited`.
    """

    task: str
    at: int
    since: float
    until: float
    callers: tuple[int, ...] = ()


class TimeSlices(NamedTuple):
    """The tasks that alternated from `time` to `until`, without a wait.

    `seconds` is how long each of `tasks` had the processor. The rest of the total time are skipped
    polls. Without tasks, the first one was alone for this time, and its slices are not recorded.
    """

    time: float
    until: float
    tasks: tuple[str, ...]
    seconds: Annotated[tuple[float, ...], Numbers]


# The kinds of events; docs/events.md defines `value` and `limit`.
EVENTS = (
    "limit",
    "soft limit",
    "following error",
    "fault",
    "e-stop",
    "abort",
    "cleared",
    "clamp",
    "too late",
    "velocity jump",
    "dropped",
    "stop",
    "cancel",
    "override",
    "handler",
    "asked",
    "buffer full",
    "wait",
)
# The kinds of events that a machine should not have.
GRAVE = ("limit", "soft limit", "following error", "fault", "e-stop", "abort", "velocity jump")


class Event(NamedTuple):
    """A reported event: `kind` is one of `EVENTS`, `axis` may be None.

    `value` and `limit` are in the user units in force then, None if there is none. `at` is the source
    position of the program, -1 if it was at none. `ordered` is the line that commanded the motion, 0 at
    standstill.
    """

    time: float
    kind: str
    axis: int | None
    value: float | None
    limit: float | None
    at: int
    ordered: int
    text: str


class ChangedSetting(NamedTuple):
    """A setting of an axis changed to a new value, in counts and seconds.

    Its name is the one in the controller.
    """

    time: float
    axis: int
    name: str
    value: object


class Zeroed(NamedTuple):
    """An axis was given a new zero; `datum` is the zero of its machine until then, counts."""

    time: float
    axis: int
    datum: float


class MoveRow(NamedTuple):
    """A move as it is stored; `acts` is true if it has an action.

    Its profile is the one with this `number` on the track of its axis, or has this `form` and `numbers`.
    `chain` is the number of the calls that led to its statement (`Log.callers`).
    """

    axis: int
    command: str
    line: int
    target: float
    commanded_speed: Annotated[float | None, Values]
    start_time: float
    scale: float
    ended: str
    zero: float
    offset: float
    acts: bool
    overlaid: bool
    number: int | None
    form: object
    numbers: Annotated[tuple[float, ...], Numbers]
    chain: int


class ProfileRow(NamedTuple):
    """A profile of a track as it is stored."""

    start: float
    form: object
    numbers: Annotated[tuple[float, ...], Numbers]
