"""Checks of digital channels.

They report outputs switched on input channels, and waits for inputs that nothing drives.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from motionlang.commands.check.silence import driven_inputs
from motionlang.kernel.mccl import Command, Fault, Line, Model, models_with, table

Add = Callable[[int, Fault], None]

_SWITCHES = frozenset({"channel_on", "channel_off"})
_WAITS = {"wait_on": "on", "wait_off": "off"}


def check_channels(lines: list[Line], settings: Mapping[str, object], model: Model, add: Add) -> None:
    """Run both checks, with one diagnostic per command."""
    commands = [each for line in lines for each in zip(line.commands, line.offsets, strict=True)]
    made = {command.number for command, _ in commands if command.verb == "channel_output"}
    driven = driven_inputs(settings)
    word = next(row.name for row in table() if row.verb == "channel_output")
    others = _other_models(commands, made, model)
    for command, at in commands:
        channel = command.number
        if channel is None or None in made or channel in made or channel in model.outputs:
            continue
        if command.verb in _SWITCHES:
            message = f"channel {channel} is an input on this board: {command.text} is rejected"
            outputs = f"{model.outputs.start} to {model.outputs.stop - 1} are outputs at power-up"
            hint = others or f"{word}{channel} makes it an output; {outputs}"
            others = ""
            add(at, Fault(0, message, hint, "wrong-channel"))
        elif command.verb in _WAITS and driven is not None and channel not in driven:
            message = f"{command.text} waits for channel {channel}, which no entry of the machine file drives"
            add(
                at,
                Fault(0, message, "it continues at once or never; add an [[input]] entry", "endless-wait"),
            )


def _other_models(commands: list[tuple[Command, int]], made: set[int | None], model: Model) -> str:
    """Return a hint with the models on which all switched channels are outputs; "" if there are none."""
    switched = {each.number for each, _ in commands if each.verb in _SWITCHES} - made - {None}
    names = models_with(lambda each: each is not model and switched.issubset(each.outputs))
    return f"it is an output on {names}: set controller.model in the machine file" if names else ""
