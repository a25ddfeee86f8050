"""Latches: positions captured at the exact time of an edge, not at the next tick.

LATCH… keywords address channels, each with settings for its trigger and source. FAST… keywords are the older
set, with one latch per axis. A latch sees the input directly, without INPUTDEBOUNCE. The meanings of the mode
numbers are from memory.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.triggers.homing import next_index
from motionlang.kernel.controller.watch import Watch, begin, end
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.lang.wait_causes import Read
from motionlang.kernel.mint.keywords.event_kinds import NUMBERS
from motionlang.kernel.mint.keywords.io_inputs import checked
from motionlang.kernel.mint.runtime.binding import ByNumber, Maker, Operation, axis_of, scale_of, unchecked
from motionlang.kernel.mint.runtime.environment import Environment

LAST_LATCH = NUMBERS["latch"][-1]
BY_INPUT, BY_INDEX = 0, 1
RISING, FALLING, BOTH = 0, 1, 2
AXIS_POSITION, ENCODER = 0, 1


class Latch:
    """One latch; positions are in counts.

    If `again` is true, it is rearmed after each capture.
    """

    def __init__(self, environment: Environment, axis: int, fired: Callable[[Latch], None]) -> None:
        self.environment, self._controller = environment, environment.controller
        self._fired = fired
        self.axis = axis
        self.trigger_mode, self.input, self.again = BY_INPUT, 0, 0
        self.edge, self.source = RISING, AXIS_POSITION
        self.armed = self.caught = False
        self.value = 0.0
        # The watches of the nearest index marks, by their positions.
        self._watches: dict[float, Watch] = {}
        self._controller.inputs.listeners.append(self._changed)

    @property
    def track(self) -> Axis:
        """The axis, or the encoder, whose index marks trigger the latch."""
        return self._controller.axes[self.axis]

    def arm(self, armed: bool) -> None:
        """Arm the latch and clear its captured value, or disarm it."""
        self._unwatch()
        self.armed = armed
        if armed:
            self.caught = False
            self._watch()

    def set(self, name: str, value: float) -> None:
        """Change a setting; an armed latch uses it at once."""
        setattr(self, name, value)
        self._unwatch()
        if self.armed:
            self._watch()

    def read(self) -> bool:
        """True if a position was captured or, with `again`, captured since the last read.

        The program asks for the input that triggers the latch.
        """
        if self.armed and self.trigger_mode == BY_INPUT:
            self._controller.inputs.note_read(self.input)
        caught = self.caught
        if caught and self.again:
            self.caught = False
            self.environment.acts += 1
        return caught

    def _watch(self) -> None:
        """Watch for the next index mark in both directions, if a mark is the trigger."""
        if self.trigger_mode != BY_INDEX:
            return
        for direction in (1, -1):
            self._watch_mark(next_index(self.track, direction))

    def _watch_mark(self, mark: float) -> None:
        if abs(mark) < INFINITY:
            watch = self._watches[mark] = Watch(mark, partial(self._mark, mark), physical=True)
            begin(self.track, watch)

    def _unwatch(self, kept: float | None = None) -> None:
        """Stop watching all marks, except the one at `kept`."""
        for mark in [each for each in self._watches if each != kept]:
            end(self.track, self._watches.pop(mark))

    def _mark(self, mark: float, direction: int) -> None:
        """Catch a mark; the axis passes it again if it comes back, or then the next one."""
        self._unwatch(kept=mark)
        self._catch()
        if self.armed:
            self._watch_mark(next_index(self.track, direction))
        else:
            self._unwatch()

    def _changed(self, channel: int, value: float) -> None:
        if not self.armed or self.trigger_mode != BY_INPUT or channel != self.input:
            return
        on = self._controller.inputs.inverted(channel)
        if self.edge == BOTH or on is (self.edge == RISING):
            self._catch()

    def _catch(self) -> None:
        self.value, self.caught = self._position(), True
        self.armed = bool(self.again)
        self._fired(self)

    def _position(self) -> float:
        """Return the position to capture: the axis position or its encoder count."""
        position = self.track.actual_position
        return position - self.track.datum if self.source == ENCODER else position


class Latches:
    """The latch channels, created on first use; a capture raises the event LATCH."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._latches = ByNumber(lambda number: self.made(self.checked(number)))

    def latch(self, number: int) -> Latch:
        """Return the latch of a channel or an axis, created on first use."""
        return self._latches[number]

    def checked(self, number: int) -> int:
        return checked(number, LAST_LATCH, "latch channel")

    def made(self, number: int) -> Latch:
        events = self._environment.events
        return Latch(self._environment, 0, lambda _: events.raise_("latch", number))


class FastLatches(Latches):
    """The fast latch of every axis; a capture raises the event FASTIN."""

    kind = Latch

    def checked(self, number: int) -> int:
        return axis_of(self._environment, number)

    def made(self, number: int) -> Latch:
        events = self._environment.events
        return self.kind(self._environment, number, lambda fired: events.raise_("fastin", fired.input))

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        if axis in self._latches:
            self._latches.pop(axis).arm(False)


def triggers(environment: Environment, numbers: Sequence[int]) -> tuple[frozenset[Read], str]:
    """Return the inputs that trigger latches, and a hint if one of the latches is not armed."""
    found = []
    for number in numbers:
        latch = environment.component(Latches).latch(number)
        if not latch.armed:
            return frozenset(), f"LATCHENABLE({number}) = 1 arms the latch first"
        if latch.trigger_mode == BY_INPUT:
            found.append(("input", latch.input))
    return frozenset(found), ""


