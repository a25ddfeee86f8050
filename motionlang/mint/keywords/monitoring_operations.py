"""What is watched beside motion: analogue inputs, following errors that warn, drives; and masks of errors."""

from __future__ import annotations

from motionlang.controller.faults import ANALOGUE_LIMIT
from motionlang.mint.keywords.defaults import FATAL_ERROR
from motionlang.mint.keywords.io_inputs import checked
from motionlang.mint.keywords.io_outputs import LAST_ANALOGUE, Analogue
from motionlang.mint.keywords.limits_operations import AxisErrors
from motionlang.mint.runtime.binding import axis_of, scale_of
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.errors import AXIS, MISC, SYNCHRONOUS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mint.runtime.binding import Row
    from motionlang.mint.runtime.environment import Environment
    from motionlang.mint.runtime.errors import Error

    Operation = Callable[..., object]

LIMITS = {"ADCMIN": -100.0, "ADCMAX": 100.0}
MONITORED = 32  # the analogue inputs that a bit pattern can name
FOLLOWING_WARNING = 1
ALL_BITS = -1

# ------------------------------------------------------------------------------------------ analogue inputs


class Monitors:
    """The limits of analogue inputs, and which inputs each axis minds; an input beyond its limits is its error."""

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self._analogue = environment.part(Analogue)
        self._errors = environment.part(AxisErrors)
        self._limits: dict[tuple[str, int], float] = {}
        self.minded: dict[int, int] = {}
        self._controller.analogue_inputs.listeners.append(lambda channel, value: self._look())

    def limit(self, name: str, channel: int) -> float:
        return self._limits.get((name, channel), LIMITS[name])

    def set_limit(self, name: str, channel: int, value: float) -> None:
        self._limits[name, channel] = value
        self._look()

    def mind(self, axis: int, pattern: int) -> None:
        """Say which inputs the axis minds from now on; one that is beyond its limits already counts at once."""
        before, self.minded[axis] = self.minded.get(axis, 0), pattern
        self._look_at(axis, before | pattern)

    def beyond(self, axis: int) -> int:
        """The inputs that an axis minds and that are beyond their limits."""
        pattern = self.minded.get(axis, 0)
        return sum(1 << k for k in range(MONITORED) if pattern >> k & 1 and self._is_beyond(k))

    def default(self, axis: int) -> None:
        """DEFAULT."""
        self._look_at(axis, self.minded.pop(axis, 0))

    def _is_beyond(self, channel: int) -> bool:
        return (
            not self.limit("ADCMIN", channel) <= self._analogue.read(channel) <= self.limit("ADCMAX", channel)
        )

    def _look(self) -> None:
        """A value or a limit has changed."""
        for axis, pattern in self.minded.items():
            self._look_at(axis, pattern)

    def _look_at(self, axis: int, pattern: int) -> None:
        """Let the axis know of the inputs of a pattern, each of which is an error of its own while it is beyond."""
        beyond = self.beyond(axis)
        for k in range(MONITORED):
            if pattern >> k & 1:
                self._errors.set_input(axis, ANALOGUE_LIMIT, bool(beyond >> k & 1), k)


def read_limit(environment: Environment, row: Row) -> Operation:
    monitors, name = environment.part(Monitors), row.name
    return lambda channel: monitors.limit(name, checked(channel, LAST_ANALOGUE, "analogue input"))


@repeatable
def write_limit(environment: Environment, row: Row) -> Operation:
    """ADCMAX and ADCMIN, percent."""
    monitors, name = environment.part(Monitors), row.name

    def write(channel: int, value: float) -> None:
        row.check(value)
        monitors.set_limit(name, checked(channel, LAST_ANALOGUE, "analogue input"), value)

    return write


def read_minded(environment: Environment, row: Row) -> Operation:
    """ADCMONITOR."""
    minded = environment.part(Monitors).minded
    return lambda axis: minded.get(axis_of(environment, axis), 0)


def write_minded(environment: Environment, row: Row) -> Operation:
    monitors = environment.part(Monitors)
    return lambda axis, pattern: monitors.mind(axis_of(environment, axis), pattern)


def read_beyond(environment: Environment, row: Row) -> Operation:
    """ADCERROR."""
    monitors = environment.part(Monitors)
    return lambda axis: monitors.beyond(axis_of(environment, axis))


