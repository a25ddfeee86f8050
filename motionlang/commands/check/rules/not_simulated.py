"""The keyword belongs to the language, but is not simulated here."""

from __future__ import annotations

from motionlang.commands.check.rule import Rule, RuleCase

RULE = Rule(
    code="not-simulated",
    text="""\
The keyword belongs to the language but is not simulated here. The program may still be right: settings are stored,
commands that do not affect motion do nothing, and the report of a run names both. The hint says if a run would end
there. That is the case at a keyword that moves an axis or decides what happens next, and at one that reads a value that
neither the program has written nor the machine file gives in `[mint.values]`. `run` also shows these warnings.
""",
    fix="remove the keyword for a run, or give its value in [mint.values] of the machine file",
    mint=RuleCase(
        None,
        wrong="ABSENCODERTURNS(0) = 4\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
        right="MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
    mccl=RuleCase(None, wrong="1MN,1MR100,1WS\nDW1\n", right="1MN,1MR100,1WS\n"),
)
