"""Errors of a run as diagnostics: their code, text and location."""

from __future__ import annotations

from motionlang.kernel import Diagnostic, ProgramError, Rejected, Source
from motionlang.kernel.lang import explain
from motionlang.kernel.lang.run_errors import NotSimulated
from motionlang.kernel.mint import DIALECT
from tests.cases import cases

TEXT = "CANSTATUS = 1\n   JOG(0) = 5  \n\n"

Where = tuple[int, int, int]


def rejected(line: int) -> Rejected:
    error = Rejected("range", "too fast", "less")
    error.line = line
    return error


@cases(
    "error, code, message, hint, where",
    [
        (rejected(2), "range", "too fast", "less", (2, 4, 10)),
        (rejected(3), "range", "too fast", "less", (3, 1, 1)),
        (rejected(0), "range", "too fast", "less", (0, 0, 1)),
        (NotSimulated("no bus", "a drive", at=0), "not-simulated", "no bus", "a drive", (1, 1, 9)),
        (NotSimulated("no bus", at=12), "not-simulated", "no bus", "", (1, 13, 1)),
        (NotSimulated("no bus"), "not-simulated", "no bus", "", (0, 0, 1)),
        (
            ZeroDivisionError(),
            "division-by-zero",
            "division by zero",
            "test the divisor before dividing",
            (0, 0, 1),
        ),
    ],
)
def test_the_diagnostic_of_an_error(
    error: Exception, code: str, message: str, hint: str, where: Where
) -> None:
    """The text of a line at fault is marked without the blanks around it.

    An error without a line and without a task has no location.
    """
    found = explain(DIALECT, Source("a.mnt", TEXT), None, error)
    assert found is not None
    assert (found.code, found.message, found.hint) == (code, message, hint)
    assert (found.line, found.column, found.length) == where


def test_errors_of_a_text_and_internal_errors() -> None:
    """Of several errors of a text the first is reported, of internal ones none."""
    source = Source("a.mnt", TEXT)
    several = ProgramError([Diagnostic("syntax", "second", 2, 1), Diagnostic("syntax", "first", 1, 1)])
    assert explain(DIALECT, source, None, several) == several.diagnostics[0]
    assert several.diagnostics[0].message == "first"
    assert explain(DIALECT, source, None, KeyError("internal")) is None
