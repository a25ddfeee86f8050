"""A move is started while the speed of its axis is 0."""

from __future__ import annotations

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import Facts, spelt


def check(facts: Facts, warn: Warn) -> None:
    for act, key, axis in facts.axes.problems.get("zeros", ()):
        if "speed" in axis.zeros:
            assert axis.loaded is not None
            waits = act.role == "go"  # a move without a buffer is rejected
            what, then = ("the move holds", " at its GO") if waits else ("the move is rejected", "")
            message = f"{what}: the speed of axis {spelt(key)} is 0{then}"
            warn(message, axis.loaded, "set it above zero first")


RULE = Rule(
    code="zero-speed",
    text="""\
A move starts while the SPEED of its axis is 0. It holds where it is until SPEED rises, so a wait for its end may never
end. A run warns of it, too, and names the line that set SPEED to 0. In MCCL the board rejects a move at SV0.
""",
    fix="set SPEED above zero before GO",
    mint=RuleCase(
        check,
        wrong="SPEED(0) = 0\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="SPEED(0) = 10\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
    mccl=RuleCase(check, wrong="1MN,1SV0\n1MR100,1WS\n", right="1MN,1SV1000\n1MR100,1WS\n"),
)
