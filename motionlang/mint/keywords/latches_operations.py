"""Latches: a position caught at the very moment of an edge, not at the next tick of anything.

LATCH… has channels that say what triggers them and what they catch; FAST… is the older set, one latch an axis. A latch
sees the input itself, without INPUTDEBOUNCE. What the numbers of the modes mean is from memory.
"""

from __future__ import annotations

from motionlang.controller.triggers.homing import next_index
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.runtime.binding import axis_of, scale_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.triggers.watch import Watch
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment

INFINITY = float("inf")
LAST_LATCH = 31
BY_INPUT, BY_INDEX = 0, 1
RISING, FALLING, BOTH = 0, 1, 2
AXIS_POSITION, ENCODER = 0, 1
# Keyword -> the attribute of a latch; FAST… keywords are those of the axis's own latch.
SETTINGS = {
    "LATCHTRIGGERMODE": "trigger_mode",
    "LATCHTRIGGERCHANNEL": "input",
    "LATCHTRIGGEREDGE": "edge",
    "LATCHSOURCE": "source",
    "LATCHSOURCECHANNEL": "axis",
    "LATCHMODE": "again",
    "LATCHINHIBITTIME": "inhibit_time",
    "LATCHINHIBITVALUE": "inhibit_distance",
    "FASTSELECT": "input",
    "FASTLATCHEDGE": "edge",
    "FASTLATCHMODE": "again",
    "FASTLATCHDISTANCE": "inhibit_distance",
}


class Latch:
    """One latch. `again` keeps it armed after it has caught something; positions are counts."""

    def __init__(self, environment: Environment, axis: int, fired: Callable[[Latch], None]) -> None:
        self._environment, self._controller = environment, environment.controller
        self._fired = fired
        self.axis = axis
        self.trigger_mode, self.input, self.edge, self.source, self.again = (
            BY_INPUT,
            0,
            RISING,
            AXIS_POSITION,
            0,
        )
        self.inhibit_time, self.inhibit_distance = 0.0, 0.0
        self.armed = self.caught = False
        self.value = 0.0
        self._time = -INFINITY
        self._watches: list[Watch] = []
        self._controller.inputs.listeners.append(self._changed)

    def arm(self, armed: bool) -> None:
        """Switch the latch on, which forgets what it caught, or off."""
        self._unwatch()
        self.armed = armed
        if armed:
            self.caught = False
            self._watch()

    def set(self, name: str, value: float) -> None:
        """Change a setting; a latch that is armed goes by it from now on."""
        setattr(self, name, value)
        self._unwatch()
        if self.armed:
            self._watch()

    def read(self) -> bool:
        """Whether something was caught; of a latch that goes on by itself, since this was asked last."""
        caught = self.caught
        if caught and self.again:
            self.caught = False
            self._environment.acts += 1
        return caught

    def _watch(self) -> None:
        """The next mark of the encoder to either side, as far as a mark is the trigger."""
        if self.trigger_mode != BY_INDEX:
            return
        for direction in (1, -1):
            mark = next_index(self._controller, self.axis, direction)
            if abs(mark) < INFINITY:
                self._watches.append(self._controller.watch(self.axis, mark, self._mark, physical=True))

    def _unwatch(self) -> None:
        for watch in self._watches:
            self._controller.unwatch(self.axis, watch)
        self._watches.clear()

    def _mark(self, direction: int) -> None:
        self._unwatch()
        self._catch()
        if self.armed:
            self._watch()

    def _changed(self, channel: int, value: float) -> None:
        if not self.armed or self.trigger_mode != BY_INPUT or channel != self.input:
            return
        on = self._controller.inputs.inverted(channel)
        if self.edge == BOTH or on is (self.edge == RISING):
            self._catch()

    def _catch(self) -> None:
        now, position = self._controller.clock.now, self._place()
        near = abs(position - self.value) < self.inhibit_distance and self._time > -INFINITY
        if near or now - self._time < self.inhibit_time / 1000.0:
            return
        self.value, self._time, self.caught = position, now, True
        self.armed = bool(self.again)
        self._fired(self)

    def _place(self) -> float:
        """What is caught: where the axis is, or what its encoder has counted."""
        position = self._controller.position(self.axis)
        return position - self._controller.axes[self.axis].datum if self.source == ENCODER else position


