"""Compute the indentation of each line of a text from its blocks.

The blocks are found by the tokens that open, continue or close them, of which those of a changed line alone are read
again; the tree of 9,000 lines takes 25 times as long. A v4 routine, from `#NAME` to its Return, is indented like a
block. A label that the statement before reaches is within the routine.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from motionlang.kernel.lang.names import LineLayout
from motionlang.kernel.lang.syntax.grammar import BAD, END, lex
from motionlang.kernel.mint.syntax.blocks import CLOSERS, DECLARATIONS, OPENERS
from motionlang.kernel.mint.syntax.tokens import PARSER

OPEN, MIDDLE, CLOSE = "open", "middle", "close"
# Kinds of token before which a keyword of a block is something else: the end of a block, or a label.
_NOT_OPENING = frozenset(("END", "EXIT", "HASH", "GOTO", "GOSUB", "RUN", "DOT", "AS"))
# Kinds of token after which such a keyword is a name: `event = 3`.
_OF_A_NAME = frozenset(("EQUAL", "LPAR", "LSQB", "DOT"))
_WATCHED = frozenset((*OPENERS, *CLOSERS, "END"))
# Kinds of token after which a statement begins.
_STARTS = frozenset(("_NL", "COLON"))


@dataclass(eq=False, repr=False, slots=True)
class _BlockToken:
    """A token that opens, continues or closes a block.

    `count` is the number of blocks that it closes: 2 for `Next i, j`.
    """

    at: int
    what: str
    count: int = 1


def layout(text: str) -> list[LineLayout]:
    lines: list[LineLayout] = []
    kinds: list[str] = []
    owners: list[LineLayout] = []  # the line of each token
    is_ended = True
    for written in text.split("\n"):
        found = _kinds(written.strip(" \t"))
        lines.append(LineLayout(continues=not is_ended, unreadable=BAD in found))
        is_ended = found[-1:] == ("_NL",)
        if len(found) > 1 or not is_ended or kinds[-1:] != ["_NL"]:  # blank lines belong to the end of a line
            kinds += found
            owners += [lines[-1]] * len(found)
    for token in _all_tokens([*kinds, "_NL", END]):
        line = owners[token.at]
        is_first = token.at == 0 or kinds[token.at - 1] == "_NL"
        if is_first and token.what != OPEN:
            line.back = token.count
        if token.what != MIDDLE:
            line.change += 1 if token.what == OPEN else -token.count
    return lines


@lru_cache(50_000)
def _kinds(line: str) -> tuple[str, ...]:
    """Return the kinds of token of a line, the last one `_NL` unless the line is continued.

    The result is cached, because most lines of a text stay the same. No token extends over the end of a line, except
    `_NL`, which includes blank lines and comments behind it.
    """
    return tuple(token.type for token in lex(PARSER, f"{line}\n"))


def _all_tokens(kinds: Sequence[str]) -> Iterator[_BlockToken]:
    """Yield the block tokens of a text, including those of v4 routines."""
    depth = 0
    label = -1  # the label at the outermost level that may begin a routine
    found: list[_BlockToken] = []
    blocks = {token.at: token for token in _block_tokens(kinds)}
    for at, kind in enumerate(kinds):
        token = blocks.get(at)
        if token is not None:
            found.append(token)
            depth += {OPEN: 1, MIDDLE: 0, CLOSE: -token.count}[token.what]
        elif depth == 0 and _is_label(kinds, at) and (label < 0 or not _is_reached(kinds, at)):
            label = at
        elif kind == "RETURN" and depth == 0 and label >= 0 and not _in_one_line_if(kinds, at):
            found += [_BlockToken(label, OPEN), _BlockToken(at, CLOSE)]
            label = -1
    yield from sorted(found, key=lambda each: each.at)


def _is_label(kinds: Sequence[str], at: int) -> bool:
    """True for the `#` or the name that begins a label line."""
    if at > 0 and kinds[at - 1] != "_NL":
        return False
    return kinds[at] == "HASH" or (list(kinds[at : at + 3]) == ["NAME", "COLON", "_NL"])


def _is_reached(kinds: Sequence[str], label: int) -> bool:
    """True if the statement before a label continues with it, so that both are of one routine."""
    end = label
    while end and kinds[end - 1] in ("_NL", "COLON"):
        end -= 1
    begin = end
    while begin and kinds[begin - 1] not in ("_NL", "COLON"):
        begin -= 1
    return kinds[begin] not in ("END", "RETURN", "GOTO") or _in_one_line_if(kinds, begin)


def _in_one_line_if(kinds: Sequence[str], at: int) -> bool:
    """True for a token outside all blocks that follows an If on its line."""
    begin = at
    while begin and kinds[begin - 1] != "_NL":
        begin -= 1
    return "IF" in kinds[begin:at]


def _block_tokens(kinds: Sequence[str]) -> Iterator[_BlockToken]:
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
                yield _BlockToken(at, CLOSE)
        elif before in _NOT_OPENING:
            continue
        elif kind in DECLARATIONS:
            if before in _STARTS and kinds[at + 1] not in _OF_A_NAME:
                yield _BlockToken(at, OPEN)
        elif kind == "IF":
            if before == "ELSE" and _begins_line(kinds, at - 1):
                continue  # an ElseIf, reported with its Else
            end = _line_end(kinds, at)
            if at > inline and "THEN" in kinds[at:end] and not _is_block(kinds, at, end):
                inline = end
            elif at > inline:
                yield _BlockToken(at, OPEN)
        elif kind in ("ELSE", "ELSEIF", "CASE"):
            if at > inline and before != "SELECT":
                yield _BlockToken(at, MIDDLE)
        elif kind == "NEXT":
            end = next((i for i in range(at, len(kinds)) if kinds[i] in _STARTS), len(kinds))
            yield _BlockToken(at, CLOSE, 1 + kinds[at:end].count("COMMA"))
        elif kind in CLOSERS:
            yield _BlockToken(at, CLOSE)
        else:
            yield _BlockToken(at, OPEN)


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
