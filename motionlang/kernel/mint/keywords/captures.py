"""Data capture: quantities recorded at a fixed period, before and after a trigger.

Nothing is sampled during a capture. A point is computed from the exact motion when the program reads it.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import ceil

from motionlang.kernel.controller.clock import TimedCall
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword, value
from motionlang.kernel.mint.keywords import captures_quantities as quantities
from motionlang.kernel.mint.keywords.captures_levels import watch
from motionlang.kernel.mint.keywords.defaults import LOOP_TIME, PERIOD
from motionlang.kernel.mint.keywords.io_inputs import checked
from motionlang.kernel.mint.runtime.binding import Operation, of, of_word
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.planners import Profile

LAST_CHANNEL, LAST_TRIGGER = 7, 1
MAX_POINTS, POINTS = 100_000, 1000
IDLE, WAITING, CAPTURING, DONE = 0, 1, 2, 3
NEVER, RISING, FALLING, EITHER = 0, 1, 2, 3


@dataclass(eq=False, slots=True)
class CaptureChannel:
    """The quantity that one capture channel records.

    `axis` applies to quantities of axes; for any other quantity `parameter` is the channel.
    """

    mode: int = quantities.OFF
    axis: int = 0
    parameter: int = 0

    @property
    def where(self) -> int:
        return self.axis if quantities.is_of(self.mode) else self.parameter


class Trigger:
    """The condition that starts the recording of a waiting capture."""

    def __init__(self) -> None:
        self.mode, self.source, self.channel, self.value, self.absolute = NEVER, quantities.OFF, 0, 0.0, 0


class Capture:
    """The capture of a controller: its settings, and the present or last recording."""

    def __init__(self, environment: Environment) -> None:
        self._environment, self._clock = environment, environment.clock
        self.channels = [CaptureChannel() for _ in range(LAST_CHANNEL + 1)]
        self.triggers = [Trigger() for _ in range(LAST_TRIGGER + 1)]
        self.points, self.before = POINTS, 0
        # The setting that gives the period: the one that was written last, and its value.
        self._given = ("CAPTUREINTERVAL", 1.0)
        self.status, self.command = IDLE, 0
        self.reports_progress = False
        # The recording: when it began to wait, the time of its first point, its period, the number of points,
        # and how many of these come before the trigger.
        self._begun, self._first, self._period, self._count, self._ahead = 0.0, 0.0, 1e-3, 0, 0
        self._recorded: list[CaptureChannel] = []
        self._columns: dict[int, list[float]] = {}
        # The zeros, by time, of axes whose encoders are recorded, and the callbacks that stop recording zeros
        # and watching triggers.
        self._datums: dict[int, list[tuple[float, float]]] = {}
        self._notes: list[Callable[[], None]] = []
        self._ends: list[Callable[[], None]] = []
        self._events: list[TimedCall] = []

    # ---------------------------------------------------------------------------------------------- settings

    @property
    def tick(self) -> float:
        """The seconds between two servo ticks."""
        controller = self._environment.controller
        return controller.gain(next(iter(controller.axes)), PERIOD, LOOP_TIME) * 1e-6

    @property
    def period(self) -> float:
        """The seconds between two points."""
        name, value = self._given
        if name == "CAPTUREINTERVAL":
            return value * self.tick
        return value * 1e-6 if name == "CAPTUREPERIOD" else value * 1e-3 / self.points

    def space(self, name: str, value: float) -> None:
        """Set the period by one of three keywords; raise Rejected while a capture runs."""
        self.refuse_running()
        self._given = (name, value)

    def spacing(self, name: str) -> int:
        """Return the period in the unit of a keyword.

        CAPTUREINTERVAL is in servo ticks and CAPTUREPERIOD in µs; any other keyword is the total time in ms.
        """
        if name == "CAPTUREINTERVAL":
            return round(self.period / self.tick)
        return round(self.period * 1e6) if name == "CAPTUREPERIOD" else round(self.period * self.points * 1e3)

    def refuse_running(self) -> None:
        if self.status in (WAITING, CAPTURING):
            raise Rejected("capture-running", "a capture is running", "CAPTURE = 0 ends it")

    # -------------------------------------------------------------------------------------------- its course

    def start(self, waits: bool) -> None:
        """Start the capture; if `waits`, recording begins at one of the triggers set."""
        self.refuse_running()
        if self.points * self.period <= 0.0:
            raise Rejected("capture-points", "all points of the capture would have the same time")
        recorded = [CaptureChannel(each.mode, each.axis, each.parameter) for each in self.channels]
        for channel in recorded:
            quantities.check(self._environment, channel.mode, channel.where)
        waits = waits and any(each.mode for each in self.triggers)
        if waits:
            self._watch_triggers()  # raises Rejected now for a trigger that is not possible
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
        self._events.append(self._clock.at(now + self._ahead * self._period, self._watch_triggers))
        duration = self._ahead * self._period
        self._report_progress(lambda percent: now + duration * percent / 100.0)

    def stop(self) -> None:
        """End the capture; the points recorded so far remain."""
        if self.status == CAPTURING:
            self._count = self.taken()
        if self.status in (WAITING, CAPTURING):
            self.status = DONE if self.status == CAPTURING else IDLE
            self._forget()

    def trigger(self) -> None:
        """Start recording now."""
        if self.status in (IDLE, DONE):
            raise Rejected("capture-stopped", "no capture is running", "CAPTURECOMMAND = 1 begins one")
        if self.status == CAPTURING:
            raise Rejected("capture-triggered", "the capture has been triggered already")
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
        points, period = self._count - self._ahead, self._period
        self._report_progress(lambda percent: now + (ceil(points * percent / 100.0) - 1) * period)

    def _watch_triggers(self) -> None:
        """Watch the triggers, now that the time before the trigger has been recorded."""
        for each in self.triggers:
            if each.mode:
                on_edge = self._trigger_for(each.mode)
                where = (each.source, each.channel, each.value, bool(each.absolute))
                self._ends.append(watch(self._environment, *where, on_edge))

    def _trigger_for(self, mode: int) -> Callable[[bool], None]:
        def on_edge(rising: bool) -> None:
            if self.status == WAITING and mode in (EITHER, RISING if rising else FALLING):
                self._trigger()

        return on_edge

    def _end(self) -> None:
        self.status = DONE
        self._forget()

    def _forget(self) -> None:
        """Stop watching triggers, stop recording changes of zero, and cancel the events."""
        for end in (*self._ends, *self._notes):
            end()
        for event in self._events:
            event.cancel()
        self._ends.clear()
        self._notes.clear()
        self._events.clear()

    def _note_zeros(self) -> None:
        """Record changes of zero of the axes whose encoders are captured.

        A new zero shifts the motion of the axis but not the count of its encoder.
        """
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
        """Return the number of points recorded so far."""
        if self.status == DONE:
            return self._count
        if self.status != CAPTURING:
            return 0
        return min(int((self._clock.now - self._first) / self._period + 1e-6) + 1, self._count)

    def point(self, channel: int, index: int) -> float:
        """Return the value of a point, counted from 0."""
        if not self._recorded or self._recorded[checked(channel, LAST_CHANNEL, "capture channel")].mode == 0:
            raise Rejected(
                "channel",
                f"capture channel {channel} has recorded nothing",
                "choose what it records with CAPTUREMODE",
            )
        taken = self.taken()
        if not 0 <= index < taken:
            there = f"there are points 0 to {taken - 1}" if taken else "there are none yet"
            raise Rejected("range", f"the capture has no point {index}", there)
        column = self._columns.setdefault(channel, [])
        if index >= len(column):
            what = self._recorded[channel]
            times = [min(self._first + k * self._period, self._clock.now) for k in range(len(column), taken)]
            datums = self._datums.get(what.where, [])
            column += quantities.column(self._environment, what.mode, what.where, times, datums)
        return column[index]

    def progress(self, after: int) -> int:
        """Return the progress in percent, `after` the trigger or before it.

        After the trigger this is the fraction of points recorded, before it the fraction of the pre-trigger time.
        """
        if after:
            share = (self.taken() - self._ahead) / (self._count - self._ahead) if self.taken() else 0.0
        elif self.status == WAITING and self._ahead:
            share = (self._clock.now - self._begun) / (self._ahead * self._period)
        else:
            share = float(self.status != IDLE)
        return min(int(share * 100.0 + 1e-6), 100)

    def _report_progress(self, reached_at: Callable[[int], float]) -> None:
        """Schedule an event at each percent, so that polling tasks check again.

        `reached_at` returns the time of a percent.
        """
        if not self.reports_progress:
            return

        def step(percent: int) -> None:
            while percent < 100 and reached_at(percent) <= self._clock.now:
                percent += 1
            if percent < 100:
                self._events.append(self._clock.at(reached_at(percent), lambda: step(percent + 1)))

        step(1)


# ----------------------------------------------------------------------------------------------- operations


def _channel_or_trigger(capture: Capture, row: Keyword, number: int) -> CaptureChannel | Trigger:
    if row.index == "trigger":
        return capture.triggers[checked(number, LAST_TRIGGER, "trigger")]
    return capture.channels[checked(number, LAST_CHANNEL, "capture channel")]


def read_attribute(capture: Capture, row: Keyword, number: int) -> object:
    return getattr(_channel_or_trigger(capture, row, number), row.attribute)


def write_attribute(capture: Capture, row: Keyword, number: int, value: float) -> None:
    """Set the quantity of a channel or the condition of a trigger.

    Raises Rejected while a capture runs.
    """
    target = _channel_or_trigger(capture, row, number)
    capture.refuse_running()
    setattr(target, row.attribute, value)


def read_name(capture: Capture, channel: int) -> str:
    return quantities.NAMES[capture.channels[checked(channel, LAST_CHANNEL, "capture channel")].mode]


def write_points(capture: Capture, points: int) -> None:
    """CAPTURENUMPOINTS: set the number of points; raise Rejected while a capture runs."""
    capture.refuse_running()
    if not 1 <= points <= MAX_POINTS:
        words = f"a capture cannot have {points} points"
        raise Rejected("capture-points", words, f"it takes 1 to {MAX_POINTS}")
    capture.points = points


def write_before(capture: Capture, milliseconds: float) -> None:
    """CAPTUREPRETRIGGERDURATION: set the time before the trigger in ms.

    Raises Rejected while a capture runs.
    """
    capture.refuse_running()
    capture.before = int(milliseconds)


def read_running(capture: Capture) -> int:
    """CAPTURE: return 1 while a capture runs."""
    return int(capture.status in (WAITING, CAPTURING))


def write_running(capture: Capture, command: int, triggered: bool = False) -> None:
    """CAPTURE: start a capture at once, or end it with 0.

    With `triggered` the capture waits for its triggers.
    """
    if command:
        capture.start(triggered)
    else:
        capture.stop()
    capture.command = command


def write_command(capture: Capture, command: int) -> None:
    """CAPTURECOMMAND: start a capture that waits for its triggers, or end it with 0."""
    write_running(capture, command, triggered=True)


def read_progress(environment: Environment, row: Keyword) -> Operation:
    capture = environment.component(Capture)
    capture.reports_progress = True
    return lambda after: capture.progress(checked(after, 1, "part of a capture"))


# ------------------------------------------------------------------------------------------------- keywords


def _attribute(name: str) -> Actions:
    return Actions(
        read=of_word(Capture, read_attribute), write=of_word(Capture, write_attribute), attribute=name
    )


_POINTS = Actions(read=of(Capture, lambda capture: capture.points), write=of(Capture, write_points))
# CAPTUREINTERVAL in ticks, CAPTUREPERIOD in µs, CAPTUREDURATION in ms: the last one written applies.
_SPACING = Actions(
    read=of_word(Capture, lambda capture, row: capture.spacing(row.name)),
    write=of_word(Capture, lambda capture, row, value: capture.space(row.name, value)),
)
_BEFORE = Actions(read=of(Capture, lambda capture: capture.before), write=of(Capture, write_before))
_RUNNING = Actions(read=of(Capture, read_running), write=of(Capture, write_running))
_COMMAND = Actions(read=of(Capture, lambda capture: capture.command), write=of(Capture, write_command))

# The quantities in order, a short form of `motionlang.kernel.mint.keywords.captures_quantities.NAMES`.
QUANTITIES = (
    "0 nothing, 1 measured position, 2 measured velocity, 3 demand position, 4 demand velocity, 5 demand acceleration, "
    "6 following error, 7 drive output in percent, 8 torque of the motor in N m, 9 encoder, 10 auxiliary encoder, "
    "11 analogue input, 12 analogue output, 13 bank of digital inputs, 14 bank of digital outputs"
)
_RUN = (
    "CAPTUREMODE(0) = 3\nCAPTURENUMPOINTS = 11\nCAPTURE = 1\nMOVER(0) = 100\nGO(0)\nPAUSE CAPTURESTATUS = 3\n"
    "PRINT {}"
)

_word = partial(value, group="capture")


def _channel(
    name: str, short: str, actions: Actions, index: str, unit: str, help: str, high: float, low: float = 0
) -> Keyword:
    return _word(
        name, short, "RW", index, unit, actions, help, f"{name}(0) = 1\nPRINT {name}(0)", 0.0, low, high
    )


ROWS = (
    _channel("CAPTUREMODE", "cpm", _attribute("mode"), "channel", "integer",
             f"Quantity that a channel of the capture records: {QUANTITIES}.", 14),
    _channel("CAPTUREAXIS", "", _attribute("axis"),
             "channel", "integer", "The axis whose quantity a channel records.", 63),
    _channel("CAPTUREMODEPARAMETER", "cpmp", _attribute("parameter"), "channel", "integer",
             "The encoder, the analogue channel or the bank that a channel records.", 999),
    Keyword("CAPTUREMODENAME", "", "reading", "R", "channel", "text", Actions(read=of(Capture, read_name)),
            "Name of the quantity that a channel records.", "CAPTUREMODE(0) = 3\nPRINT CAPTUREMODENAME(0)",
            group="capture"),
    _word("CAPTURENUMPOINTS", "", "RW", "none", "integer", _POINTS, "Number of points that a channel records.",
          "CAPTURENUMPOINTS = 100\nPRINT CAPTURENUMPOINTS", 1000.0),
    _word("CAPTUREINTERVAL", "cpi", "RW", "none", "integer", _SPACING, "Servo ticks (LOOPTIME) from point to point.",
          "CAPTUREINTERVAL = 2\nPRINT CAPTUREPERIOD", 1.0, 1, 2147483647),
    _word("CAPTUREPERIOD", "cpp", "RW", "none", "integer", _SPACING, "Microseconds from point to point.",
          "CAPTUREPERIOD = 500\nPRINT CAPTUREDURATION", 1000.0, 1, 2147483647),
    _word("CAPTUREDURATION", "cpr", "RW", "none", "ms", _SPACING,
          "The length of a capture; its points are this divided by their number apart.",
          "CAPTUREDURATION = 500\nPRINT CAPTUREPERIOD", 1000.0, 1, 2147483647.0),
    _word("CAPTUREPRETRIGGERDURATION", "", "RW", "none", "ms", _BEFORE,
          "Time that a capture records before its trigger; earlier triggers are ignored.",
          "CAPTUREPRETRIGGERDURATION = 50\nPRINT CAPTUREPRETRIGGERDURATION", 0.0, 0, 2147483647.0),
    _channel("CAPTURETRIGGERMODE", "", _attribute("mode"), "trigger", "integer",
             "Trigger of a capture: 0 none, 1 the source rising through the value, 2 falling, 3 either.", 3),
    _channel("CAPTURETRIGGERSOURCE", "", _attribute("source"), "trigger", "integer",
             "The quantity that triggers a capture, numbered as in CAPTUREMODE; "
             "for digital channels, one channel only.", 14),
    _channel("CAPTURETRIGGERCHANNEL", "", _attribute("channel"), "trigger", "integer",
             "The axis, the encoder or the channel whose quantity triggers a capture.", 999),
    _channel("CAPTURETRIGGERVALUE", "", _attribute("value"), "trigger", "number",
             "The value that the source must pass.", 8388607.0, -8388607.0),
    _channel("CAPTURETRIGGERABSOLUTE", "", _attribute("absolute"), "trigger", "bool",
             "1: the source counts without its sign.", 1),
    Keyword("CAPTURETRIGGER", "", "command", "C", "none", "", Actions(do=of(Capture, Capture.trigger)),
            "Trigger the capture that waits.",
            "CAPTURETRIGGERMODE(0) = 1\nCAPTURETRIGGERSOURCE(0) = 13\nCAPTURECOMMAND = 1\nCAPTURETRIGGER\n"
            "PRINT CAPTURESTATUS", group="capture"),
    _word("CAPTURE", "", "RW", "none", "bool", _RUNNING,
          "1 begins a capture at once, 0 ends it; 1 while one is running.",
          _RUN.format("CAPTURE"), 0.0, 0, 1),
    _word("CAPTURECOMMAND", "", "RW", "none", "integer", _COMMAND,
          "1 begins a capture, which waits for its triggers where any is set; 0 ends it.",
          _RUN.replace("CAPTURE = 1", "CAPTURECOMMAND = 1").format("CAPTURECOMMAND"), 0.0, 0, 1),
    _word("CAPTURESTATUS", "", "R", "none", "integer", Actions(read=of(Capture, lambda capture: capture.status)),
          "0 no capture, 1 it waits for its trigger, 2 it records, 3 it is done.", _RUN.format("CAPTURESTATUS")),
    _word("CAPTUREPROGRESS", "", "R", "part", "integer", Actions(read=read_progress),
          "Percent recorded: part 0 before the trigger, part 1 after it.",
          _RUN.format("CAPTUREPROGRESS(1)")),
    _word("CAPTUREPOINT", "", "R", "channel, point", "number", Actions(read=of(Capture, Capture.point)),
          "A point of a channel, counted from 0.",
          _RUN.format("CAPTUREPOINT(0, 10)")),
)  # fmt: skip