class Latches:
    """The latch channels, each from its first use on."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._latches: dict[int, Latch] = {}

    def latch(self, channel: int) -> Latch:
        """The latch of a channel, made on first use; a catch raises LATCH."""
        latch = self._latches.get(checked(channel, LAST_LATCH, "latch channel"))
        if latch is None:
            events = self._environment.events
            latch = Latch(self._environment, 0, lambda _: events.raise_("latch", channel))
            self._latches[channel] = latch
        return latch


class FastLatches:
    """The fast latch of every axis."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._latches: dict[int, Latch] = {}

    def latch(self, axis: int) -> Latch:
        """The fast latch of an axis, made on first use; a catch raises FASTIN."""
        latch = self._latches.get(axis_of(self._environment, axis))
        if latch is None:
            events = self._environment.events
            latch = Latch(self._environment, axis, lambda fired: events.raise_("fastin", fired.input))
            self._latches[axis] = latch
        return latch

    def default(self, axis: int) -> None:
        """DEFAULT."""
        if axis in self._latches:
            self._latches.pop(axis).arm(False)


# ----------------------------------------------------------------------------------------------- operations


def _find(environment: Environment, row: Row) -> Callable[[int], Latch]:
    if row.name.startswith("FAST"):
        return environment.part(FastLatches).latch
    return environment.part(Latches).latch


def read_setting(environment: Environment, row: Row) -> Operation:
    """What a latch goes by; positions in user units of its axis, times in ms."""
    find, name, unit = _find(environment, row), SETTINGS[row.name], row.unit

    def read(channel: int) -> float:
        latch = find(channel)
        value: float = getattr(latch, name)
        return scale_of(environment, latch.axis).to_user(value) if unit == "uu" else int(value)

    return read


def write_setting(environment: Environment, row: Row) -> Operation:
    """What a latch goes by; positions in user units of its axis, times in ms."""
    find, name, unit = _find(environment, row), SETTINGS[row.name], row.unit

    def write(channel: int, value: float) -> None:
        latch = find(channel)
        if name == "axis":
            axis_of(environment, int(value))
        latch.set(name, scale_of(environment, latch.axis).to_counts(value) if unit == "uu" else value)

    return write


def read_enable(environment: Environment, row: Row) -> Operation:
    find = _find(environment, row)
    return lambda channel: int(find(channel).armed)


def write_enable(environment: Environment, row: Row) -> Operation:
    find = _find(environment, row)
    return lambda channel, armed: find(channel).arm(bool(armed))


def read_caught(environment: Environment, row: Row) -> Operation:
    find = _find(environment, row)
    return lambda channel: int(find(channel).read())


def read_value(environment: Environment, row: Row) -> Operation:
    """What was caught: a position in user units, within POSWRAP as POS shows it, an encoder's count in counts."""
    find, wraps = _find(environment, row), environment.wraps

    def read(channel: int) -> float:
        latch = find(channel)
        if latch.source == ENCODER:
            return latch.value
        shown, wrap = scale_of(environment, latch.axis).position_to_user(latch.value), wraps.get(latch.axis)
        return shown % wrap if wrap else shown

    return read


def read_encoder(environment: Environment, row: Row) -> Operation:
    """FASTENCODER: what the encoder had counted."""
    find = _find(environment, row)

    def read(axis: int) -> float:
        return find(axis).value - environment.controller.axes[axis].datum

    return read


OPERATIONS = {
    "latches.setting": {"read": read_setting, "write": write_setting},
    "latches.enable": {"read": read_enable, "write": write_enable},
    "latches.caught": {"read": read_caught},
    "latches.value": {"read": read_value},
    "latches.encoder": {"read": read_encoder},
}
# What raises the events of a kind, made for programs that handle them.
SOURCES = {"latch": Latches, "fastin": FastLatches}
