"""The board that a program is written for, from its file extension, commands, axes and outputs."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.kernel.lang.program import Target
from motionlang.kernel.mccl.models import DEFAULT, MODELS
from motionlang.kernel.mccl.models import written_for as by_suffix
from motionlang.kernel.mccl.resolve.line import Line
from motionlang.kernel.source import Source

_SWITCHES = frozenset({"channel_on", "channel_off"})


def written_for(source: Source, lines: Sequence[Line]) -> Target:
    """Return the first model that has all commands, axes and outputs of a program; the others that do follow.

    There is none if the program switches no outputs, or if no model has them all.
    """
    suffixed = by_suffix(source.name)
    if suffixed != DEFAULT:
        return Target(suffixed, [f"the extension .{source.name.rpartition('.')[2]}"], [])
    commands = [command for line in lines for command in line.commands]
    families = {each.row.family for each in commands if each.row is not None}
    made = {each.number for each in commands if each.function == "channel_output"}
    switched = {
        line.number: command
        for line in reversed(lines)
        for command in reversed(line.commands)
        if command.function in _SWITCHES and command.number is not None and command.number not in made
    }
    axes = max((each.axis for each in commands), default=0)
    fitting = [
        model
        for model in MODELS.values()
        if axes <= model.axes
        and all(each.number in model.outputs for each in switched.values())
        and not families.intersection(model.lacks)
    ]
    if not switched or not fitting:
        return Target("", [], [])
    first, *others = fitting
    outputs = f"{first.outputs.start} to {first.outputs.stop - 1} are outputs at power-up"
    line, command = min(switched.items())
    return Target(
        first.name, [f"line {line}: {command.text}, and {outputs}"], [model.name for model in others]
    )
