"""Where a program depends on the inputs of its board."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel.lang.wait_causes import InputRead
from motionlang.kernel.mccl.resolve.line import Line

# The use of a channel by a command, and the level at which the program continues or the test holds.
_KINDS = {
    "wait_on": ("wait", 1),
    "wait_off": ("wait", 0),
    "if_on": ("test", 1),
    "if_off": ("test", 0),
    "do_if_on": ("test", 1),
    "do_if_off": ("test", 0),
}


def input_reads(lines: Sequence[Line]) -> list[InputRead]:
    """Return where a program depends on inputs, in line order."""
    found = []
    for line in lines:
        verbs = [command.verb for command in line.commands]
        macro = line.commands[0].number if verbs[0] == "define_macro" else None
        for here, command in enumerate(line.commands):
            if command.verb in _KINDS:
                kind, level = _KINDS[command.verb]
                polls = verbs[here + 1 : here + 2] == ["leave"] and "repeat" in verbs[here:]
                kind = "poll" if polls else kind
                if kind == "test" and verbs[here + 1 : here + 2] == ["jump_macro"]:
                    # A jump back to its own macro polls, one to another macro leaves at this level. If the macro
                    # then tries again without a move, it waits for this level.
                    if line.commands[here + 1].number == macro:
                        kind, level = "poll", 1 - level
                    elif _tries_again(line, here):
                        kind = "poll"
                    else:
                        kind, level = "guard", 1 - level
                found.append(InputRead(kind, command.number, level, line.number, line.number))
    return found


def _tries_again(line: Line, here: int) -> bool:
    """True if a macro calls itself at its end, and moves nothing behind a command."""
    first, last = line.commands[0], line.commands[-1]
    rest = line.commands[here:]
    moves = any(each.row is not None and each.row.topic == "move" for each in rest)
    return last.verb == "jump_macro" and last.number == first.number and not moves
