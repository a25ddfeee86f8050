"""Where a program depends on the inputs of its board."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel.lang.wait_causes import InputRead
from motionlang.kernel.mccl.resolve.line import Line

# The level at which a command that reads a channel goes on.
_LEVELS = {"wait_on": 1, "wait_off": 0, "if_on": 1, "if_off": 0, "do_if_on": 1, "do_if_off": 0}


def input_reads(lines: Sequence[Line]) -> list[InputRead]:
    """Return where a program depends on inputs, in line order."""
    return [
        InputRead(command.number, _LEVELS[command.verb], line.number)
        for line in lines
        for command in line.commands
        if command.verb in _LEVELS
    ]
