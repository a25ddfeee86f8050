"""The check for loops that replace a motion in every iteration.

If no time passes in the loop, none of these motions is ever seen.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.commands.check.facts import spelt
from motionlang.commands.check.mint.facts import MintFacts
from motionlang.kernel.mint.resolve.facts import meaning
from motionlang.kernel.mint.resolve.symbols import Function, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

Add = Callable[..., None]

_LOOPS = (nodes.For, nodes.While, nodes.Repeat, nodes.Loop)
# With one of these in its body, a loop may skip the statement, end, or take time.
_UNSURE = (nodes.If, nodes.Select, nodes.Jump, nodes.Exit, nodes.Return, nodes.End, nodes.Label, nodes.Pause,
           nodes.Input, nodes.Run, *_LOOPS)  # fmt: skip
# Roles of keywords that load the move buffer, and so wait while it is full.
_BLOCKS = frozenset(("move", "entry", "course", "path"))


def check_iterations(facts: MintFacts, function: Function, add: Add) -> None:
    """Report the first motion in each loop that every iteration replaces."""
    acts = {act.at: act for act in facts.acts_of[function]}
    for node in (node for kind in _LOOPS for node in facts.nodes[function].get(kind, ())):
        inner = list(walk(node.body))
        if any(isinstance(each, _UNSURE) for each in inner):
            continue
        found = [acts[each.start] for each in inner if type(each) is nodes.Name and each.start in acts]
        if any(act.role in _BLOCKS or act.role == "call" or _waits(act.row) for act in found):
            continue
        changing = _changing(node)
        given = {each.target.start: each.values for each in inner if type(each) is nodes.Assign}
        for act in sorted(found, key=lambda act: act.at):
            if act.role == "act" and any(_depends(each, changing) for each in given.get(act.at, ())):
                assert act.row is not None
                axis = spelt(act.axes[0])
                message = f"each iteration of this loop starts a motion of axis {axis} without waiting"
                add("never-waits", message, act.at, "add WAIT = 10 to the loop to give each its time")
                break


def _waits(row: object) -> bool:
    return getattr(row, "verb", "") == "wait"


def _changing(node: nodes.Node) -> set[Symbol | None]:
    """Return the variables whose value changes in every iteration."""
    found: set[Symbol | None] = set()
    if type(node) is nodes.For:
        found.add(meaning(node.variable))
    for each in walk(node.body):  # type: ignore[attr-defined]
        if type(each) is nodes.Assign and type(each.target) is nodes.Name and each.target.args is None:
            symbol = meaning(each.target)
            if symbol is not None and any(_depends(value, {symbol}) for value in each.values):
                found.add(symbol)
    return found - {None}


def _depends(value: nodes.Expr, on: set[Symbol | None]) -> bool:
    return any(type(each) is nodes.Name and meaning(each) in on for each in walk([value]))