# ----------------------------------------------------------------------------------------------- operations


def read_setting(latch: Latch, row: Keyword) -> int:
    return int(getattr(latch, row.attribute))


def write_setting(latch: Latch, row: Keyword, value: float) -> None:
    if row.attribute == "axis":
        axis_of(latch.environment, int(value))
    latch.set(row.attribute, value)


def read_value(latch: Latch, row: Keyword) -> float:
    """Return the captured value.

    A position is in user units, within POSWRAP like POS. An encoder count is in counts.
    """
    return (
        latch.value
        if latch.source == ENCODER
        else scale_of(latch.environment, latch.axis).shown_position(latch.value)
    )


def read_encoder(latch: Latch, row: Keyword) -> float:
    """FASTENCODER: return the captured encoder count."""
    return latch.value - latch.environment.controller.axes[latch.axis].datum


def on_latch(function: Callable[..., object]) -> Maker:
    """Make an operation on a latch, chosen by channel, or by axis for FAST keywords."""

    def made(environment: Environment, row: Keyword) -> Operation:
        latches = environment.component(FastLatches if row.name.startswith("FAST") else Latches)
        return lambda channel, *value: function(latches.latch(channel), row, *value)

    return made


# ------------------------------------------------------------------------------------------------- keywords


def _setting_of(attribute: str) -> Actions:
    return Actions(read=on_latch(read_setting), write=on_latch(write_setting), attribute=attribute)


_ENABLE = Actions(
    read=on_latch(lambda latch, row: int(latch.armed)),
    write=unchecked(on_latch(lambda latch, row, armed: latch.arm(bool(armed)))),
)
_CAUGHT = Actions(read=on_latch(lambda latch, row: int(latch.read())))
_VALUE = Actions(read=on_latch(read_value))

_ARMED = "LATCHTRIGGERCHANNEL(0) = 3\nLATCHENABLE(0) = 1\nPRINT {}(0)"
_FAST = "FASTSELECT(0) = 3\nFASTENABLE(0) = 1\nPRINT {}(0)"


def _setting(
    name: str, sets: str, index: str, unit: str, value: str, help: str, high: float, default: float = 0.0,
    selects: str = "",
) -> Keyword:  # fmt: skip
    return Keyword(name, "", "setting", "RW", index, unit, _setting_of(sets), help,
                   f"{name}(0) = {value}\nPRINT {name}(0)", default=default, low=0, high=high,
                   group="latches", selects=selects)  # fmt: skip


def reading_row(name: str, index: str, unit: str, actions: Actions, help: str, example: str) -> Keyword:
    """Return the row of what a latch has caught; `example` has {} for the keyword."""
    return Keyword(name, "", "reading", "R", index, unit, actions, help, example.format(name), default=0.0,
                   group="latches")  # fmt: skip


ROWS = (
    _setting("LATCHTRIGGERMODE", "trigger_mode", "latch", "integer", "1",
             "Trigger of a latch: 0 an input, 1 the encoder's index.", 1),
    _setting("LATCHTRIGGERCHANNEL", "input", "latch", "integer", "3", "The input that triggers a latch.", 999,
             selects="input"),
    _setting("LATCHTRIGGEREDGE", "edge", "latch", "integer", "2",
             "The edge that triggers a latch: 0 becoming active, 1 becoming inactive, 2 both.", 2),
    _setting("LATCHSOURCE", "source", "latch", "integer", "1",
             "Quantity that a latch captures: 0 the position of an axis in user units, 1 its encoder "
             "value.", 1),
    _setting("LATCHSOURCECHANNEL", "axis", "latch", "integer", "1", "The axis whose position a latch catches.", 63),
    _setting("LATCHMODE", "again", "latch", "integer", "1",
             "0: a latch catches once and must be enabled again; 1: it stays enabled, and reading LATCH resets it.", 1),
    Keyword("LATCHENABLE", "", "setting", "RW", "latch", "bool", _ENABLE,
            "Arm a latch; it forgets what it had caught.",
            _ARMED.format("LATCHENABLE"), default=0.0, low=0, high=1, group="latches"),
    reading_row("LATCH", "latch", "bool", _CAUGHT, "1 when a latch has caught a position.", _ARMED),
    reading_row("LATCHVALUE", "latch", "number", _VALUE, "Captured value of a latch.", _ARMED),
    _setting("FASTSELECT", "input", "axis", "integer", "3", "The input that triggers the fast latch of the axis.", 999,
             selects="input"),
    Keyword("FASTENABLE", "", "setting", "W", "axis", "integer", _ENABLE,
            "Arm the fast latch of the axis; it forgets what it had caught.",
            _FAST.format("FASTLATCH"), low=0, high=1, group="latches"),
    _setting("FASTLATCHEDGE", "edge", "axis", "bool", "1",
             "0: the input triggers when it becomes active; 1: inactive.", 1),
    _setting("FASTLATCHMODE", "again", "axis", "integer", "1", "0: the fast latch catches once; 1: it stays armed.", 1),
    reading_row("FASTLATCH", "axis", "bool", _CAUGHT, "1 when the fast latch of the axis has caught.", _FAST),
    reading_row("FASTPOS", "axis", "number", _VALUE, "The position that the fast latch has caught.", _FAST),
    reading_row("FASTENCODER", "axis", "number", Actions(read=on_latch(read_encoder)),
                "Encoder value captured by the fast latch.", _FAST),
)  # fmt: skip
# The event sources of each kind, created for programs that handle these events.
SOURCES = {"latch": Latches, "fastin": FastLatches}
