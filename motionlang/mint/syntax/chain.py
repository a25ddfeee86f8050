"""Nodes of a long run of operations, which `nesting.py` makes of those that the parser built."""

from __future__ import annotations

from motionlang.mint.syntax.node import Node
from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.syntax.nodes import Expr


@record
class Link(Node):
    """A further operand of a `Chain`, with the operator before it; it stands at its operand."""

    op: str
    value: Expr


@record
class Chain(Node):
    """A long left-associative run of operations, `a + b - c …`: a `Binary` of each would be nested thousands deep."""

    first: Expr
    links: list[Link]
