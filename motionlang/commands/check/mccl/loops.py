"""Lines that repeat forever without a wait, for the rules about them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from motionlang.commands.check.mccl.verbs import POSITIONING

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.facts import MacroFacts
    from motionlang.kernel.mccl import Command, Line

# Verbs of commands that jump, leave the line or skip commands, and of those that take time.
_LEAVES = ("if_", "do_if_", "jump", "leave", "call_macro", "start_task", "wait", "find_", "path", "get_")


class EndlessLine(NamedTuple):
    """A line whose command `last` always jumps back to command `first`, in which nothing takes time."""

    line: Line
    first: int
    last: int

    @property
    def moves(self) -> list[tuple[Command, int]]:
        """The moves that are repeated, with their offsets."""
        repeated = slice(self.first, self.last)
        commands = zip(self.line.commands[repeated], self.line.offsets[repeated], strict=True)
        return [(command, at) for command, at in commands if command.verb in POSITIONING]


def endless_lines(facts: MacroFacts) -> Iterator[EndlessLine]:
    """Yield each line that repeats forever without a wait."""
    for line in facts.lines:
        for last in range(len(line.commands)):
            first = _repeats_from(facts, line, last)
            if first is not None:
                if first == last or not any(each.verb.startswith(_LEAVES) for each in line.commands[:last]):
                    yield EndlessLine(line, first, last)
                break


def _repeats_from(facts: MacroFacts, line: Line, k: int) -> int | None:
    """Return the index to which a command always jumps back, or its own, or None.

    An `MJ` to the macro that contains it repeats the macro.
    """
    verb, number = line.commands[k].verb, line.commands[k].number
    is_macro = line.commands[0].verb == "define_macro"
    first = int(is_macro)
    if verb == "repeat" and number == 0 and facts.flow.endless:
        return first
    if verb == "jump_macro" and is_macro and number is not None and number == line.commands[0].number:
        return first
    if verb in ("jump", "jump_by") and number is not None:
        target = first + facts.flow.target(verb, number, k - first)
        return target if target <= k else None
    return None
