"""An entry of the machine file has `asked`, and the program never waits for its value and never polls it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.lang import DRIVES, ChannelUse

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts

# The device of inputs that are read as one number, and that of registers.
_BANK, _REGISTER = "input bank", DRIVES["modbus.register"][0]
# The tables of memory that the controller's own Modbus server shows as registers.
_SHOWN_AS_REGISTERS = ("comms", "netdata")


def check(facts: MintFacts | MacroFacts, warn: Warn) -> None:
    asked = {
        (table, _number(table, entry)): _name(table, entry)
        for table in DRIVES
        for entry in facts.settings.get(table, ())  # type: ignore[attr-defined]
        if "asked" in entry
    }
    if not asked:
        return
    structure = facts.structure
    uses = [use for each in structure.statements.values() for use in each.channels if use.access == "read"]
    lines = {line for each in structure.waits.all() for line in each.lines}
    polled = [use for use in uses if structure.line(use.at) in lines]
    for (table, number), name in sorted(asked.items()):
        if not any(_may_read(use, table, number) for use in polled):
            at = next((use.at for use in uses if _may_read(use, table, number)), 0)
            hint = "wait for it or poll it, or give its entry at, output or a position in place of asked"
            if table not in ("input", "analogue"):
                hint = "wait for it or poll it, or give its entry at in place of asked"
            warn(f"nothing asks for {name}, so its entry of the machine file never acts", at, hint)


def _number(table: str, entry: Mapping[str, object]) -> str:
    """Return the number of an entry as a use of its channel has it, "" for a key."""
    key = DRIVES[table][1]
    server = f"{entry['server']}, " if "server" in entry else ""
    return f"{server}{entry[key]}" if key else ""


def _name(table: str, entry: Mapping[str, object]) -> str:
    device, key = DRIVES[table]
    server = f" of server {entry['server']}" if "server" in entry else ""
    return f"{device} {entry[key]}{server}" if key else f"a {device}"


def _may_read(use: ChannelUse, table: str, number: str) -> bool:
    """True if a use reads the value of an entry, or one whose number is computed."""
    if use.channel == _BANK:
        return table == "input"
    if use.channel == _REGISTER and "," not in use.number:
        return table in _SHOWN_AS_REGISTERS
    if use.channel != DRIVES[table][0]:
        return False
    parts: Sequence[str] = use.number.split(", ")
    return not number or use.number == number or not all(each.isdecimal() for each in parts)


_MACHINE = "input = [{ channel = 1, asked = 0.3 }]\n"
RULE = Rule(
    code="never-asked",
    text="""\
An entry of the machine file with [`asked`](machine-file.md#what-answers-when-asked) acts while the program waits for
its input, key or number, or polls it in a loop. No wait and no loop of the program reads it.
""",
    fix="wait for the value or poll it, or say in another way when it changes",
    mint=RuleCase(check, wrong="IF INX(1) THEN PRINT 1\n", right="PAUSE INX(1)\nPRINT 1\n", machine=_MACHINE),
    mccl=RuleCase(check, wrong="TC1\n", right="WN1\n", machine=_MACHINE),
)
