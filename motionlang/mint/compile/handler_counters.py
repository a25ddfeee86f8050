"""Find counters in programs with a TIMER.

They are variables that its handler, or polling loops, only advance and compare.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence

from motionlang.mint.compile import operators, outcomes
from motionlang.mint.compile.body import Body
from motionlang.mint.compile.polling import may_poll, reached
from motionlang.mint.resolve.symbols import NUMERIC, Symbol
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

HANDLERS = ("timer",)
_LOOPS = nodes.While, nodes.Repeat, nodes.Loop, nodes.For


def describe(b: Body) -> None:
    """Describe to the runtime the counters of a function and their compared constants.

        ticks = ticks + 1
        If ticks >= 100 Then ticks = 0

    A counter of a handler is advanced by constants in one direction, and set only to constants elsewhere. Two
    facts are described with it: whether a loop that may poll uses it, and whether the handler sets it.

    A counter of a task is advanced in its loops that may poll, and not set there. It becomes a cell of the program,
    so that it can be advanced while the task is suspended.
    """
    function = b.function
    if b.whole.typed or not _has_handler(b):
        return
    if function.kind == "event" and function.name.lower() in HANDLERS:
        _describe(b, function.name.lower(), [function.body], _shared, _polled(b))
        outcomes.describe(b)
    elif function.kind in ("main", "task") and not function.jumps and b.whole.debugging is None:
        key = "main" if function.kind == "main" else f"task {function.name.lower()}"
        loops = [[node] for node in walk(function.body) if isinstance(node, _LOOPS) and may_poll(node.body)]
        found = _describe(b, key, loops, lambda node: _local(b, node), None)
        b.cells = {own.python for own in found}
        b.outside |= b.cells


def _has_handler(b: Body) -> bool:
    """True if the program has a block for one of the events."""
    for function in b.whole.names.functions:  # noqa: SIM110 - a generator costs more than the rest
        if function.kind == "event" and function.name.lower() in HANDLERS:
            return True
    return False


def _describe(
    b: Body,
    key: str,
    bodies: Sequence[Sequence[nodes.Stmt]],
    variable: Callable[[object], Symbol | None],
    polled: set[Symbol] | None,
) -> list[Symbol]:
    """Describe and return the counters among the variables of some statements.

    They are described under `key`. `polled` are the variables that loops use; None if the counters may not be set.
    """
    uses: Counter[Symbol] = Counter()
    explained: Counter[Symbol] = Counter()
    directions: dict[Symbol, set[str]] = {}
    is_set: set[Symbol] = set()
    constants: dict[Symbol, list[float]] = {}
    # Loops inside others are reached with these.
    seen: set[int] = set()
    bodies = [body for body in bodies if body]
    for node in (node for body in bodies if id(body[0]) not in seen for node in reached(b, body)):
        if id(node) in seen:
            continue
        seen.add(id(node))
        own = variable(node)
        if own is not None:
            uses[own] += 1
        if isinstance(node, nodes.Binary) and node.op in operators.COMPARISONS:
            for side, other in ((node.left, node.right), (node.right, node.left)):
                own = variable(side)
                if own is not None and isinstance(other, nodes.Number):
                    constants.setdefault(own, []).append(float(other.value))
                    explained[own] += 1
        elif isinstance(node, nodes.Assign) and len(node.values) == 1:
            own, value = variable(node.target), node.values[0]
            if own is not None and isinstance(value, nodes.Number):
                explained[own] += 1
                is_set.add(own)
            elif own is not None and isinstance(value, nodes.Binary) and _is_step(own, value, variable):
                explained[own] += 2
                directions.setdefault(own, set()).add(value.op)
    # A counter that passes a constant must count in one direction.
    found = [own for own, ops in directions.items() if len(ops) == 1 and uses[own] == explained[own]]
    if polled is None:
        found = [own for own in found if own not in is_set]
    if found:
        names = tuple(own.python for own in found)
        levels = tuple(tuple(constants.get(own, ())) for own in found)
        facts = tuple((own in (polled or ()), own in is_set) for own in found)
        b.whole.use("counters", key, names, levels, facts)
    return found


def _polled(b: Body) -> set[Symbol]:
    """Return the variables that are used by possibly polling loops outside handlers."""
    found: set[Symbol] = set()
    for function in b.whole.names.functions:
        if function is b.function:
            continue
        loops = [node for node in walk(function.body) if isinstance(node, _LOOPS) and may_poll(node.body)]
        iterations = [function.body] if function.jumps else [[node] for node in loops]
        for iteration in iterations:
            found.update(own for node in reached(b, iteration) if (own := _shared(node)) is not None)
    return found


def _shared(node: object) -> Symbol | None:
    """Return the shared numeric variable that a node names, None for any other node."""
    own = _numeric(node)
    return own if own is not None and own.shared else None


def _local(b: Body, node: object) -> Symbol | None:
    """Return the numeric variable of this function alone that a node names.

    None for any other node.
    """
    own = _numeric(node)
    return own if own is not None and not own.shared and own.home is b.function else None


def _numeric(node: object) -> Symbol | None:
    """Return the numeric variable that a node names.

    None if it can be changed by another name.
    """
    symbol = node.symbol if isinstance(node, nodes.Name) and node.args is None else None
    if symbol is None or symbol.kind != "variable" or symbol.type.name not in NUMERIC:
        return None
    return None if symbol.boxed or symbol.by_ref or symbol.is_array else symbol


def _is_step(own: Symbol, value: nodes.Binary, variable: Callable[[object], Symbol | None]) -> bool:
    """True if an expression is the variable `own` plus or minus a whole constant."""
    is_whole = isinstance(value.right, nodes.Number) and isinstance(value.right.value, int)
    return is_whole and value.op in ("+", "-") and variable(value.left) is own
