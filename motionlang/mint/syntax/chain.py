"""Nodes of a long run of operations, which `nesting.py` makes of those that the parser built."""

from __future__ import annotations

from motionlang.mint.syntax.node import Node

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.syntax.nodes import Expr


class Link(Node):
    """A further operand of a `Chain`, with the operator before it; it stands at its operand."""

    __slots__ = ("op", "value")

    def __init__(self, at: int, op: str, value: Expr) -> None:
        self.at, self.op, self.value = at, op, value


class Chain(Node):
    """A long left-associative run of operations, `a + b - c …`: a `Binary` of each would be nested thousands deep."""

    __slots__ = ("first", "links")

    def __init__(self, at: int, first: Expr, links: list[Link]) -> None:
        self.at, self.first, self.links = at, first, links
