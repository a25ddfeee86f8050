"""Event handlers: Event blocks and v4 labels.

A label is a handler if it has the name of an event and no jump leads to it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from motionlang.kernel.mint.keywords.event_kinds import RAISED_BY, kind_and_number, label_event
from motionlang.kernel.mint.resolve.folding import fold
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk

if TYPE_CHECKING:
    from motionlang.kernel.lang.step_graph import StepGraph
    from motionlang.kernel.mint.resolve.names import Symbols


def label_handlers(function: Function) -> list[str]:
    """Return the labels of the main program that handle events, in lower case, in the order of the text."""
    if function.kind != "main" or not function.jumps:
        return []
    parts = sorted(walk(function.body), key=lambda each: each.start)
    targets = {each.name.lower() for each in parts if isinstance(each, nodes.Jump)}
    labels = dict.fromkeys(each.name.lower() for each in parts if isinstance(each, nodes.Label))
    return [each for each in labels if each not in targets and label_event(each) is not None]


def handled(function: Function, graph: StepGraph, *events: str) -> Iterator[nodes.Node]:
    """Yield the nodes of the statements that handlers among the labels execute, those of some events or all."""
    handlers = [each for each in label_handlers(function) if not events or each in events]
    if not handlers:
        return iter(())
    own = graph.ranges[function.qualified_name]
    entries = [p for p, name in graph.labels.items() if p in own and name.lower() in handlers]
    offsets = {graph.points[p].at for p in graph.reached(*entries) if p in own}
    return walk(_executed(each) for each in walk(function.body) if each.start in offsets)


def _executed(node: nodes.Node) -> nodes.Node | None:
    """Return what a step of a statement executes: of a block, its condition."""
    if isinstance(node, (nodes.If, nodes.While)):
        return node.condition
    return node if isinstance(node, nodes.Stmt) else None


def raised_by(names: Symbols, event: str) -> list[tuple[str, int]]:
    """Return the channels whose change raises an event: kind and number, -1 for any.

    A stop event has the inputs that the program assigns to STOPINPUT.
    """
    found = kind_and_number(event)
    row = names.table.get(RAISED_BY[found[0]]) if found is not None and found[0] in RAISED_BY else None
    if row is None or found is None:
        return []
    if not row.selects:
        channel = row.channel.removesuffix(" bank")
        return [(channel, found[1])] if channel else []
    numbers: dict[int, None] = {}
    for node in walk(statement for each in names.functions for statement in each.body):
        target = meant(node.target) if isinstance(node, nodes.Assign) else None
        if isinstance(node, nodes.Assign) and isinstance(target, nodes.Name) and target.row is row:
            values = (fold(meant(each)) for each in node.values)
            numbers |= {int(each): None for each in values if isinstance(each, (int, float)) and each >= 0}
    return [(row.selects, number) for number in numbers]


def handles(names: Symbols, event: str) -> bool:
    """True if the program handles an event without a number, such as onerror."""
    blocks = (each.name.lower() for each in names.functions if each.kind == "event")
    return event in blocks or event in label_handlers(names.main)
