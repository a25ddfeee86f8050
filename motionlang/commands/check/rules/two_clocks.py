"""TIME and a variable of type Time are subtracted: both count, and their difference never changes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.resolve.symbols import TIME
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meaning, meant
from motionlang.kernel.mint.syntax.unparse import shown

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for node in facts.of_kind(nodes.Binary):
        if node.op != "-":
            continue
        one, other = meant(node.left), meant(node.right)
        for clock, name in ((one, other), (other, one)):
            if type(clock) is not nodes.Name or type(name) is not nodes.Name:
                continue
            symbol = meaning(name)
            if (
                _is_clock(clock)
                and symbol is not None
                and symbol.kind == "variable"
                and symbol.type.name == TIME
            ):
                message = (
                    f"{name.name} is a Time variable, which counts by itself: {shown(node)} never changes"
                )
                hint = f"set {name.name} to 0 and read {name.name}, or declare it As Integer"
                warn(message, node.start, hint)


def _is_clock(name: nodes.Name) -> bool:
    return name.row is not None and name.row.function == "time"


RULE = Rule(
    code="two-clocks",
    text="""\
A variable of type Time counts milliseconds by itself, as TIME does. Their difference is the same at all times, so it
measures nothing, and a wait for it never ends.
""",
    fix="set the variable to 0 and read the variable alone, or declare it As Integer",
    mint=RuleCase(
        check,
        wrong="Dim t As Time\nt = TIME\nPAUSE TIME - t > 2000\n",
        right="Dim t As Time\nt = 0\nPAUSE t > 2000\n",
    ),
)
