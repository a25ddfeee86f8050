"""Event handlers: Event blocks and v4 labels.

A label is a handler if it has the name of an event and no jump leads to it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from motionlang.kernel.mint.keywords.event_kinds import RAISED_BY, kind_and_number
from motionlang.kernel.mint.resolve.folding import fold
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk

if TYPE_CHECKING:
    from motionlang.kernel.mint.resolve.names import Names


def label_handlers(function: Function) -> set[str]:
    """Return the labels of the main program that handle events, in lower case."""
    return set(function.graph.handlers) if function.jumps else set()


def handled(function: Function, *events: str) -> Iterator[nodes.Node]:
    """Yield the nodes of the statements that handlers among the labels execute, those of some events or all."""
    return walk(function.graph.handled(*events)) if function.jumps else iter(())


def raised_by(names: Names, event: str) -> list[tuple[str, int]]:
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


def handles(names: Names, event: str) -> bool:
    """True if the program handles an event without a number, such as onerror."""
    blocks = (each.name.lower() for each in names.functions if each.kind == "event")
    return event in blocks or event in label_handlers(names.main)
