"""A program uses the short name of a keyword as a variable: `TM = TM + 1` changes TERMINAL."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.check.unknown_words import another_name
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    seen: set[str] = set()
    names = (each for each in facts.of_kind(nodes.Name) if each.row is not None)
    in_full = {
        each.row.name for each in names if each.row is not None and each.name.lower() == each.row.name.lower()
    }
    for node in facts.of_kind(nodes.Assign):
        target, value = node.target, node.values[0]
        if type(target) is not nodes.Name or target.row is None or target.args is not None:
            continue
        is_short = target.name.lower() != target.row.name.lower()
        counts = (
            type(value) is nodes.Binary and type(value.left) is nodes.Name and value.left.row is target.row
        )
        what = (
            "counts here"
            if counts
            else "the program also writes in full"
            if target.row.name in in_full
            else ""
        )
        if is_short and what and target.row.name not in seen:
            seen.add(target.row.name)
            warn(
                f"{target.name} is the keyword {target.row.name}, which {what}",
                target.start,
                another_name(target.name, target.row),
            )


RULE = Rule(
    code="short-name",
    text="""\
A statement sets a keyword that is written by its short name and was probably meant as a variable: it adds to it, or
the program writes the keyword in full elsewhere. `TM = TM + 1` changes TERMINAL, the terminals to which PRINT writes;
`jg = 1` beside `JOG.0 = 40` starts a jog.
""",
    fix="give the variable another name",
    mint=RuleCase(
        check,
        wrong="TM = 0\nWHILE INX.1 = 0\n  TM = TM + 1\n  WAIT = 10\nENDW\n",
        right="n = 0\nWHILE INX.1 = 0\n  n = n + 1\n  WAIT = 10\nENDW\n? n\n",
    ),
)
