"""More moves are loaded than the buffer holds, before the GO that could empty it.

The state of an axis has the moves that certainly wait before a statement. A For without a branch loads the moves of its
body in each of its iterations.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.commands.check.axis_state import IDLE
from motionlang.commands.check.rule import Rule, RuleCase, Warn
from motionlang.commands.check.rule_facts import LOADS, spelt
from motionlang.kernel.lang import HEAD, NEXT
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import changed, meaning, walk

if TYPE_CHECKING:
    from collections.abc import Mapping

    from motionlang.commands.check.mint.mint_facts import MintFacts
    from motionlang.kernel.lang import AxisKey as Key
    from motionlang.kernel.lang import Use

DEFAULT_SIZE = 2
# Statements that leave a loop or may skip a part of its body, and roles of keywords that may empty a buffer.
_BREAKS = (nodes.Exit, nodes.Jump, nodes.Return, nodes.End, nodes.Run, nodes.Label)
_EMPTIES = frozenset(("go", "stop", "act", "course", "path", "call"))


def check(facts: MintFacts, warn: Warn) -> None:
    set_sizes, without_go = facts.constants(facts.word("buffer_size")), facts.triggered()
    sizes = {key: None if own is None else max([DEFAULT_SIZE, *own]) for key, own in set_sizes.items()}

    def size_of(key: Key) -> float | None:
        """Return the number of entries that the buffer of an axis holds, None if unknown."""
        if {key, None} & without_go or None in sizes or (isinstance(key, str) and sizes):
            return None
        return sizes.get(key, DEFAULT_SIZE)

    for function in facts.functions:
        before, points = facts.axes.before[function], facts.graph.points
        places = {(points[p].at, points[p].role): p for p in facts.points[function]}
        for p, node in facts.nodes_of(function):
            if p not in before:
                continue
            for act in facts.acts[p]:
                if act.role in LOADS:
                    for key in act.axes[:1] if act.role == "path" else act.axes:
                        size = size_of(key)
                        if size is not None and facts.axes.known(before[p], key).waiting >= size:
                            _overfilled(act, key, size, warn)
            if type(node) is nodes.For:
                iterations = _iterations(facts, node)
                for key, loads in _loads_of_each(facts, places, node).items():
                    size = size_of(key)
                    axis = facts.axes.known(before[p], key)
                    if iterations is None or size is None or axis.motion != IDLE:
                        continue
                    if axis.waiting + len(loads) <= size < axis.waiting + iterations * len(loads):
                        _overfilled(loads[0], key, size, warn)


def _overfilled(act: Use, key: Key, size: float, warn: Warn) -> None:
    message = f"axis {spelt(key)} already has {size:.10g} moves in its buffer and no GO: this waits forever"
    warn(message, act.at, f"write GO before this, or set MOVEBUFFERSIZE above {size:.10g}")


def _iterations(facts: MintFacts, node: nodes.For) -> int | None:
    """Return how often a For is repeated, None if it is unknown or if its body may change that."""
    counter = meaning(node.variable)
    for inner in walk(node.body):
        if type(inner) in _BREAKS or any(meaning(name) is counter for name in changed(inner)):
            return None
    start, stop = facts.number(node.first), facts.number(node.stop)
    step = 1.0 if node.step is None else facts.number(node.step)
    return None if start is None or stop is None or not step else int((stop - start) // step) + 1


def _loads_of_each(
    facts: MintFacts, places: Mapping[tuple[int, str], int], node: nodes.For
) -> dict[Key, list[Use]]:
    """Return the loads of every iteration by axis; none if the body may empty a buffer.

    `places` has the points of its function by offset and role.
    """
    body = range(places[node.start, HEAD] + 1, places[node.start, NEXT])
    acts = [act for p in body for act in facts.acts.get(p, ())]
    loads: dict[Key, list[Use]] = {}
    if any(act.role in _EMPTIES for act in acts):
        return loads
    direct = {inner.target.start for inner in node.body if type(inner) is nodes.Assign}
    for act in acts:
        if act.role in ("move", "entry") and act.at in direct:
            for key in act.axes:
                if key is not None:
                    loads.setdefault(key, []).append(act)
    return loads


RULE = Rule(
    code="buffer-overfilled",
    text="""\
The buffer of an axis holds MOVEBUFFERSIZE moves, 2 by default, and one more while a move is running. A statement that
finds the buffer full waits for space. If the loaded moves need a GO that comes after this statement, there will never
be space, and the program hangs. The warning also covers a `For` that loads too many moves.
""",
    fix="write GO sooner, or increase MOVEBUFFERSIZE",
    mint=RuleCase(
        check,
        wrong="MOVER(0) = 1\nMOVER(0) = 2\nMOVER(0) = 3\nGO(0)\n",
        right="MOVEBUFFERSIZE(0) = 3\nMOVER(0) = 1\nMOVER(0) = 2\nMOVER(0) = 3\nGO(0)\n",
    ),
)
