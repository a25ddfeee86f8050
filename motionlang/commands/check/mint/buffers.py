"""The loads of the move buffer, for the rules about it."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import AxisKey as Key

# Roles of keywords that load the move buffer, and so wait while it is full.
LOADS = frozenset(("move", "entry", "course", "path"))


def triggered(facts: MintFacts) -> set[Key]:
    """Return the axes whose moves may start without a GO."""
    return facts.named("TRIGGERMODE")
