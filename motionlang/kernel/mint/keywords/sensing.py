"""State of axes and encoders: motion, targets, idle windows, counts, wraps."""

from __future__ import annotations

from collections.abc import Callable
from math import floor
from typing import TYPE_CHECKING

from motionlang.kernel.controller.axis import Axis
from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.queue import buffer
from motionlang.kernel.controller.readers import passing_within
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.defaults import IDLE
from motionlang.kernel.mint.keywords.state import IS_IDLE, wrapped_position
from motionlang.kernel.mint.keywords.unsimulated import write_jump
from motionlang.kernel.mint.runtime.binding import Maker, Operation, by_axis, of, of_word, scale_of, unchecked
from motionlang.kernel.mint.runtime.changes import always, end_of_motion, moving, repeatable, with_dependency
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.traced import reading

if TYPE_CHECKING:
    from motionlang.kernel.mint.keywords.compensation import Compensation


# AXISMODE: the bit of each kind of motion, by the keyword that started it. 0 is idle. The bits are our own
# choice.
KINDS: dict[int, tuple[str, ...]] = {
    1: ("MOVEA", "MOVER", "INCA", "INCR", "MOVEDWELL"),
    2: ("JOG",),
    4: ("HOME",),
    8: ("VECTORA", "VECTORR", "CIRCLEA", "CIRCLER", "HELIXA", "HELIXR"),
    16: ("FOLLOW",),
    32: ("CAM",),
    64: ("FLY",),
    128: ("SPLINE",),
    256: ("OFFSET",),
}
OTHER, SUSPENDED = 512, 1024
# The target of a motion without an end is infinite.
ENDLESS = 1e300
_BITS = {word: bit for bit, words in KINDS.items() for word in words}


def read_axis_mode(environment: Environment, axis: int) -> int:
    """AXISMODE: return the bit of the present kind of motion, 0 at rest.

    An additional bit is set while the motion is suspended.
    """
    a = environment.controller.axes[axis]
    if a.move is None:
        return 0
    return _BITS.get(a.move.command, OTHER) | (SUSPENDED if a.suspended else 0)


def read_acceleration(environment: Environment, axis: int) -> float:
    """ACCELDEMAND: return the acceleration in user units per second squared."""
    a = environment.controller.axes[axis]
    return a.scale.to_user(a.at(environment.clock.now).acceleration, "uu/s2")


def read_velocity_error(environment: Environment, axis: int) -> float:
    """VELERROR: return the demanded minus the measured velocity in user units per second."""
    controller = environment.controller
    error = controller.demand_velocity(axis) - controller.velocity(axis)
    return controller.axes[axis].scale.to_user(error, "uu/s")


def _shown(environment: Environment, axis: int, target: float) -> float:
    """Return a target in user units within POSWRAP; without one, the position."""
    counts = target if abs(target) < ENDLESS else environment.controller.position(axis)
    return scale_of(environment, axis).shown_position(counts)


# --------------------------------------------------------------------------------------------- idle windows

AT_POSITION, AT_SPEED = 1, 2


class IdleWindows(StoredSettings):
    """Conditions for IDLE in addition to the end of the move.

    They are stored by keyword and axis, in counts.
    """

    defaults = IDLE
    in_counts = True

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self._since: dict[int, float] = {}
        self.controller.listeners.append(self._on_event, "idle")
        environment.settled = self.settled

    def set(self, name: str, axis: int, value: float) -> None:
        super().set(name, axis, value)
        self._configure_motor(axis)

    def _configure_motor(self, axis: int) -> None:
        """Pass the settling conditions to a simulated motor."""
        mode, far = int(self.setting("IDLEMODE", axis)), INFINITY
        self.controller.settle_within(
            axis,
            self.setting("IDLEPOS", axis) if mode & AT_POSITION else far,
            self.setting("IDLEVEL", axis) if mode & AT_SPEED else far,
            self.setting("IDLETIME", axis) / 1000.0,
        )

    def settled(self, axis: int) -> bool:
        """True if an axis at rest has been inside its windows for IDLETIME."""
        mode = int(self.setting("IDLEMODE", axis))
        if not mode:
            return True
        controller = self.controller
        if controller.is_open(axis):
            return True  # no control loop is closed, so there is no error to settle
        if controller.has_motor(axis) and controller.settled_time(axis) > controller.clock.now:
            return False
        if mode & AT_POSITION and abs(controller.following_error(axis)) > self.setting("IDLEPOS", axis):
            return False
        if mode & AT_SPEED and abs(controller.velocity(axis)) > self.setting("IDLEVEL", axis):
            return False
        # The same sum as in the scheduled event. A difference could be too small by rounding.
        return controller.clock.now >= self._since.get(axis, -1e300) + self.setting("IDLETIME", axis) / 1000.0

    def _on_event(self, what: str, axis: int) -> None:
        """Schedule the check of IDLE for IDLETIME after the end of a move."""
        if what == "idle":
            clock = self.controller.clock
            self._since[axis] = clock.now
            clock.at(clock.now + self.setting("IDLETIME", axis) / 1000.0, lambda: None)

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        super().default(axis)
        self._configure_motor(axis)


