"""Nothing jumps to a label, and it handles no event."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.keywords.event_kinds import kind_and_number, label_event
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check(facts: MintFacts, warn: Warn) -> None:
    for function in facts.functions:
        is_main = function.kind == "main"
        targets = {node.name.lower() for node in facts.of_kind(nodes.Jump, function)}
        for label in facts.of_kind(nodes.Label, function):
            is_handler = is_main and label_event(label.name) is not None
            if label.name.lower() not in targets and not is_handler and " " not in label.name:
                is_event = is_main and kind_and_number(label.name) is not None
                hint = f"Mint v4 has no event {label.name} for programs; MintMT has one" if is_event else ""
                warn(f"label {label.name} is never used", label.start, hint)


RULE = Rule(
    code="unused-label",
    text="""\
Nothing jumps to the label, and it is not the name of an event (a handler, in v4). `#MBLOW` gets this
warning too: only an embedded or a host application can trap that event of Mint v4. MintMT has `Event MBLOW`.
""",
    fix="remove the label",
    mint=RuleCase(
        check,
        wrong="#again\nPRINT 1\n",
        right="PRINT 1\n",
    ),
)
