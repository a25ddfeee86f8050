"""What is watched beside motion: analogue inputs, following errors that warn, drives; and masks of errors."""

from __future__ import annotations

from motionlang.controller.faults import ANALOGUE_LIMIT
from motionlang.mint.keywords.axis_settings import Settings, reading, writing
from motionlang.mint.keywords.defaults import FATAL_ERROR
from motionlang.mint.keywords.io_outputs import Analogue, analogue_input
from motionlang.mint.keywords.limits_operations import AxisErrors
from motionlang.mint.runtime.binding import Row, of, of_word
from motionlang.mint.runtime.changes import repeatable
from motionlang.mint.runtime.environment import Environment
from motionlang.mint.runtime.errors import AXIS, MISC, SYNCHRONOUS, Error, Errors

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


def do_trim(environment: Environment, channel: int) -> None:
    """ADCOFFSETTRIM: what the input shows now is its zero."""
    inputs = environment.part(Analogue)
    gain = inputs.setting("ADCGAIN", analogue_input(channel)) / 100.0
    inputs.set("ADCOFFSET", channel, -float(environment.controller.analogue_inputs[channel]) * gain)


# ------------------------------------------------------------------------------------------------- warnings


class Warnings(Settings):
    """The warnings of axes: bit 0, the following error was beyond FOLERRORWARNING. They stay until they are cleared."""

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.bits: dict[int, int] = {}
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
        super().default(axis)
        if self.levels.pop(axis, None) is not None:
            self._watch(axis, float("inf"))

    def _watch(self, axis: int, level: float) -> None:
        self.controller.warn_of_error(axis, level, lambda: self._warn(axis))

    def _warn(self, axis: int) -> None:
        if not int(self.setting("AXISWARNINGDISABLE", axis)) & FOLLOWING_WARNING:
            self.bits[axis] = self.bits.get(axis, 0) | FOLLOWING_WARNING


def read_level(environment: Environment, axis: int) -> float:
    """FOLERRORWARNING, user units."""
    levels = environment.part(Warnings).levels
    return (
        environment.controller.axes[axis].scale.to_user(levels[axis], "uu") if axis in levels else FATAL_ERROR
    )


def write_level(environment: Environment, row: Row, axis: int, value: float) -> None:
    """FOLERRORWARNING, user units; without a motor it has no effect, which the report tells."""
    level = abs(environment.controller.axes[axis].scale.to_counts(value, "uu"))
    environment.part(Warnings).set_level(axis, level)
    if not environment.controller.has_motor(axis):
        environment.machine.without_effect.setdefault(row.name, [])


# ---------------------------------------------------------------------------------------------------- masks


class Masks(Settings):
    """The errors that call no ONERROR: by the bits of an axis, and by their numbers."""

    otherwise = ALL_BITS

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
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
        return error.group == AXIS and not error.data[1] & int(self.setting("ERRORMASK", error.data[0]))


def write_code_mask(masks: Masks, code: int, data: int, masked: int) -> None:
    """ERRORMASKCODE: one code, with its first datum, calls ONERROR no more or again."""
    (masks.codes.add if masked else masks.codes.discard)((code, data))


def write_misc_disable(masks: Masks, pattern: int) -> None:
    masks.misc_disabled = pattern


# --------------------------------------------------------------------- the drive and the controller itself


def drive_errors(environment: Environment, axis: int) -> int:
    """DRIVEERROR."""
    world = environment.machine.world
    return 0 if world is None else world.drive_errors.get(axis, 0)


def read_misc(environment: Environment) -> int:
    """MISCERROR."""
    world, disabled = environment.machine.world, environment.part(Masks).misc_disabled
    return 0 if world is None else world.misc & ~disabled


def write_misc(environment: Environment, value: int) -> None:
    """MISCERROR: clears the errors of the controller."""
    if environment.machine.world is not None:
        environment.machine.world.misc = 0


_CLEAR = of(Environment, lambda e, axis, value: e.controller.clear_faults(axis))
OPERATIONS = {
    "monitoring.limit": {
        "read": of_word(Monitors, lambda part, row, channel: part.limit(row.name, analogue_input(channel))),
        "write": repeatable(
            of_word(
                Monitors,
                lambda part, row, channel, value: part.set_limit(row.name, analogue_input(channel), value),
            )
        ),
    },
    "monitoring.minded": {
        "read": of(Monitors, lambda monitors, axis: monitors.minded.get(axis, 0)),
        "write": of(Monitors, Monitors.mind),
    },
    "monitoring.beyond": {"read": of(Monitors, Monitors.beyond)},
    "monitoring.trim": {"do": of(Environment, do_trim)},
    "monitoring.following_warning": {
        "read": of(Environment, read_level),
        "write": of_word(Environment, write_level),
    },
    "monitoring.warning": {
        "read": of(Warnings, lambda warnings, axis: warnings.bits.get(axis, 0)),
        "write": of(Warnings, lambda warnings, axis, value: warnings.clear(axis)),
    },
    "monitoring.warning_disable": {"read": reading(Warnings), "write": writing(Warnings)},
    "monitoring.mask": {"read": reading(Masks), "write": writing(Masks)},
    "monitoring.code_mask": {
        "read": of(Masks, lambda masks, code, data: int((code, data) in masks.codes)),
        "write": of(Masks, write_code_mask),
    },
    "monitoring.asynchronous": {
        "read": of(Errors, lambda errors: int(any(error.group != SYNCHRONOUS for error in errors.found)))
    },
    "monitoring.enable_switch": {"read": of(Environment, lambda e, axis: int(e.controller.may_enable(axis)))},
    "monitoring.drive_error": {"read": of(Environment, drive_errors), "write": _CLEAR},
    "monitoring.drive_fault": {
        "read": of(Environment, lambda e, axis: int(drive_errors(e, axis) != 0)),
        "write": _CLEAR,
    },
    "monitoring.misc": {"read": of(Environment, read_misc), "write": of(Environment, write_misc)},
    "monitoring.misc_disable": {
        "read": of(Masks, lambda masks: masks.misc_disabled),
        "write": of(Masks, write_misc_disable),
    },
}
