"""Nothing reads a variable or a Define, except to compute the variable's own next value."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.mint.variables import Suggestions, variables
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.resolve.symbols import SEMAPHORE

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for function in facts.functions:
        for symbol in function.scope.names.values():
            if symbol.kind == "define" and symbol.uses <= 0:
                warn(f"{symbol.name} is defined and never used", symbol.at)
    suggestions = Suggestions()
    for symbol, is_used in variables(facts):
        given = facts.writers.get(symbol)
        # Taking a semaphore waits for it, which is a use.
        if is_used or symbol in facts.retained or (given and symbol.type.name == SEMAPHORE):
            continue
        what = "is declared and never used"
        if given:
            what = f"is assigned but never read{' elsewhere' if symbol.uses > 0 else ''}"
        near = None if symbol.declared else suggestions.most_similar(symbol, lambda each: each.uses > 0)
        hint = f"did you mean {near}?" if near else ""
        warn(f"{symbol.name} {what}", symbol.at, hint, candidates=(near,) if near else ())


RULE = Rule(
    code="unused-variable",
    text="""\
A variable is declared and never used; or nothing reads the values that it is given, except to compute its own next
value, as in `n = n + 1`. There is no warning for constants, parameters and the data of `Dim nv`. If no Dim declares the
variable, the hint is the variable that you probably meant.
""",
    fix="remove the variable, or correct the name where it is meant",
    mint=RuleCase(
        check,
        wrong="Dim part = 1\n",
        right="Dim part = 1\nPRINT part\n",
    ),
)
