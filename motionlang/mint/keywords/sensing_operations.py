"""What an axis and its encoder tell: kind of motion, demands, targets, idle windows, encoder counts, wraps."""

from __future__ import annotations

from math import floor

from motionlang.controller.faults import Refusal
from motionlang.controller.moves import buffer
from motionlang.lang.task import INFINITY
from motionlang.mint.keywords.defaults import IDLE
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import Changes, always, moving, passing_within, repeatable

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.keywords.compensation_operations import Compensation
    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment

    Operation = Callable[..., object]

# AXISMODE: the bit of each kind of motion, by the keyword that began it. 0 is idle; the bits are our own.
KINDS: dict[int, tuple[str, ...]] = {
    1: ("MOVEA", "MOVER", "INCA", "INCR", "MOVEDWELL"),
    2: ("JOG", "JOGCOMMAND", "FREQ"),
    4: ("HOME", "DATUM"),
    8: ("VECTORA", "VECTORR", "CIRCLEA", "CIRCLER", "HELIXA", "HELIXR"),
    16: ("FOLLOW",),
    32: ("CAM",),
    64: ("FLY",),
    128: ("SPLINE",),
    256: ("OFFSET",),
}
OTHER, SUSPENDED = 512, 1024
_BITS = {word: bit for bit, words in KINDS.items() for word in words}


def read_axis_mode(environment: Environment, row: Row) -> Operation:
    """AXISMODE: a bit for the kind of motion, 0 at rest, and one more while it is suspended."""
    axes = environment.controller.axes

    def read(axis: int) -> int:
        a = axes[axis_of(environment, axis)]
        if a.move is None:
            return 0
        return _BITS.get(a.move.command, OTHER) | (SUSPENDED if a.suspended else 0)

    return read


@moving
def read_acceleration(environment: Environment, row: Row) -> Operation:
    """ACCELDEMAND, user units a second squared."""
    axes, clock = environment.controller.axes, environment.clock

    def read(axis: int) -> float:
        scale = scale_of(environment, axis)
        return scale.to_user(axes[axis].at(clock.now).acceleration, row.unit)

    return read


@moving
def read_target(environment: Environment, row: Row) -> Operation:
    """POSTARGET; of motion without an end, where the axis is."""
    target = environment.controller.target
    return lambda axis: _shown(environment, axis, target(axis_of(environment, axis)))


@moving
def read_last_target(environment: Environment, row: Row) -> Operation:
    """POSTARGETLAST: where the axis will be when its buffer is empty."""
    axes = environment.controller.axes
    return lambda axis: _shown(environment, axis, buffer.end(axes[axis_of(environment, axis)]))


def _shown(environment: Environment, axis: int, target: float) -> float:
    """An end in user units, within POSWRAP, as POSROLLOVERTARGET tells the turn; the position where there is none."""
    scale, wrap = scale_of(environment, axis), environment.wraps.get(axis)
    counts = target if abs(target) < 1e300 else environment.controller.position(axis)
    shown = scale.position_to_user(counts)
    return shown % wrap if wrap else shown


@always
def read_seconds(environment: Environment, row: Row) -> Operation:
    clock = environment.clock
    return lambda: float(clock.now)


# --------------------------------------------------------------------------------------------- idle windows

AT_POSITION, AT_SPEED = 1, 2


class IdleWindows:
    """What IDLE asks for beyond the end of the move, by keyword and axis, in counts."""

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self._settings: dict[tuple[str, int], float] = {}
        self._since: dict[int, float] = {}
        self._controller.listeners.append(self._heard, "idle")
        environment.settled = self.settled

    def setting(self, name: str, axis: int) -> float:
        return self._settings.get((name, axis), IDLE[name])

    def set(self, name: str, axis: int, value: float) -> None:
        self._settings[name, axis] = value
        self._tell_motor(axis)

    def _tell_motor(self, axis: int) -> None:
        """Let a simulated motor know what settling means."""
        mode, far = int(self.setting("IDLEMODE", axis)), float("inf")
        self._controller.settle_within(
            axis,
            self.setting("IDLEPOS", axis) if mode & AT_POSITION else far,
            self.setting("IDLEVEL", axis) if mode & AT_SPEED else far,
            self.setting("IDLETIME", axis) / 1000.0,
        )

    def settled(self, axis: int) -> bool:
        """Whether an axis whose move is over is inside its windows, and has been for IDLETIME."""
        mode = int(self.setting("IDLEMODE", axis))
        if not mode:
            return True
        controller = self._controller
        if controller.is_open(axis):
            return True  # nothing holds the motor: there is no error to settle
        if controller.has_motor(axis) and controller.settled_time(axis) > controller.clock.now:
            return False
        if mode & AT_POSITION and abs(controller.following_error(axis)) > self.setting("IDLEPOS", axis):
            return False
        if mode & AT_SPEED and abs(controller.velocity(axis)) > self.setting("IDLEVEL", axis):
            return False
        rest = controller.clock.now - self._since.get(axis, -1e300)
        return rest >= self.setting("IDLETIME", axis) / 1000.0

    def settling_time(self, axis: int) -> int:
        """Milliseconds from the end of the move to IDLE: IDLETIME, and what a simulated motor needed before it."""
        if not self.setting("IDLEMODE", axis):
            return 0
        late = 0.0
        if self._controller.has_motor(axis) and axis in self._since:
            late = min(max(self._controller.settled_since(axis) - self._since[axis], 0.0), 1e6)
        return round(late * 1000.0) + int(self.setting("IDLETIME", axis))

    def _heard(self, what: str, axis: int) -> None:
        """The move is over: IDLETIME later whoever waits for IDLE must look again."""
        if what == "idle":
            clock = self._controller.clock
            self._since[axis] = clock.now
            clock.at(clock.now + self.setting("IDLETIME", axis) / 1000.0, lambda: None)

    def default(self, axis: int) -> None:
        """DEFAULT."""
        for name in IDLE:
            self._settings.pop((name, axis), None)
        self._tell_motor(axis)


