"""Variables that a loop gives other values turn by turn and that decide nothing in it: a counter, an extremum, a copy.

    n = n + 1                               If POS(0) > peak Then peak = POS(0)                 x = POS(0)

Turns that are alike but for these can be skipped, all but the last one: it gives the copy and the extremum the values
that they would have, and a counter has counted on by as many turns. The condition of an extremum is the same again
until the reading turns round, which the copy is asked for instead of a level; of a mere copy nobody asks anything.
"""

from __future__ import annotations

from motionlang.mint.resolve.symbols import FLOAT, NUMERIC
from motionlang.mint.syntax import nodes

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable

    from motionlang.mint.compile.body import Body
    from motionlang.mint.resolve.symbols import Symbol

# What stands for a level, in generated text, until the reading turns round, and whatever it does.
UNTIL_IT_TURNS, WHATEVER = "1e999", "-1e999"
COMPARED = frozenset(("<", ">", "<=", ">="))


def idle(b: Body, turn: Iterable[nodes.Node]) -> tuple[list[str], set[str], dict[int, str]]:
    """Counters, and all such variables of a loop, by their spelling, and the levels of the readings they are given.

    `turn` is every node that a turn reaches.
    """
    uses: dict[Symbol | None, int] = {}
    counters: set[Symbol] = set()
    levels: dict[int, tuple[Symbol, str]] = {}
    alone = b.function.kind != "sub" and not b.function.jumps and not b.watching
    for node in turn if alone else ():
        own = _own(b, node)
        uses[own] = uses.get(own, 0) + 1
        given = node.body[0] if isinstance(node, nodes.If) and len(node.body) == 1 else node
        own, value = (
            (_own(b, given.target), given.values[0]) if isinstance(given, nodes.Assign) else (None, None)
        )
        if own is None or value is None:
            continue
        if isinstance(node, nodes.If):
            test = node.condition
            if isinstance(test, nodes.Binary) and test.op in COMPARED and _reading(value):
                sides = [_own(b, side) or _reading(side) for side in (test.left, test.right)]
                if sides in ([own, _reading(value)], [_reading(value), own]):
                    uses[own] = uses.get(own, 0) - 1
                    levels[id(value)] = own, UNTIL_IT_TURNS
        elif isinstance(value, nodes.Binary) and value.op in "+-" and _own(b, value.left) is own:
            if isinstance(value.right, nodes.Number) and isinstance(value.right.value, int):
                uses[own] = uses.get(own, 0) - 2
                counters.add(own)
        elif own.type.name == FLOAT and _reading(value):
            uses[own] = uses.get(own, 0) - 1
            levels.setdefault(id(value), (own, WHATEVER))
    mere = {own for own, left in uses.items() if own is not None and not left}
    kept = {number: text for number, (own, text) in levels.items() if own in mere}
    return sorted(own.python for own in mere & counters), {own.python for own in mere}, kept


def _own(b: Body, node: nodes.Node) -> Symbol | None:
    """The number of this function alone that a name stands for."""
    symbol = node.symbol if isinstance(node, nodes.Name) and node.args is None else None
    if symbol is None or symbol.kind != "variable" or symbol.home is not b.function:
        return None
    shared = symbol.shared or symbol.boxed or symbol.by_ref or symbol.is_array
    return None if shared or symbol.type.name not in NUMERIC else symbol


def _reading(node: nodes.Node) -> tuple[object, ...]:
    """A reading of one axis or channel that can be asked for, for comparison; () where it is anything else."""
    row = node.row if isinstance(node, nodes.Name) else None
    args = getattr(node, "args", None) or ()
    if row is None or not row.solved or not all(isinstance(each, nodes.Number) for each in args):
        return ()
    return row, *[each.value for each in args]
