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
# The part of a relative move that may be lost by rounding without a warning.
MAX_LOST = 0.01


class LineAbandoned(Exception):
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


def no_time(text: str, axis: int) -> Fault:
    """Return the warning about a wait for a time without a number, which does not wait."""
    hint = "write the time in seconds, as in WA0.5"
    if axis:
        hint = f"{axis}WS waits for the end of the move; {hint}"
    return Fault(0, f"{text} has no number, so it waits for 0 s", hint, "values")


def inexact(text: str, axis: int, value: float, whole: float, counts: float) -> Fault | None:
    """Return the warning about a relative move by `whole` counts, None if these are close to `value` user units."""
    exact = value * counts
    if abs(whole - exact) <= MAX_LOST * abs(exact):
        return None
    unit = "count" if abs(whole) == 1.0 else "counts"
    message = f"{text} moves axis {axis} by {whole:.10g} {unit}, not by {exact:.10g}"
    hint = "the difference adds up with each MR; give the targets with MA"
    if not whole:
        message = f"{text} moves axis {axis} by less than half a count, which is 0"
        hint = f"US is in counts per user unit, and {counts:.10g} is in force"
    return Fault(0, message, hint, "range")


def rounded(text: str, value: float, whole: float) -> Fault:
    """Return the warning about a rate that the board rounds, since no scale is set."""
    message = f"{text} sets {whole:.10g}: a rate is a whole number until a scale is set"
    name = text.removesuffix(f"{value:.10g}")
    return Fault(0, message, f"write {name}{whole or 1:.10g}, or set the units of the axis first", "range")
