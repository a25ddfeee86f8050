"""A relative move or a wait for a time of MCCL has no number, so it moves by 0 or waits for 0 s."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mccl import codes

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts


def check(facts: MacroFacts, warn: Warn) -> None:
    for command, at in facts.commands:
        if command.function == "move_by" and command.is_bare:
            fault = codes.no_distance(command.text)
            warn(fault.message, at, fault.hint)
        elif command.function == "wait" and command.is_bare:
            fault = codes.no_time(command.text, command.axis)
            warn(fault.message, at, fault.hint)


RULE = Rule(
    code="values",
    text="""\
MR without a number moves by 0, and WA without a number does not wait: `1WS` waits for the end of a move. In Mint, a
number of axes, arguments or values that does not fit the keyword is an error.
""",
    fix="give as many axes, arguments or values as motionlang help WORD shows",
    mint=RuleCase(
        None,
        wrong="SPEED(0) = 10, 20\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="SPEED(0, 1) = 10, 20\nMOVER(0, 1) = 5, 5 : GO(0, 1)\n",
    ),
    mccl=RuleCase(check, wrong="1MN,1MR,1WS\n", right="1MN,1MR100,1WS\n"),
)
