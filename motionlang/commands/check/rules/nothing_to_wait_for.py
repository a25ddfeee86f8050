"""A wait for the end of a motion stands before the first motion of the axis.

The lines of the foreground are followed in their order, with the macros that they call. In a line that repeats, a
motion behind the wait counts, too.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.mccl.verbs import CALLS, MOVES, REPEATS, WAITS
from motionlang.commands.check.rule import Case, Rule, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.facts import MacroFacts
    from motionlang.kernel.mccl import Command, Line

Bodies = dict[int | None, "Line"]


def check(facts: MacroFacts, warn: Warn) -> None:
    bodies = {line.commands[0].number: line for line in facts.lines if _is_macro(line)}
    moved: set[int] = set()
    for line in facts.lines:
        if _is_macro(line):
            continue
        if any(command.verb in REPEATS for command in line.commands):
            moved |= _moved(line, bodies, set())
        for command, at in zip(line.commands, line.offsets, strict=True):
            if command.verb in WAITS and 0 not in moved and not _has_moved(command, moved):
                message = f"{command.text} waits for the end of a move, and nothing has moved yet"
                warn(message, at, "move first, as in 1MR1000,1WS")
            moved |= _moved_by(command, bodies, set())


def _is_macro(line: Line) -> bool:
    return line.commands[0].verb == "define_macro"


def _has_moved(command: Command, moved: set[int]) -> bool:
    return bool(moved) if command.axis == 0 else command.axis in moved


def _moved(line: Line, bodies: Bodies, seen: set[int]) -> set[int]:
    """Return the axes that a line moves; 0 means all axes or an unknown one."""
    return {axis for command in line.commands for axis in _moved_by(command, bodies, seen)}


def _moved_by(command: Command, bodies: Bodies, seen: set[int]) -> set[int]:
    if command.verb in MOVES:
        return {command.axis}
    if command.verb not in CALLS:
        return set()
    body = bodies.get(command.number)
    if body is None or command.number is None:
        return {0}
    if command.number in seen:
        return set()
    seen.add(command.number)
    return _moved(body, bodies, seen)


RULE = Rule(
    code="nothing-to-wait-for",
    group="Control flow",
    text="""\
WS or WT waits for the end of a move, but nothing before it in the file, and no macro called before it, has moved the
axis.
""",
    fix="move the axis before you wait for it",
    mccl=Case(
        check,
        wrong="1MN\n1WS\n",
        right="1MN,1MR100\n1WS\n",
    ),
)
