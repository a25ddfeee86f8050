"""A keyword: one row of a dialect's vocabulary, the source of everything about it.

Dispatch, diagnostics, did-you-mean, completion, `help`, highlighting, the linter and `docs/keywords/` read
these rows and nothing else. A row refers to the functions that execute it (`Actions`), which its file
defines.
"""

from __future__ import annotations

from collections.abc import Callable
from copy import copy
from dataclasses import KW_ONLY, InitVar, dataclass, field
from math import inf, nextafter
from typing import Any

# The channels of a bank of inputs or outputs.
BANK = 32
# The devices of a machine that a keyword numbers, in the order of a map of a program.
CHANNELS = (
    "input", "input bank", "output", "output bank", "digital", "analogue input",
    "analogue output", "encoder", "comms element", "network data",
    "Modbus register", "remote node", "nv word", "key", "answer",
)  # fmt: skip
# The devices in which a host and a program leave numbers for each other.
HOST_CHANNELS = frozenset(("comms element", "network data", "Modbus register"))
# The device, by the section of the machine file that drives a reading, or else by the last word of `index`.
_DRIVEN = {"analogue": "analogue input", "encoder": "encoder", "netdata": "network data", "key": "key"}
_INDEXED = {"input": "input", "output": "output",
            "register": "Modbus register", "element": "comms element", "auxchannel": "encoder"}  # fmt: skip
# The kind of a reading, by the section of the machine file that drives it, or else by `index`.
_READS_BY_DRIVEN = {"input": "input", "analogue": "analogue", "encoder": "encoder", "key": "operator",
                    "answer": "operator", "comms": "host", "netdata": "host",
                    "remote": "host"}  # fmt: skip
_READS_BY_INDEX = {"axis": "axis", "axes": "axis", "task": "task", "latch": "latch"}
# What a statement does to an axis, in the order of a map of a program.
TOPICS = ("enable", "home", "move", "speed", "limit", "master", "scale", "servo", "stop")
_TOPICS_BY_ROLE = {"move": "move", "entry": "move", "course": "move", "path": "move", "act": "move",
                   "stop": "stop", "scale": "scale", "zero": "home"}  # fmt: skip
_TOPICS_BY_GROUP = {"limits": "limit", "homing": "home", "following": "master", "trajectory": "speed",
                    "user units": "scale", "servo": "servo", "servo filter": "servo", "contour": "move"}  # fmt: skip

# Units of integers. A time in ms may still be written with a fraction.
WHOLE_UNITS = frozenset(("integer", "bool", "bits", "counts", "ms"))

# The group of keywords whose value is stored and read back, and has no effect.
KEPT = "kept, not simulated"

# The effects of a statement on the axes it names. A keyword has at most one of the first group, its role in a
# program that is followed step by step; the others add details.
ROLES = {
    "move": "loads a move with a known end into the buffer of its axis",
    "entry": "loads another entry into the buffer: a dwell, an output",
    "course": "loads a motion without a known end into the buffer",
    "path": "loads a move of several axes into their buffers; GO of the first axis starts it",
    "go": "starts the buffered moves",
    "stop": "stops the axis and empties its buffer",
    "act": "moves the axis at once, without GO",
    "start": "moves the axis at once to a known end",
    "mode": "selects the kind of motion",
    "run": "starts the motion of the mode",
    "rest": "waits until the axis is at rest",
    "enable": "switches the axis on, and puts its units in force",
    "scale": "changes the user unit",
    "rescale": "changes the user unit from the next time on that the axis is switched on",
    "zero": "sets the present position to another value",
}
# The traits: "relative", "position", "target", "upper", "lower" (a value is a distance, or that of the axis or of its
# limit), "line" (a path that ends at given positions), "endless", "targets" (a mode that runs to targets), "abrupt",
# "off", "all" (axes), "datum" (the zero moves), "follows" (a master), "hands-over" (an input, a table or an analogue
# value also moves the axis from then on), "switch" (the motion may have ended).


@dataclass(eq=False, slots=True)
class Actions:
    """The functions of a keyword, None if there is none; calls differ by language.

    `function`       the name of its function in the controller, the steps or the linter; "" if they need none
    `read`, `write`, `load`, `do`   read its value, write it, load a move into the buffer, execute a command
    `replaced`   reads the value that a write replaces, if `read` does not
    `attribute`  the property that it reads and writes of its subject, such as the "edge" of a latch
    """

    function: str = ""
    read: Callable[..., Any] | None = None
    write: Callable[..., Any] | None = None
    load: Callable[..., Any] | None = None
    do: Callable[..., Any] | None = None
    replaced: Callable[..., Any] | None = None
    attribute: str = ""


