"""From MCCL text to lines and commands, with `grammars/mccl.lark`.

This module contains no mnemonic.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from motionlang.mccl.syntax.tables import COMMAND, PIECE, SEPARATORS, TERMINALS

# The parts of a command: the axis with the mnemonic, and at most one parameter, which is an integer, a
# real number, a register or a text in quotes. A missing part is None.
Parts = tuple[str | None, ...]

_AXIS, _MNEMONIC = (re.compile(TERMINALS[name], re.ASCII) for name in ("AXIS", "MNEMONIC"))
# The controller's input buffer, in characters.
MAX_LINE = 255


def pieces(line: str) -> list[str]:
    """Return the text of each command of a line, including invalid ones."""
    found: list[str] = PIECE.findall(line)
    while found and not found[-1]:
        found.pop()
    return found


def spans(line: str) -> Iterator[tuple[int, int]]:
    """Yield the start and end of the text of each command of a line."""
    for match in PIECE.finditer(line):
        if match[1]:
            yield match.span(1)


def parts(piece: str) -> Parts | None:
    """Return the components of a command, or None if the text is not a command."""
    match = COMMAND.fullmatch(piece)
    return match and match.groups()


def without_comment(line: str) -> str:
    """Return the line without its comment, as a downloader sends it."""
    end = max((end for _, end in spans(line)), default=0)
    separators = SEPARATORS.match(line, end)
    return line[: separators.end()] if separators else line[:end]


def head(text: str) -> tuple[str, str]:
    """Return the axis number and mnemonic at the beginning of a command.

    The mnemonic is "" if it has none.
    """
    axis = _AXIS.match(text)
    begin = axis.end() if axis else 0
    mnemonic = _MNEMONIC.match(text, begin)
    return text[:begin], mnemonic[0] if mnemonic else ""
