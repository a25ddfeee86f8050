"""The line ranges of a program's subs, tasks and handlers, for profiles."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel.mint.syntax.node import Node
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.traversal import children


def blocks_of(module: Module) -> list[tuple[str, int, int]]:
    """Return name, first and last line of every block of a parsed program."""
    named: list[tuple[str, Node, Sequence[object]]] = []
    for task in module.tasks:
        named.append((f"task {task.name}", task, [*task.body, *task.subs]))
        named += ((sub.name, sub, sub.body) for sub in task.subs)
    named += ((sub.name, sub, sub.body) for sub in module.subs)
    named += ((f"event {event.name}", event, event.body) for event in module.events)
    named += (("Startup", startup, startup.body) for startup in module.startup)
    return [(str(name), module.line(node.start), _last(module, node, body)) for name, node, body in named]


def _last(module: Module, node: Node, body: Sequence[object]) -> int:
    """Return the line of the last node of a block.

    At each level of the tree the child that begins last contains the last one.
    """
    last, below = node.start, body
    while nodes := [each for each in below if isinstance(each, Node)]:
        edge = max(nodes, key=lambda each: each.start)
        last, below = max(last, edge.start), children(edge)
    return module.line(last)
