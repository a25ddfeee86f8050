"""What is wrong with a program that cannot be parsed: the lines that cannot be read, and the mistakes of all others."""

from __future__ import annotations

from motionlang.errors import ProgramError
from motionlang.mint.compile.compiler import compile_module
from motionlang.mint.keywords import table
from motionlang.mint.syntax.parser import parse
from motionlang.mint.syntax.tables import TABLES
from motionlang.source import Source

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.errors import Diagnostic
    from motionlang.mint.syntax.nodes import Module

# What is wrong with a statement by itself. Other mistakes, such as an Exit in no loop, may come of a line taken out.
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
# A line that opens a block takes others with it: its end, then what stood between.
_TURNS = 4


def with_other_lines(
    source: Source, settings: dict[str, object] | None, unreadable: ProgramError
) -> ProgramError:
    """The mistakes of a text and, with the lines that have them taken out, what the compiler says of the others.

    A name that stands in a line taken out may have been declared there: lines that use it are given no blame.
    """
    lines = source.text.split("\n")
    module, taken = _readable(source.name, lines, unreadable)
    if module is None:
        return unreadable
    names = {name for number in taken for name in _names(lines[number - 1])}
    try:
        compile_module(module, settings)
    except ProgramError as error:
        more = [each for each in error.diagnostics if _stands(each, lines, names)]
        return ProgramError([*unreadable.diagnostics, *more])
    return unreadable


def _readable(name: str, lines: list[str], error: ProgramError) -> tuple[Module | None, set[int]]:
    """The tree of what is left without the lines that cannot be read, and these; no tree where nothing helps."""
    taken: set[int] = set()
    for _ in range(_TURNS):
        taken.update(each.line for each in error.diagnostics)
        kept = ("" if number in taken else line for number, line in enumerate(lines, 1))
        try:
            return parse(Source(name, "\n".join(kept))), taken
        except ProgramError as again:
            error = again
    return None, taken


_WORDS = ("NAME", "DOTTED")


def _names(line: str) -> set[str]:
    """The words of a line that are not Mint's."""
    words = table()
    pieces = set(TABLES.texts(line))  # each once: a line may have a million of them
    found = {piece.lower() for piece in pieces if TABLES.kind_of[piece] in _WORDS}
    return {word for word in found if (row := words.get(word)) is None or not row.simulated}


def _stands(mistake: Diagnostic, lines: list[str], names: set[str]) -> bool:
    """Whether a mistake would be one, too, if the lines taken out were right."""
    return mistake.code in _OF_A_STATEMENT and not _names(lines[mistake.line - 1]) & names
