"""How deeply the expressions of a program are nested: what comes after the parser walks them recursively."""

from __future__ import annotations

from motionlang.errors import Diagnostic, ProgramError
from motionlang.mint.syntax.build import DEEPEST_EXPRESSION
from motionlang.mint.syntax.nodes import Node

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.syntax.nodes import Module


def check_depth(module: Module) -> None:
    """Raise ProgramError for every line with an expression that is nested too deeply."""
    places = module.places
    lines = {places.line(node.at): node.at for node in _too_deep(module)}
    if lines:
        raise ProgramError(
            Diagnostic(
                "syntax",
                f"the expression is nested more than {DEEPEST_EXPRESSION} deep",
                line,
                places.column(at),
                length=places.length(at),
                hint="split it into several statements",
            )
            for line, at in lines.items()
        )


def _too_deep(module: Module) -> list[Node]:
    """The nodes that stand just below the limit, found without recursion."""
    found = []
    waiting: list[tuple[Node, int]] = [(module, 0)]
    while waiting:
        node, depth = waiting.pop()
        if depth > DEEPEST_EXPRESSION:
            found.append(node)
        else:
            waiting += _children(node, depth + 1)
    return found


def _children(node: Node, depth: int) -> list[tuple[Node, int]]:
    values = [getattr(node, name) for name in node.__slots__]
    found = [(value, depth) for value in values if isinstance(value, Node)]
    for value in values:
        if isinstance(value, list):
            found += [(each, depth) for each in value]
    return found