def do_trim(environment: Environment, row: Row) -> Operation:
    """ADCOFFSETTRIM: what the input shows now is its zero."""
    analogue, inputs = environment.part(Analogue), environment.controller.analogue_inputs

    def do(channel: int) -> None:
        checked(channel, LAST_ANALOGUE, "analogue input")
        gain = analogue.setting("ADCGAIN", channel) / 100.0
        analogue.set("ADCOFFSET", channel, -float(inputs[channel]) * gain)

    return do


# ------------------------------------------------------------------------------------------------- warnings


class Warnings:
    """The warnings of axes: bit 0, the following error was beyond FOLERRORWARNING. They stay until they are cleared."""

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self.bits: dict[int, int] = {}
        self.disabled: dict[int, int] = {}
        self.levels: dict[int, float] = {}

    def set_level(self, axis: int, level: float) -> None:
        """The following error, counts, beyond which an axis warns."""
        self.levels[axis] = level
        self._watch(axis, level)

    def clear(self, axis: int) -> None:
        """Forget the warnings of an axis; what is beyond its level still, or again, warns anew."""
        self.bits.pop(axis, None)
        self._watch(axis, self.levels.get(axis, float("inf")))

    def default(self, axis: int) -> None:
        """DEFAULT."""
        self.disabled.pop(axis, None)
        if self.levels.pop(axis, None) is not None:
            self._watch(axis, float("inf"))

    def _watch(self, axis: int, level: float) -> None:
        self._controller.warn_of_error(axis, level, lambda: self._warn(axis))

    def _warn(self, axis: int) -> None:
        if not self.disabled.get(axis, 0) & FOLLOWING_WARNING:
            self.bits[axis] = self.bits.get(axis, 0) | FOLLOWING_WARNING


def read_warning(environment: Environment, row: Row) -> Operation:
    bits = environment.part(Warnings).bits
    return lambda axis: bits.get(axis_of(environment, axis), 0)


def write_warning(environment: Environment, row: Row) -> Operation:
    """AXISWARNING: whatever is written, it clears the warnings of the axis."""
    warnings = environment.part(Warnings)

    def write(axis: int, value: int) -> None:
        row.check(value)
        warnings.clear(axis_of(environment, axis))

    return write


def read_warning_disable(environment: Environment, row: Row) -> Operation:
    disabled = environment.part(Warnings).disabled
    return lambda axis: disabled.get(axis_of(environment, axis), 0)


def write_warning_disable(environment: Environment, row: Row) -> Operation:
    """AXISWARNINGDISABLE: the bits that are set do not warn."""
    disabled = environment.part(Warnings).disabled

    def write(axis: int, pattern: int) -> None:
        disabled[axis_of(environment, axis)] = pattern

    return write


def read_following_warning(environment: Environment, row: Row) -> Operation:
    """FOLERRORWARNING, user units."""
    levels = environment.part(Warnings).levels

    def read(axis: int) -> float:
        scale = scale_of(environment, axis)
        return scale.to_user(levels[axis], "uu") if axis in levels else FATAL_ERROR

    return read


def write_following_warning(environment: Environment, row: Row) -> Operation:
    """FOLERRORWARNING, user units; without a motor it has no effect, which the report tells."""
    warnings = environment.part(Warnings)

    def write(axis: int, value: float) -> None:
        row.check(value)
        warnings.set_level(axis, abs(scale_of(environment, axis).to_counts(value, "uu")))
        if not environment.controller.has_motor(axis):
            environment.machine.without_effect.setdefault(row.name, [])

    return write


# ---------------------------------------------------------------------------------------------------- masks


class Masks:
    """The errors that call no ONERROR: by the bits of an axis, and by their numbers."""

    def __init__(self, environment: Environment) -> None:
        self.calling: dict[int, int] = {}
        self.codes: set[tuple[int, int]] = set()
        self.misc_disabled = 0
        environment.errors.masked = self.is_masked

    def is_masked(self, error: Error) -> bool:
        """Whether an error calls no ONERROR: its code, its bit of the axis or of MISCERROR is masked."""
        first = error.data[0] if error.data else 0
        if (error.number, first) in self.codes:
            return True
        if error.group == MISC:
            return not first & ~self.misc_disabled
        return error.group == AXIS and not error.data[1] & self.calling.get(error.data[0], ALL_BITS)

    def default(self, axis: int) -> None:
        """DEFAULT."""
        self.calling.pop(axis, None)


