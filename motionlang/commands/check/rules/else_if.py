"""An Else If on one line is read as an ElseIf."""

from __future__ import annotations

from motionlang.commands.check.rule import Rule, RuleCase

RULE = Rule(
    code="else-if",
    text="""\
An `Else If` on one line, with a Then and a statement behind it, is read as an ElseIf: what follows belongs to it up to
the next branch. It may be meant as an Else whose only statement is that If.
""",
    fix="write ElseIf, or Else on a line of its own",
    mint=RuleCase(
        None,
        wrong=(
            "Dim n = INX(1)\n"
            "If n = 1 Then\n"
            "  OUTX(1) = 1\n"
            "Else If n = 2 Then OUTX(2) = 1\n"
            "  OUTX(3) = 1\n"
            "End If\n"
        ),
        right=(
            "Dim n = INX(1)\n"
            "If n = 1 Then\n"
            "  OUTX(1) = 1\n"
            "ElseIf n = 2 Then\n"
            "  OUTX(2) = 1\n"
            "  OUTX(3) = 1\n"
            "End If\n"
        ),
    ),
)
