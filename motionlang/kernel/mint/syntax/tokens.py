"""The tokens of a text, for what must work on a text that does not parse.

All else reads the tree.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from motionlang.kernel.lang.syntax.grammar import BAD, END, Token, lex, load
from motionlang.kernel.mint.syntax.build import Builder

PARSER = load("mint", Builder())
# The spelling of each kind of token that has only one.
SPELLINGS = {str(each.name): each.pattern.value for each in PARSER.terminals if each.pattern.type == "str"}

# The kinds of token as a reader sees them. A kind that is not listed is a control word or an operator.
_CLASSES = {
    BAD: "bad",
    "NAME": "word",
    "DOTTED": "word",
    "NUMBER": "number",
    "STRING": "string",
    "CHARACTER": "string",
    **dict.fromkeys(("COLON", "COMMA", "SEMICOLON", "LPAR", "RPAR", "LSQB", "RSQB"), "separator"),
}
_COMMENT = re.compile(r"'[^\n]*|[Rr][Ee][Mm][^\n]*|:")
_SIGNS = frozenset("+-~")


class Tokens:
    """The kinds, texts and offsets of the tokens of a text, maybe `found` before, with an empty one for its end."""

    def __init__(self, text: str, found: Iterable[Token] | None = None) -> None:
        self.kinds: list[str] = []
        self.texts: list[str] = []
        self.starts: list[int] = []
        self.ends: list[int] = []
        for token in lex(PARSER, ended(text)) if found is None else found:
            self.kinds.append(token.type)
            self.texts.append(str(token))
            self.starts.append(token.start_pos or 0)
            self.ends.append(token.end_pos or 0)
        self.kinds.append(END)
        self.texts.append("")
        self.starts.append(len(text))
        self.ends.append(len(text))


def ended(text: str) -> str:
    """Return a text whose last line ends, even if that line is continued."""
    return f"{text}\n\n"


def token_at(text: str, at: int) -> str:
    """Return the text of the token at an offset, "" at the end of the line."""
    return next((str(token) for token in lex(PARSER, _rest_of_line(text, at))), "")


def value_length(text: str, at: int) -> int:
    """Return the length of the value that begins with a token.

    The value includes signs, and an expression in parentheses after them.
    """
    found = lex(PARSER, _rest_of_line(text, at))
    first = token = next(found, None)
    if first is None:
        return 1
    while token is not None and token in _SIGNS:
        token = next(found, None)
    if token is None or token.type == BAD:
        return len(first)
    end, depth = token.end_pos or 0, 1
    if token is not first and token == "(":
        for inner in found:
            depth += (inner == "(") - (inner == ")")
            if depth == 0:
                return inner.end_pos or 0
    return end


def _rest_of_line(text: str, at: int) -> str:
    end = text.find("\n", at)
    return text[at:] if end < 0 else text[at:end]


def tokens(text: str) -> Iterator[tuple[str, str, int]]:
    """Yield the tokens of a text for highlighting: kind, text and offset.

    Blanks and line ends are left out. The kinds are word, control, number, string, comment, operator,
    separator and bad. Any text is accepted.
    """
    end = 0
    for token in lex(PARSER, ended(text)):
        start = token.start_pos or 0
        yield from _between(text, end, start)
        end = token.end_pos or 0
        if token.type == "_NL":
            yield from _comments(token, start)
        else:
            kind = _CLASSES.get(token.type) or ("control" if token[0].isalpha() else "operator")
            yield kind, str(token), start
    yield from _between(text, end, len(text))


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