def read_mask(environment: Environment, row: Row) -> Operation:
    calling = environment.part(Masks).calling
    return lambda axis: calling.get(axis_of(environment, axis), ALL_BITS)


def write_mask(environment: Environment, row: Row) -> Operation:
    """ERRORMASK: the errors of the axis that call ONERROR."""
    calling = environment.part(Masks).calling

    def write(axis: int, pattern: int) -> None:
        calling[axis_of(environment, axis)] = pattern

    return write


def read_code_mask(environment: Environment, row: Row) -> Operation:
    codes = environment.part(Masks).codes
    return lambda code, data: int((code, data) in codes)


def write_code_mask(environment: Environment, row: Row) -> Operation:
    """ERRORMASKCODE: one code, with its first datum, calls ONERROR no more or again."""
    codes = environment.part(Masks).codes

    def write(code: int, data: int, masked: int) -> None:
        row.check(masked)
        (codes.add if masked else codes.discard)((code, data))

    return write


# --------------------------------------------------------------------- the drive and the controller itself


def read_asynchronous(environment: Environment, row: Row) -> Operation:
    """ASYNCERRORPRESENT."""
    errors = environment.errors
    return lambda: int(any(error.group != SYNCHRONOUS for error in errors.found))


def read_enable_switch(environment: Environment, row: Row) -> Operation:
    controller = environment.controller
    return lambda axis: int(controller.may_enable(axis_of(environment, axis)))


def read_drive_error(environment: Environment, row: Row) -> Operation:
    """DRIVEERROR; DRIVEFAULT tells only whether there is one."""
    world, whole = environment.machine.world, row.name == "DRIVEERROR"

    def read(axis: int) -> int:
        bits = 0 if world is None else world.drive_errors.get(axis_of(environment, axis), 0)
        return bits if whole else int(bits != 0)

    return read


def write_drive_error(environment: Environment, row: Row) -> Operation:
    """Clears the errors of the axis, among them the drive's."""

    def write(axis: int, value: int) -> None:
        row.check(value)
        environment.controller.clear_faults(axis_of(environment, axis))

    return write


def read_misc(environment: Environment, row: Row) -> Operation:
    world, masks = environment.machine.world, environment.part(Masks)
    return lambda: 0 if world is None else world.misc & ~masks.misc_disabled


def read_misc_disable(environment: Environment, row: Row) -> Operation:
    masks = environment.part(Masks)
    return lambda: masks.misc_disabled


def write_misc_disable(environment: Environment, row: Row) -> Operation:
    """MISCERRORDISABLE: the bits that are set call no ONERROR."""
    masks = environment.part(Masks)

    def write(pattern: int) -> None:
        masks.misc_disabled = pattern

    return write


def write_misc(environment: Environment, row: Row) -> Operation:
    """MISCERROR: clears the errors of the controller."""
    world = environment.machine.world

    def write(value: int) -> None:
        row.check(value)
        if world is not None:
            world.misc = 0

    return write


OPERATIONS = {
    "monitoring.limit": {"read": read_limit, "write": write_limit},
    "monitoring.minded": {"read": read_minded, "write": write_minded},
    "monitoring.beyond": {"read": read_beyond},
    "monitoring.trim": {"do": do_trim},
    "monitoring.following_warning": {"read": read_following_warning, "write": write_following_warning},
    "monitoring.warning": {"read": read_warning, "write": write_warning},
    "monitoring.warning_disable": {"read": read_warning_disable, "write": write_warning_disable},
    "monitoring.mask": {"read": read_mask, "write": write_mask},
    "monitoring.code_mask": {"read": read_code_mask, "write": write_code_mask},
    "monitoring.asynchronous": {"read": read_asynchronous},
    "monitoring.enable_switch": {"read": read_enable_switch},
    "monitoring.drive_error": {"read": read_drive_error, "write": write_drive_error},
    "monitoring.misc": {"read": read_misc, "write": write_misc},
    "monitoring.misc_disable": {"read": read_misc_disable, "write": write_misc_disable},
}
