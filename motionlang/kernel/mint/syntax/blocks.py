"""The blocks of Mint: the tokens that open and close them; blocks open on a stack.

The tables repeat what the grammar states, and a test keeps them consistent.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from motionlang.kernel.lang.syntax.grammar import Token
from motionlang.kernel.lang.syntax.stack import Stack
from motionlang.kernel.mint.syntax.tokens import SPELLINGS

# Blocks at the top level of a file (a Sub in a Task, too), never inside a statement.
DECLARATIONS = ("SUB", "FUNCTION", "TASK", "EVENT", "STARTUP", "TYPE")

# The kinds of token that open a block, and the keyword as messages spell it.
OPENERS = {
    kind: SPELLINGS[kind] for kind in ("IF", "FOR", "WHILE", "REPEAT", "LOOP", "SELECT", *DECLARATIONS)
}

# The kinds of token that close or continue a block, and that block. `End X` closes X.
CLOSERS = {
    "NEXT": "FOR",
    "UNTIL": "REPEAT",
    "ELSE": "IF",
    "ELSEIF": "IF",
    "ENDIF": "IF",
    "ENDWHILE": "WHILE",
    "ENDW": "WHILE",
    "WEND": "WHILE",
    "ENDLOOP": "LOOP",
    "ENDL": "LOOP",
    "CASE": "SELECT",
}

# The grammar's symbols for the beginning of a block, and the token it began with.
_HEADS = {"select_head": "SELECT", "for_head": "FOR", "if_head": "IF", "line_then": "THEN"}

WRONG = "WRONG"  # the kind of token that is put in place of a text that does not follow the grammar


@dataclass(eq=False, repr=False, slots=True)
class OpenBlock:
    """An open block: its kind, its opening token, True if it is a one-line If, and the name behind it."""

    kind: str
    token: Token
    inline: bool
    name: str

    @property
    def closing(self) -> tuple[str, ...]:
        """Return the kinds of token that close the block."""
        kinds = next(iter(closers(self.kind).values()))
        return (*kinds, WRONG) if self.kind == "REPEAT" else kinds


def closing(kind: str) -> str:
    """Return the text that closes a block, for messages."""
    text = next(iter(closers(kind)))
    return f"{text} and its condition" if kind == "REPEAT" else text


def closers(kind: str) -> dict[str, tuple[str, ...]]:
    """Map the texts that close or continue a block to their kinds of token; the usual one is first."""
    end = [] if kind in ("FOR", "REPEAT") else [("END", kind)]
    kinds = [*end, *((closer,) for closer, block in CLOSERS.items() if block == kind)]
    return {" ".join(SPELLINGS[each] for each in words): words for words in kinds}


def opened_blocks(stack: Stack) -> Iterator[OpenBlock]:
    """Iterate over the blocks that are open on a stack, innermost first."""
    above, name = "", ""  # the symbol above and its first token
    after_then = ""  # the symbol above the last Then
    for symbol, tokens in stack:
        kind = _HEADS.get(symbol, symbol)
        if kind in ("THEN", "DO"):
            after_then = "_NL" if kind == "DO" else above
        elif kind in OPENERS:
            variable = tokens[1] if symbol == "for_head" else name
            yield OpenBlock(kind, tokens[0], symbol == "IF" and after_then != "_NL", variable)
        above, name = symbol, tokens[0] if tokens else ""


def block_words(kinds: list[str]) -> tuple[tuple[str, ...], ...]:
    """Return the words of a line without which other blocks are open behind it.

    The most likely ones come first.
    """
    if not kinds:
        return ()
    first = kinds[0]
    if first == "END" and kinds[1:2] and kinds[1] in OPENERS:
        return (("END", kinds[1]),)
    if first == "DO":
        return (("LOOP",),)
    if first == "NEXT" and "COMMA" in kinds:
        return ("NEXT", *("NAME", "COMMA") * kinds.count("COMMA"), "NAME"), ("NEXT",)
    if first == "IF" and "THEN" in kinds and kinds[-1] not in ("THEN", "DO"):
        return ()  # a one-line If
    if first in OPENERS and _closes_itself(first, kinds):
        return ()
    return ((first,),) if first in OPENERS or first in CLOSERS else ()


def _closes_itself(first: str, kinds: list[str]) -> bool:
    """True if a line also closes the block it opens, as `For … : … : Next` does."""
    ends = [kinds[i + 1] for i in range(len(kinds) - 1) if kinds[i] == "END"]
    return first in ends or any(
        CLOSERS.get(kind) == first and kind not in ("ELSE", "CASE") for kind in kinds[1:]
    )