def read_window(environment: Environment, row: Row) -> Operation:
    """IDLEPOS and IDLEVEL in user units, IDLETIME in ms, IDLEMODE."""
    windows, name, unit = environment.part(IdleWindows), row.name, row.unit

    def read(axis: int) -> float:
        value = scale_of(environment, axis).to_user(windows.setting(name, axis), unit)
        return value if unit.startswith("uu") else int(value)

    return read


@repeatable
def write_window(environment: Environment, row: Row) -> Operation:
    """IDLEPOS and IDLEVEL in user units, IDLETIME in ms, IDLEMODE."""
    windows, name, unit = environment.part(IdleWindows), row.name, row.unit

    def write(axis: int, value: float) -> None:
        row.check(value)
        windows.set(name, axis, scale_of(environment, axis).to_counts(value, unit))

    return write


def read_settling_time(environment: Environment, row: Row) -> Operation:
    """IDLESETTLINGTIME, ms."""
    windows = environment.part(IdleWindows)

    def read(axis: int) -> int:
        axis_of(environment, axis)
        return windows.settling_time(axis)

    return read


# ------------------------------------------------------------------------------------------------- encoders


class Encoders:
    """The encoders of the axes, which count on whatever zero the program gives to an axis, and those of the machine
    file, which take the place of an axis's where they have the same number.

    What an encoder shows is its counts / ENCODERPRESCALE / ENCODERSCALE, from the value it was given, within
    ENCODERWRAP.
    """

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self.changes = environment.part(Changes)
        self._settings: dict[tuple[str, int], float] = {}
        # What the motors do on top of what POS shows, where the program compensates.
        self.compensation: Compensation | None = None

    def setting(self, name: str, channel: int) -> float:
        return self._settings.get((name, channel), 0.0 if name in ("ENCODERWRAP", "zero") else 1.0)

    def set(self, name: str, channel: int, value: float) -> None:
        self._settings[name, channel] = value

    def counts(self, channel: int) -> float:
        if channel in self._controller.encoders:
            return self._controller.encoder_position(channel)
        shift = self.compensation.shift(channel) if self.compensation is not None else 0.0
        return self._controller.position(channel) + shift - self._controller.axes[channel].datum

    def read(self, channel: int) -> float:
        return self.shown(channel, self.counts(channel))

    def until(self, channel: int, level: float | None) -> float:
        """When what an encoder of the machine file shows passes a level; one of an axis may at any time."""
        track = self.track(channel)
        if level is None or level == INFINITY or track not in self._controller.encoders:
            return self.changes.moving()
        zero, per_unit = self.setting("zero", channel), self.per_unit(channel)
        crossing_time = self._controller.encoder_crossing_time
        return passing_within(
            self.setting("ENCODERWRAP", channel),
            self.counts(channel) / per_unit + zero,
            level,
            lambda place: crossing_time(track, (place - zero) * per_unit),
        )

    def track(self, channel: int) -> int:
        """The number under which the controller has an encoder that the world turns."""
        return channel

    def shown(self, channel: int, counts: float) -> float:
        """What an encoder shows at a count."""
        shown = counts / self.per_unit(channel) + self.setting("zero", channel)
        wrap = self.setting("ENCODERWRAP", channel)
        return shown % wrap if wrap else shown

    def write(self, channel: int, value: float) -> None:
        self.set("zero", channel, value - self.counts(channel) / self.per_unit(channel))

    def speed(self, channel: int) -> float:
        return self.velocity(channel) / self.per_unit(channel)

    def velocity(self, channel: int) -> float:
        """In counts a second."""
        if channel in self._controller.encoders:
            return self._controller.encoder_velocity(channel)
        shift = self.compensation.rate(channel) if self.compensation is not None else 0.0
        return self._controller.velocity(channel) + shift

    def per_unit(self, channel: int) -> float:
        """Counts in one unit of what the encoder shows."""
        return self.setting("ENCODERSCALE", channel) * self.setting("ENCODERPRESCALE", channel)


