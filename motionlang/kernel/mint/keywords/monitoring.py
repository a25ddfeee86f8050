"""Monitoring of analogue inputs, following error and drives; error masks."""

from __future__ import annotations

from functools import partial
from math import inf

from motionlang.kernel.controller.faults import ANALOGUE_LIMIT
from motionlang.kernel.controller.io.bits import signed
from motionlang.kernel.lang.keyword import Actions, Keyword, value
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.defaults import FATAL_ERROR, MODES
from motionlang.kernel.mint.keywords.io_outputs import Analogue, analogue_input
from motionlang.kernel.mint.keywords.limits import ERROR_MODE, AxisErrors
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.errors import AXIS, MISC, SYNCHRONOUS, Error, Errors

LIMITS = {"ADCMIN": -100.0, "ADCMAX": 100.0}
MONITORED = 32  # the analogue inputs that a bit pattern can name
FOLLOWING_WARNING = 1
ALL_BITS = -1

# ------------------------------------------------------------------------------------------ analogue inputs


class Monitors:
    """The limits of analogue inputs, and the inputs that each axis monitors.

    An input beyond its limits is an error of the axis.
    """

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self._analogue = environment.component(Analogue)
        self._errors = environment.component(AxisErrors)
        self._limits: dict[tuple[str, int], float] = {}
        self.minded: dict[int, int] = {}
        self._controller.analogue_inputs.listen(lambda channel, value: self._check_all())

    def limit(self, name: str, channel: int) -> float:
        return self._limits.get((name, channel), LIMITS[name])

    def set_limit(self, name: str, channel: int, value: float) -> None:
        self._limits[name, channel] = value
        self._check_all()

    def mind(self, axis: int, pattern: int) -> None:
        """Set the inputs that the axis monitors, as bits.

        An input that is already beyond its limits causes the error at once.
        """
        before, self.minded[axis] = self.minded.get(axis, 0), pattern
        self._update_errors(axis, before | pattern)

    def beyond(self, axis: int) -> int:
        """Return the monitored inputs that are beyond their limits, as bits."""
        pattern = self.minded.get(axis, 0)
        return signed(sum(1 << k for k in range(MONITORED) if pattern >> k & 1 and self._is_beyond(k)))

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        self._update_errors(axis, self.minded.pop(axis, 0))

    def _is_beyond(self, channel: int) -> bool:
        return (
            not self.limit("ADCMIN", channel) <= self._analogue.read(channel) <= self.limit("ADCMAX", channel)
        )

    def _check_all(self) -> None:
        """Check all axes after a change of a value or a limit."""
        for axis, pattern in self.minded.items():
            self._update_errors(axis, pattern)

    def _update_errors(self, axis: int, pattern: int) -> None:
        beyond = self.beyond(axis)
        for k in range(MONITORED):
            if pattern >> k & 1:
                self._errors.set_input(axis, ANALOGUE_LIMIT, bool(beyond >> k & 1), k)


def do_trim(environment: Environment, channel: int) -> None:
    """ADCOFFSETTRIM: make the present value of the input its new zero."""
    inputs = environment.component(Analogue)
    gain = inputs.setting("ADCGAIN", analogue_input(channel)) / 100.0
    inputs.set("ADCOFFSET", channel, -float(environment.controller.analogue_inputs[channel]) * gain)


# ------------------------------------------------------------------------------------------------- warnings


class Warnings(StoredSettings):
    """The warnings of the axes, which remain until they are cleared.

    Bit 0 means that the following error exceeded FOLERRORWARNING.
    """

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.bits: dict[int, int] = {}
        self.levels: dict[int, float] = {}

    def set_level(self, axis: int, level: float) -> None:
        """Set the following error in counts above which a warning is raised."""
        self.levels[axis] = level
        self._watch(axis, level)

    def clear(self, axis: int) -> None:
        """Clear the warnings of an axis.

        A following error that still exceeds the level, or exceeds it again, raises a new warning.
        """
        self.bits.pop(axis, None)
        self._watch(axis, self.levels.get(axis, inf))

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        super().default(axis)
        if self.levels.pop(axis, None) is not None:
            self._watch(axis, inf)

    def _watch(self, axis: int, level: float) -> None:
        self.controller.warn_of_error(axis, level, lambda: self._warn(axis))

    def _warn(self, axis: int) -> None:
        if not int(self.setting("AXISWARNINGDISABLE", axis)) & FOLLOWING_WARNING:
            self.bits[axis] = self.bits.get(axis, 0) | FOLLOWING_WARNING


def read_level(environment: Environment, axis: int) -> float:
    """FOLERRORWARNING: return the level in user units."""
    levels = environment.component(Warnings).levels
    return (
        environment.controller.axes[axis].scale.to_user(levels[axis], "uu") if axis in levels else FATAL_ERROR
    )