# ------------------------------------------------------------------------------------------------- encoders


class Encoders:
    """The encoders of the axes and of the machine file.

    The encoder of an axis counts independently of the zero that the program sets. An encoder of the machine
    file replaces that of the axis with the same number.

    The reading of an encoder is counts / ENCODERPRESCALE / ENCODERSCALE, plus an offset, within ENCODERWRAP.
    Writing a value to the encoder sets the offset.
    """

    def __init__(self, environment: Environment) -> None:
        self._environment, self._controller = environment, environment.controller
        self._end_of_motion = end_of_motion(environment)
        self._settings: dict[tuple[str, int], float] = {}
        # Motion of the motors in addition to POS, if the program uses compensation.
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

    def until(self, channel: int, level: float | None = None) -> float:
        """Return the earliest time at which an encoder may cross a level.

        This is exact for an encoder of the machine file. The encoder of an axis may cross it while anything moves.
        """
        track = self.track(channel)
        if level is None or track not in self._controller.encoders:
            return self._end_of_motion()
        zero, per_unit = self.setting("zero", channel), self.per_unit(channel)
        crossing_time = self._controller.encoder_crossing_time
        return passing_within(
            self.setting("ENCODERWRAP", channel),
            self.counts(channel) / per_unit + zero,
            level,
            lambda position: crossing_time(track, (position - zero) * per_unit),
        )

    def checked(self, channel: int) -> int:
        """Return the channel; raise Rejected if no axis or machine file encoder has it."""
        return channel_of(self._environment, channel)

    def track(self, channel: int) -> int:
        """Return the controller's number for an encoder of the machine file."""
        return channel

    def shown(self, channel: int, counts: float) -> float:
        """Convert a count to the reading of an encoder."""
        shown = counts / self.per_unit(channel) + self.setting("zero", channel)
        wrap = self.setting("ENCODERWRAP", channel)
        return shown % wrap if wrap else shown

    def write(self, channel: int, value: float) -> None:
        self.set("zero", channel, value - self.counts(channel) / self.per_unit(channel))

    def speed(self, channel: int) -> float:
        return self.velocity(channel) / self.per_unit(channel)

    def velocity(self, channel: int) -> float:
        """Return the velocity in counts/s."""
        if channel in self._controller.encoders:
            return self._controller.encoder_velocity(channel)
        shift = self.compensation.rate(channel) if self.compensation is not None else 0.0
        return self._controller.velocity(channel) + shift

    def per_unit(self, channel: int) -> float:
        """Return the number of counts per unit of the encoder's reading."""
        return self.setting("ENCODERSCALE", channel) * self.setting("ENCODERPRESCALE", channel)


def channel_of(environment: Environment, channel: int) -> int:
    """Return the channel; raise Rejected if no axis or machine file encoder has it."""
    if channel not in environment.controller.axes and channel not in environment.controller.encoders:
        axes = list(environment.controller.axes)
        hint = f"the encoders are those of axes {axes[0]} to {axes[-1]}"
        raise Rejected("channel", f"there is no encoder {channel}", hint)
    return channel


def compared(kind: type[Encoders]) -> Maker:
    """Make an operation that reads an encoder, and finds when it crosses a level."""

    def made(environment: Environment, row: Keyword) -> Operation:
        encoders, reads = environment.component(kind), environment.controller.reads

        def read(channel: int, level: float | None = None) -> float:
            value = encoders.read(encoders.checked(channel))
            return reading(value, "encoder", encoders.track(channel)) if reads.traces else value

        return with_dependency(environment, read, encoders.until)

    return made


