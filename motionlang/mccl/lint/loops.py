"""Check for lines that repeat for ever without a wait.

Such a line cuts short the motion that it starts, or blocks the controller.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.mccl.codes import Fault

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.resolve.line import Line

    Add = Callable[[int, Fault], None]

_MOVES = frozenset({"move_to", "move_by", "go_home", "move_to_point"})
# Commands that jump, leave the line or skip commands, and those that take time.
_LEAVES = ("if_", "do_if_", "jump", "leave", "call_macro", "start_task", "wait", "find_", "path", "get_")


def endless_lines(lines: Iterable[Line], add: Add) -> None:
    """Warn, once per line, of an endless `RP` in a line in which nothing takes time."""
    for line in lines:
        for k, command in enumerate(line.commands):
            if _verb(command) == "repeat" and command.number == 0:
                _judge(line, k, add)
                break


def _judge(line: Line, k: int, add: Add) -> None:
    first = int(_verb(line.commands[0]) == "define_macro")
    body = line.commands[first:k]
    if any(_verb(each).startswith(_LEAVES) for each in body):
        return
    moves = [(each, at) for each, at in zip(body, line.places[first:k], strict=True) if _verb(each) in _MOVES]
    if moves:
        command, at = moves[-1]
        message = f"RP repeats {command.text} without waiting for its end"
        hint = f"add {command.axis or ''}WS after it"
        add(at, Fault(0, message, hint, "never-waits"))
    else:
        message = "RP repeats the line forever, without a wait or an exit"
        add(line.places[k], Fault(0, message, "add WA0.1 before it, or end after ten repetitions with RP10",
                                  "endless-loop"))  # fmt: skip


def _verb(command: Command) -> str:
    return command.row.verb if command.row is not None else ""
