"""A comment silences a warning that does not exist."""

from __future__ import annotations

from motionlang.commands.check.rule import Rule, RuleCase

RULE = Rule(
    code="silenced",
    text="""\
A `lint: ignore` names a warning that does not exist, or an error, which cannot be silenced.
""",
    fix="write a code that check shows in brackets, as in lint: ignore unused-variable",
    mint=RuleCase(
        None,
        wrong="PRINT 1 ' lint: ignore unused-varable\n",
        right="PRINT 1 ' lint: ignore unused-variable\n",
    ),
    mccl=RuleCase(None, wrong="1TP ; lint: ignore motor-of\n", right="1TP ; lint: ignore motor-off\n"),
)
