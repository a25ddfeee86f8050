"""Errors of a program that cannot be parsed: its unreadable lines, and those that the check finds in the others."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from motionlang.kernel.errors import Diagnostic, ProgramError
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.kernel.mint.syntax.recovery import readable
from motionlang.kernel.mint.syntax.tokens import Tokens
from motionlang.kernel.source import Source

# Errors that concern a statement by itself. Other errors, such as an Exit outside a loop, may be caused by a
# removed line.
_OF_A_STATEMENT = frozenset(
    {
        "unknown-word",
        "not-simulated",
        "values",
        "read-only",
        "write-only",
        "not-a-command",
        "type",
        "range",
        "axis",
        "channel",
        "index",
        "division-by-zero",
    }
)


def parsed(source: Source, check: Callable[[Module], object]) -> Module:
    """Parse a text; raise ProgramError with its syntax errors and those that `check` finds in its readable lines."""
    try:
        return parse(source)
    except ProgramError as error:
        raise with_other_lines(source, check, error) from None


def with_other_lines(
    source: Source, check: Callable[[Module], object], unreadable: ProgramError
) -> ProgramError:
    """Return the syntax errors of a text and those that `check` raises for its readable lines."""
    module, taken = readable(source, unreadable)
    if module is None:
        return unreadable
    try:
        check(module)
    except ProgramError as error:
        return ProgramError([*unreadable.diagnostics, *unrelated(error.diagnostics, source, taken)])
    return unreadable


def unrelated(found: Iterable[Diagnostic], source: Source, taken: Iterable[int]) -> list[Diagnostic]:
    """Return those of the errors of the readable lines that would remain if the removed lines were correct.

    A name in a removed line may have been declared there, so lines that use it are not reported.
    """
    names = {name for number in taken for name in _names(source.line(number))}
    return [each for each in found if _is_unrelated(each, source, names)]


_WORDS = ("NAME", "DOTTED")


def _names(line: str) -> set[str]:
    """Return the words of a line that are not keywords of Mint."""
    words = table()
    tokens = Tokens(line)
    found = {text.lower() for kind, text in zip(tokens.kinds, tokens.texts, strict=True) if kind in _WORDS}
    return {word for word in found if (row := words.get(word)) is None or not row.simulated}


def _is_unrelated(mistake: Diagnostic, source: Source, names: set[str]) -> bool:
    """True if an error would remain if the removed lines were correct."""
    return mistake.code in _OF_A_STATEMENT and not _names(source.line(mistake.line)) & names