def write_level(environment: Environment, row: Keyword, axis: int, value: float) -> None:
    """FOLERRORWARNING: set the level in user units.

    Without a motor it has no effect, which the report states.
    """
    level = abs(environment.controller.axes[axis].scale.to_counts(value, "uu"))
    environment.component(Warnings).set_level(axis, level)
    if not environment.controller.has_motor(axis):
        environment.machine.without_effect.setdefault(row.name, [])


# ---------------------------------------------------------------------------------------------------- masks


class Masks(StoredSettings):
    """The errors that do not call ONERROR: bits of axis errors, and error codes."""

    otherwise = ALL_BITS

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        self.codes: set[tuple[int, int]] = set()
        self.misc_disabled = 0
        environment.errors.masked = self.is_masked

    def is_masked(self, error: Error) -> bool:
        """True if an error does not call ONERROR.

        Either its code, its bit in the axis errors or its bit in MISCERROR is masked.
        """
        first = error.data[0] if error.data else 0
        if (error.number, first) in self.codes:
            return True
        if error.group == MISC:
            return not first & ~self.misc_disabled
        return error.group == AXIS and not error.data[1] & int(self.setting("ERRORMASK", error.data[0]))


def write_code_mask(masks: Masks, code: int, data: int, masked: int) -> None:
    """ERRORMASKCODE: mask or unmask one error code with a certain first data value."""
    (masks.codes.add if masked else masks.codes.discard)((code, data))


def write_misc_disable(masks: Masks, pattern: int) -> None:
    masks.misc_disabled = pattern


# --------------------------------------------------------------------- the drive and the controller itself


def drive_errors(environment: Environment, axis: int) -> int:
    """DRIVEERROR: return the drive errors of the axis."""
    world = environment.machine.world
    return 0 if world is None else world.drive_errors.get(axis, 0)


def read_misc(environment: Environment) -> int:
    """MISCERROR: return the controller errors that are not disabled, as bits."""
    world, disabled = environment.machine.world, environment.component(Masks).misc_disabled
    return 0 if world is None else world.misc & ~disabled


def write_misc(environment: Environment, value: int) -> None:
    """MISCERROR: clear the errors of the controller."""
    if environment.machine.world is not None:
        environment.machine.world.misc = 0


_CLEAR = of(Environment, lambda e, axis, value: e.controller.clear_faults(axis))


# ------------------------------------------------------------------------------------------------- keywords

_LIMIT = Actions(
    read=of_word(Monitors, lambda monitors, row, channel: monitors.limit(row.name, analogue_input(channel))),
    write=repeatable(
        of_word(
            Monitors,
            lambda monitors, row, channel, value: monitors.set_limit(
                row.name, analogue_input(channel), value
            ),
        )
    ),
)
_MINDED = Actions(
    read=of(Monitors, lambda monitors, axis: monitors.minded.get(axis, 0)), write=of(Monitors, Monitors.mind)
)
_WARNING = Actions(
    read=of(Warnings, lambda warnings, axis: warnings.bits.get(axis, 0)),
    write=of(Warnings, lambda warnings, axis, value: warnings.clear(axis)),
)
_CODE_MASK = Actions(
    read=of(Masks, lambda masks, code, data: int((code, data) in masks.codes)),
    write=of(Masks, write_code_mask),
)
_ASYNCHRONOUS = Actions(
    read=of(Errors, lambda errors: int(any(error.group != SYNCHRONOUS for error in errors.found)))
)
_ENABLE_SWITCH = Actions(read=of(Environment, lambda e, axis: int(e.controller.may_enable(axis))))
_DRIVE_FAULT = Actions(read=of(Environment, lambda e, axis: int(drive_errors(e, axis) != 0)), write=_CLEAR)
_MISC_DISABLE = Actions(
    read=of(Masks, lambda masks: masks.misc_disabled), write=of(Masks, write_misc_disable)
)

_ADC = "ADCMIN(2) = 10\nADCMAX(2) = 90\nADCMONITOR(0) = 4\nPRINT {}"
_FAIL = "{}ACCEL(0) = 0\nMOVER(0) = 1\nGO(0)\nPRINT IDLE(0)\nEnd\nEvent ONERROR\n  PRINT ERRCODE\nEnd Event"

_word = partial(value, group="errors")


