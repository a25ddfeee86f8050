"""Checks of numbers: rates that the board rounds to whole ones, and moves without a distance."""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.mccl import NUMBER, Fault, Line, Model, codes
from motionlang.kernel.mccl.axis.axis import nearest_whole

Add = Callable[[int, Fault], None]

# Verbs of the commands after which rates are in units of the user, and not rounded.
SCALES = frozenset(("scale", "rate", "time_unit", "constant", "offset", "zero"))
RATES = frozenset(("uu/s", "uu/s2"))


def check_numbers(lines: list[Line], model: Model, add: Add) -> None:
    """Report each number that the board changes, and each relative move without one."""
    commands = [each for line in lines for each in zip(line.commands, line.offsets, strict=True)]
    scaled = {command.axis for command, _ in commands if command.verb in SCALES}
    for command, at in commands:
        row = command.row
        if row is None:
            continue
        if row.verb == "move_by" and command.is_bare:
            add(at, codes.no_distance(command.text))
        is_rate = row.unit in RATES and row.kind == "setting" and command.kind == NUMBER
        if is_rate and model.rounds and not scaled & {0, command.axis}:
            value, whole = float(command.value), nearest_whole(float(command.value))
            if value != whole:
                add(at, codes.rounded(command.text, value, whole))
