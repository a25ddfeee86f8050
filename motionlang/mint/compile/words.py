"""Words of Mint where a program uses them: here those that are not simulated part from those that are.

Which a word is says the row that its name was resolved to; neither way looks anything up again.
"""

from __future__ import annotations

from motionlang.mint.compile import keyword_use, unsimulated_use

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.keyword import Keyword
    from motionlang.mint.compile.body import Body, Value
    from motionlang.mint.syntax import nodes


def read(b: Body, node: nodes.Name, row: Keyword) -> Value:
    """The value of a word in an expression."""
    return keyword_use.read(b, node, row) if row.simulated else unsimulated_use.read(b, node, row)


def write(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """`WORD(axes) = values`."""
    if row.simulated:
        keyword_use.write(b, node, target, row)
    else:
        unsimulated_use.write(b, node, target, row)


def command(b: Body, node: nodes.Call, row: Keyword) -> None:
    """A word that stands alone, as `GO(0)` does."""
    if row.simulated:
        keyword_use.command(b, node, row)
    else:
        unsimulated_use.command(b, node, row)
