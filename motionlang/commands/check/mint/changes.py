"""What may change while a part of a program waits or loops, for the rules about waits and loops without an end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from motionlang.commands.check.axis_state import IDLE, AllAxes
from motionlang.commands.check.mint.conditions import Conditional
from motionlang.kernel.mint.resolve.folding import binary, unary
from motionlang.kernel.mint.resolve.symbols import SEMAPHORE, Function
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import Read

# Keywords with which an input without a signal is 1.
_POLARITIES = frozenset(("INPUTACTIVELEVEL",))
_LEAVES = (nodes.Exit, nodes.Jump, nodes.Return, nodes.End, nodes.Label)


def names_in(node: nodes.Expr) -> list[nodes.Name]:
    """Return the names in a condition, for a Define those in its expression."""
    found = [each for each in walk([node]) if type(each) is nodes.Name]
    definitions = [each.definition for each in found if each.definition is not None]
    inner = [name for each in definitions for name in names_in(each)]
    return [*(each for each in found if each.definition is None), *inner]


def unchanging(facts: MintFacts, node: nodes.Pause | Conditional, state: AllAxes | None) -> list[Read] | None:
    """Return the readings that decide when a wait or a loop ends, None if one of them, or a variable, may change.

    Without a state, axes may move.
    """
    names = names_in(node.condition)
    if not names or facts.value(node.condition) is not None:
        return None
    found = facts.structure.waits.at(node.start)
    always = any(name.row is not None and name.row.changes == "always" for name in names)
    symbols = {name.symbol for name in names if name.symbol is not None}
    # What the analysis does not follow: a host, references, functions with a memory, semaphores.
    others = symbols & (facts.hosted | facts.referred) or any(
        each.by_ref or each.kind == "sub" or each.type.name == SEMAPHORE for each in symbols
    )
    if found is None or found.computes or always or others:
        return None
    for kind, number in found.leaves:
        if kind == "position" and state is not None:
            if facts.axes.known(state, number).motion != IDLE:
                return None
        elif kind != "input" or not _is_dead(facts, number):
            return None
    return sorted(found.leaves)


def unchanging_loops(facts: MintFacts, function: Function) -> Iterator[tuple[Conditional, list[Read]]]:
    """Yield the loops that are never left once they run, with the inputs in their conditions, which nothing drives."""
    loops: list[Conditional] = [*facts.of_kind(nodes.While, function), *facts.of_kind(nodes.Repeat, function)]
    for loop in loops:
        found = unchanging(facts, loop, None)
        if found is not None and not any(isinstance(each, _LEAVES) for each in walk(loop.body)):
            yield loop, found


def at_rest(facts: MintFacts, node: nodes.Expr) -> float | None:
    """Return the value of a condition while the inputs that nothing drives are 0, None if it depends on more."""
    if any(row.name in _POLARITIES for row in facts.used):
        return None
    node = meant(node)
    if type(node) is nodes.Name and _is_dead_input(facts, node):
        return 0
    value = facts.value(node)
    if type(node) is nodes.Unary:
        operand = at_rest(facts, node.operand)
        value = None if operand is None else unary(node.op, operand)
    elif type(node) is nodes.Binary:
        left, right = at_rest(facts, node.left), at_rest(facts, node.right)
        value = None if left is None or right is None else binary(node.op, left, right)
    return None if isinstance(value, str) else value


def _is_dead_input(facts: MintFacts, name: nodes.Name) -> bool:
    """True if a name is an input that no entry of the machine file drives."""
    row = name.row
    if row is None or row.driven != "input" or row.index != "input" or not name.args:
        return False
    channel = facts.number(name.args[0])
    return channel is not None and _is_dead(facts, int(channel))


def _is_dead(facts: MintFacts, channel: int | None) -> bool:
    driven = facts.driven_inputs()
    return channel is not None and driven is not None and channel not in driven
