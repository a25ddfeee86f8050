"""Flatten long chains of operations, and reject expressions nested too deeply.

The grammar is left-associative, so the parser makes `a + b + c …` a `Binary` in a `Binary` and so on. The
later passes are recursive, and Python's recursion is limited. To its author a chain of operations is not
nested, so a long one becomes a `Chain`, which counts as one level. Brackets, arguments and signs count as levels,
too. Only texts with long lines are processed here. Cost: one visit of each node, without recursion.
"""

from __future__ import annotations

from motionlang.errors import Diagnostic, ProgramError
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.build import LINKS, MAX_EXPRESSION_DEPTH
from motionlang.mint.syntax.nodes import Binary, Chain, Link, Module, Node

# Nodes that nest inside an expression. Any other node, such as a statement, starts again at depth 0.
_NESTS = (
    nodes.Name,
    nodes.Member,
    nodes.Unary,
    Binary,
    Chain,
    Link,
    nodes.Number,
    nodes.String,
    nodes.Omitted,
)


def flatten_chains(module: Module) -> None:
    """Replace every run of more than `LINKS` operations by a `Chain`."""
    waiting: list[Node] = [module]
    while waiting:
        node = waiting.pop()
        for name in node.__slots__:
            value = getattr(node, name)
            if isinstance(value, Node):
                value = _flat(value)
                setattr(node, name, value)
                waiting.append(value)
            elif isinstance(value, list):
                value[:] = [_flat(each) for each in value]
                waiting += value


def _flat(node: Node) -> Node:
    """Return a `Chain` for a long run of operations, and any other node unchanged."""
    operations: list[Binary] = []
    first = node
    while type(first) is Binary:
        operations.append(first)
        first = first.left
    if len(operations) <= LINKS:
        return node
    links = [Link(each.right.at, each.op, each.right) for each in reversed(operations)]
    return Chain(node.at, first, links)  # type: ignore[arg-type]


def check_depth(module: Module) -> None:
    """Raise ProgramError for every line with an expression that is nested too deeply."""
    offsets = module.offsets
    lines = {offsets.line(node.at): node.at for node in _too_deep(module)}
    if lines:
        raise ProgramError(
            Diagnostic(
                "syntax",
                f"the expression is nested more than {MAX_EXPRESSION_DEPTH} deep",
                line,
                offsets.column(at),
                length=offsets.length(at),
                hint="split it into several statements",
            )
            for line, at in lines.items()
        )


def _too_deep(module: Module) -> list[Node]:
    """Return the nodes just below the depth limit, found without recursion."""
    found = []
    waiting: list[tuple[Node, int]] = [(module, 0)]
    while waiting:
        node, depth = waiting.pop()
        if depth > MAX_EXPRESSION_DEPTH:
            found.append(node)
        else:
            waiting += _children(node, depth + 1)
    return found


def depth_of(expression: Node) -> int:
    """Return the number of levels in an expression."""
    deepest, waiting = 0, [(expression, 1)]
    while waiting:
        node, depth = waiting.pop()
        deepest = max(deepest, depth)
        waiting += _children(node, depth + 1)
    return deepest


def _children(node: Node, depth: int) -> list[tuple[Node, int]]:
    values = [getattr(node, name) for name in node.__slots__]
    found = [value for value in values if isinstance(value, Node)]
    for value in values:
        if isinstance(value, list):
            found += value
    return [(each, depth if isinstance(each, _NESTS) else 0) for each in found]
