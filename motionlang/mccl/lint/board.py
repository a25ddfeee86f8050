"""The board that a program is written for, from its file extension and its outputs."""

from __future__ import annotations

from motionlang.mccl.models import DEFAULT, MODELS
from motionlang.mccl.models import written_for as by_suffix
from motionlang.mccl.resolve.line import Line, lines_of
from motionlang.source import Source

_SWITCHES = frozenset({"channel_on", "channel_off"})


def written_for(source: Source) -> tuple[str, list[str]]:
    """Return the first model that has all commands and outputs of a program, and the reasons.

    The name is empty if the program switches no outputs, or if no model has them all.
    """
    suffixed = by_suffix(source.name)
    if suffixed != DEFAULT:
        return suffixed, [f"the extension .{source.name.rpartition('.')[2]}"]
    lines = [each for each in lines_of(source.text) if isinstance(each, Line)]
    commands = [command for line in lines for command in line.commands]
    families = {each.row.family for each in commands if each.row is not None}
    made = {each.number for each in commands if each.verb == "channel_output"}
    switched = {
        line.number: command
        for line in reversed(lines)
        for command in reversed(line.commands)
        if command.verb in _SWITCHES and command.number is not None and command.number not in made
    }
    for name, model in MODELS.items():
        fits = all(each.number in model.outputs for each in switched.values())
        if switched and fits and not families.intersection(model.lacks):
            outputs = f"{model.outputs.start} to {model.outputs.stop - 1} are outputs at power-up"
            line, command = min(switched.items())
            return name, [f"line {line}: {command.text}, and {outputs}"]
    return "", []
