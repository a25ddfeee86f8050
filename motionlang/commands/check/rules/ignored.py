"""A part of a line has no effect: a number behind a command that takes none, or what was not meant as a comment."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mccl import NUMBER, line_of
from motionlang.kernel.mccl.keywords.row import takes_number
from motionlang.kernel.mccl.resolve.decode import fault_of
from motionlang.kernel.mccl.resolve.errors import axis_behind
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts

# A comment directly behind a command.
_BEHIND = re.compile(r"(?<=\w);(?=\S)(.*)")
# A text between single quotes in place of a value of PRINT.
_QUOTED = re.compile(r"[ \t,;]*('([^'\"\n]*)')[ \t]*(?:[,;].*)?$", re.MULTILINE)


def check_mint(facts: MintFacts, warn: Warn) -> None:
    text = facts.module.source.text
    for node in facts.of_kind(nodes.Print):
        if node.items and not node.items[-1].separator:
            continue
        found = _QUOTED.match(text, node.end)
        if found is not None:
            message = "' begins a comment, so this text is not printed"
            quoted, fix = found[1], f'"{found[2]}"'
            warn(message, found.start(1), "a text is in double quotes", length=len(quoted), fix=fix)


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    for command, at in facts.commands:
        if command.row is not None and not takes_number(command.row) and command.kind == NUMBER:
            number, hint = f"{command.value:.10g}", f"write {command.axis or ''}{command.name}"
            if axis_behind(command, number, facts.axis_count):
                hint = f"the axis goes before the command: {number}{command.name}"
            warn(f"{command.text}: {command.name} takes no number, which is ignored", at, hint)
    text = facts.structure.source.text
    for line in facts.lines:
        end = text.find("\n", line.offsets[-1])
        found = _BEHIND.search(text, line.offsets[-1], end if end >= 0 else len(text))
        if found is not None and _are_commands(found[1]):
            message = "the semicolon begins a comment: the commands behind it are not carried out"
            warn(message, found.start(), "separate commands by commas", length=1, fix=",")


def _are_commands(text: str) -> bool:
    line = line_of(text.strip())
    return line is not None and not any(fault_of(each) for each in line.commands)


RULE = Rule(
    code="ignored",
    text="""\
A part of a line has no effect. A command that takes no number, such as PT, ignores one: `TP1` tells all positions, and
`1TP` that of axis 1. A semicolon begins a comment,
so it does not separate commands: `1MR100;1WS0` moves and does not wait. The second warning is only for a semicolon
directly between two commands.

In Mint, `'` begins a comment, so `PRINT 'done'` prints an empty line. The warning is for a text between two of these
quotes where PRINT has no value; `check --fix` writes double quotes.
""",
    fix="remove the number, separate the commands by a comma, or put the text in double quotes",
    mint=RuleCase(check_mint, wrong="PRINT 'done'\n", right='PRINT "done"\n'),
    mccl=RuleCase(check_mccl, wrong="1MN,1PT1,1MR100;1WS0\n", right="1MN,1PT,1MR100,1WS0\n"),
)
