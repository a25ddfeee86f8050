"""Error masks, and the errors of drives and of the controller itself."""

from __future__ import annotations

from functools import partial

from motionlang.kernel.lang.keyword import Actions, value
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.runtime.binding import of
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.errors import AXIS, MISC, SYNCHRONOUS, Error, Errors

ALL_BITS = -1

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

_FAIL = "{}ACCEL(0) = 0\nMOVER(0) = 1\nGO(0)\nPRINT IDLE(0)\nEnd\nEvent ONERROR\n  PRINT ERRCODE\nEnd Event"

_word = partial(value, group="errors")


ROWS = (
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
