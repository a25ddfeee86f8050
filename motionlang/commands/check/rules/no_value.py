"""A variable is read, and nothing gives it a value, so it is always 0 or empty."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.mint.variables import Suggestions, constants_only, variables
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mccl.resolve.command import REGISTER
from motionlang.kernel.mccl.runtime.register_uses import ACCUMULATOR, uses_of, variable
from motionlang.kernel.mint.resolve.symbols import CONTROLLER, RECORD, SEMAPHORE, STRING, TIME

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts

# Types of variables that have a value without an assignment.
_WITH_VALUE = frozenset((TIME, SEMAPHORE, CONTROLLER, RECORD))


def check_mint(facts: MintFacts, warn: Warn) -> None:
    given = facts.writers.keys() | facts.retained | facts.begun
    suggestions = Suggestions()
    for symbol, is_used in variables(facts):
        if not is_used or symbol in given or symbol.is_array or symbol.type.name in _WITH_VALUE:
            continue
        value = "empty" if symbol.type.name == STRING else "0"
        near = suggestions.most_similar(symbol, lambda each: each in facts.writers and each.uses <= 1)
        warn(
            f"{symbol.name} is read but never assigned: it is always {value}",
            symbol.at,
            f"did you mean {near} in its assignment?"
            if near
            else "assign it in its Dim or before it is read",
            candidates=(near,) if near else (),
        )
    for symbol, meant in constants_only(facts):
        hint = f"did you mean {meant}? If it is a variable, declare it with Dim"
        warn(
            f"{symbol.name} is tested, and only constants are assigned to it",
            symbol.at,
            hint,
            candidates=(meant,),
        )


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    uses = [(uses_of(command), command, at) for command, at in facts.commands]
    if facts.has_host or any(found is None for found, _, _ in uses):
        return
    given = {number for found, _, _ in uses if found is not None for number in found.sets}
    for found, command, at in uses:
        reads = set(found.reads) if found is not None else set()
        if command.kind == REGISTER:
            reads.add(variable(int(command.value)))
        for number in sorted(reads - given - {ACCUMULATOR}):
            register = number if number >= 0 else -1 - number
            stored = "no line of this file stores a value there: it is 0"
            message = f"{command.text} reads register {register}, and {stored}"
            warn(message, at, f"AR{register} stores the accumulator in it")


RULE = Rule(
    code="no-value",
    text="""\
A variable is read, but nothing gives it a value: not its Dim, no statement, and no sub to which it is passed. It is
always 0 or an empty text. There is no warning for arrays and records. Or a variable without a Dim is named like a
keyword, only constants are assigned to it and it is only tested: `OUT4 = 1` switches no output, and `TIMER` is not
`TIME`.

In MCCL: a register that no AR stores. There is no warning if a comment has `lint: host`, or if a register is known only
at run time.
""",
    fix="assign a value first, or correct the name",
    mint=RuleCase(
        check_mint,
        wrong="Dim part\nPRINT part\n",
        right="Dim part = 1\nPRINT part\n",
    ),
    mccl=RuleCase(check_mccl, wrong="RA10,TR0\n", right="AL5,AR10\nRA10,TR0\n"),
)
