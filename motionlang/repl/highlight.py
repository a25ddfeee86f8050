"""Syntax highlighting of a line."""

from __future__ import annotations

from collections.abc import Callable

from prompt_toolkit.document import Document
from prompt_toolkit.formatted_text import StyleAndTextTuples
from prompt_toolkit.lexers import Lexer
from prompt_toolkit.styles import Style

from motionlang.kernel import Dialect
from motionlang.repl.commands import is_command
from motionlang.views.highlight import pieces

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
    """Split all of `text` into fragments, each with its style."""
    if is_command(text):
        return [("class:dotted", text)]
    return [(_STYLES.get(kind, ""), piece) for _, kind, piece in pieces(dialect, text)]


class WordLexer(Lexer):
    """`styled` for each line, in the form that the terminal needs."""

    def __init__(self, dialect: Dialect) -> None:
        self._dialect = dialect

    def lex_document(self, document: Document) -> Callable[[int], StyleAndTextTuples]:
        """Return a function from line number to styled text; it is empty past the end."""
        lines: list[StyleAndTextTuples] = [[]]
        for style, text, *_ in styled(self._dialect, document.text):
            first, *rest = text.split("\n")
            lines[-1].append((style, first))
            lines.extend([(style, fragment)] for fragment in rest)
        return lambda number: lines[number] if number < len(lines) else []


_STYLES = {
    "move": "class:move",
    "keyword": "class:keyword",
    "not-simulated": "class:not-simulated",
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
