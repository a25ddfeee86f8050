"""Keywords of Mint v4 that have other names in MintMT.

A program that declares one of these names may use it for its own purposes.
"""

from __future__ import annotations

from motionlang.kernel.lang.keyword import BANK, Actions, Keyword
from motionlang.kernel.mint.keywords.hold_to_analogue import HOLD
from motionlang.kernel.mint.keywords.io_inputs import LAST_CHANNEL, checked
from motionlang.kernel.mint.keywords.sensing import AXIS_MODE
from motionlang.kernel.mint.runtime.binding import axis_of, of, of_word
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.runtime.errors import AXIS, Error, Errors


def last(errors: Errors, of_axis: bool = False) -> Error | None:
    """Return the newest active error or, if all have been read, the last one read."""
    known = [*errors.found, *([] if errors.found or errors.shown is None else [errors.shown])]
    return next((each for each in reversed(known) if not of_axis or each.group == AXIS), None)


def read_error(errors: Errors) -> int:
    return 0 if (found := last(errors)) is None else found.number


def read_line(errors: Errors) -> int:
    return 0 if (found := last(errors)) is None else errors.line_of(found)


def read_axis(errors: Errors) -> int:
    return -1 if (found := last(errors, of_axis=True)) is None else found.data[0]


def do_contour(environment: Environment, row: Keyword, axes: tuple[int, ...], line: int) -> None:
    """CONTOURON and CONTOUROFF: switch contour mode."""
    for axis in axes:
        environment.controller.configure(axis_of(environment, axis), "contour_mode", row.name.endswith("ON"))


class DefaultBank:
    """The bank of 32 channels that keywords without brackets refer to."""

    def __init__(self, environment: Environment) -> None:
        self.number = 0

    def set(self, number: int) -> None:
        self.number = checked(number, LAST_CHANNEL // BANK, "bank")


# ------------------------------------------------------------------------------------------------- keywords

_CONTOUR_ACTIONS = Actions(do=of_word(Environment, do_contour))
_BANK = Actions(
    "default_bank",
    read=of(DefaultBank, lambda bank: bank.number),
    write=of(DefaultBank, lambda bank, number: bank.set(number)),
)

GROUP = "v4"
_FAIL = "\nEnd\nEvent ONERROR\n  PRINT {0}\nEnd Event"
_CONTOUR = "CONTOURMODE(0) = {}\n{}(0)\nPRINT CONTOURMODE(0)"


def _last(name: str, actions: Actions, help: str, default: float = 0.0, renamed: str = "") -> Keyword:
    return Keyword(name, "", "reading", "R", "none", "integer", actions, help,
                   f"ACCEL(0) = 0\nMOVER(0) = 1\nGO(0){_FAIL.format(name)}", default=default, group=GROUP,
                   renamed=renamed)  # fmt: skip


def _contour(name: str, before: int, help: str) -> Keyword:
    return Keyword(name, "", "command", "C", "axes", "", _CONTOUR_ACTIONS, help, _CONTOUR.format(before, name),
                   group=GROUP, renamed=f"CONTOURMODE = {1 - before}")  # fmt: skip


ROWS = (
    _last("ERR", Actions(read=of(Errors, read_error)),
          "Number of the last error, 0 before the first one (v4; ERRCODE in MintMT).", renamed="ERRCODE"),
    _last("ERL", Actions(read=of(Errors, read_line)),
          "Line of the last error, 0 before the first one (v4; ERRLINE in MintMT).", renamed="ERRLINE"),
    _last("ERRAXIS", Actions(read=of(Errors, read_axis)),
          "Axis of the last error that an axis had, -1 before the first one (v4).",
          default=-1.0),
    Keyword("MODE", "", "reading", "R", "axis", "bits", AXIS_MODE,
            "Kind of motion of an axis (v4; AXISMODE in MintMT).", "MOVER(0) = 100\nGO(0)\nPRINT MODE(0)",
            default=0.0, group=GROUP, renamed="AXISMODE"),
    Keyword("HOLDTOANALOG", "", "setting", "RW", "axis", "%", HOLD,
            "Move an axis so that an analogue input holds this value (v4; HTA).",
            "HTACHANNEL(0) = 1 : HTAKPROP(0) = 2\nHOLDTOANALOG(0) = 25\nWAIT = 200\nPRINT VEL(0)\nSTOP(0)",
            default=0.0, low=-100.0, high=100.0, group="motion", effect="act",
            renamed="HTA"),
    Keyword("BANK", "", "setting", "RW", "none", "integer", _BANK,
            "The bank of inputs or outputs that keywords such as IN, OUT and INPUTDEBOUNCE mean without brackets (v4).",
            "BANK = 1\nINPUTDEBOUNCE = 3\nPRINT INPUTDEBOUNCE(1)", default=0.0, low=0, high=LAST_CHANNEL // BANK,
            group=GROUP),
    _contour("CONTOURON", 0, "Run through paths without slowing down (v4; CONTOURMODE = 1 in MintMT)."),
    _contour("CONTOUROFF", 1, "Slow down between paths (v4; CONTOURMODE = 0 in MintMT)."),
)  # fmt: skip
