"""Pygments lexers of Mint and MCCL, also for Sphinx, `pygmentize` and `rich`.

The package registers both as entry points.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar

from pygments.lexer import Lexer
from pygments.token import Comment, Error, Generic, Keyword, Name, Number, String, Text

from motionlang.kernel import dialect
from motionlang.views.highlight import pieces

_TOKENS: dict[str, Any] = {
    "move": Name.Function,
    "keyword": Name.Builtin,
    "not-simulated": Name.Exception,
    "control": Keyword,
    "axis": Name.Label,
    "register": Name.Variable,
    "number": Number,
    "string": String,
    "text": String,
    "comment": Comment,
    "name": Name,
    "bad": Error,
    "unknown": Error,
    "prompt": Generic.Prompt,
}


class _DialectLexer(Lexer):
    """Base of both lexers; `dialect_name` is the name of the language in motionlang."""

    dialect_name: ClassVar[str]

    def get_tokens_unprocessed(self, text: str) -> Iterator[tuple[int, Any, str]]:
        """Return offset, token type and text of each token."""
        for offset, kind, piece in pieces(dialect(self.dialect_name), text):
            yield offset, _TOKENS.get(kind, Text), piece


class MintLexer(_DialectLexer):
    """Mint (Baldor, ABB)."""

    name = "Mint"
    aliases: ClassVar[list[str]] = ["mint"]
    filenames: ClassVar[list[str]] = ["*.mnt", "*.mntx", "*.prg"]
    dialect_name = "mint"


class McclLexer(_DialectLexer):
    """MCCL (Precision MicroControl)."""

    name = "MCCL"
    aliases: ClassVar[list[str]] = ["mccl"]
    filenames: ClassVar[list[str]] = ["*.mcl", "*.mccl"]
    dialect_name = "mccl"
