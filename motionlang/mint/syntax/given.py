"""Nodes for values that are supplied when a program starts.

They replace values in the text.
"""

from __future__ import annotations

from motionlang.mint.syntax.node import Node
from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.resolve.symbols import Type
    from motionlang.mint.syntax.nodes import Expr


@record
class Given(Node):
    """A value that the program receives when it starts.

    It replaces the initial value of a name that differs between runs of one compiled program.
    """

    name: str
    is_text: bool


@record
class Cast(Node):
    """A conversion to another type: a `Const` with a type whose value is a `Given`."""

    value: Expr
    type: Type
