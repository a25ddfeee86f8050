"""A loop that nothing ends: in Mint nothing changes its condition, in MCCL commands repeat without a wait."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.mccl.loops import endless_cycles
from motionlang.commands.check.mint.changes import unchanging_loops
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts


def check_mint(facts: MintFacts, warn: Warn) -> None:
    for function in facts.functions:
        for loop, inputs in unchanging_loops(facts, function):
            if not inputs:  # those with inputs are an endless-wait
                word = "While" if type(loop) is nodes.While else "Repeat"
                message = f"nothing in this {word} changes what its condition depends on"
                warn(message, loop.start, "the program never leaves it")


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    for cycle in endless_cycles(facts):
        command = cycle.commands[cycle.last]
        if len(cycle.commands) == 1 and command.function != "repeat":
            warn(f"{command.text} jumps to itself forever", cycle.last, "jump to another command")
        elif not cycle.moves:  # those with moves are never-waits
            hint = "add WA0.1 before it"
            if command.function == "repeat":
                hint += f", or end after ten repetitions with {command.name}10"
            what = "macros" if command.function == "jump_macro" else "line"
            message = f"{command.name} repeats the {what} forever, without a wait or an exit"
            warn(message, cycle.last, hint)


RULE = Rule(
    code="endless-loop",
    text="""\
Nothing in a While or Repeat changes the values in its condition, and no Exit leads out of it. In MCCL:
commands that RP, JP, JR or MJ repeat forever, also through several macros, in which nothing takes time, nothing is
tested and nothing leads out.
""",
    fix="change the condition in the loop, or leave it with Exit",
    mint=RuleCase(
        check_mint,
        wrong="Dim n\nWhile n < 5\n  OUTX(1) = 1\nEnd While\n",
        right="Dim n\nWhile n < 5\n  OUTX(1) = 1\n  n = n + 1\nEnd While\n",
    ),
    mccl=RuleCase(check_mccl, wrong="1MN\nTP,RP\n", right="1MN\nTP,WA0.1,RP\n"),
)
