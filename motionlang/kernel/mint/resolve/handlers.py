"""Event handlers: Event blocks and v4 labels.

A label is a handler if it has the name of an event and no jump leads to it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mint.resolve.symbols import Function

if TYPE_CHECKING:
    from motionlang.kernel.mint.resolve.names import Names


def label_handlers(function: Function) -> set[str]:
    """Return the labels of the main program that handle events, in lower case."""
    return set(function.graph.handlers) if function.jumps else set()


def handles(names: Names, event: str) -> bool:
    """True if the program handles an event without a number, such as onerror."""
    blocks = (each.name.lower() for each in names.functions if each.kind == "event")
    return event in blocks or event in label_handlers(names.main)
