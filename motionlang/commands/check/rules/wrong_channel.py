"""A channel is not the one that was meant: an output at an input, or a bank of 32 in place of one channel.

In MCCL a channel is an output at power-up or after a CT anywhere in the file. A CT whose channel is in a register may
be for any channel. In Mint a bank above 0 is probably a channel if its value is used as true or false, or if nothing
but 0 and 1 is written to it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.lang import BANK
from motionlang.kernel.mccl import models_with, table
from motionlang.kernel.mint import table as mint_table
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts

_SWITCHES = frozenset({"channel_on", "channel_off"})


def check_mint(facts: MintFacts, warn: Warn) -> None:
    """Report a bank whose value is used as true or false, as that of one channel is."""
    truths: list[nodes.Expr] = []
    for node in walk(facts.module.everything):
        if isinstance(node, nodes.If | nodes.While | nodes.Repeat | nodes.Pause):
            truths.append(node.condition)
        elif type(node) is nodes.Binary and node.op in ("And", "Or"):
            truths += [node.left, node.right]
        elif type(node) is nodes.Unary and node.op == "Not":
            truths.append(node.operand)
        elif type(node) is nodes.Binary and node.op in ("=", "<>"):
            truths += [each for each, other in _sides(node) if facts.number(other) in (0, 1)]
    for truth in (*truths, *_switched(facts)):
        _check_bank(facts, truth, warn)


def _switched(facts: MintFacts) -> Iterator[nodes.Expr]:
    """Yield the targets of assignments to banks to which nothing but 0, 1, _ON and _OFF is assigned."""
    targets: dict[tuple[str, float | None], list[nodes.Expr]] = {}
    patterns = set()
    for node in facts.of_kind(nodes.Assign):
        name = meant(node.target)
        if type(name) is not nodes.Name or name.row is None or name.row.index != "bank" or not name.args:
            continue
        key = name.row.name, facts.number(name.args[0])
        targets.setdefault(key, []).append(node.target)
        if len(node.values) > 1 or not (_is_bool(node.values[0]) or facts.number(node.values[0]) in (0, 1)):
            patterns.add(key)
    for key, found in targets.items():
        if key not in patterns:
            yield from found


def _sides(node: nodes.Binary) -> tuple[tuple[nodes.Expr, nodes.Expr], ...]:
    return (node.left, node.right), (node.right, node.left)


def _is_bool(node: nodes.Expr) -> bool:
    return type(node) is nodes.Name and node.row is not None and node.row.unit == "bool"


def _check_bank(facts: MintFacts, node: nodes.Expr, warn: Warn) -> None:
    name = meant(node)
    if type(name) is not nodes.Name or name.row is None or name.row.index != "bank" or not name.args:
        return
    bank, one = facts.number(name.args[0]), mint_table().get(f"{name.row.name}X")
    if not bank or one is None:
        return
    first, last = int(bank) * BANK, int(bank) * BANK + BANK - 1
    if name.row.driven == "input" and set(range(first, last + 1)) & (facts.driven_inputs() or set()):
        return
    written = facts.module.source.text[name.start : name.end]
    message = f"{written} is a bank, with the {one.index}s {first} to {last}"
    warn(message, name.start, f"{one.index} {bank:.0f} alone is {one.name}({bank:.0f})")


def check(facts: MacroFacts, warn: Warn) -> None:
    made = {command.number for command, _ in facts.commands if command.function == "channel_output"}
    outputs = facts.model.outputs
    wrong = [
        (command, at)
        for command, at in facts.commands
        if command.function in _SWITCHES and command.number is not None
        if not made & {None, command.number} and command.number not in outputs
    ]
    word, other_models = table().doing("channel_output"), _other_models(facts, made)
    for command, at in wrong[:1] if other_models else wrong:  # one model is one cause
        channel = command.number
        hint = f"{word}{channel} makes it an output; {outputs.start} to {outputs.stop - 1} are outputs at power-up"
        warn(
            f"channel {channel} is an input on this board: {command.text} is rejected",
            at,
            other_models or hint,
        )


def _other_models(facts: MacroFacts, made: set[int | None]) -> str:
    """Return a hint with the models on which all switched channels are outputs; "" if there are none."""
    switched = (
        {command.number for command, _ in facts.commands if command.function in _SWITCHES} - made - {None}
    )
    names = models_with(lambda each: each is not facts.model and switched.issubset(each.outputs))
    return f"it is an output on {names}: set controller.model in the machine file" if names else ""


RULE = Rule(
    code="wrong-channel",
    text="""\
A bank of 32 channels is used where one channel is probably meant: `IF IN(3)` asks for inputs 96 to 127, and `INX(3)` is
input 3. The warning is for a bank above 0 that is used as true or false, unless the machine file drives an input of it,
and for one to which the program writes nothing but 0 and 1: `OUT(1) = 1` switches output 32 on, `OUTX(1) = 1` output 1.

In MCCL, CN or CF names a channel that is an input at power-up, and no CT in the file makes it an output. The board
rejects the command.
""",
    fix="write INX or OUTX for one channel; in MCCL, make the channel an output with CT first",
    mint=RuleCase(
        check_mint,
        wrong="IF IN(3) THEN PRINT 1\n",
        right="IF INX(3) THEN PRINT 1\n",
    ),
    mccl=RuleCase(
        check,
        wrong="CN1\n",
        right="CT1,CN1\n",
    ),
)
