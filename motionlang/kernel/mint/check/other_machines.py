"""Statements as other machines have them, `MOVE X 100` or `G01 X100`, and what is typed here."""

from __future__ import annotations

import re

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.keywords import table

_LETTERS = "XYZ"
# A word, an axis if there is one, and a value; a letter may be directly before the value.
_STATEMENT = re.compile(
    rf"\b([A-Z]\w*)[ \t]+(?:([{_LETTERS}]|\d+(?=[ \t,=]))[ \t]*[,=]?[ \t]*)?(-?\d+\.?\d*)", re.IGNORECASE
)


def as_typed(text: str, at: int) -> str:
    """Return a hint with the statement that another machine writes as in `text` at an offset, "" for none."""
    for found in _STATEMENT.finditer(text):
        if found.start() <= at and ":" not in text[found.end() : at]:
            return _hint(*found.groups())
    return ""


def _hint(word: str, axis: str | None, value: str) -> str:
    rows = [row for row in map(table().get, (word, *table().meant_by(word))) if row is not None]
    number = str(_LETTERS.find(axis.upper())) if axis and axis.isalpha() else axis or "0"
    moves = [row for row in rows if row.kind == "move" and row.index == "axis"]
    if moves:
        typed = ", ".join(
            f"{_assigned(row, number, value)} moves {'by' if row.does('relative') else 'to'} {value}"
            for row in moves
        )
        return f"{typed}; GO({number}) starts it"
    settings = [
        _assigned(row, number, value) for row in rows if row.kind == "setting" and row.index == "axis"
    ]
    return f"write {' or '.join(settings)}" if settings else ""


def _assigned(row: Keyword, axis: str, value: str) -> str:
    return f"{row.name}({axis}) = {value}"
