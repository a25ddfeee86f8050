"""Variables that a loop gives other values turn by turn and that decide nothing in it: a counter, an extremum, a copy.

    n = n + 1                               If POS(0) > peak Then peak = POS(0)                 x = POS(0)

Turns that are alike but for these can be skipped, all but the last one: it gives the copy and the extremum the values
that they would have, and a counter has counted on by as many turns. The condition of an extremum is the same again
until the reading turns round, which the copy is asked for instead of a level; of a mere copy nobody asks anything.
"""

from __future__ import annotations

from motionlang.mint.resolve.symbols import FLOAT, NUMERIC
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.compile.body import Body
    from motionlang.mint.resolve.symbols import Symbol

# What stands for a level, in generated text, until the reading turns round, and whatever it does.
UNTIL_IT_TURNS, WHATEVER = "1e999", "-1e999"
COMPARED = frozenset(("<", ">", "<=", ">="))


def carried(b: Body, turn: list[nodes.Node]) -> tuple[list[str], set[str], dict[int, str]]:
    """Counters and other such variables of a loop, by their spelling, and the levels of the readings they are given."""
    uses: dict[Symbol | None, int] = {}
    counters: set[Symbol] = set()
    levels: dict[int, str] = {}
    alone = b.function.kind != "sub" and not b.function.jumps and not b.watching
    found = list(walk(turn)) if alone else []
    for node in found:
        if isinstance(node, nodes.Name):
            own = _own(b, node)
            uses[own] = uses.get(own, 0) + 1
        elif isinstance(node, nodes.Assign) and len(node.values) == 1:
            own, value = _own(b, node.target), node.values[0]
            if own is not None and _counts(b, own, value):
                uses[own] = uses.get(own, 0) - 2
                counters.add(own)
            elif own is not None and own.type.name == FLOAT and _is_solved(b, value):
                uses[own] = uses.get(own, 0) - 1
                levels.setdefault(id(value), WHATEVER)
        elif isinstance(node, nodes.If) and isinstance(node.condition, nodes.Binary) and len(node.body) == 1:
            test, given = node.condition, node.body[0]
            if test.op in COMPARED and isinstance(given, nodes.Assign) and _is_solved(b, given.values[0]):
                own, reading = _own(b, given.target), given.values[0]
                for side, other in ((test.left, test.right), (test.right, test.left)):
                    if own is not None and _own(b, side) is own and _spelled(other) == _spelled(reading):
                        uses[own] = uses.get(own, 0) - 1
                        levels[id(reading)] = UNTIL_IT_TURNS
    mere = {own for own, left in uses.items() if own is not None and not left}
    return sorted(own.python for own in mere & counters), {own.python for own in mere}, levels


def _counts(b: Body, own: Symbol, value: nodes.Node) -> bool:
    """Whether a value is that of the variable itself, and a whole number more or less."""
    if not isinstance(value, nodes.Binary) or value.op not in "+-" or _own(b, value.left) is not own:
        return False
    return isinstance(value.right, nodes.Number) and value.right.value.__class__ is int


def _own(b: Body, node: object) -> Symbol | None:
    """The variable of this function alone that a name stands for."""
    symbol = node.symbol if isinstance(node, nodes.Name) and node.args is None else None
    if (
        symbol is None
        or symbol.kind != "variable"
        or symbol.home is not b.function
        or symbol.type.name not in NUMERIC
    ):
        return None
    return None if symbol.shared or symbol.boxed or symbol.by_ref or symbol.is_array else symbol


def _is_solved(b: Body, node: nodes.Node) -> bool:
    """Whether a value is nothing but a reading that can be asked for."""
    row = node.row if isinstance(node, nodes.Name) else None
    return row is not None and row.solved and _spelled(node) is not None


def _spelled(node: nodes.Node) -> tuple[object, ...] | None:
    """A reading of one axis or channel, for comparison."""
    if not isinstance(node, nodes.Name) or not all(
        isinstance(each, nodes.Number) for each in node.args or ()
    ):
        return None
    return node.name.lower(), *[each.value for each in node.args or () if isinstance(each, nodes.Number)]
