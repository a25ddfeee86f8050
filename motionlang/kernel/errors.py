"""Errors in a user's program: the message, its location, and a hint.

A `Diagnostic` is one error; a `ProgramError` has all errors of a file. They are displayed by
`motionlang.views.diagnostics`. The controller raises `Rejected` while a program runs. Faults of the *machine* are part
of an axis's state, not errors.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from motionlang.kernel.tools import PicklableError

# The codes of diagnostics and their meanings. The rules of the linter (`commands/check/rules/`) have the examples and
# the fix of each of their codes, `commands/help/explanations.py` those of the others.
CODES: dict[str, str] = {
    "syntax": "The text does not follow the grammar of the language.",
    "language": "The file is written in the other language.",
    "missing-end": "A block was opened and never closed.",
    "stray-end": "A block is closed that was never opened.",
    "unknown-word": "The name is neither a keyword nor declared in the program.",
    "not-simulated": "The keyword belongs to the language, but is not simulated here.",
    "values": "The number of axes, arguments or values does not fit the keyword.",
    "read-only": "The keyword can be read but not written.",
    "write-only": "The keyword can be written but has no value to read.",
    "not-a-command": "The keyword is a value and cannot be a statement.",
    "type": "The types of the values do not match.",
    "duplicate": "The name is already taken.",
    "range": "The value lies outside what the keyword accepts.",
    "axis": "There is no such axis on this controller.",
    "channel": "There is no such input, output or element.",
    "no-connection": "The node or the server does not answer.",
    "terminal": "There is no such terminal.",
    "one-terminal": "This can be done with one terminal at a time.",
    "index": "The subscript lies outside the array.",
    "division-by-zero": "A number was divided by zero.",
    "overflow": "The number is too large for its type.",
    "string-overflow": "The text is longer than its String.",
    "argument": "The function has no value for this argument.",
    "disabled-axis": "The axis is off, and the command needs it on.",
    "enable-input": "The hardware enable input of the drive is off.",
    "axis-error": "The axis has an error; it accepts no motion until the error is cleared.",
    "zero-speed": "A move with no speed never ends.",
    "zero-acceleration": "A move with no acceleration or deceleration can neither start nor stop.",
    "moving": "The command needs the axis at rest.",
    "stopping": "The axis is decelerating to rest and accepts no move until then.",
    "buffer-in-use": "The size of a move buffer can only be changed while it is empty and the axis at rest.",
    "buffer-full": "The move buffer is full and will never drain.",
    "never": "The program waits for something that can no longer happen.",
    "not-primed": "The error registers were read before an error was read into them.",
    "recursion": "Calls are nested deeper than the controller's stack.",
    "limit": "The run ended because it produced too much data.",
    "golden": "The run does not match its golden files, or has none.",
    "beyond-limit": "A limit was exceeded or met, an axis had a fault, or the motion is not verified.",
    "interrupted": "The run was ended from the keyboard, or by a signal.",
    "crash": "An internal error of motionlang, not an error of the program.",
    "window": "A picture or a trace needs data that the run does not have.",
    "budget": "The run took longer than the machine file's budget allows.",
    "recording": "The recording cannot be read or compared.",
    "extra": "An optional library that the command needs is not installed.",
    "file": "The file could not be read or written.",
    "address": "The TCP address or serial device cannot be served or reached.",
    "machine-file": "The machine file is invalid.",
    "option": "An option of the command line does not fit the program or its machine file.",
    "guess": "The result depends on guesses of motionlang init.",
    "not-a-number": "The operator's answer to INPUT is no number, and its number is taken, or 0.",
    "unasked": "An answer was given that no INPUT took.",
    "command-error": "The controller answered the command with an error code.",
    "model": "The chosen controller model does not support this.",
    # Warnings of the linters; docs/diagnostics.md explains each.
    "never-asked": "An entry of the machine file has asked, and the program never asks for its value.",
    "never-started": "A move is loaded into the buffer and never started.",
    "in-motion": "A position is read or set while the move just started is in motion.",
    "scale-in-motion": "The scale is changed while the axis moves.",
    "scale-after-speed": "The scale is set after speeds and rates and changes them.",
    "time-before-speed": "A ramp time is set before the speed it refers to.",
    "short-name": "A statement adds to a keyword that is written by its short name.",
    "short-ramp": "A ramp is shorter than one trajectory update.",
    "unused-setting": "A speed or a rate is set and never used.",
    "nothing-loaded": "A GO starts nothing, because no move is loaded.",
    "exact-position": "A position is compared for equality while the axis moves.",
    "two-clocks": "A Time variable, which counts by itself, is subtracted from TIME or the reverse.",
    "wait-condition": "A WAIT, which takes a time, is given a condition.",
    "busy-loop": "An endless loop that computes and never waits.",
    "buffer-overfilled": "More moves are loaded before GO than the buffer holds.",
    "beyond-travel": "A move ends beyond the travel of the axis or its software limits.",
    "two-tasks": "Two tasks command the same axis.",
    "endless-wait": "A wait for a condition that nothing can change.",
    "endless-loop": "A loop that never changes its condition.",
    "constant-condition": "A condition that is always true or always false.",
    "mixed-operators": "& or | next to a comparison, without brackets.",
    "unreachable": "No path leads to the statement.",
    "unused-label": "A label that is never used.",
    "unused-variable": "A variable that is never read.",
    "no-value": "A variable that is read and never given a value.",
    "never-waits": "A loop starts moves and never waits for one.",
    "cut-short": "A motion is stopped in the moment in which it starts.",
    "ignored": "A part of a line has no effect.",
    "slow-handler": "The handler of the timer waits longer than its period.",
    "wrong-channel": "An output is switched at a channel that is an input.",
    "unused-sub": "A sub or a function that is never called.",
    "unused-task": "A task that is never run.",
    "motor-off": "A command moves a motor that is off.",
    "nothing-to-wait-for": "A wait for the end of a move that was never started.",
    "still-running": (
        "A move or a wait needs an axis at rest, but the axis runs in velocity mode until it is stopped."
    ),
    "else-if": "An Else If on one line is read as an ElseIf, which may not be what you want.",
    "silenced": "A comment silences a warning that does not exist.",
}


class Diagnostic:
    """One error: `line` and `column` count from 1, `length` is the width of carets.

    `code` is one of `CODES`, or of another package that reports by it.
    `column` 0 means that only the line is known, `line` 0 that the error is about the whole file. `count` is the
    number of occurrences in a run, from the machine time `first` to `last`, s. `fix` is the correction of the marked
    text if it is unambiguous, or "". `candidates` are texts that may have been meant instead of it.
    """

    __slots__ = (
        "candidates", "code", "column", "count", "first", "fix", "hint", "last", "length", "line", "message",
        "severity",
    )  # fmt: skip

    def __init__(
        self,
        code: str,
        message: str,
        line: int = 0,
        column: int = 0,
        *,
        length: int = 1,
        hint: str = "",
        severity: str = "error",
        fix: str = "",
        candidates: Sequence[str] = (),
    ) -> None:
        self.code, self.message, self.line, self.column = code, message, line, column
        self.length, self.hint, self.severity, self.fix = length, hint, severity, fix
        self.candidates = tuple(candidates)
        self.count, self.first, self.last = 1, 0.0, 0.0

    def __repr__(self) -> str:
        return f"Diagnostic({self.code!r}, {self.message!r}, {self.line}, {self.column})"

    @property
    def key(self) -> tuple[object, ...]:
        """An identity shared by equal diagnostics."""
        return self.code, self.message, self.line, self.column, self.severity

    def again(self, time: float) -> None:
        """Count another occurrence."""
        self.count += 1
        self.last = time

    def as_dict(self) -> dict[str, object]:
        """Return the fields of the JSON report, with count and times if there are several."""
        times: dict[str, object] = {}
        if self.count > 1:
            times = {"count": self.count, "first_time": self.first, "last_time": self.last}
        return {
            "severity": self.severity,
            "code": self.code,
            "message": self.message,
            "line": self.line,
            "column": self.column,
            "hint": self.hint,
            **times,
        }


class ProgramError(PicklableError):
    """An invalid or failed program, with all diagnostics in the order of the text."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = sorted(diagnostics, key=lambda d: (d.line, d.column))
        super().__init__(
            "; ".join(f"line {d.line}: {d.message}" if d.line else d.message for d in self.diagnostics)
        )

    @classmethod
    def of(cls, code: str, message: str, line: int = 0, column: int = 0, hint: str = "") -> ProgramError:
        """Return the error with one diagnostic."""
        return cls([Diagnostic(code, message, line, column, hint=hint)])


class Rejected(PicklableError):
    """A command that the controller rejects; `code` is one of `CODES`.

    The language decides how to handle it: Mint raises a run-time error, MCCL gives a `?` code, and both
    report a diagnostic if the program does not handle it.
    """

    def __init__(self, code: str, message: str, hint: str = "") -> None:
        self.code, self.message, self.hint = code, message, hint
        self.line = 0  # the program line at fault, if it is not the one being executed
        super().__init__(message)


class Terminated(SystemExit):
    """A signal such as SIGTERM has ended the command; `code` is its exit status."""

    def __init__(self, number: int) -> None:
        self.number = number
        super().__init__(128 + number)


class OutOfTime(KeyboardInterrupt):
    """The run has used up its processor time, `seconds`."""

    def __init__(self, seconds: float) -> None:
        super().__init__()
        self.seconds = seconds
