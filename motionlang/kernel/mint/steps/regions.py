"""Loops of Gotos, which a backward jump makes of the statements from its label on."""

from __future__ import annotations

from dataclasses import dataclass

from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk


@dataclass(slots=True)
class GotoLoop:
    """A loop of Gotos: its first and last step, and the statement at whose end it ends."""

    statement: nodes.Stmt
    first: int = -1
    last: int = -1


def regions(function: Function) -> dict[str, GotoLoop]:
    """Return the loops formed by the Gotos of a function, by their labels."""
    if not function.jumps:
        return {}
    parts = sorted(walk(function.body), key=lambda each: each.start)
    labels = {each.name.lower(): each for each in parts if isinstance(each, nodes.Label)}
    found: dict[str, GotoLoop] = {}
    for each in parts:
        label = (
            labels.get(each.name.lower()) if isinstance(each, nodes.Jump) and each.kind == "goto" else None
        )
        if label is not None and label.start < each.start:
            found[label.name.lower()] = GotoLoop(_end(function.body, label, each))
    return found


def _end(body: list[nodes.Stmt], label: nodes.Node, jump: nodes.Node) -> nodes.Stmt:
    """Return the statement with a jump, in the innermost block that also has its label."""
    node = next(each for each in body if each.start <= jump.start < each.end)
    for inner in _bodies(node):
        if inner and inner[0].start <= label.start and jump.start < inner[-1].end:
            return _end(inner, label, jump)
    return node


def _bodies(node: nodes.Stmt) -> list[list[nodes.Stmt]]:
    """Return the blocks of a statement."""
    if isinstance(node, nodes.Select):
        return [case.body for case in node.cases]
    if isinstance(node, nodes.If):
        return [node.body, node.orelse]
    return [node.body] if isinstance(node, (nodes.For, nodes.While, nodes.Repeat, nodes.Loop)) else []