def write_encoder(encoders: Encoders, channel: int, value: float) -> None:
    encoders.write(encoders.checked(channel), value)


def read_speed(encoders: Encoders, channel: int) -> float:
    return encoders.speed(encoders.checked(channel))


def _name(row: Keyword) -> str:
    """Return the axis encoder keyword that corresponds to a keyword of any family."""
    return row.name.removeprefix("AUX")


def read_setting(encoders: Encoders, row: Keyword, channel: int) -> float:
    """Return the scale, the prescale or the wrap of an encoder."""
    value = encoders.setting(_name(row), encoders.checked(channel))
    return int(value) if row.unit == "integer" else value


def write_setting(encoders: Encoders, row: Keyword, channel: int, value: float) -> None:
    """Set the scale, the prescale or the wrap of an encoder."""
    encoders.set(_name(row), encoders.checked(channel), value)


# ---------------------------------------------------------------------------------------------------- wraps


def write_wrap(environment: Environment, axis: int, value: float) -> None:
    """POSWRAP: set the range in which POS counts."""
    environment.controller.set_wrap(axis, value)


def read_wraps(environment: Environment, axis: int) -> int:
    """POSROLLOVER: return the number of times POS has wrapped."""
    scale = scale_of(environment, axis)
    position = scale.position_to_user(environment.controller.position(axis))
    return floor(position / scale.wrap) if scale.wrap else 0


def write_wraps(environment: Environment, axis: int, value: int) -> None:
    """POSROLLOVER: shift the position by the difference in wraps; POS does not change."""
    controller, scale = environment.controller, scale_of(environment, axis)
    more = (value - read_wraps(environment, axis)) * scale.wrap
    counts = scale.to_counts(more)
    controller.define_position(axis, controller.position(axis) + counts)


# ------------------------------------------------------------------------------------------------- keywords

AXIS_MODE = Actions(read=of(Environment, read_axis_mode))


def _target(end: Callable[[Axis], float]) -> Maker:
    """Make an operation that reads the target, or the position in endless motion."""

    @by_axis
    def made(environment: Environment, row: Keyword, axis: int) -> Operation:
        a, moves = environment.controller.axes[axis], end_of_motion(environment)

        def until() -> float:
            return INFINITY if abs(end(a)) < ENDLESS else moves()

        return with_dependency(environment, lambda: _shown(environment, axis, end(a)), until)

    return made


_TARGET = Actions(read=_target(lambda a: a.target))
_LAST_TARGET = Actions(read=_target(buffer.end))
_WINDOW = Actions(read=setting_reader(IdleWindows), write=repeatable(setting_writer(IdleWindows)))
_ENCODER_SETTING = Actions(read=of_word(Encoders, read_setting), write=of_word(Encoders, write_setting))
_WRAP = Actions(
    read=of(Environment, lambda e, axis: scale_of(e, axis).wrap), write=of(Environment, write_wrap)
)
_WRAPS = Actions(read=moving(of(Environment, read_wraps)), write=unchecked(of(Environment, write_wraps)))

_MOVE = "MOVER(0) = 100\nGO(0)\nPRINT {}(0)"


def _reading(name: str, short: str, unit: str, actions: str | Actions, help: str,
             changes: str = "", solved: bool = False) -> Keyword:  # fmt: skip
    return Keyword(name, short, "reading", "R", "axis", unit, actions, help, _MOVE.format(name),
                   group="state", changes=changes, solved=solved)  # fmt: skip


def _window(name: str, unit: str, help: str, high: float) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, _WINDOW, help,
                   f"{name}(0) = 3\nPRINT {name}(0)", default=float(IDLE[name]), low=0, high=high,
                   group="state")  # fmt: skip


def _encoder(name: str, unit: str, help: str, low: float, default: float) -> Keyword:
    return Keyword(name, "", "setting", "RW", "channel", unit, _ENCODER_SETTING, help,
                   f"{name}(0) = 4\nPRINT {name}(0)", default=default, low=low, high=8388607.0,
                   group="encoders")  # fmt: skip


