"""Nodes for a long run of operations, which `nesting.py` makes from nested nodes."""

from __future__ import annotations

from motionlang.mint.syntax.node import Node
from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.syntax.nodes import Expr


@record
class Link(Node):
    """An operator of a `Chain` and the operand after it; `at` is the operand's token."""

    op: str
    value: Expr


@record
class Chain(Node):
    """A long left-associative run of operations, such as `a + b - c …`.

    As nested `Binary` nodes it would be thousands of levels deep.
    """

    first: Expr
    links: list[Link]
