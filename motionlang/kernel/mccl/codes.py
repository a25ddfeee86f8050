"""The `?` codes of the controller, and the exception that leads to such a reply."""

from __future__ import annotations

from collections.abc import Sequence

# The meanings of error codes, from the table that the MX driver was written with (after PMC's manual).
MEANINGS: dict[int, str] = {
    0: "no error",
    1: "unrecognised command",
    2: "bad command format",
    3: "I/O error",
    4: "command string too long",
    -1: "command parameter error",
    -2: "command code invalid",
    -3: "negative repeat count",
    -4: "macro define command not first",
    -5: "macro number out of range",
    -6: "macro does not exist",
    -7: "command cancelled by user",
    -14: "no axis specified",
    -15: "axis not assigned",
    -16: "axis already assigned",
    -17: "axis duplicate assigned",
}

UNRECOGNISED = 1
FORMAT = 2
IO = 3
TOO_LONG = 4
PARAMETER = -1
INVALID = -2
NEGATIVE_REPEAT = -3
DEFINE_NOT_FIRST = -4
MACRO_RANGE = -5
NO_MACRO = -6
CANCELLED = -7
NO_AXIS = -14
NOT_ASSIGNED = -15
ALREADY_ASSIGNED = -16
ASSIGNED_TWICE = -17


class Abandoned(Exception):
    """Raised by a command to leave its line and all macros around it."""


class Fault(Exception):
    """Raised so that the controller answers a command with `?code`.

    `kind` is one of `errors.CODES`. `candidates` are the commands that may have been meant.
    """

    def __init__(
        self,
        code: int,
        message: str,
        hint: str = "",
        kind: str = "command-error",
        candidates: Sequence[str] = (),
    ) -> None:
        self.code, self.message, self.hint, self.kind = code, message, hint, kind
        self.candidates = tuple(candidates)
        super().__init__(message)


def define_not_first() -> Fault:
    message = "MD must be the first command of its line"
    return Fault(DEFINE_NOT_FIRST, message, "put it on a line of its own", "syntax")


def negative_repeat(times: int) -> Fault:
    message = f"RP cannot repeat {times} times"
    return Fault(NEGATIVE_REPEAT, message, "RP without a number repeats forever", "range")


def no_register(number: int, count: int) -> Fault:
    return Fault(PARAMETER, f"there is no register {number}", f"registers are 0 to {count - 1}", "range")


def needs_axis(name: str, text: str) -> Fault:
    return Fault(NO_AXIS, f"{name} needs an axis number in front", f"such as 1{text}", "axis")


def no_distance(text: str) -> Fault:
    """Return the warning about a relative move without a number, which is a move by 0."""
    return Fault(
        0, f"{text} has no number, so it moves by 0", f"write the distance, as in {text}1000", "values"
    )


def too_short(text: str, axis: int, counts: float) -> Fault:
    """Return the warning about a relative move that is less than half a count."""
    message = f"{text} moves axis {axis} by less than half a count, which is 0"
    return Fault(0, message, f"US is in counts per user unit, and {counts:.10g} is in force", "range")


def rounded(text: str, value: float, whole: float) -> Fault:
    """Return the warning about a rate that the board rounds, since no scale is set."""
    message = f"{text} sets {whole:.10g}: a rate is a whole number until a scale is set"
    name = text.removesuffix(f"{value:.10g}")
    return Fault(0, message, f"write {name}{whole or 1:.10g}, or set the units of the axis first", "range")
