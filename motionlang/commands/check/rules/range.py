"""A rate or a relative move of MCCL has a fraction of a count, which the board rounds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mccl import NUMBER, codes
from motionlang.kernel.mccl.axis.axis import nearest_whole

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts

# Verbs of the commands after which the board no longer rounds rates: US, UR, UO and UZ. UK is of torques, UT of waits.
_SCALES = frozenset(("scale", "rate", "offset", "zero"))
_RATES = frozenset(("uu/s", "uu/s2"))


def check(facts: MacroFacts, warn: Warn) -> None:
    _check_rates(facts, warn)
    scales = facts.values(lambda row: row.function == "scale")
    switched_on = sorted(key for key in facts.given("enable") if isinstance(key, int))
    for command, at in facts.commands:
        if command.function != "move_by" or command.kind != NUMBER:
            continue
        value = float(command.value)
        for axis in [command.axis] if command.axis else switched_on:
            known = [scales.get(key, []) for key in (axis, None)]
            counts = {each for values in known if values is not None for each in values} or {1.0}
            if None in known or len(counts) > 1:
                continue
            scale = counts.pop()
            fault = codes.inexact(command.text, axis, value, nearest_whole(value * scale), scale)
            if fault is not None:
                warn(fault.message, at, fault.hint)


def _check_rates(facts: MacroFacts, warn: Warn) -> None:
    if not facts.model.rounds:
        return
    scaled = {command.axis for command, _ in facts.commands if command.function in _SCALES}
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
    text="""\
A rate such as SV or SA has a fraction, and no command of the file sets the units of its axis: the board rounds it to
counts. Or a move by MR is not a whole number of counts, and rounding changes it by more than 1 %: with `1US3`, ten
times `1MR.5` end at 6.67. In Mint, a value that lies outside what the keyword accepts is an error.
""",
    fix="choose a value within the range that the hint names",
    mint=RuleCase(
        None,
        wrong="SPEED(0) = -5\nMOVER(0) = 5 : GO(0)\n",
        right="SPEED(0) = 5\nMOVER(0) = 5 : GO(0)\n",
    ),
    mccl=RuleCase(check, wrong="1SV2.5\n1MN,1MR100,1WS\n", right="1SV3\n1MN,1MR100,1WS\n"),
)
