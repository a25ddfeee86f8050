"""Comments that silence warnings, and the inputs that a machine file drives."""

from __future__ import annotations

from motionlang.errors import Diagnostic
from motionlang.lang.lint import driven_inputs, has_host, silence
from motionlang.mint.lint import COMMENT
from motionlang.source import Source
from tests.cases import cases


def warnings(*lines: int, code: str = "busy-loop", severity: str = "warning") -> list[Diagnostic]:
    return [Diagnostic(code, "", line, severity=severity) for line in lines]


@cases(
    "text, left",
    [
        ("a\nb\nc", [1, 2, 3]),
        ("a\nb ' lint: ignore\nc", [1, 3]),
        ("a\nb ' LINT:ignore busy-loop\nc", [1, 3]),
        ("a\nb ' why not; lint: ignore in-motion, busy-loop\nc", [1, 3]),
        ("a\nb ' lint: ignore in-motion\nc", [1, 2, 3]),
        ("a ' lint: ignore\nb ' lint: ignore\nc", [3]),
        # On its own line it is about the line below.
        ("a\n  ' lint: ignore\nc", [1, 2]),
        ("  ' lint: ignore in-motion\n b ' lint: ignore busy-loop\nc", [1, 3]),
        # Only a comment counts, and only the word.
        ('a\nPRINT "lint: ignore"\nc', [1, 2, 3]),
        ("a\nb ' lint: ignored\nc", [1, 2, 3]),
        ("a\nb ' lint: host\nc", [1, 2, 3]),
    ],
)
def test_a_comment_silences_the_warnings_of_its_line(text: str, left: list[int]) -> None:
    found = silence(Source("a", text), warnings(1, 2, 3), COMMENT)
    assert [each.line for each in found] == left


def test_an_error_is_not_silenced() -> None:
    errors = warnings(1, severity="error")
    assert silence(Source("a", "a ' lint: ignore"), errors, COMMENT) == errors


@cases(
    "comment, column, length, message, hint",
    [
        ("' lint: ignore busyloop", 18, 8, "there is no warning busyloop", "did you mean busy-loop?"),
        ("' lint: ignore zzz", 18, 3, "there is no warning zzz", "docs/lint.md lists all warnings"),
        ("' lint: ignore type", 18, 4, "type is an error and cannot be ignored", ""),
    ],
)
def test_an_unknown_code_is_reported(comment: str, column: int, length: int, message: str, hint: str) -> None:
    (found,) = silence(Source("a", f"\na {comment}"), [], COMMENT)
    assert (
        found.code,
        found.severity,
        found.line,
        found.column,
        found.length,
        found.message,
        found.hint,
    ) == (
        *("silenced", "warning", 2, column, length),
        *(message, hint),
    )


def test_a_program_that_a_host_uses_says_so() -> None:
    for text, expected in (
        ("a\nb ' lint: host", True),
        ("a\nb ' LINT:HOST reads all", True),
        ('a\nPRINT "lint: host"', False),
        ("a\nb ' lint: hosts", False),
        ("a\nb ' a host", False),
    ):
        assert has_host(Source("a", text), COMMENT) is expected, text


@cases(
    "settings, inputs",
    [
        ({}, None),
        ({"controller.axes": 4, "run.until": 1.0}, None),
        ({"controller.axes": 4, "axis.0.travel": [0, 1]}, set()),
        ({"input": [{"channel": 3}, {"channel": 5}], "axis.0.home_input": 7}, {3, 5, 7}),
    ],
)
def test_the_inputs_that_a_machine_file_drives(settings: dict[str, object], inputs: set[int] | None) -> None:
    """Without a file any input may change."""
    assert driven_inputs(settings) == inputs
