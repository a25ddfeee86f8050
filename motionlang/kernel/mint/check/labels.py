"""Check labels, Goto and Gosub."""

from __future__ import annotations

from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk


def check_labels(b: Body) -> None:
    """Report duplicate labels of a function, and record all of them."""
    labels = [node for node in walk(b.function.body) if isinstance(node, nodes.Label)]
    for node in sorted(labels, key=lambda each: each.start):
        if node.name.lower() in b.labels:
            b.problem("duplicate", f"there is already a label {node.name}", node)
        b.labels.setdefault(node.name.lower(), None)


def jump(b: Body, node: nodes.Jump) -> None:
    """Check a Goto or a Gosub."""
    if node.name.lower() not in b.labels:
        _unknown_label(b, node)


def _unknown_label(b: Body, node: nodes.Jump) -> None:
    name, problems = node.name, b.program.problems
    symbol = b.scope.find(name)
    if symbol is not None and symbol.kind == "sub":
        hint = f"a sub is called by its name alone: {symbol.name}"
        problems.add("unknown-word", f"{symbol.name} is a sub, not a label", name.start, hint)
        return
    hint = f"a label has a line of its own: #{name}"
    problems.unknown(f"there is no label {name}", name, lambda: b.labels, name.start, hint)
