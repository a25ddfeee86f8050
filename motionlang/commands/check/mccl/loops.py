"""Cycles of commands that nothing leaves and in which nothing takes time, for the rules about them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.kernel.lang import Use
    from motionlang.kernel.mccl import Command

# Commands that repeat the line or jump within it.
REPEATS = frozenset({"repeat", "jump", "jump_by"})
# Commands that take time, or after which anything may happen.
_UNSURE = ("get_", "start_task", "find_", "path")


class EndlessCycle(NamedTuple):
    """The commands of a cycle, by their offsets, in the order of the text; `last` is the one that leads back."""

    commands: dict[int, Command]
    last: int
    moves: list[Use]


def endless_cycles(facts: MacroFacts) -> Iterator[EndlessCycle]:
    """Yield each cycle that a part of the file reaches and never leaves, and in which no task waits."""
    points, within = facts.graph.points, facts.graph.within
    known = {at: command for command, at in facts.commands}
    for cycle in facts.endless():
        commands = {at: known[at] for at in sorted({points[p].at for p in cycle}) if at in known}
        statements = [facts.structure.statements[at] for at in commands]
        if any(each.waits or (each.condition and each.condition != each.text) for each in statements):
            continue
        if not commands or any(each.function.startswith(_UNSURE) for each in commands.values()):
            continue
        back = [points[p].at for p in cycle for after in within[p] if after <= p and points[p].at in commands]
        uses = (act for p in sorted(cycle) for act in facts.acts.get(p, ()))
        moves = [act for act in uses if act.role in ("start", "act")]
        yield EndlessCycle(commands, max(back), moves)
