"""A move ends beyond the travel of its axis, or beyond a software limit of the program."""

from __future__ import annotations

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import Facts, spelt


def check(facts: Facts, warn: Warn) -> None:
    for act, key, axis in facts.axes.problems.get("beyond-travel", ()):
        limit = facts.axes.reach.beyond(act, key, axis)
        assert limit is not None
        message = f"the move ends at {axis.target:.10g}, beyond {limit.text} of axis {spelt(key)}"
        warn(message, act.at, limit.hint)


RULE = Rule(
    code="beyond-travel",
    text="""\
A move ends beyond the limit switch of its axis (`axis.0.travel` of the machine file), or beyond a SOFTLIMITFORWARD or
SOFTLIMITREVERSE of the program; in MCCL beyond an HL or LL that LN enables. The warning appears if the end of the move
is known: for constants, and for moves by a distance from a known position. A limit that is set when the move is over
does not count. A POS or DH that gives the axis a new zero is taken into account. After a search for the home switch
only the software limits are checked.

In Mint, a program that sets one software limit puts the other one in force, too, and that is 0 until it is set.
""",
    fix="move less far, or correct the travel in the machine file",
    mint=RuleCase(
        check,
        wrong="MOVEA(0) = 500 : GO(0)\n",
        right="MOVEA(0) = 300 : GO(0)\n",
        machine="[axis.0]\ntravel = [0, 400]\n",
    ),
    mccl=RuleCase(
        check,
        wrong="1MN,1MA500,1WS\n",
        right="1MN,1MA300,1WS\n",
        machine="[axis.1]\ntravel = [0, 400]\n",
    ),
)
