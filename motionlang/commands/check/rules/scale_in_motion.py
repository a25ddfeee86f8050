"""The scale of an axis is changed while the axis moves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import spelt

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for act, key, _ in facts.axes.problems.get("scale-in-motion", ()):
        assert act.row is not None
        message = f"{act.row.name} is changed while axis {spelt(key)} moves"
        warn(message, act.at, f"PAUSE IDLE({spelt(key)}) waits until it is at rest")


RULE = Rule(
    code="scale-in-motion",
    text="""\
SCALEFACTOR is changed while a move or jog of the axis is certainly in motion. The controller stores counts: the move
still ends at the same count, which is a different position in the new unit.
""",
    fix="change the scale while the axis is at rest",
    mint=RuleCase(
        check,
        wrong="MOVER(0) = 5 : GO(0)\nSCALE(0) = 2\n",
        right="MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nSCALE(0) = 2\n",
    ),
)
