"""The blocks of a text, found by its tokens alone, even in an incomplete text.

`block_tokens` yields each token that opens, continues or closes a block. The formatter counts them, and `blocks` pairs
them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from motionlang.kernel.mint.syntax.blocks import CLOSERS, DECLARATIONS, OPENERS

OPEN, MIDDLE, CLOSE = "open", "middle", "close"
# Kinds of token before which a keyword of a block is something else: the end of a block, or a label.
_NOT_OPENING = frozenset(("END", "EXIT", "HASH", "GOTO", "GOSUB", "RUN", "DOT", "AS"))
# Kinds of token after which such a keyword is a name: `event = 3`.
_OF_A_NAME = frozenset(("EQUAL", "LPAR", "LSQB", "DOT"))
_WATCHED = frozenset((*OPENERS, *CLOSERS, "END"))
# Kinds of token after which a statement begins.
_STARTS = frozenset(("_NL", "COLON"))


@dataclass(eq=False, repr=False, slots=True)
class BlockToken:
    """A token that opens, continues or closes a block.

    The kind of the block is one of `OPENERS`. `count` is the number of blocks that the token closes: 2 for `Next i, j`.
    """

    at: int
    what: str
    kind: str
    count: int = 1


@dataclass(eq=False, repr=False, slots=True)
class Span:
    """A block from its opening token to the last token of its end.

    `name` is the token of the block's name, -1 if it has none.
    """

    kind: str
    first: int
    last: int
    name: int


def block_tokens(kinds: Sequence[str]) -> Iterator[BlockToken]:
    """Yield the tokens that open, continue or close a block.

    One-line Ifs are not blocks.
    """
    inline = -1  # the tokens up to here belong to a one-line If
    for at in [at for at, kind in enumerate(kinds) if kind in _WATCHED]:
        kind = kinds[at]
        before = kinds[at - 1] if at else "_NL"
        if kind == "END":
            closed = kinds[at + 1] if at + 1 < len(kinds) else ""
            if closed in OPENERS and before not in _NOT_OPENING and (closed != "IF" or at > inline):
                yield BlockToken(at, CLOSE, closed)
        elif before in _NOT_OPENING:
            continue
        elif kind in DECLARATIONS:
            if before in _STARTS and kinds[at + 1] not in _OF_A_NAME:
                yield BlockToken(at, OPEN, kind)
        elif kind == "IF":
            if before == "ELSE" and _begins_line(kinds, at - 1):
                continue  # an ElseIf, reported with its Else
            end = _line_end(kinds, at)
            if at > inline and "THEN" in kinds[at:end] and not _is_block(kinds, at, end):
                inline = end
            elif at > inline:
                yield BlockToken(at, OPEN, kind)
        elif kind in ("ELSE", "ELSEIF", "CASE"):
            if at > inline and before != "SELECT":
                yield BlockToken(at, MIDDLE, CLOSERS[kind])
        elif kind == "NEXT":
            end = next((i for i in range(at, len(kinds)) if kinds[i] in _STARTS), len(kinds))
            yield BlockToken(at, CLOSE, "FOR", 1 + kinds[at:end].count("COMMA"))
        elif kind in CLOSERS:
            yield BlockToken(at, CLOSE, CLOSERS[kind])
        else:
            yield BlockToken(at, OPEN, kind)


def blocks(kinds: Sequence[str]) -> list[Span]:
    """Return the closed blocks of a text, in the order in which they begin."""
    found: list[Span] = []
    opened: list[BlockToken] = []
    for token in block_tokens(kinds):
        if token.what == OPEN:
            opened.append(token)
            continue
        for _ in range(token.count if token.what == CLOSE else 0):
            index = next((i for i in range(len(opened) - 1, -1, -1) if opened[i].kind == token.kind), -1)
            if index < 0:
                break
            first = opened[index]
            del opened[index:]
            named = first.kind in DECLARATIONS and kinds[first.at + 1] not in _STARTS
            last = token.at + (kinds[token.at] == "END")
            found.append(Span(first.kind, first.at, last, first.at + 1 if named else -1))
    return sorted(found, key=lambda each: each.first)


def _begins_line(kinds: Sequence[str], at: int) -> bool:
    return at == 0 or kinds[at - 1] == "_NL"


def _line_end(kinds: Sequence[str], at: int) -> int:
    while at < len(kinds) and kinds[at] not in ("_NL", "$END"):
        at += 1
    return at


def _is_block(kinds: Sequence[str], at: int, end: int) -> bool:
    """True if only colons follow the Then of an If on its line."""
    then = next(i for i in range(at, end) if kinds[i] == "THEN")
    return all(kind == "COLON" for kind in kinds[then + 1 : end])
