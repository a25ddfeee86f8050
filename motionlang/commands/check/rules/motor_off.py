"""A command moves an axis that the file never switches on, or has switched off.

The first one of each axis that is never on is reported.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.rule import Rule, RuleCase, Warn

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts

# Commands that start a motion.
_MOVES = frozenset((
    "move_to", "move_by", "go_home", "go", "move_to_point", "find_index", "find_edge", "path", "slave", "jog_on",
))  # fmt: skip


def check(facts: MacroFacts, warn: Warn) -> None:
    on = {command.axis for command, _ in facts.commands if command.function == "motor_on"}
    reported: set[int] = set()
    for command, at in facts.commands:
        if command.function not in _MOVES or command.axis in reported:
            continue
        if not on if command.axis == 0 else not on & {0, command.axis}:
            reported.add(command.axis)
            which = "an axis" if command.axis == 0 else f"axis {command.axis}"
            warn(f"no line of this file switches {which} on", at, f"{command.axis or ''}MN does")
    for act, key, _ in facts.axes.problems.get("motor-off", ()):
        if key not in facts.never_on:
            warn(
                f"{facts.text(act)} moves axis {key}, which is switched off",
                act.at,
                f"{key}MN switches it on",
            )


RULE = Rule(
    code="motor-off",
    text="""\
A command moves an axis that no line of the file enables with MN, or that MF or RT has switched off. An axis without an
MN may already be on if you load the file into a controller that is in use.
""",
    fix="switch the motor on with MN",
    mccl=RuleCase(
        check,
        wrong="1MR100\n",
        right="1MN,1MR100\n",
    ),
)
