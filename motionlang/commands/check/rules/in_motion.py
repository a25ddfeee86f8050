"""A position is read or set right behind the GO that started a move, when no time has passed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.facts import spelt
from motionlang.commands.check.rule import Case, Rule, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mint.facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for act, key, _ in facts.axes.problems.get("in-motion", ()):
        what = "set" if act.role == "zero" else "read"
        message = f"the position of axis {spelt(key)} is {what} while the move just started is in motion"
        warn(message, act.at, f"PAUSE IDLE({spelt(key)}) waits for its end")


RULE = Rule(
    code="in-motion",
    group="Motion",
    text="""\
The program reads or sets the position immediately after the GO that started a move, when no time has passed. It gets
the start of the move, where it probably needs the end. If a PAUSE, a WAIT or a loop comes in between, the position is
meant to be read during the move, and there is no warning.
""",
    fix="wait for the end of the move with PAUSE IDLE before you use the position",
    mint=Case(
        check,
        wrong="MOVER(0) = 5 : GO(0)\nPRINT POS(0)\n",
        right="MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nPRINT POS(0)\n",
    ),
)
