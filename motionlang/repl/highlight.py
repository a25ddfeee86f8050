"""Highlighting: the dialect cuts the text up, the keyword table says which words it knows."""

from __future__ import annotations

from collections.abc import Callable

from prompt_toolkit.document import Document
from prompt_toolkit.formatted_text import StyleAndTextTuples
from prompt_toolkit.lexers import Lexer
from prompt_toolkit.styles import Style

from motionlang.lang.dialect import Dialect
from motionlang.repl.commands import is_command

STYLE = Style.from_dict(
    {
        "prompt": "bold",
        "dotted": "ansimagenta",
        "move": "ansicyan bold",
        "keyword": "ansicyan",
        "not-simulated": "ansired",
        "control": "ansiblue bold",
        "unknown": "ansired underline",
        "axis": "bold",
        "register": "ansimagenta",
        "number": "ansigreen",
        "string": "ansiyellow",
        "comment": "ansibrightblack italic",
        "bottom-toolbar": "noreverse ansibrightblack",
        "bottom-toolbar.text": "",
    }
)


def styled(dialect: Dialect, text: str) -> StyleAndTextTuples:
    """`text` in pieces, each with its style; nothing of it is left out."""
    if is_command(text):
        return [("class:dotted", text)]
    pieces: StyleAndTextTuples = []
    at = 0
    for kind, piece, offset in dialect.tokens(text):
        if offset > at:
            pieces.append(("", text[at:offset]))
        pieces.append((_style(dialect, kind, piece), piece))
        at = offset + len(piece)
    if at < len(text):
        pieces.append(("", text[at:]))
    return pieces


class WordLexer(Lexer):
    """`styled`, a line at a time, as the terminal wants it."""

    def __init__(self, dialect: Dialect) -> None:
        self._dialect = dialect

    def lex_document(self, document: Document) -> Callable[[int], StyleAndTextTuples]:
        """Styled text by line number; beyond the last line nothing."""
        lines: list[StyleAndTextTuples] = [[]]
        for style, text, *_ in styled(self._dialect, document.text):
            first, *rest = text.split("\n")
            lines[-1].append((style, first))
            lines.extend([(style, part)] for part in rest)
        return lambda number: lines[number] if number < len(lines) else []


def _style(dialect: Dialect, kind: str, text: str) -> str:
    row = dialect.table().get(text) if kind in _WORDS else None
    if row is not None:
        return "class:" + ("move" if row.kind == "move" else "keyword" if row.simulated else "not-simulated")
    return _STYLES.get(kind, "")


_WORDS = ("word", "command", "not-simulated")
_STYLES = {
    "control": "class:control",
    "number": "class:number",
    "axis": "class:axis",
    "register": "class:register",
    "string": "class:string",
    "text": "class:string",
    "comment": "class:comment",
    "bad": "class:unknown",
    "unknown": "class:unknown",
}
