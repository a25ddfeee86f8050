"""What handles events: Event blocks, and labels of v4 with an event's name, to which nothing jumps."""

from __future__ import annotations

from motionlang.mint.keywords.event_kinds import kind_and_number
from motionlang.mint.syntax.nodes import Jump, Label
from motionlang.mint.syntax.traversal import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.resolve.names import Names
    from motionlang.mint.resolve.symbols import Function


def label_handlers(function: Function) -> set[str]:
    """The labels of the main program that handle events, in small letters."""
    if function.kind != "main":
        return set()
    labels = {node.name.lower() for node in function.body if type(node) is Label}
    named = {label for label in labels if kind_and_number(label) is not None}
    return named and named - {node.name.lower() for node in walk(function.body) if type(node) is Jump}


def handles(names: Names, event: str) -> bool:
    """Whether the program handles an event that exists once, such as onerror."""
    blocks = (each.name.lower() for each in names.functions if each.kind == "event")
    return event in blocks or event in label_handlers(names.main)
