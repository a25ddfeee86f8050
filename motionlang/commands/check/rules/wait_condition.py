"""A WAIT, which takes a time, is given a condition, or a PAUSE, which takes a condition, a time."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from motionlang.commands.check.mint.conditions import is_truth_value
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint import table
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts

_WAIT = re.compile(r"(\w+)[ \t]*=?[ \t]*")


def check(facts: MintFacts, warn: Warn) -> None:
    for function in facts.functions:
        for p, node in facts.nodes_of(function):
            if p not in facts.axes.before[function]:
                continue
            if isinstance(node, nodes.Assign | nodes.Call) and _waits_for_condition(node):
                message = "WAIT takes a time in ms, and this is a condition: it waits 0 or 1 ms"
                _replace(facts, node, message, "PAUSE waits until a condition is true", "PAUSE", warn)
            elif type(node) is nodes.Pause:
                number = meant(node.condition)
                if type(number) is nodes.Number and number.value > 1:
                    word = table().doing("wait")
                    message = (
                        f"PAUSE takes a condition, and {number.value:.10g} is always true: it does not wait"
                    )
                    _replace(facts, node, message, f"{word} waits for a time in ms", word, warn)


def _replace(facts: MintFacts, node: nodes.Node, message: str, hint: str, word: str, warn: Warn) -> None:
    """Report a WAIT or PAUSE that should be the other, which is `word`."""
    found = _WAIT.match(facts.module.source.text, node.start)
    assert found is not None
    fix = (word if found[1].isupper() else word.capitalize()) + " " * (not found[0][-1:].isspace())
    warn(message, node.start, hint, length=len(found[0].rstrip()), fix=fix)


def _waits_for_condition(node: nodes.Assign | nodes.Call) -> bool:
    target = meant(node.target)
    if type(target) is not nodes.Name or target.row is None or target.row.function != "wait":
        return False
    values = node.values if type(node) is nodes.Assign else target.args or []
    return len(values) == 1 and is_truth_value(meant(values[0]))


RULE = Rule(
    code="wait-condition",
    text="""\
WAIT is given a condition, as in `WAIT IDLE(0)`. It takes a time in ms and a condition is 0 or 1, so the program waits
one millisecond at most. PAUSE waits until a condition is true; `--fix` writes it. Or PAUSE is given a time, as in
`PAUSE 100`: a number other than 0 is always true, so the program does not wait. `--fix` writes WAIT.
""",
    fix="write PAUSE instead of WAIT; check --fix does",
    mint=RuleCase(
        check,
        wrong="MOVER(0) = 5 : GO(0)\nWAIT IDLE(0)\n",
        right="MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\n",
    ),
)
