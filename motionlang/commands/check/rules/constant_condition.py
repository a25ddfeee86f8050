"""A condition compares constants, or has a number that is not compared as an operand of And or Or."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.mint.conditions import COMPARISONS
from motionlang.commands.check.rule import Case, Rule, Warn
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.commands.check.mint.facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for function in facts.functions:
        reached = facts.reached(function)
        for p, node in facts.nodes_of(function):
            if p in reached and (type(node) is nodes.Pause or facts.is_test(p)):
                _check_condition(facts, node.condition if type(node) is nodes.Pause else node, warn)


def _check_condition(facts: MintFacts, node: nodes.Node, warn: Warn) -> None:
    if type(node) is nodes.Binary and node.op in COMPARISONS:
        value = facts.number(node)
        if value is not None:
            warn(f"this condition is always {'true' if value else 'false'}", node.start)
    elif type(node) is nodes.Binary and node.op in ("And", "Or"):
        for side in (node.left, node.right):
            if type(side) is nodes.Number:
                _lone_number(node, side, warn)
            else:
                _check_condition(facts, side, warn)
    elif type(node) is nodes.Unary and node.op == "Not":
        _check_condition(facts, node.operand, warn)


def _lone_number(node: nodes.Binary, side: nodes.Number, warn: Warn) -> None:
    decides = bool(side.value) is (node.op == "Or")
    always = "true" if side.value else "false"
    effect = f"so the condition is always {always}" if decides else "so it changes nothing"
    message = f"{side.value:.10g} is an operand of {node.op} on its own, {effect}"
    warn(message, side.start, "compare it, as in x = 1 Or x = 2; & and | work on bits")


RULE = Rule(
    code="constant-condition",
    group="Control flow",
    text="""\
Both sides of a comparison are constants; or a number is an operand of And or Or by itself, as in `If n = 1 Or 2 Then`,
which is always true. There is no warning for a constant alone, because `If _DEBUG Then` is a switch and `While 1` an
intended endless loop.
""",
    fix="compare each value, as in n = 1 Or n = 2",
    mint=Case(
        check,
        wrong="Dim n = INX(1)\nIf n = 1 Or 2 Then OUTX(1) = 1\n",
        right="Dim n = INX(1)\nIf n = 1 Or n = 2 Then OUTX(1) = 1\n",
    ),
)
