"""Find the readings that alone decide the course of a program with a TIMER.

Its tasks and handlers do the same whenever they are in the same state and these readings have the same outcomes. The
outcome of a reading that changes by itself is the side on which it is of each constant that it is compared with.
"""

from __future__ import annotations

from motionlang.mint.compile import operators
from motionlang.mint.compile.polling import plainly_acts, reached
from motionlang.mint.resolve.symbols import TIME
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import walk

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping
    from typing import Any

    from motionlang.mint.compile.body import Body

# A keyword, its index, and the constant that it is compared with.
Reading = tuple[str, int, float | None]


def describe(b: Body) -> None:
    """Describe to the runtime the readings of a program, if each has outcomes.

    What is read in a statement that acts does not matter, because no statement that acts is ever repeated.
    """
    found: dict[Reading, None] = {}
    for function in b.whole.names.functions:
        nodes_by_kind: dict[type, list[Any]] = {}
        for node in reached(b, function.body):
            nodes_by_kind.setdefault(node.__class__, []).append(node)
        for reading in _readings(nodes_by_kind):
            if reading is None:
                return
            found[reading] = None
    b.whole.use("outcomes", tuple(found))


def _readings(found: Mapping[type, list[Any]]) -> Iterator[Reading | None]:
    """Yield the readings among some nodes; None for one without an outcome."""
    assigns, calls, prints = (found.get(kind, []) for kind in (nodes.Assign, nodes.Call, nodes.Print))
    # A LINE compares with the text of its row.
    if any(node.word for node in prints):
        yield None
    # The time is no outcome, but a statement that stores it is never repeated either.
    stored = {id(value) for node in assigns for value in node.values}
    ignored = {id(node.target) for node in (*assigns, *calls)}
    for node in (*assigns, *calls, *prints, *found.get(nodes.Input, [])):
        if plainly_acts(node):
            ignored.update(map(id, walk([node])))
    levels = {
        id(side): float(other.value)
        for node in found.get(nodes.Binary, [])
        if node.op in operators.COMPARISONS
        for side, other in ((node.left, node.right), (node.right, node.left))
        if isinstance(other, nodes.Number)
    }
    for node in found.get(nodes.Name, []):
        if id(node) in ignored:
            continue
        row, index = node.row, _index(node)
        if row is None or row.kind not in ("reading", "setting"):
            if node.symbol is not None and node.symbol.type.name == TIME:
                yield None
            continue
        is_time = row.solved and row.index == "none"
        if is_time and id(node) in stored:
            continue
        level = levels.get(id(node)) if row.solved and not is_time else None
        is_known = row.actions.outcome is not None or level is not None
        yield (row.name, index, level) if is_known and index is not None else None


def _index(node: nodes.Name) -> int | None:
    """Return the only index of a reading; None if it has others, or is no constant."""
    index = node.args[0] if node.args and len(node.args) == 1 else None
    return index.value if isinstance(index, nodes.Number) and isinstance(index.value, int) else None
