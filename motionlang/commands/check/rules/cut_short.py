"""A motion is stopped, or replaced, in the moment in which it starts, so that nothing moves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts


def check(facts: MacroFacts, warn: Warn) -> None:
    for act, key, _ in facts.axes.problems.get("cut-short", ()):
        text = facts.structure.statements[act.at].text
        message = f"{text} stops axis {key} in the moment in which its motion starts"
        warn(message, act.at, f"{key}WS before it waits for the end of a move, WA for a time")
    for act, key, _ in facts.axes.problems.get("replaced", ()):
        message = f"{facts.text(act)} replaces the move of axis {key} in the moment in which that starts"
        warn(message, act.at, f"{key}WS before it waits for the end of the move")


RULE = Rule(
    code="cut-short",
    text="""\
MF, AB or ST comes directly behind the command that starts a motion, without any time between: the axis does not move.
WS waits for the end of a move; in velocity mode a WA lets the axis run. The same holds for an MA directly behind a
move: no axis has a queue of moves, and the axis goes to the new target alone. With PS and PP the MA waits for the end
of the first move.
""",
    fix="wait for the end of the motion before you stop it",
    mccl=RuleCase(check, wrong="1MN,1MR100,1MF\n", right="1MN,1MR100,1WS,1MF\n"),
)