def channel_of(environment: Environment, channel: int) -> int:
    """The encoder channel, or the refusal of one that does not exist: those of the axes and of the machine file."""
    if channel not in environment.controller.axes and channel not in environment.controller.encoders:
        axes = list(environment.controller.axes)
        hint = f"the encoders are those of axes {axes[0]} to {axes[-1]}"
        raise Refusal("channel", f"there is no encoder {channel}", hint)
    return channel


def read_encoder(environment: Environment, row: Row) -> Operation:
    encoders = environment.part(Encoders)
    return encoders.changes.comparable(
        lambda channel: encoders.read(channel_of(environment, channel)), encoders.until
    )


def write_encoder(environment: Environment, row: Row) -> Operation:
    encoders = environment.part(Encoders)
    return lambda channel, value: encoders.write(channel_of(environment, channel), value)


@moving
def read_encoder_speed(environment: Environment, row: Row) -> Operation:
    encoders = environment.part(Encoders)
    return lambda channel: encoders.speed(channel_of(environment, channel))


@moving
def read_encoder_count(environment: Environment, row: Row) -> Operation:
    encoders = environment.part(Encoders)
    return lambda channel: floor(encoders.counts(channel_of(environment, channel)) + 0.5)


def read_encoder_setting(environment: Environment, row: Row) -> Operation:
    """ENCODERSCALE, ENCODERPRESCALE and ENCODERWRAP."""
    encoders, name, whole = environment.part(Encoders), row.name, row.unit == "integer"

    def read(channel: int) -> float:
        value = encoders.setting(name, channel_of(environment, channel))
        return int(value) if whole else value

    return read


def write_encoder_setting(environment: Environment, row: Row) -> Operation:
    """ENCODERSCALE, ENCODERPRESCALE and ENCODERWRAP."""
    encoders, name = environment.part(Encoders), row.name

    def write(channel: int, value: float) -> None:
        row.check(value)
        encoders.set(name, channel_of(environment, channel), value)

    return write


# ---------------------------------------------------------------------------------------------------- wraps


class Wraps:
    """POSWRAP of every axis in counts: another scale shows it, as any setting that was made before, in other units."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._counts: dict[int, float] = {}
        environment.controller.listeners.append(self._heard, "scale")

    def set(self, axis: int, value: float) -> None:
        self._environment.wraps[axis] = value
        self._counts[axis] = value * abs(scale_of(self._environment, axis).counts)

    def _heard(self, what: str, axis: int) -> None:
        if what == "scale" and axis in self._counts:
            self._environment.wraps[axis] = self._counts[axis] / abs(scale_of(self._environment, axis).counts)


def read_wrap(environment: Environment, row: Row) -> Operation:
    return lambda axis: environment.wraps.get(axis_of(environment, axis), 0.0)


def write_wrap(environment: Environment, row: Row) -> Operation:
    """POSWRAP, user units."""
    wraps = environment.part(Wraps)

    def write(axis: int, value: float) -> None:
        row.check(value)
        wraps.set(axis_of(environment, axis), value)

    return write


@moving
def read_turns(environment: Environment, row: Row) -> Operation:
    """POSROLLOVER: how many times POS has wrapped."""
    controller = environment.controller

    def read(axis: int) -> int:
        wrap = environment.wraps.get(axis)
        scale = scale_of(environment, axis)
        return floor(scale.position_to_user(controller.position(axis)) / wrap) if wrap else 0

    return read


def write_turns(environment: Environment, row: Row) -> Operation:
    """POSROLLOVER: the position grows by the turns that are more, POS stays."""
    turns = read_turns(environment, row)

    def write(axis: int, value: int) -> None:
        before: int = turns(axis)
        counts = scale_of(environment, axis).to_counts((value - before) * environment.wraps.get(axis, 0.0))
        environment.controller.define_position(axis, environment.controller.position(axis) + counts)

    return write


OPERATIONS = {
    "sensing.axis_mode": {"read": read_axis_mode},
    "sensing.acceleration": {"read": read_acceleration},
    "sensing.target": {"read": read_target},
    "sensing.last_target": {"read": read_last_target},
    "sensing.window": {"read": read_window, "write": write_window},
    "sensing.settling_time": {"read": read_settling_time},
    "sensing.seconds": {"read": read_seconds},
    "sensing.encoder": {"read": read_encoder, "write": write_encoder},
    "sensing.encoder_speed": {"read": read_encoder_speed},
    "sensing.encoder_count": {"read": read_encoder_count},
    "sensing.encoder_setting": {"read": read_encoder_setting, "write": write_encoder_setting},
    "sensing.wrap": {"read": read_wrap, "write": write_wrap},
    "sensing.turns": {"read": read_turns, "write": write_turns},
}
