"""A move is started while the acceleration or the deceleration of its axis is 0."""

from __future__ import annotations

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import Facts, spelt


def check(facts: Facts, warn: Warn) -> None:
    for act, key, axis in facts.axes.problems.get("zeros", ()):
        if "speed" not in axis.zeros:  # zero-speed is the better warning if both are 0
            assert axis.loaded is not None
            rate = "acceleration" if "accel" in axis.zeros else "deceleration"
            waits = act.role == "go"  # a move without a buffer is rejected
            what, then = ("the move cannot run", " at its GO") if waits else ("the move is rejected", "")
            message = f"{what}: the {rate} of axis {spelt(key)} is 0{then}"
            warn(message, axis.loaded, "set it above zero first")


RULE = Rule(
    code="zero-acceleration",
    text="""\
A move starts while ACCEL or DECEL (in MCCL SA or DS) of its axis is 0. It could not start or could not stop, so a run
ends there.
""",
    fix="set ACCEL and DECEL above zero before GO",
    mint=RuleCase(
        check,
        wrong="ACCEL(0) = 0\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="ACCEL(0) = 100\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
    mccl=RuleCase(check, wrong="1MN,1SA0\n1MR100,1WS\n", right="1MN,1SA1000\n1MR100,1WS\n"),
)
