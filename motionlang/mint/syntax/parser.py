"""Parse Mint text into its syntax tree."""

from __future__ import annotations

import re
from collections.abc import Iterator

from motionlang.lang.parsing.parser import BAD, Stuck, TooDeep
from motionlang.lang.parsing.source_offsets import SourceOffsets
from motionlang.mint.syntax.build import MAX_EXPRESSION_DEPTH, Misuse
from motionlang.mint.syntax.nodes import Module
from motionlang.mint.syntax.tables import TABLES
from motionlang.source import Source

# The kinds of token as a reader sees them. A kind that is not listed is a control word or an operator.
_CLASSES = {"NAME": "word", "DOTTED": "word", "NUMBER": "number", "STRING": "string", "CHARACTER": "string"}
_SEPARATORS = {"COLON", "COMMA", "SEMICOLON", "LPAR", "RPAR", "LSQB", "RSQB"}
_COMMENT = re.compile(r"'[^\n]*|[Rr][Ee][Mm][^\n]*|:")


def parse(source: Source) -> Module:
    """Return the tree of a program; raise ProgramError with all errors of the text."""
    texts = TABLES.texts(source.text)
    kinds = TABLES.kinds_of(texts)
    try:
        module: Module = TABLES.parse(texts, kinds)
    except (Stuck, TooDeep, Misuse):
        from motionlang.mint.syntax.errors import diagnose  # imported only for a text with an error

        raise diagnose(source) from None
    module.offsets = SourceOffsets(source, TABLES, texts, kinds)
    if not _short(module.offsets):
        from motionlang.mint.syntax.nesting import check_depth, flatten_chains

        flatten_chains(module)
        check_depth(module)
    return module


def _short(offsets: SourceOffsets) -> bool:
    """True if all lines are too short for an expression to be nested too deeply.

    A level takes at least one character, as in `---1`.
    """
    lines = offsets.source.text.split("\n")
    return not offsets.continues and max(map(len, lines)) <= MAX_EXPRESSION_DEPTH


def is_complete(text: str) -> bool:
    """True if the text is complete, so that it may end here.

    It is incomplete inside an open block and after a line continuation.
    """
    from motionlang.mint.syntax.errors import unfinished

    return not (text.rstrip(" \t\n").endswith(("\\", " _")) or unfinished(TABLES.texts(text)))


def tokens(text: str) -> Iterator[tuple[str, str, int]]:
    """Yield the tokens of a text for highlighting: kind, text and offset.

    Blanks and line ends are left out. The kinds are word, control, number, string, comment, operator,
    separator and bad. Any text is accepted.
    """
    end = 0
    for match in TABLES.matches(text):
        start = match.start(1)
        yield from _between(text, end, start)
        piece, end = match[1], match.end()
        kind = TABLES.kind_of[piece]
        if kind == "_NL":
            yield from _comments(piece, start)
        else:
            yield _class(kind, piece), piece, start
    yield from _between(text, end, len(text))


def _class(kind: str, piece: str) -> str:
    if kind == BAD:
        return "bad"
    if kind in _SEPARATORS:
        return "separator"
    return _CLASSES.get(kind) or ("control" if piece[0].isalpha() else "operator")


def _comments(piece: str, start: int) -> Iterator[tuple[str, str, int]]:
    """Yield the comments in a token of line ends, which includes comments and blanks."""
    for match in _COMMENT.finditer(piece):
        kind = "separator" if match[0] == ":" else "comment"
        yield kind, match[0], start + match.start()


def _between(text: str, start: int, end: int) -> Iterator[tuple[str, str, int]]:
    """Yield the line continuation mark between two tokens; skip blanks."""
    gap = text[start:end]
    if gap.strip():
        at = start + len(gap) - len(gap.lstrip())
        yield "separator", text[at:end].rstrip(), at
