"""Invalid programs under tests/errors/mint, each with its diagnostics in a `.txt`."""

from __future__ import annotations

from pathlib import Path

import pytest

from motionlang import run
from motionlang.kernel import ProgramError, Source
from motionlang.kernel.mint.resolve.problems import Problems
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.views.diagnostics import render

BROKEN = sorted((Path(__file__).parents[3] / "errors" / "mint").glob("*.mnt"))


def reported(path: Path) -> str:
    """Return the output up to the error, and all messages."""
    source = Source.read(path)
    result = run(source, until=3600.0)
    shown = [f"{line}\n" for line in result.output]
    return "".join(shown + [render(each, source) for each in result.diagnostics])


@pytest.mark.parametrize("path", BROKEN, ids=lambda path: path.stem)
def test_the_message_teaches(path: Path, request: pytest.FixtureRequest) -> None:
    text, golden = reported(path), path.with_suffix(".txt")
    if request.config.getoption("--update"):
        golden.write_text(text)
    assert text == golden.read_text()


def test_there_are_broken_programs() -> None:
    assert len(BROKEN) >= 15


def test_a_hundred_warnings_hide_no_error() -> None:
    problems = Problems(parse(Source("a.mnt", "PRINT 1\n" * 200)))
    for at in range(150):
        problems.add("not-simulated", "no effect", at, severity="warning")
    problems.add("type", "wrong", 151)
    with pytest.raises(ProgramError):
        problems.raise_errors()


@pytest.mark.parametrize(
    ("text", "message", "hint"),
    [
        ("SPEED", "SPEED needs a value", "SPEED = value sets it, PRINT SPEED shows it"),
        ("SPEED(0)", "SPEED needs a value", "SPEED(…) = value sets it, PRINT SPEED(…) shows it"),
        ("TIME 0", "TIME needs a value", "TIME = 0"),
        ("TIMEREVENT(2.5)", "TIMEREVENT needs a value", "TIMEREVENT = 2.5"),
        ("TIME x", "TIME needs a value", "TIME = value"),
        ("TIME", "TIME needs a value", "TIME = value sets it, PRINT TIME shows it"),
        ("IDLE(0)", "IDLE is a value, not a statement", "print it with PRINT IDLE(…)"),
        ("IDLE", "IDLE is a value, not a statement", "print it with PRINT IDLE"),
    ],
)
def test_a_keyword_that_is_no_statement_is_shown_as_it_is_used(text: str, message: str, hint: str) -> None:
    (found,) = run(Source("a.mnt", f"{text}\n")).diagnostics
    assert (found.message, found.hint) == (message, hint)