@dataclass(eq=False, repr=False)
class Keyword:
    """One keyword of a motion language.

    `kind`     "setting" | "reading" | "command" | "move" | "function" | "constant" | "statement"
    `access`   "R", "W", "RW" (values) or "C" (a command without a value)
    `index`    the contents of the brackets: "axis", "axes" (a list), "channel", "bank", "none"
    `unit`     "uu", "uu/s", "uu/s2", "uu/s3", "s", "ms", "counts", "%", "bool", "bits", "number", "text", ""
    `actions`  the functions that execute it, or only a `function`: a setting or a reading of the controller,
               the value of a constant, the name of a function or a statement; "" if it is not simulated
    `low`…`high`  the accepted range, inclusive; None if open
    `below`    True if the range excludes `high` (MCCL)
    `solved`   its `read` accepts the level of a comparison, and can solve when the value passes that level
    `simulated`   False: recognised, documented, reported as "not simulated"
    `effect`   the effect of writing or executing the keyword on its axes: words of `ROLES` and traits
    `gives`    the property of moves that it sets: "speed", "accel", "decel jerk" …; the last one written is
               in force
    `changes`  "motion": the value changes only while the axis moves; "always": it may differ at each read
    `every`    read for several axes, it is true if it is true for each of them
    `optional` the number of values that may be omitted at the end of the brackets
    `tunes`    the quantity of the servo loop that it sets: one of the gains of its language in `servo.gains`
    `meant`    words that people write for it if they do not know it
    `family`   the keywords that a controller lacks or limits together with it, as defined in `models.py` of a
               language
    `driven`   the section of the machine file that sets the value read, such as "input"
    `channel`  the device, one of `CHANNELS`, that the brackets number, or the parameter of a command without an axis
    `output`   what a command writes to its channel, as text
    `reads`    what reading it depends on, one of `wait_causes.KINDS`; "variable" for variables that the `Uses` of its
               step say, "" if it reads nothing
    `selects`  the device that the value numbers, such as the input of a home switch; without a value the axis
               numbers it
    `waits`    what a task waits for at the keyword, one of `record.records.CAUSES`; "" if it does not wait
    `tests`    the condition of a command that goes on if it holds, or waits for it, with {} for the parameter
    `topic`    what writing it does to an axis, one of `TOPICS`, "" for anything else
    `renamed`  for a keyword of an older generation: its name in the newer one, with " = VALUE" if it is a setting there
    `word`     the name or the short form by which a program names it, for messages
    """

    name: str
    short: str
    kind: str
    access: str
    index: str
    unit: str
    action: InitVar[str | Actions]
    help: str
    example: str = ""
    _: KW_ONLY
    default: float | str | None = None
    low: float | None = None
    high: float | None = None
    below: bool = False
    group: str = ""
    simulated: bool = True
    solved: bool = False
    effect: str = ""
    gives: str = ""
    changes: str = ""
    tunes: str = ""
    driven: str = ""
    channel: str = ""
    output: str = ""
    reads: str = ""
    selects: str = ""
    waits: str = ""
    tests: str = ""
    topic: str = ""
    meant: str = ""
    family: str = ""
    renamed: str = ""
    every: bool = False
    optional: int = 0
    word: str = field(init=False)
    actions: Actions = field(init=False)
    function: str = field(init=False)

    def __post_init__(self, action: str | Actions) -> None:
        self.word = self.name
        self.actions = action if isinstance(action, Actions) else Actions(action)
        self.function = self.actions.function
        self.channel = self.channel or self._device()
        self.reads = self.reads or self._default_reads()
        self.topic = self.topic or self._default_topic()

    @property
    def is_whole(self) -> bool:
        """True if its value is read as an integer."""
        return self.unit in WHOLE_UNITS

    @property
    def takes_fractions(self) -> bool:
        """True if a value written to it keeps its fraction."""
        return self.unit not in WHOLE_UNITS or self.unit == "ms"

    @property
    def limits(self) -> tuple[float, float]:
        """The smallest and the largest accepted value, infinite where the range is open."""
        high = inf if self.high is None else nextafter(self.high, -inf) if self.below else self.high
        return (-inf if self.low is None else self.low), high

    def refusal(self, value: float) -> tuple[str, str] | None:
        """Return message and hint for a value outside the range, as NaN always is."""
        low, high = self.limits
        if low <= value <= high:
            return None
        hint = "" if self.low is None or self.high is None else f"it takes {low:.10g} to {high:.10g}"
        return f"{self.word} cannot be {value:.10g}", hint

    @property
    def caveat(self) -> str:
        """The words "not simulated" or "kept, not simulated"; "" for a simulated keyword."""
        return "" if self.simulated else KEPT if self.group == KEPT else "not simulated"

    @property
    def without_value(self) -> str:
        """What a reading shows that has no value, in words."""
        return "is empty" if self.unit == "text" else "reads 0"

    @property
    def example_value(self) -> str:
        """A line by which the machine file gives its value."""
        value = {"text": '"…"', "number": "1.5"}.get(self.unit, "1")
        return f"{self.name} = {value}"

    @property
    def accepted(self) -> str:
        """The accepted range as text, "" if it is not limited."""
        low, high = (None if bound is None else f"{bound:.10g}" for bound in (self.low, self.high))
        if low is None or high is None:
            return f"{low} or more" if low else f"{high} or less" if high else ""
        return f"{low} to below {high}" if self.below else f"{low} to {high}"

    @property
    def attribute(self) -> str:
        """The property of its subject that the keyword reads and writes."""
        return self.actions.attribute

    def shortened(self) -> Keyword:
        """Return the same row, named by its short form."""
        row = copy(self)
        row.word = self.short.upper()
        return row

    def does(self, what: str) -> bool:
        """True if `effect` contains `what`, a word of `ROLES` or a trait."""
        return what in self.effect.split()

    @property
    def role(self) -> str:
        """The word of `ROLES` in `effect`, "" if there is none."""
        return next((what for what in self.effect.split() if what in ROLES), "")

    @property
    def is_stored(self) -> bool:
        """True if writing it only stores a value, which acts later."""
        return not self.effect or self.role == "rescale" or self.effect in ("upper", "lower")

    def _device(self) -> str:
        """Return the device that the brackets number, as far as other columns say it."""
        words = self.index.split(", ")
        if "node" in words:
            return "remote node"
        if self.driven == "input" and words[-1] == "bank":
            return "input bank"
        if {"axis", "axes", "server"} & set(words) and self.driven != "encoder":
            return "Modbus register" if "server" in words else ""
        return _DRIVEN.get(self.driven) or _INDEXED.get(words[-1], "")

    def _default_topic(self) -> str:
        if self.index.split(", ")[0] not in ("axis", "axes") and not self.does("all"):
            return ""
        if self.does("datum") and not self.does("stop"):
            return "home"
        usual = _TOPICS_BY_GROUP.get(self.group, "")
        return _TOPICS_BY_ROLE.get(self.role) or ("speed" if self.gives and usual != "limit" else usual)

    def _default_reads(self) -> str:
        if self.kind not in ("reading", "setting", "move") or "R" not in self.access:
            return ""
        if self.driven in _READS_BY_DRIVEN:
            return _READS_BY_DRIVEN[self.driven]
        if self.index in ("axis", "axes") and (self.solved or self.changes == "motion"):
            return "position"
        return _READS_BY_INDEX.get(self.index, "other")

    def __repr__(self) -> str:
        return f"Keyword({self.name!r})"


def kind_of(access: str) -> str:
    """Return the kind of a value or a command with an access."""
    return "command" if access == "C" else "setting" if "W" in access else "reading"


def constant(
    name: str, value: float | str, help: str, unit: str = "integer", meant: str = ""
) -> Keyword:  # fmt: skip
    """Return the row of a constant, which people also write without its underscore."""
    return Keyword(name, "", "constant", "R", "none", unit, str(value), help, f"PRINT {name}",
                   group="constants", meant=f"{name[1:].upper()} {meant}".strip())  # fmt: skip


def value(
    name: str, short: str, access: str, index: str, unit: str, actions: Actions, help: str, example: str,
    default: float = 0.0, low: float | None = None, high: float | None = None, group: str = "",
    channel: str = "", selects: str = "",
) -> Keyword:  # fmt: skip
    """Return the row of a value: a reading if it can only be read, else a setting."""
    return Keyword(name, short, kind_of(access), access, index, unit, actions, help, example, default=default,
                   low=low, high=high, group=group, channel=channel, selects=selects)  # fmt: skip
