"""The extent of each block of a program, read from its tree."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

from motionlang.kernel.lang.names import Block
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

_KINDS: dict[type, str] = {
    nodes.For: "for",
    nodes.While: "while",
    nodes.Repeat: "repeat",
    nodes.Loop: "loop",
    nodes.Select: "select",
    nodes.If: "if",
    nodes.Sub: "sub",
    nodes.Task: "task",
    nodes.Event: "event",
    nodes.Startup: "startup",
    nodes.UserType: "type",
}
# An If that is neither an ElseIf nor on one line.
_BLOCK_IF = re.compile(r"if\b.*\b(?:end)?if", re.IGNORECASE | re.DOTALL)


def blocks(module: nodes.Module) -> list[Block]:
    """Return the blocks of a text, in the order in which they begin."""
    found = [_block(node) for node in walk([*module.everything, *module.types]) if type(node) in _KINDS]
    text = module.source.text
    closed = (each for each in found if each.kind != "if" or _BLOCK_IF.fullmatch(text, *each.span))
    return sorted(closed, key=lambda each: each.span[0])


def _block(node: Any) -> Block:
    kind = "function" if isinstance(node, nodes.Sub) and node.function else _KINDS[type(node)]
    name: Word | None = getattr(node, "name", None)
    at = (name.start, name.end) if name else (node.start, node.start + len(kind))
    return Block(kind, str(name or ""), at, (node.start, node.end))


def blocks_of(module: nodes.Module) -> list[tuple[str, int, int]]:
    """Return name, first and last line of every block of a parsed program."""
    named: list[tuple[str, nodes.Node, Iterable[object]]] = []
    for task in module.tasks:
        named.append((f"task {task.name}", task, [*task.body, *task.subs]))
        named += ((sub.name, sub, sub.body) for sub in task.subs)
    named += ((sub.name, sub, sub.body) for sub in module.subs)
    named += ((f"event {event.name}", event, event.body) for event in module.events)
    named += (("Startup", startup, startup.body) for startup in module.startup)
    return [
        (str(name), module.line(node.start), module.line(max(each.start for each in (node, *walk(body)))))
        for name, node, body in named
    ]
