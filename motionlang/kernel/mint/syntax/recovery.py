"""Parse a text with errors: unreadable lines are blanked until the rest parses."""

from __future__ import annotations

from motionlang.kernel.errors import ProgramError
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.parser import parse
from motionlang.kernel.source import Source

# The maximum number of attempts. Blanking a line that opens a block makes others unreadable: its end, then
# the lines between.
_ATTEMPTS = 4


def readable(source: Source, error: ProgramError) -> tuple[Module | None, set[int]]:
    """Return the tree of a text without its unreadable lines, and their numbers.

    Blanks replace these lines, so positions in the rest stay the same. `error` has the errors of the text. The
    tree is None if the rest cannot be parsed either.
    """
    taken: set[int] = set()
    for _ in range(_ATTEMPTS):
        taken.update(each.line for each in error.diagnostics)
        remaining = (" " * len(line) if number in taken else line for number, line in source.numbered())
        try:
            return parse(Source(source.name, "\n".join(remaining), source.before)), taken
        except ProgramError as again:
            error = again
    return None, taken
