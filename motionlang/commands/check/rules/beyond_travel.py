"""A move ends beyond the travel of its axis, or beyond a software limit of the program."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.facts import spelt
from motionlang.commands.check.rule import Case, Rule, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mint.facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for act, key, axis in facts.axes.problems.get("beyond-travel", ()):
        limit = facts.axes.reach.beyond(key, axis)
        message = f"the move ends at {axis.target:.10g}, beyond {limit} of axis {spelt(key)}"
        warn(message, act.at, "the axis stops there with an error")


RULE = Rule(
    code="beyond-travel",
    group="Motion",
    text="""\
A move ends beyond the limit switch of its axis (`axis.0.travel` of the machine file), or beyond a SOFTLIMITFORWARD or
SOFTLIMITREVERSE of the program. The warning appears if the end of the move is known: for constants, and for moves by a
distance from a known position. A POS that gives the axis a new zero is taken into account. After HOME the zero depends
on the switches, and only the software limits are checked.
""",
    fix="move less far, or correct the travel in the machine file",
    mint=Case(
        check,
        wrong="MOVEA(0) = 500 : GO(0)\n",
        right="MOVEA(0) = 300 : GO(0)\n",
        machine="[axis.0]\ntravel = [0, 400]\n",
    ),
)
