"""Errors of a running program, as diagnostics with a location."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.errors import Diagnostic, ProgramError, Rejected
from motionlang.kernel.source import Source

if TYPE_CHECKING:
    from motionlang.kernel.lang.dialect import Dialect
    from motionlang.kernel.lang.task import Task

# Python's arithmetic errors, in the terms of the program's author.
_ARITHMETIC: dict[type[BaseException], tuple[str, str, str]] = {
    ZeroDivisionError: ("division-by-zero", "division by zero", "test the divisor before dividing"),
    OverflowError: (
        "overflow",
        "the result is too large for a number",
        "check the values that go into this line",
    ),
    MemoryError: ("limit", "the program needs too much memory", "make its arrays smaller"),
}


class NotSimulated(Exception):
    """Raised if a statement reaches a keyword that is known but not simulated.

    No handler of the language catches it. `at` is the source position of the keyword, -1 if only the position
    of the statement is known.
    """

    def __init__(self, message: str, hint: str = "", at: int = -1) -> None:
        self.message, self.hint, self.at = message, hint, at
        super().__init__(message)


def explain(dialect: Dialect, source: Source, task: Task | None, error: Exception) -> Diagnostic | None:
    """Return the diagnostic for an error of a run; None if it is an internal error."""
    if isinstance(error, ProgramError):
        return error.diagnostics[0]
    if isinstance(error, Rejected):
        code, message, hint = error.code, error.message, error.hint
    elif isinstance(error, NotSimulated):
        code, message, hint = "not-simulated", error.message, error.hint
    elif type(error) in _ARITHMETIC:
        code, message, hint = _ARITHMETIC[type(error)]
    else:
        return None
    line, column, length = _where(dialect, source, task, error)
    return Diagnostic(code, message, line, column, length=length, hint=hint)


def _where(dialect: Dialect, source: Source, task: Task | None, error: Exception) -> tuple[int, int, int]:
    if isinstance(error, Rejected) and error.line:
        text = source.line(error.line)
        indent = len(text) - len(text.lstrip())
        return error.line, indent + 1, max(1, len(text.strip()))
    if isinstance(error, NotSimulated) and error.at >= 0:
        return dialect.locate(source, error.at)
    if task is None:
        return 0, 0, 1
    return dialect.locate(source, task.at_error(error))
