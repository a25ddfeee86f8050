"""What may change while a part of a program waits or loops, for the rules about waits and loops without an end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from motionlang.commands.check.axis_state import IDLE, AllAxes
from motionlang.commands.check.mint.conditions import Conditional
from motionlang.kernel.mint.resolve.folding import binary, unary
from motionlang.kernel.mint.resolve.symbols import TIME, Function, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import changed, meaning, meant, walk

if TYPE_CHECKING:
    from motionlang.commands.check.mint.mint_facts import MintFacts

# Keywords with which an input without a signal is 1.
_POLARITIES = frozenset(("INPUTACTIVELEVEL",))
_LEAVES = (nodes.Exit, nodes.Jump, nodes.Return, nodes.End, nodes.Label)


def may_change(facts: MintFacts, function: Function, name: nodes.Name, state: AllAxes) -> bool:
    """True if the value of a name may change while a function waits in a state of the axes."""
    symbol, row = name.symbol, name.row
    if symbol is not None:
        return _variable_may_change(facts, function, symbol)
    if row is None:
        return True
    if row.kind == "constant":
        return False
    if row.kind == "function":
        return row.changes == "always"
    if row.changes == "motion":
        return facts.axes.known(state, facts.key_of(name)).motion != IDLE
    return not _is_dead_input(facts, name)


def unchanging_loops(facts: MintFacts, function: Function) -> Iterator[tuple[Conditional, list[nodes.Name]]]:
    """Yield the loops that are never left by their conditions once they run.

    The second result is the inputs in the condition, which nothing drives. If there are none, nothing in the loop
    changes the variables in its condition.
    """
    loops: list[Conditional] = [*facts.of_kind(nodes.While, function), *facts.of_kind(nodes.Repeat, function)]
    for loop in loops:
        names = [each for each in walk([loop.condition]) if type(each) is nodes.Name]
        if not names or facts.value(loop.condition) is not None:
            continue
        inputs = [name for name in names if _is_dead_input(facts, name)]
        if any(_changes_outside(facts, function, name) for name in names if name not in inputs):
            continue
        symbols = {name.symbol for name in names if name.symbol is not None}
        if not _may_end(facts, function, loop, symbols):
            yield loop, inputs


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


def _changes_outside(facts: MintFacts, function: Function, name: nodes.Name) -> bool:
    """True if the value of a name may change without a statement of the loop that tests it."""
    symbol, row = name.symbol, name.row
    if symbol is None:
        return row is None or row.kind not in ("constant", "function") or row.changes == "always"
    return symbol.kind not in ("const", "variable", "parameter") or _variable_may_change(
        facts, function, symbol
    )


def _may_end(facts: MintFacts, function: Function, loop: Conditional, symbols: set[Symbol]) -> bool:
    """True if a loop has an exit, or if it or a sub that it calls may write one of the variables in its condition."""
    inside = list(walk(loop.body))
    if any(isinstance(each, _LEAVES) for each in inside):
        return True
    if symbols & {meaning(each) for inner in inside for each in changed(inner)}:
        return True
    calls = any(
        type(each) is nodes.Name and each.symbol is not None and each.symbol.kind == "sub" for each in inside
    )
    return calls and any(
        symbol.home is not function or bool(facts.writers.get(symbol, set()) - {function})
        for symbol in symbols
    )


def _variable_may_change(facts: MintFacts, function: Function, symbol: Symbol) -> bool:
    """True if another task, an event handler or a host may change a variable while this function runs."""
    if symbol.kind == "const":
        return False
    if symbol.kind not in ("variable", "parameter") or symbol.type.name == TIME or symbol.by_ref:
        return True
    if symbol in facts.hosted or symbol in facts.handled:
        return True
    mine = facts.roots[function]
    if len(mine) != 1:
        return True
    writers = facts.writers.get(symbol, set())
    return any(facts.roots[writer] - mine for writer in writers)


def _is_dead_input(facts: MintFacts, name: nodes.Name) -> bool:
    """True if a name is an input that no entry of the machine file drives."""
    row = name.row
    if row is None or row.driven != "input" or row.index != "input" or not name.args:
        return False
    channel, driven = facts.number(name.args[0]), facts.driven_inputs()
    return channel is not None and driven is not None and channel not in driven
