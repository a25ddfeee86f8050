"""A comment silences a warning that does not exist."""

from __future__ import annotations

from motionlang.commands.check.rule import Case, Rule

RULE = Rule(
    code="silenced",
    group="Names",
    text="""\
A `lint: ignore` names a warning that does not exist, or an error, which cannot be silenced.
""",
    fix="write a code that check shows in brackets, as in lint: ignore unused-variable",
    mint=Case(
        None,
        wrong="PRINT 1 ' lint: ignore unused-varable\n",
        right="PRINT 1 ' lint: ignore unused-variable\n",
    ),
    mccl=Case(None, wrong="1TP ; lint: ignore motor-of\n", right="1TP ; lint: ignore motor-off\n"),
)
