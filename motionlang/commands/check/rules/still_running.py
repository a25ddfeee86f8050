"""A command needs an axis at rest that runs in velocity mode, which nothing has stopped."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts

# The shapes of moves that start at rest.
_SHAPES = {"PS": "S-curve", "PP": "parabola"}


def check(facts: MacroFacts, warn: Warn) -> None:
    limited = {each for act in facts.written_by(lambda row: row.function == "limits_on") for each in act.axes}
    for act, key, axis in facts.axes.problems.get("still-running", ()):
        if {key, None} & (facts.axes.stopped | limited):
            continue  # a task or a limit may stop the axis
        if act.role == "rest":
            message = f"{facts.text(act)} never ends: axis {key} runs in velocity mode until it is stopped"
            warn(message, act.at, f"{key}ST first")
        else:
            rest = f"{key}ST,{key}WS first, or {key}PT for a trapezoid"
            message = f"{facts.text(act)} is rejected: axis {key} still runs in velocity mode"
            warn(message, act.at, f"with {_SHAPES[axis.shape]}, a move starts at rest: {rest}")


RULE = Rule(
    code="still-running",
    text="""\
An axis runs in velocity mode (VM, GO) and has not been stopped, and then a WS or WT waits for it to come to rest, or a
position move needs it at rest. A move with an S-curve or parabolic profile starts from rest and is rejected.
""",
    fix="stop the axis with ST before you wait for it",
    mccl=RuleCase(
        check,
        wrong="1MN,1VM,1GO\n1WS\n",
        right="1MN,1VM,1GO,WA1\n1ST,1WS\n",
    ),
)
