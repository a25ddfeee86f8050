"""Pass keywords on to the compiler of simulated or of unsimulated ones.

The name was resolved to the row of the keyword, which decides. Neither compiler looks it up again.
"""

from __future__ import annotations

from motionlang.lang.keyword import Keyword
from motionlang.mint.compile import keyword_use, unsimulated_use
from motionlang.mint.compile.body import Body, Value
from motionlang.mint.syntax import nodes


def read(b: Body, node: nodes.Name, row: Keyword) -> Value:
    """Return the value of a keyword in an expression."""
    return keyword_use.read(b, node, row) if row.simulated else unsimulated_use.read(b, node, row)


def write(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Compile `WORD(axes) = values`."""
    if row.simulated:
        keyword_use.write(b, node, target, row)
    else:
        unsimulated_use.write(b, node, target, row)


def command(b: Body, node: nodes.Call, row: Keyword) -> None:
    """Compile a keyword as a statement, such as `GO(0)`."""
    if row.simulated:
        keyword_use.command(b, node, row)
    else:
        unsimulated_use.command(b, node, row)
