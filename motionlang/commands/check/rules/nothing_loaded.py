"""A GO starts nothing: no move is loaded, or in MCCL no mode is selected whose motion GO starts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import spelt

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check_mint(facts: MintFacts, warn: Warn) -> None:
    for act, _, _ in facts.axes.problems.get("nothing-loaded", ()):
        axes = ", ".join(map(spelt, act.axes))
        warn("this GO starts nothing: no move is loaded", act.at, f"load one first, as in MOVER({axes}) = 10")


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    for act, key, _ in facts.axes.problems.get("nothing-loaded", ()):
        message = f"{facts.text(act)} starts nothing: axis {key} is in position mode"
        warn(message, act.at, f"{key}VM before it, or MA or MR for a move")
    if not any(row.role == "mode" for row in facts.used):
        for act in facts.written_by(lambda row: row.role == "run"):
            if act.axes == (None,):
                message = f"{facts.text(act)} starts nothing: no line of this file selects velocity mode"
                warn(message, act.at, "VM before it, or MA or MR for a move")


RULE = Rule(
    code="nothing-loaded",
    text="""\
A GO of axes for which no move is loaded: nothing was loaded, or an earlier GO has started it. In MCCL: a GO of an axis
in position mode; the board answers `?-2`.
""",
    fix="load a move first, or remove the GO",
    mint=RuleCase(
        check_mint,
        wrong="GO(0)\nPAUSE IDLE(0)\n",
        right="MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
    mccl=RuleCase(check_mccl, wrong="1MN,1GO\n", right="1MN,1VM,1GO\n"),
)
