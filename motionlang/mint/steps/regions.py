"""Loops of Gotos, which a backward jump makes of the statements from its label on."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

if TYPE_CHECKING:
    from motionlang.mint.resolve.symbols import Function


@dataclass(slots=True)
class Region:
    """A loop of Gotos: its first and last step, and the outermost statement with the last jump back."""

    statement: int
    first: int = -1
    last: int = -1


def regions(function: Function) -> dict[str, Region]:
    """Return the loops formed by the Gotos of a function, by their labels."""
    labels: dict[str, int] = {}
    found: dict[str, Region] = {}
    for number, node in enumerate(function.body):
        if isinstance(node, nodes.Label):
            labels.setdefault(node.name.lower(), number)
        for each in walk([node]) if function.jumps else ():
            name = each.name.lower() if isinstance(each, nodes.Jump) and each.kind != "gosub" else ""
            if name in labels:
                found[name] = Region(number)
    return found
