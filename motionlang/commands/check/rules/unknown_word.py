"""A macro is called that no line of the file defines."""

from __future__ import annotations

from motionlang.commands.check.rule import Rule, RuleCase

RULE = Rule(
    code="unknown-word",
    text="""\
A macro is called, or started as a task, but no line of the file defines it. It may already be in the controller.
In Mint, a name that is neither a keyword nor declared is an error.
""",
    fix=(
        "write the keyword that the hint names, or declare a variable with Dim; motionlang help "
        "TEXT searches keywords by what they do, and [mint.words] of the machine file names those "
        "of an older Mint"
    ),
    mint=RuleCase(
        None,
        wrong="SPED(0) = 100\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="SPEED(0) = 100\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
    mccl=RuleCase(None, wrong="MC5\n", right="MD5,1TP\nMC5\n"),
)
