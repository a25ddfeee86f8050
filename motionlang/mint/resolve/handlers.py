"""What handles events: Event blocks, and labels of v4 with an event's name, to which nothing jumps."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.resolve.names import Names
    from motionlang.mint.resolve.symbols import Function


def label_handlers(function: Function) -> set[str]:
    """The labels of the main program that handle events, in small letters."""
    return set(function.graph.handlers) if function.jumps else set()


def handles(names: Names, event: str) -> bool:
    """Whether the program handles an event that exists once, such as onerror."""
    blocks = (each.name.lower() for each in names.functions if each.kind == "event")
    return event in blocks or event in label_handlers(names.main)
