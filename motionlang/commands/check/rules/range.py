"""A rate of MCCL has a fraction, which the board rounds until a scale is set."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Case, Rule, Warn
from motionlang.kernel.mccl import NUMBER, codes
from motionlang.kernel.mccl.axis.axis import nearest_whole

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.facts import MacroFacts

# Verbs of the commands after which rates are in units of the user, and not rounded.
_SCALES = frozenset(("scale", "rate", "time_unit", "constant", "offset", "zero"))
_RATES = frozenset(("uu/s", "uu/s2"))


def check(facts: MacroFacts, warn: Warn) -> None:
    if not facts.model.rounds:
        return
    scaled = {command.axis for command, _ in facts.commands if command.verb in _SCALES}
    for command, at in facts.commands:
        row = command.row
        if row is None or row.unit not in _RATES or row.kind != "setting" or command.kind != NUMBER:
            continue
        value = float(command.value)
        whole = nearest_whole(value)
        if value != whole and not scaled & {0, command.axis}:
            fault = codes.rounded(command.text, value, whole)
            warn(fault.message, at, fault.hint)


RULE = Rule(
    code="range",
    group="Machine",
    text="""\
A rate such as SV or SA has a fraction, and no command of the file sets the units of its axis: the board rounds it to
counts. In Mint, a value that lies outside what the keyword accepts is an error.
""",
    fix="choose a value within the range that the hint names",
    mint=Case(
        None,
        wrong="SPEED(0) = -5\nMOVER(0) = 5 : GO(0)\n",
        right="SPEED(0) = 5\nMOVER(0) = 5 : GO(0)\n",
    ),
    mccl=Case(check, wrong="1SV2.5\n1MN,1MR100,1WS\n", right="1SV3\n1MN,1MR100,1WS\n"),
)
