"""An input of the machine file has `asked`, and the program never waits for it and never polls it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check(facts: MintFacts | MacroFacts, warn: Warn) -> None:
    entries = facts.settings.get("input", ())
    asked: list[int] = [each["channel"] for each in entries if "asked" in each]  # type: ignore[attr-defined]
    if not asked:
        return
    waits = list(facts.structure.waits.all())
    read = {number for each in waits for kind, number in each.leaves | each.within if kind == "input"}
    if None in read:  # it computes the number, or reads a bank
        return
    uses = [
        use
        for each in facts.structure.statements.values()
        for use in each.channels
        if use.access == "read" and use.channel == "input"
    ]
    for channel in sorted({*asked} - read):
        at = next((use.at for use in uses if use.number == str(channel)), 0)
        message = f"nothing asks for input {channel}, so its entry of the machine file never changes it"
        warn(
            message,
            at,
            "wait for it or poll it, or give its entry at, output or a position in place of asked",
        )


_MACHINE = "input = [{ channel = 1, asked = 0.3 }]\n"
RULE = Rule(
    code="never-asked",
    group="Control flow",
    text="""\
An entry `[[input]]` of the machine file with [`asked`](machine-file.md#what-answers-when-asked) changes the input
while the program waits for it or polls it in a loop. No wait and no loop of the program reads this input.
""",
    fix="wait for the input or poll it, or say in another way when it changes",
    mint=RuleCase(check, wrong="IF INX(1) THEN PRINT 1\n", right="PAUSE INX(1)\nPRINT 1\n", machine=_MACHINE),
    mccl=RuleCase(check, wrong="TC1\n", right="WN1\n", machine=_MACHINE),
)
