"""The blocks of Mint: what opens and closes each, and which are open on a stack.

The grammar says the same; here it is said for a reader of messages. A test holds the two together.
"""

from __future__ import annotations

from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.parsing.linked_stack import Cell

# From the kind of token that opens a block to the word as messages spell it.
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

# Words that close a block, or go on with one, and the block; `End X` closes X.
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

# Blocks that stand at the top of a file (a Sub in a Task, too) and never inside a statement.
DECLARATIONS = {"SUB", "FUNCTION", "TASK", "EVENT", "STARTUP", "TYPE"}

# What the grammar makes of the beginning of a block, by what it began with.
_HEADS = {"select_head": "SELECT", "for_head": "FOR", "if_head": "IF", "line_then": "THEN"}

# The plainest line that opens the block or goes on with it.
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


@record
class Block:
    """A block that is open: its kind, its opener's token, and whether it is an If of one line."""

    kind: str
    at: int
    inline: bool

    @property
    def closing(self) -> tuple[str, ...]:
        """The kinds of token that close it."""
        if self.kind == "FOR":
            return ("NEXT",)
        return ("UNTIL", "NUMBER") if self.kind == "REPEAT" else ("END", self.kind)


def closing(kind: str) -> str:
    """How a block is closed, in words."""
    if kind == "FOR":
        return "Next"
    return "Until and its condition" if kind == "REPEAT" else f"End {OPENERS[kind]}"


def opened_blocks(top: Cell) -> list[Block]:
    """The blocks that are open on a stack, the innermost first."""
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
    """The plainest lines that leave the same blocks open as one with these kinds would, the likeliest first."""
    if not kinds:
        return ()
    first = kinds[0]
    if first == "END" and kinds[1:2] and kinds[1] in OPENERS:
        return (("END", kinds[1], "_NL"),)
    if first == "NEXT" and "COMMA" in kinds:
        return ("NEXT", *("NAME", "COMMA") * kinds.count("COMMA"), "NAME", "_NL"), PLAIN[first]
    if first == "IF" and "THEN" in kinds and kinds[-1] not in ("THEN", "DO"):
        return ()  # an If of one line
    if first in OPENERS and _closes_itself(first, kinds):
        return ()
    return (PLAIN[first],) if first in PLAIN else ()


def _closes_itself(first: str, kinds: list[str]) -> bool:
    """`For … : … : Next` on one line opens nothing."""
    ends = [kinds[i + 1] for i in range(len(kinds) - 1) if kinds[i] == "END"]
    return first in ends or any(
        CLOSERS.get(kind) == first and kind not in ("ELSE", "CASE") for kind in kinds[1:]
    )
