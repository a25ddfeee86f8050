"""Data capture: quantities recorded at instants of its own, from a trigger on and for a while before it.

Nothing is sampled while it runs. What a point is, is worked out when the program reads it, from the exact motion.
"""

from __future__ import annotations

from math import ceil

from motionlang.controller.faults import Refusal
from motionlang.mint.keywords import captures_quantities as quantities
from motionlang.mint.keywords.captures_levels import watch
from motionlang.mint.keywords.defaults import LOOP_TIME, PERIOD
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.runtime.binding import of, of_word

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.controller.clock import Event
    from motionlang.mint.runtime.binding import Operation, Row
    from motionlang.mint.runtime.environment import Environment
    from motionlang.profile import Profile

LAST_CHANNEL, LAST_TRIGGER = 7, 1
MOST_POINTS, POINTS = 100_000, 1000
IDLE, WAITING, CAPTURING, DONE = 0, 1, 2, 3
NEVER, RISING, FALLING, EITHER = 0, 1, 2, 3


class Channel:
    """What one channel records; the axis of a quantity of axes, the parameter is the channel of any other."""

    __slots__ = ("axis", "mode", "parameter")

    def __init__(self, mode: int = quantities.OFF, axis: int = 0, parameter: int = 0) -> None:
        self.mode, self.axis, self.parameter = mode, axis, parameter

    @property
    def where(self) -> int:
        return self.axis if quantities.is_of(self.mode) else self.parameter


class Trigger:
    """When a capture that waits begins to record."""

    __slots__ = ("absolute", "channel", "mode", "source", "value")

    def __init__(self) -> None:
        self.mode, self.source, self.channel, self.value, self.absolute = NEVER, quantities.OFF, 0, 0.0, 0


