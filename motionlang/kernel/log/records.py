"""The records of a log, by kind: their fields in the order of writing.

Times are seconds of the machine's clock. `at` is a source position, an offset that the dialect's `locate` converts to
line and column, -1 if no program ran; `line` is a line. `chain` is the number of the calls that led to the statement
(`Log.callers`).
"""

from typing import NamedTuple


class Changed(NamedTuple):
    """An input changed its value."""

    time: float
    channel: int
    value: float


class Switched(NamedTuple):
    """An output changed its value."""

    time: float
    channel: int
    value: float
    at: int
    chain: int


class Written(NamedTuple):
    """The program wrote another value for its host or into another device; `target` names the place.

    `is_output` is True for an output of a node, which acts on the machine.
    """

    time: float
    target: str
    value: float
    at: int
    chain: int
    is_output: bool = False


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
    """A complete line that was printed."""

    time: float
    text: str
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
    seconds: tuple[float, ...]


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