ROWS = (
    _word("ADCMAX", "", "RW", "channel", "%", _LIMIT,
          "The highest value of an analogue input without error.",
          _ADC.format("ADCMAX(2)"), 100.0, -100.0, 100.0, group="io"),
    _word("ADCMIN", "", "RW", "channel", "%", _LIMIT,
          "The lowest value of an analogue input without error.",
          _ADC.format("ADCMIN(2)"), -100.0, -100.0, 100.0, group="io"),
    _word("ADCMONITOR", "", "RW", "axis", "bits", _MINDED,
          "Bit pattern of the analogue inputs that the axis minds: beyond ADCMIN and ADCMAX they are an error of it.",
          _ADC.format("ADCMONITOR(0)"), group="io"),
    _word("ADCERROR", "", "R", "axis", "bits", Actions(read=of(Monitors, Monitors.beyond)),
          "Bit pattern of the analogue inputs that the axis minds and that are beyond their limits now.",
          _ADC.format("ADCERROR(0)"), group="io"),
    _word("ADCERRORMODE", "", "RW", "axis", "integer", ERROR_MODE,
          "Reaction of the axis when an analogue input that it monitors leaves its limits: one of "
          "_emIGNORE, _emCRASH_STOP, _emCRASH_STOP_DISABLE, _emERROR_DECEL, _emERROR_DECEL_DISABLE, "
          "_emCALL_EVENT.",
          "ADCERRORMODE(0) = _emERROR_DECEL\nPRINT ADCERRORMODE(0)", float(MODES["ADCERRORMODE"]), 0, 5,
          group="limits"),
    Keyword("ADCOFFSETTRIM", "", "command", "C", "channel", "", Actions(do=of(Environment, do_trim)),
            "Make what an analogue input shows now its zero, by its ADCOFFSET.",
            "ADCOFFSETTRIM(0)\nPRINT ADC(0)", group="io"),
    _word("FOLERRORWARNING", "", "RW", "axis", "uu",
          Actions(read=of(Environment, read_level), write=of_word(Environment, write_level)),
          "The following error beyond which the axis warns, in AXISWARNING; only a simulated motor has one.",
          "FOLERRORWARNING(0) = 2\nPRINT FOLERRORWARNING(0)", FATAL_ERROR, 0.0, 8388607.0,
          group="servo"),
    _word("AXISWARNING", "", "RW", "axis", "bits", _WARNING,
          "Warnings of the axis: bit 0, its following error was beyond FOLERRORWARNING. Writing 0 clears them.",
          "AXISWARNING(0) = 0\nPRINT AXISWARNING(0)", 0.0, 0, 0),
    _word("AXISWARNINGDISABLE", "", "RW", "axis", "bits",
          Actions(read=setting_reader(Warnings), write=setting_writer(Warnings)),
          "Bit pattern of the warnings that the axis does not give.",
          "AXISWARNINGDISABLE(0) = 1\nPRINT AXISWARNINGDISABLE(0)"),
    _word("ERRORMASK", "", "RW", "axis", "bits",
          Actions(read=setting_reader(Masks), write=setting_writer(Masks)),
          "Bit pattern of the errors of the axis, as in AXISERROR, that call ONERROR; the axis stops as ever.",
          "ERRORMASK(0) = 0x7E\nABORT\nPRINT AXISERROR(0), AXISERROR(1)\nEnd\nEvent ONERROR\n"
          "  While ERRORREADNEXT(_egAXIS, 1)\n    PRINT ERRSTRING\n  End While\nEnd Event", -1.0),
    _word("ERRORMASKCODE", "", "RW", "code, data", "bool", _CODE_MASK,
          "1: the error of that number, of an axis the one that data names, does not call ONERROR.",
          _FAIL.format("ERRORMASKCODE(3, 0) = _TRUE\n"), 0.0, 0, 1),
    _word("ASYNCERRORPRESENT", "", "R", "none", "bool", _ASYNCHRONOUS,
          "1 while the list of errors has one that no statement has made: of an axis or of the controller.",
          "PRINT ASYNCERRORPRESENT"),
    _word("DRIVEENABLESWITCH", "des", "R", "axis", "bool", _ENABLE_SWITCH,
          "1 while the hardware enable input of the drive is on, or where the machine file gives it none.",
          "PRINT DRIVEENABLESWITCH(0)", 1.0),
    _word("ENABLESWITCH", "", "R", "axis", "bool", _ENABLE_SWITCH,
          "Same as DRIVEENABLESWITCH.", "PRINT ENABLESWITCH(0)", 1.0),
    _word("DRIVEERROR", "dre", "RW", "axis", "bits", Actions(read=of(Environment, drive_errors), write=_CLEAR),
          "Errors of the drive, which only the machine file brings about. Writing 0 clears the errors of the axis.",
          "DRIVEERROR(0) = 0\nPRINT DRIVEERROR(0)", 0.0, 0, 0),
    _word("DRIVEFAULT", "", "R", "axis", "integer", _DRIVE_FAULT, "1 while the drive has an error.",
          "PRINT DRIVEFAULT(0)"),
    _word("MISCERROR", "", "RW", "none", "bits",
          Actions(read=of(Environment, read_misc), write=of(Environment, write_misc)),
          "Errors of the controller itself, which only the machine file brings about. Writing 0 clears them.",
          "MISCERROR = 0\nPRINT MISCERROR", 0.0, 0, 0),
    _word("MISCERRORDISABLE", "", "RW", "none", "bits", _MISC_DISABLE,
          "Bit pattern of the errors of the controller that MISCERROR does not show and that call no ONERROR.",
          "MISCERRORDISABLE = 1\nPRINT MISCERRORDISABLE"),
)  # fmt: skip
