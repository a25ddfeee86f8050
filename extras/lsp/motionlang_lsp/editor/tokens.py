"""Semantic tokens: the kinds of words, from the tables of syntax highlighting."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from motionlang.kernel import dialect
from motionlang.views.highlight import pieces
from motionlang_lsp.editor.page import Page

# The kinds of tokens, in the order of their numbers, by the kinds of `views/highlight.py` and `kernel/lang/names.py`.
TYPES = (
    "keyword", "function", "property", "variable", "parameter", "type", "label", "event", "macro", "number",
    "string", "comment", "operator", "class",
)  # fmt: skip
_TYPE_OF = {
    "control": "keyword",
    "keyword": "property",
    "move": "function",
    "not-simulated": "property",
    "number": "number",
    "string": "string",
    "text": "string",
    "comment": "comment",
    "operator": "operator",
    "axis": "number",
    "register": "variable",
    "variable": "variable",
    "parameter": "parameter",
    "constant": "variable",
    "define": "macro",
    "sub": "function",
    "function": "function",
    "task": "class",
    "event": "event",
    "label": "label",
    "type": "type",
    "member": "property",
    "macro": "macro",
}
_NUMBERS = {kind: TYPES.index(name) for kind, name in _TYPE_OF.items()}
# Modifiers, in the order of their bits.
MODIFIERS = ("readonly", "deprecated", "defaultLibrary")
_MODIFIERS = {"constant": 1, "not-simulated": 2 | 4, "keyword": 4, "move": 4}


@lru_cache(50_000)
def _words(language: str, line: str) -> tuple[tuple[int, int, str, str], ...]:
    """Return column, length, kind and name of the tokens of a line.

    The result is cached, because most lines do not change with a keystroke.
    """
    found = []
    for column, kind, piece in pieces(dialect(language), line):
        if kind in ("word", "keyword", "move", "not-simulated"):
            name = piece.partition(".")[0]
            found.append((column, len(name), kind, name.lower()))
        elif kind in _NUMBERS:
            found.append((column, len(piece), kind, ""))
    return tuple(found)


def tokens(page: Page) -> Iterator[tuple[int, int, int, int, int]]:
    """Yield line, column, length, type and modifiers of the words; lines and columns count from 0.

    A name has the kind of the definition with its spelling.
    """
    kinds: dict[str, str] = {}
    for each in page.names.definitions:
        kinds.setdefault(each.name.lower(), each.kind)
    language = page.language.name
    for number, line in enumerate(page.text.split("\n")):
        for column, length, kind, name in _words(language, line):
            kind = kinds.get(name, kind) if name else kind
            type_number = _NUMBERS.get(kind)
            if type_number is not None:
                yield number, column, length, type_number, _MODIFIERS.get(kind, 0)