class Capture:
    """The capture of a controller: its settings, and the one that runs or was run last."""

    def __init__(self, environment: Environment) -> None:
        self._environment, self._clock = environment, environment.clock
        self.channels = [Channel() for _ in range(LAST_CHANNEL + 1)]
        self.triggers = [Trigger() for _ in range(LAST_TRIGGER + 1)]
        self.points, self.before = POINTS, 0
        # How far apart the points are: the setting that was written last, and its value.
        self._given = ("CAPTUREINTERVAL", 1.0)
        self.status, self.command = IDLE, 0
        self.tells_progress = False
        # The capture: when it began to wait, when its first point is, how far apart they are, and how many.
        self._begun, self._first, self._period, self._count, self._ahead = 0.0, 0.0, 1e-3, 0, 0
        self._recorded: list[Channel] = []
        self._columns: dict[int, list[float]] = {}
        # The zeros of axes whose encoders are recorded, by time; what ends the noting of them, and that of triggers.
        self._datums: dict[int, list[tuple[float, float]]] = {}
        self._notes: list[Callable[[], None]] = []
        self._ends: list[Callable[[], None]] = []
        self._events: list[Event] = []

    # ---------------------------------------------------------------------------------------------- settings

    @property
    def tick(self) -> float:
        """Seconds between two servo ticks."""
        controller = self._environment.controller
        return controller.gain(next(iter(controller.axes)), PERIOD, LOOP_TIME) * 1e-6

    @property
    def period(self) -> float:
        """Seconds between two points."""
        name, value = self._given
        if name == "CAPTUREINTERVAL":
            return value * self.tick
        return value * 1e-6 if name == "CAPTUREPERIOD" else value * 1e-3 / self.points

    def space(self, name: str, value: float) -> None:
        """Set how far apart the points are, by one of three words."""
        self.refuse_running()
        self._given = (name, value)

    def spacing(self, name: str) -> int:
        """How far apart the points are: in ticks, in us, or as the whole time in ms."""
        if name == "CAPTUREINTERVAL":
            return round(self.period / self.tick)
        return round(self.period * 1e6) if name == "CAPTUREPERIOD" else round(self.period * self.points * 1e3)

    def refuse_running(self) -> None:
        if self.status in (WAITING, CAPTURING):
            raise Refusal("capture-running", "a capture is running", "CAPTURE = 0 ends it")

    # -------------------------------------------------------------------------------------------- its course

    def start(self, waits: bool) -> None:
        """Begin; with `waits` for one of the triggers, as far as any is set."""
        self.refuse_running()
        if self.points * self.period <= 0.0:
            raise Refusal("capture-points", "the points of the capture would all be at one time")
        recorded = [Channel(each.mode, each.axis, each.parameter) for each in self.channels]
        for channel in recorded:
            quantities.check(self._environment, channel.mode, channel.where)
        waits = waits and any(each.mode for each in self.triggers)
        if waits:
            self._look()  # a trigger that cannot be is refused now
        self._forget()
        now = self._clock.now
        self._recorded, self._columns = recorded, {}
        self._begun, self._period, self._count = now, self.period, self.points
        self._ahead = min(int(self.before * 1e-3 / self._period + 1e-9), self.points - 1) if waits else 0
        self._note_zeros()
        self.status = WAITING
        if not waits:
            self._trigger()
            return
        self._events.append(self._clock.at(now + self._ahead * self._period, self._look))
        self._tell_progress(now, self._ahead)

    def stop(self) -> None:
        """End it; the points that were taken stay."""
        if self.status == CAPTURING:
            self._count = self.taken()
        if self.status in (WAITING, CAPTURING):
            self.status = DONE if self.status == CAPTURING else IDLE
            self._forget()

    def trigger(self) -> None:
        """Begin to record now."""
        if self.status in (IDLE, DONE):
            raise Refusal("capture-stopped", "no capture is running", "CAPTURECOMMAND = 1 begins one")
        if self.status == CAPTURING:
            raise Refusal("capture-triggered", "the capture has been triggered already")
        self._trigger()

    def _trigger(self) -> None:
        for end in self._ends:
            end()
        self._ends.clear()
        now = self._clock.now
        self._ahead = min(self._ahead, int((now - self._begun) / self._period + 1e-9))
        self._first, self.status = now - self._ahead * self._period, CAPTURING
        last = max(self._first + (self._count - 1) * self._period, now)
        self._events.append(self._clock.at(last, self._end))
        self._tell_progress(now, self._count - self._ahead)

    def _look(self) -> None:
        """What is before the trigger is full: from now on one may come."""
        for each in self.triggers:
            if each.mode:
                told = self._told_by(each.mode)
                where = (each.source, each.channel, each.value, bool(each.absolute))
                self._ends.append(watch(self._environment, *where, told))

    def _told_by(self, mode: int) -> Callable[[bool], None]:
        def told(rising: bool) -> None:
            if self.status == WAITING and mode in (EITHER, RISING if rising else FALLING):
                self._trigger()

        return told

    def _end(self) -> None:
        self.status = DONE
        self._forget()

    def _forget(self) -> None:
        """Nothing is waited for, and no zeros are noted any more."""
        for end in (*self._ends, *self._notes):
            end()
        for event in self._events:
            event.cancel()
        self._ends.clear()
        self._notes.clear()
        self._events.clear()

    def _note_zeros(self) -> None:
        """Encoders of axes do not know of new zeros: note them, as the motion has them in it."""
        axes = self._environment.controller.axes
        self._datums = {}
        for channel in self._recorded:
            if (
                channel.mode == quantities.ENCODER
                and channel.where in axes
                and channel.where not in self._datums
            ):
                self._datums[channel.where] = self._noted(channel.where)

    def _noted(self, axis: int) -> list[tuple[float, float]]:
        a, clock = self._environment.controller.axes[axis], self._clock
        noted = [(clock.now, a.datum)]

        def follow(_: Profile) -> None:
            if a.datum != noted[-1][1]:
                noted.append((clock.now, a.datum))

        self._notes.append(self._environment.controller.follow_profiles(axis, follow))
        return noted

    # ------------------------------------------------------------------------------------------- its results

    def taken(self) -> int:
        """How many points there are so far."""
        if self.status == DONE:
            return self._count
        if self.status != CAPTURING:
            return 0
        return min(int((self._clock.now - self._first) / self._period + 1e-6) + 1, self._count)

    def point(self, channel: int, index: int) -> float:
        """A point, counted from 0."""
        if not self._recorded or self._recorded[checked(channel, LAST_CHANNEL, "capture channel")].mode == 0:
            raise Refusal(
                "channel",
                f"capture channel {channel} has recorded nothing",
                "CAPTUREMODE says what it records",
            )
        taken = self.taken()
        if not 0 <= index < taken:
            there = f"there are points 0 to {taken - 1}" if taken else "there are none yet"
            raise Refusal("range", f"the capture has no point {index}", there)
        column = self._columns.setdefault(channel, [])
        if index >= len(column):
            what = self._recorded[channel]
            times = [min(self._first + k * self._period, self._clock.now) for k in range(len(column), taken)]
            datums = self._datums.get(what.where, [])
            column += quantities.column(self._environment, what.mode, what.where, times, datums)
        return column[index]

    def progress(self, after: int) -> int:
        """Percent of the points from the trigger on, or of the time that must pass before it."""
        if after:
            share = (self.taken() - self._ahead) / (self._count - self._ahead) if self.taken() else 0.0
        elif self.status == WAITING and self._ahead:
            share = (self._clock.now - self._begun) / (self._ahead * self._period)
        else:
            share = float(self.status != IDLE)
        return min(int(share * 100.0 + 1e-6), 100)

    def _tell_progress(self, begin: float, points: int) -> None:
        """Let whoever polls look again at each percent."""
        if not self.tells_progress or points <= 1:
            return

        def step(percent: int) -> None:
            at = begin + ceil(points * percent / 100.0) * self._period
            if percent < 100:
                self._events.append(self._clock.at(max(at, self._clock.now), lambda: step(percent + 1)))

        step(1)


