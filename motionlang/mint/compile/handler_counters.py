"""Find the counters of a handler: variables that it only advances and compares."""

from __future__ import annotations

from collections import Counter

from motionlang.mint.compile import operators
from motionlang.mint.compile.polling import may_poll, reached
from motionlang.mint.resolve.symbols import NUMERIC
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.compile.body import Body
    from motionlang.mint.resolve.symbols import Symbol

HANDLERS = ("timer",)
_LOOPS = nodes.While, nodes.Repeat, nodes.Loop, nodes.For


def describe(b: Body) -> None:
    """Describe to the runtime the counters of a handler and their compared constants.

        ticks = ticks + 1
        If ticks >= 100 Then ticks = 0

    A counter is advanced by a constant in one statement, and set only to constants elsewhere. Two facts are
    described with it: whether a loop that may poll uses it, and whether the handler sets it.
    """
    if b.function.kind != "event" or b.function.name.lower() not in HANDLERS or b.whole.typed:
        return
    uses: Counter[Symbol] = Counter()
    explained: Counter[Symbol] = Counter()
    steps: Counter[Symbol] = Counter()
    is_set: set[Symbol] = set()
    constants: dict[Symbol, list[float]] = {}
    for node in reached(b, b.function.body):
        own = _variable(node)
        if own is not None:
            uses[own] += 1
        if isinstance(node, nodes.Binary) and node.op in operators.COMPARISONS:
            for side, other in ((node.left, node.right), (node.right, node.left)):
                own = _variable(side)
                if own is not None and isinstance(other, nodes.Number):
                    constants.setdefault(own, []).append(float(other.value))
                    explained[own] += 1
        elif isinstance(node, nodes.Assign) and len(node.values) == 1:
            own, value = _variable(node.target), node.values[0]
            if own is not None and isinstance(value, nodes.Number):
                explained[own] += 1
                is_set.add(own)
            elif own is not None and _is_step(own, value):
                explained[own] += 2
                steps[own] += 1
    found = [own for own in steps if steps[own] == 1 and uses[own] == explained[own]]
    if found:
        names = tuple(own.python for own in found)
        levels = tuple(tuple(constants.get(own, ())) for own in found)
        polled = _polled(b)
        facts = tuple((own in polled, own in is_set) for own in found)
        b.whole.use("counters", b.function.name.lower(), names, levels, facts)


def _polled(b: Body) -> set[Symbol]:
    """Return the variables that are used by possibly polling loops outside handlers."""
    found: set[Symbol] = set()
    for function in b.whole.names.functions:
        if function is b.function:
            continue
        loops = [node for node in walk(function.body) if isinstance(node, _LOOPS) and may_poll(node.body)]
        iterations = [function.body] if function.jumps else [[node] for node in loops]
        for iteration in iterations:
            found.update(own for node in reached(b, iteration) if (own := _variable(node)) is not None)
    return found


def _variable(node: object) -> Symbol | None:
    """Return the shared numeric variable that a node names, None for any other node."""
    symbol = node.symbol if isinstance(node, nodes.Name) and node.args is None else None
    if symbol is None or symbol.kind != "variable" or not symbol.shared or symbol.type.name not in NUMERIC:
        return None
    return None if symbol.boxed or symbol.by_ref or symbol.is_array else symbol


def _is_step(own: Symbol, value: nodes.Expr) -> bool:
    """True if an expression is the variable `own` plus or minus a whole constant."""
    if not isinstance(value, nodes.Binary) or value.op not in ("+", "-"):
        return False
    is_whole = isinstance(value.right, nodes.Number) and isinstance(value.right.value, int)
    return is_whole and _variable(value.left) is own
