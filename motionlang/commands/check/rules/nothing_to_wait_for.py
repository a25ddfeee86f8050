"""A wait for the end of a motion comes before the first motion of the axis."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts


def check(facts: MacroFacts, warn: Warn) -> None:
    found = [act for act, _, _ in facts.axes.problems.get("nothing-to-wait-for", ())]
    for part, states in facts.axes.before.items():
        for p, _ in facts.statements_of(part):
            # A wait for all axes.
            bare = [act for act in facts.acts[p] if act.role == "rest" and act.axes == (None,)]
            axes = [states[p].rest, *states[p].axes.values()] if p in states and bare else []
            found += bare if axes and all(axis.unmoved for axis in axes) else []
    for act in found:
        message = f"{facts.text(act)} waits for the end of a move, and nothing has moved yet"
        warn(message, act.at, "move first, as in 1MR1000,1WS")


RULE = Rule(
    code="nothing-to-wait-for",
    text="""\
WS or WT waits for the end of a move, and no command on any path to it, also in the macros that are called, has moved
the axis.
""",
    fix="move the axis before you wait for it",
    mccl=RuleCase(
        check,
        wrong="1MN\n1WS\n",
        right="1MN,1MR100\n1WS\n",
    ),
)
