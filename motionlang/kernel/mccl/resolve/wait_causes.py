"""The channels and quantities that the loops of a program read.

A loop is the commands between the target of a jump back and the jump.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from motionlang.kernel.lang.wait_causes import InputRead, LoopDependencies, Read
from motionlang.kernel.mccl.resolve.command import Command
from motionlang.kernel.mccl.resolve.line import Line

_BACK = frozenset(("repeat", "jump", "jump_by", "jump_macro"))

# The use of a channel by a command, and the level at which the program continues or the test holds.
_KINDS = {
    "wait_on": ("wait", 1),
    "wait_off": ("wait", 0),
    "if_on": ("test", 1),
    "if_off": ("test", 0),
    "do_if_on": ("test", 1),
    "do_if_off": ("test", 0),
}


def asked(lines: Sequence[Line]) -> Callable[[int], LoopDependencies | None]:
    """Return a function that maps the offset of a jump back to the reads of its loop."""
    macros: dict[int, Line] = {}
    for line in lines:
        first = line.commands[0]
        if first.verb == "define_macro" and first.number is not None:
            macros[first.number] = line.rest(1)
    found: dict[int, LoopDependencies] = {}
    for line in lines:
        own = line.rest(1) if line.commands[0].verb == "define_macro" else line
        for here, command in enumerate(own.commands):
            if command.verb in _BACK:
                body = own.commands[_target(command, here) : here + 1]
                called = [macro for each in body if (macro := _called(each, macros)) is not None]
                commands = [*body, *(each for macro in called for each in macro.commands)]
                reads = frozenset(read for each in commands for read in _read(each))
                numbers = frozenset((line.number, *(macro.number for macro in called)))
                why = "in " + ",".join(each.text for each in body)
                found[own.offsets[here]] = LoopDependencies(reads, reads, numbers, why)
    return found.get


def _target(command: Command, here: int) -> int:
    """Return the index of a jump's target; 0 if it is only known at run time."""
    number, verb = command.number, command.verb
    if number is None or verb in ("repeat", "jump_macro"):
        return 0
    target = here + number if verb == "jump_by" else number
    return target if 0 <= target <= here else 0


def _called(command: Command, macros: dict[int, Line]) -> Line | None:
    number = command.number
    return macros.get(number) if command.verb == "call_macro" and number is not None else None


def _read(command: Command) -> Iterator[Read]:
    kind, number = command.reads if command.pure else "", command.number
    if kind in ("input", "analogue"):
        yield kind, number
    elif kind in ("position", "axis"):
        yield kind, command.axis
    elif command.verb == "recall" and (number is None or number >= 10):
        yield "task", None


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
