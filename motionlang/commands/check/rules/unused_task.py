"""No Run starts a task."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    run = {node.name.lower() for node in facts.of_kind(nodes.Run)}
    for function in facts.functions:
        if function.kind == "task" and function.name.lower() not in run:
            name = function.name
            warn(f"task {name} is never run", function.at, f"start it with Run {name}")


RULE = Rule(
    code="unused-task",
    text="""\
No Run starts the task.
""",
    fix="start the task with Run, or remove it",
    mint=RuleCase(
        check,
        wrong="Task Feed\n  OUTX(1) = 1\nEnd Task\n",
        right="Run Feed\nTask Feed\n  OUTX(1) = 1\nEnd Task\n",
    ),
)