ROWS = (
    _reading("AXISMODE", "amd", "bits", AXIS_MODE,
             "Kind of motion: 0 idle, 1 a move, 2 JOG, 4 HOME, 8 a path, 16 FOLLOW, 32 CAM, 64 FLY, 128 SPLINE, "
             "256 OFFSET, 512 another one; 1024 is added while the axis is suspended."),
    Keyword("POSDEMAND", "", "reading", "RW", "axis", "uu",
            Actions("demand", read=wrapped_position("demand"), write=write_jump),
            "The position that the profiler demands: POS, where no motor is simulated. Writing it, which makes the "
            "demand jump, is not simulated.", _MOVE.format("POSDEMAND"), group="state", changes="motion", solved=True),
    _reading("VELDEMAND", "", "uu/s", "demand_velocity", "The velocity that the profiler demands.",
             changes="motion", solved=True),
    _reading("ACCELDEMAND", "", "uu/s2", Actions(read=moving(of(Environment, read_acceleration))),
             "The acceleration that the profiler demands."),
    _reading("VELERROR", "", "uu/s", Actions(read=moving(of(Environment, read_velocity_error))),
             "Demanded minus measured velocity."),
    _reading("POSTARGET", "", "uu", _TARGET, "End position of the move in progress."),
    _reading("POSTARGETLAST", "", "uu", _LAST_TARGET, "End position of the last move in the buffer."),
    _reading("POSACHIEVED", "", "bool", IS_IDLE, "1 when the axis has come to the end of its moves, as IDLE is."),
    _window("IDLEMODE", "integer",
            "Conditions of IDLE in addition to the end of the move: bit 0 following error within "
            "IDLEPOS, bit 1 speed within IDLEVEL, either for IDLETIME; 0 none.", 3),
    _window("IDLEPOS", "uu", "Following error up to which an axis counts as idle.", 8388607.0),
    _window("IDLEVEL", "uu/s", "Speed up to which an axis counts as idle.", 8388607.0),
    _window("IDLETIME", "integer", "Milliseconds that an axis must be inside its windows to be idle.",
            60000),
    Keyword("SYSTEMSECONDS", "", "reading", "R", "none", "number",
            Actions(read=always(of(Environment, lambda e: float(e.clock.now)))),
            "Seconds since power-up.", "PRINT SYSTEMSECONDS", default=0.0, group="control"),
    Keyword("ENCODER", "", "setting", "RW", "channel", "number",
            Actions(read=compared(Encoders), write=of(Encoders, write_encoder)),
            "Value of the encoder of an axis, in units of ENCODERSCALE; POS = 0 does not change it.",
            "ENCODER(0) = 100\nPRINT ENCODER(0)", default=0.0, group="encoders", driven="encoder", solved=True),
    Keyword("ENCODERVEL", "", "reading", "R", "channel", "number", Actions(read=moving(of(Encoders, read_speed))),
            "Speed of an encoder, in units of ENCODERSCALE a second.",
            "JOG(0) = 100\nWAIT = 10\nPRINT ENCODERVEL(0)\nCANCEL(0)", default=0.0, group="encoders"),
    _encoder("ENCODERSCALE", "number", "Counts of an encoder in one of its units.", 1e-6, 1.0),
    _encoder("ENCODERPRESCALE", "integer", "Prescaler of an encoder: its counts are divided by this.", 1, 1.0),
    _encoder("ENCODERWRAP", "number", "The range in which ENCODER counts, from 0 on; 0 for no end.", 0, 0.0),
    Keyword("POSWRAP", "", "setting", "RW", "axis", "number", _WRAP,
            "The range in which POS counts, from 0 on, in user units; 0 for no end. MOVEA stays within one wrap.",
            "POSWRAP(0) = 360\nPOS(0) = 370\nPRINT POS(0)", default=0.0, low=0, high=8388607.0, group="state"),
    Keyword("POSROLLOVER", "", "setting", "RW", "axis", "integer", _WRAPS,
            "Number of times that POS has wrapped.",
            "POSWRAP(0) = 360\nPOS(0) = 370\nPRINT POSROLLOVER(0)",
            default=0.0, low=-2147483648.0, high=2147483647.0, group="state"),
)  # fmt: skip
