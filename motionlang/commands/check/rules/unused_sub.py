"""Nothing calls a sub or a function, directly or indirectly."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for function in facts.functions:
        if function.kind == "sub" and not facts.roots[function]:
            warn(f"{function.name} is never called", function.at)


RULE = Rule(
    code="unused-sub",
    text="""\
The sub or function is not called, or is called only by subs that are never called themselves.
""",
    fix="call the sub, or remove it",
    mint=RuleCase(
        check,
        wrong="Sub Feed()\n  OUTX(1) = 1\nEnd Sub\n",
        right="Feed\nSub Feed()\n  OUTX(1) = 1\nEnd Sub\n",
    ),
)
