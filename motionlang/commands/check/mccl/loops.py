"""Check for lines that repeat for ever without a wait.

Such a line cuts short the motion that it starts, or blocks the controller.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from motionlang.kernel.mccl import Command, Fault, Line
from motionlang.kernel.mccl.resolve.flow import Flow

Add = Callable[[int, Fault], None]

_MOVES = frozenset({"move_to", "move_by", "go_home", "move_to_point"})
# Commands that jump, leave the line or skip commands, and those that take time.
_LEAVES = ("if_", "do_if_", "jump", "leave", "call_macro", "start_task", "wait", "find_", "path", "get_")


def endless_lines(lines: Iterable[Line], flow: Flow, add: Add) -> None:
    """Warn, once per line, of an endless loop in which nothing takes time."""
    for line in lines:
        for k, command in enumerate(line.commands):
            begin = _repeats_from(line, k, command, flow)
            if begin is not None:
                _check(line, begin, k, add)
                break


def _repeats_from(line: Line, k: int, command: Command, flow: Flow) -> int | None:
    """Return the index to which a command always jumps back, or its own, or None.

    An `MJ` to the macro that contains it repeats the macro.
    """
    verb, number = command.verb, command.number
    is_macro = line.commands[0].verb == "define_macro"
    first = int(is_macro)
    if verb == "repeat" and number == 0 and flow.endless:
        return first
    if verb == "jump_macro" and is_macro and number is not None and number == line.commands[0].number:
        return first
    if verb in ("jump", "jump_by") and number is not None:
        target = first + flow.target(verb, number, k - first)
        return target if target <= k else None
    return None


def _check(line: Line, begin: int, k: int, add: Add) -> None:
    if begin == k:
        message = f"{line.commands[k].text} jumps to itself forever"
        add(line.offsets[k], Fault(0, message, "jump to another command", "endless-loop"))
        return
    if any(each.verb.startswith(_LEAVES) for each in line.commands[:k]):
        return
    word = line.commands[k].name
    moves = [
        (each, at)
        for each, at in zip(line.commands[begin:k], line.offsets[begin:k], strict=True)
        if each.verb in _MOVES
    ]
    if moves:
        command, at = moves[-1]
        message = f"{word} repeats {command.text} without waiting for its end"
        hint = f"add {command.axis or ''}WS after it"
        add(at, Fault(0, message, hint, "never-waits"))
    else:
        message = f"{word} repeats the line forever, without a wait or an exit"
        hint = "add WA0.1 before it"
        if line.commands[k].verb == "repeat":
            hint += f", or end after ten repetitions with {word}10"
        add(line.offsets[k], Fault(0, message, hint, "endless-loop"))
