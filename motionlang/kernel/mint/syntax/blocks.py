"""The blocks of Mint: the tokens that open and close them; blocks open on a stack.

This table is for messages. It repeats what the grammar states, and a test keeps the two consistent.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motionlang.kernel.lang.syntax.stack import Cell

# The kinds of token that open a block, and the keyword as messages spell it.
OPENERS = {
    "IF": "If",
    "FOR": "For",
    "WHILE": "While",
    "REPEAT": "Repeat",
    "LOOP": "Loop",
    "SELECT": "Select",
    "SUB": "Sub",
    "FUNCTION": "Function",
    "TASK": "Task",
    "EVENT": "Event",
    "STARTUP": "Startup",
    "TYPE": "Type",
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

# Blocks at the top level of a file (a Sub in a Task, too), never inside a statement.
DECLARATIONS = {"SUB", "FUNCTION", "TASK", "EVENT", "STARTUP", "TYPE"}

# The grammar's symbols for the beginning of a block, and the token it began with.
_HEADS = {"select_head": "SELECT", "for_head": "FOR", "if_head": "IF", "line_then": "THEN"}

# The shortest line that opens or continues each block.
PLAIN = {
    "IF": ("IF", "NUMBER", "THEN", "_NL"),
    "FOR": ("FOR", "NAME", "EQUAL", "NUMBER", "TO", "NUMBER", "_NL"),
    "WHILE": ("WHILE", "NUMBER", "_NL"),
    "REPEAT": ("REPEAT", "_NL"),
    "LOOP": ("LOOP", "_NL"),
    "SELECT": ("SELECT", "CASE", "NUMBER", "_NL"),
    "CASE": ("CASE", "NUMBER", "_NL"),
    "SUB": ("SUB", "NAME", "_NL"),
    "FUNCTION": ("FUNCTION", "NAME", "_NL"),
    "TASK": ("TASK", "NAME", "_NL"),
    "EVENT": ("EVENT", "NAME", "_NL"),
    "STARTUP": ("STARTUP", "_NL"),
    "TYPE": ("TYPE", "NAME", "_NL"),
    "ELSE": ("ELSE", "_NL"),
    "ELSEIF": ("ELSEIF", "NUMBER", "THEN", "_NL"),
    "NEXT": ("NEXT", "_NL"),
    "UNTIL": ("UNTIL", "NUMBER", "_NL"),
    **{kind: (kind, "_NL") for kind in ("ENDIF", "ENDWHILE", "ENDW", "WEND", "ENDLOOP", "ENDL")},
}


@dataclass(eq=False, repr=False, slots=True)
class Block:
    """An open block: its kind, its opening token, and True if it is a one-line If."""

    kind: str
    at: int
    inline: bool

    @property
    def closing(self) -> tuple[str, ...]:
        """Return the kinds of token that close the block."""
        if self.kind == "FOR":
            return ("NEXT",)
        return ("UNTIL", "NUMBER") if self.kind == "REPEAT" else ("END", self.kind)


def closing(kind: str) -> str:
    """Return the text that closes a block, for messages."""
    if kind == "FOR":
        return "Next"
    return "Until and its condition" if kind == "REPEAT" else f"End {OPENERS[kind]}"


def opened_blocks(top: Cell) -> list[Block]:
    """Return the blocks that are open on a stack, innermost first."""
    blocks = []
    above = after_then = ""  # the symbol above the cell, and the one above the last Then
    for cell in top:
        kind = _HEADS.get(cell.symbol, cell.symbol)
        if kind in ("THEN", "DO"):
            after_then = "_NL" if kind == "DO" else above
        elif kind in OPENERS:
            blocks.append(Block(kind, cell.at, cell.symbol == "IF" and after_then != "_NL"))
        above = cell.symbol
    return blocks


def plain_lines(kinds: list[str]) -> tuple[tuple[str, ...], ...]:
    """Return the shortest lines that leave the same blocks open as a given line.

    The most likely line comes first.
    """
    if not kinds:
        return ()
    first = kinds[0]
    if first == "END" and kinds[1:2] and kinds[1] in OPENERS:
        return (("END", kinds[1], "_NL"),)
    if first == "NEXT" and "COMMA" in kinds:
        return ("NEXT", *("NAME", "COMMA") * kinds.count("COMMA"), "NAME", "_NL"), PLAIN[first]
    if first == "IF" and "THEN" in kinds and kinds[-1] not in ("THEN", "DO"):
        return ()  # a one-line If
    if first in OPENERS and _closes_itself(first, kinds):
        return ()
    return (PLAIN[first],) if first in PLAIN else ()


def _closes_itself(first: str, kinds: list[str]) -> bool:
    """True if a line also closes the block it opens, as `For … : … : Next` does."""
    ends = [kinds[i + 1] for i in range(len(kinds) - 1) if kinds[i] == "END"]
    return first in ends or any(
        CLOSERS.get(kind) == first and kind not in ("ELSE", "CASE") for kind in kinds[1:]
    )
