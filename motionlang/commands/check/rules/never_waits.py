"""A loop starts a motion in every iteration without a wait, so that the next one replaces it.

In Mint this is certain for a keyword that moves an axis at once, with a value that changes in every iteration of a loop
without a branch. Moves of the buffer wait while it is full.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.mccl.loops import endless_cycles
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import LOADS, spelt
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meaning, walk

if TYPE_CHECKING:
    from motionlang.commands.check.mccl.mccl_facts import MacroFacts
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import Use
    from motionlang.kernel.mint.resolve.symbols import Symbol

Loop = nodes.For | nodes.While | nodes.Repeat | nodes.Loop
_LOOPS: tuple[type[Loop], ...] = (nodes.For, nodes.While, nodes.Repeat, nodes.Loop)
# With one of these in its body, a loop may skip the statement, end, or take time.
_UNSURE = (nodes.If, nodes.Select, nodes.Jump, nodes.Exit, nodes.Return, nodes.End, nodes.Label, nodes.Pause,
           nodes.Input, nodes.Run, *_LOOPS)  # fmt: skip


def check_mint(facts: MintFacts, warn: Warn) -> None:
    acts = {act.at: act for found in facts.acts_of.values() for act in found}
    loops: list[Loop] = [each for kind in _LOOPS for each in facts.of_kind(kind)]
    for loop in loops:
        inner = list(walk(loop.body))
        if any(isinstance(each, _UNSURE) for each in inner):
            continue
        found = [acts[each.start] for each in inner if type(each) is nodes.Name and each.start in acts]
        if any(map(_takes_time, found)):
            continue
        changing = _changing(loop)
        given = {each.target.start: each.values for each in inner if type(each) is nodes.Assign}
        for act in sorted(found, key=lambda act: act.at):
            if act.role == "act" and any(_depends(each, changing) for each in given.get(act.at, ())):
                axis = spelt(act.axes[0])
                message = f"each iteration of this loop starts a motion of axis {axis} without waiting"
                warn(message, act.at, "add WAIT = 10 to the loop to give each its time")
                break


def _takes_time(act: Use) -> bool:
    return act.role in LOADS or act.role == "call" or (act.row is not None and act.row.function == "wait")


def _changing(loop: Loop) -> set[Symbol | None]:
    """Return the variables whose value changes in every iteration."""
    found: set[Symbol | None] = set()
    if type(loop) is nodes.For:
        found.add(meaning(loop.variable))
    for each in walk(loop.body):
        if type(each) is nodes.Assign and type(each.target) is nodes.Name and each.target.args is None:
            symbol = meaning(each.target)
            if symbol is not None and any(_depends(value, {symbol}) for value in each.values):
                found.add(symbol)
    return found - {None}


def _depends(value: nodes.Expr, on: set[Symbol | None]) -> bool:
    return any(type(each) is nodes.Name and meaning(each) in on for each in walk([value]))


def check_mccl(facts: MacroFacts, warn: Warn) -> None:
    for cycle in endless_cycles(facts):
        if cycle.moves:
            move, word = cycle.moves[-1], cycle.commands[cycle.last].name
            message = f"{word} repeats {facts.text(move)} without waiting for its end"
            warn(message, move.at, f"add {move.axes[0] or ''}WS after it")


RULE = Rule(
    code="never-waits",
    text="""\
A loop starts a new motion in each iteration and never waits, so each motion is cut short by the next one ten
microseconds later. In Mint, the warning is for a jog whose value changes in each iteration of a loop without a WAIT, a
PAUSE, a branch or an exit. In MCCL, it is for a move in commands that RP, JP, JR or MJ repeat forever without a wait,
a test and an exit. A run also warns if it starts several hundred motions from the same few lines within milliseconds,
whatever the loop looks like.
""",
    fix="wait for each move, or let time pass in the loop",
    mint=RuleCase(
        check_mint,
        wrong="Dim k\nFor k = 1 To 50\n  JOG(0) = k\nNext\nJOG(0) = 0\n",
        right="Dim k\nFor k = 1 To 50\n  JOG(0) = k\n  WAIT = 10\nNext\nJOG(0) = 0\n",
    ),
    mccl=RuleCase(check_mccl, wrong="1MN\n1MR100,RP\n", right="1MN\n1MR100,1WS,RP\n"),
)
