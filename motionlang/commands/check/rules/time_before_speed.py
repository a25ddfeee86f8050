"""The time of a ramp is set before the speed on which it depends."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import spelt

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for _, key, axis in facts.axes.problems.get("time-before-speed", ()):
        assert axis.timed is not None
        message = f"the time of a ramp of axis {spelt(key)} is set before SPEED, on which it depends"
        warn(message, axis.timed, "set SPEED first")


RULE = Rule(
    code="time-before-speed",
    text="""\
ACCELTIME and DECELTIME are times to reach SPEED. If they come before any SPEED is set, they refer to the default of
power-up, 40 000 counts per second. Set SPEED first. motionlang stores the time and works out the rate when a move
starts, so here the order makes no difference; a controller that converts the time to a rate at once gets the wrong
rate.
""",
    fix="set SPEED first",
    mint=RuleCase(
        check,
        wrong="ACCELTIME(0) = 100\nSPEED(0) = 50\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="SPEED(0) = 50\nACCELTIME(0) = 100\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
)
