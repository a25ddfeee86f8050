"""Completion of keywords with help, commands of the prompt and file names."""

from __future__ import annotations

import re
from collections.abc import Iterable

from prompt_toolkit.completion import CompleteEvent, Completer, Completion, PathCompleter
from prompt_toolkit.document import Document

from motionlang.kernel import Dialect
from motionlang.repl.commands import COMMANDS, is_command

_WORD = re.compile(r"[A-Za-z_]\w*$")
_PROSE = ("comment", "string", "text")


def candidates(dialect: Dialect, text: str) -> list[tuple[str, int, str]]:
    """Return the completions of `text`.

    Each has a name in the case that the user types, the number of characters that it replaces, and its line of help.
    """
    line = text.rpartition("\n")[2]
    if line.lstrip().startswith(".") and " " not in line.lstrip():
        begun = line.lstrip()[1:]
        found = [command for name, command in COMMANDS.items() if name.startswith(begun.lower())]
        return [(command.name, len(begun), command.help) for command in found]
    word = _WORD.search(line)
    if word is None or _in_prose(dialect, line):
        return []
    begun, upper = word[0], word[0].upper()
    rows = [
        row for row in dialect.table() if row.name.upper().startswith(upper) or row.short.upper() == upper
    ]
    rows.sort(key=lambda row: (not row.simulated, row.name.upper()))
    return [
        (
            row.name.lower() if begun.islower() else row.name,
            len(begun),
            row.help if row.simulated else f"not simulated: {row.help}",
        )
        for row in rows
    ]


class WordCompleter(Completer):
    """`candidates` for the terminal, and file names after `.load` and `.plot`."""

    def __init__(self, dialect: Dialect) -> None:
        self._dialect = dialect
        self._paths = PathCompleter(expanduser=True)

    def get_completions(self, document: Document, complete_event: CompleteEvent) -> Iterable[Completion]:
        """Return file names after a command that takes one, else the `candidates`."""
        word, _, argument = document.current_line_before_cursor.lstrip().partition(" ")
        command = COMMANDS.get(word[1:]) if is_command(word) else None
        if command is not None and "FILE" in command.argument and argument:
            yield from self._paths.get_completions(Document(argument), complete_event)
            return
        for name, length, help in candidates(self._dialect, document.text_before_cursor):
            yield Completion(name, start_position=-length, display_meta=help)


def _in_prose(dialect: Dialect, line: str) -> bool:
    """True if the end of `line` is in a comment or a string, which may be open."""
    pieces = list(dialect.tokens(line))
    return bool(pieces) and (pieces[-1][0] in _PROSE or pieces[-1][1].startswith('"'))
