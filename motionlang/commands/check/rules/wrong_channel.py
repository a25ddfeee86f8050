"""An output is switched at a channel that is an input.

A channel is an output at power-up or after a CT anywhere in the file. A CT whose channel is in a register may be for
any channel.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Case, Rule, Warn
from motionlang.kernel.mccl import models_with, table

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.facts import MacroFacts

_SWITCHES = frozenset({"channel_on", "channel_off"})


def check(facts: MacroFacts, warn: Warn) -> None:
    made = {command.number for command, _ in facts.commands if command.verb == "channel_output"}
    outputs = facts.model.outputs
    wrong = [
        (command, at)
        for command, at in facts.commands
        if command.verb in _SWITCHES and command.number is not None
        if not made & {None, command.number} and command.number not in outputs
    ]
    word, other_models = table().doing("channel_output"), _other_models(facts, made)
    for command, at in wrong[:1] if other_models else wrong:  # one model is one cause
        channel = command.number
        hint = f"{word}{channel} makes it an output; {outputs.start} to {outputs.stop - 1} are outputs at power-up"
        warn(
            f"channel {channel} is an input on this board: {command.text} is rejected",
            at,
            other_models or hint,
        )


def _other_models(facts: MacroFacts, made: set[int | None]) -> str:
    """Return a hint with the models on which all switched channels are outputs; "" if there are none."""
    switched = {command.number for command, _ in facts.commands if command.verb in _SWITCHES} - made - {None}
    names = models_with(lambda each: each is not facts.model and switched.issubset(each.outputs))
    return f"it is an output on {names}: set controller.model in the machine file" if names else ""


RULE = Rule(
    code="wrong-channel",
    group="Machine",
    text="""\
CN or CF names a channel that is an input at power-up, and no CT in the file makes it an output. The board rejects the
command.
""",
    fix="make the channel an output with CT first",
    mccl=Case(
        check,
        wrong="CN1\n",
        right="CT1,CN1\n",
    ),
)