# ----------------------------------------------------------------------------------------------- operations


def _part(capture: Capture, row: Row, number: int) -> Channel | Trigger:
    """The channel or the trigger of which a word is an attribute."""
    if row.index == "trigger":
        return capture.triggers[checked(number, LAST_TRIGGER, "trigger")]
    return capture.channels[checked(number, LAST_CHANNEL, "capture channel")]


def read_attribute(capture: Capture, row: Row, number: int) -> object:
    return getattr(_part(capture, row, number), row.attribute)


def write_attribute(capture: Capture, row: Row, number: int, value: float) -> None:
    """What a channel records, and what a trigger waits for; refused while a capture runs."""
    part = _part(capture, row, number)
    capture.refuse_running()
    setattr(part, row.attribute, value)


def read_name(capture: Capture, channel: int) -> str:
    return quantities.NAMES[capture.channels[checked(channel, LAST_CHANNEL, "capture channel")].mode]


def write_points(capture: Capture, points: int) -> None:
    """CAPTURENUMPOINTS; refused while a capture runs."""
    capture.refuse_running()
    if not 1 <= points <= MOST_POINTS:
        words = f"a capture cannot have {points} points"
        raise Refusal("capture-points", words, f"it takes 1 to {MOST_POINTS}")
    capture.points = points


def write_before(capture: Capture, milliseconds: float) -> None:
    """CAPTUREPRETRIGGERDURATION, ms; refused while a capture runs."""
    capture.refuse_running()
    capture.before = int(milliseconds)


def read_running(capture: Capture, row: Row) -> int:
    """CAPTURE, and CAPTURECOMMAND, which tells of the command that was given last."""
    if row.name == "CAPTURECOMMAND":
        return capture.command
    return int(capture.status in (WAITING, CAPTURING))


def write_running(capture: Capture, row: Row, command: int) -> None:
    """CAPTURE begins at once, CAPTURECOMMAND waits for a trigger; 0 ends either."""
    if command:
        capture.start(row.name == "CAPTURECOMMAND")
    else:
        capture.stop()
    capture.command = command


def read_progress(environment: Environment, row: Row) -> Operation:
    capture = environment.part(Capture)
    capture.tells_progress = True
    return lambda after: capture.progress(checked(after, 1, "part of a capture"))


_ATTRIBUTE = {"read": of_word(Capture, read_attribute), "write": of_word(Capture, write_attribute)}
OPERATIONS = {
    **{f"captures.channel.{each}": _ATTRIBUTE for each in Channel.__slots__},
    **{f"captures.trigger.{each}": _ATTRIBUTE for each in Trigger.__slots__},
    "captures.name": {"read": of(Capture, read_name)},
    "captures.points": {
        "read": of(Capture, lambda capture: capture.points),
        "write": of(Capture, write_points),
    },
    # CAPTUREINTERVAL in ticks, CAPTUREPERIOD in µs, CAPTUREDURATION in ms: the last one written holds.
    "captures.spacing": {
        "read": of_word(Capture, lambda capture, row: capture.spacing(row.name)),
        "write": of_word(Capture, lambda capture, row, value: capture.space(row.name, value)),
    },
    "captures.before": {
        "read": of(Capture, lambda capture: capture.before),
        "write": of(Capture, write_before),
    },
    "captures.trigger": {"do": of(Capture, Capture.trigger)},
    "captures.running": {"read": of_word(Capture, read_running), "write": of_word(Capture, write_running)},
    "captures.status": {"read": of(Capture, lambda capture: capture.status)},
    "captures.progress": {"read": read_progress},
    "captures.point": {"read": of(Capture, Capture.point)},
}
