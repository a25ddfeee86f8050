"""Checks of the move buffer: too many moves, and moves that are never started."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from motionlang.commands.check.axis_state import IDLE, Follower, State
from motionlang.commands.check.facts import spelt
from motionlang.commands.check.mint.facts import MintFacts
from motionlang.kernel.lang import HEAD, NEXT, Use
from motionlang.kernel.lang import AxisKey as Key
from motionlang.kernel.mint.resolve.facts import changed, meaning
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk

Add = Callable[..., None]

DEFAULT_SIZE = 2
GO = frozenset(("go",))
_LOADS = ("move", "entry", "course", "path")
_BREAKS = (nodes.Exit, nodes.Jump, nodes.Return, nodes.End, nodes.Run, nodes.Label)


class Buffers:
    """The two checks of the move buffer; `add` records a warning."""

    def __init__(self, facts: MintFacts, follower: Follower, add: Add) -> None:
        self.facts, self.follower, self.add = facts, follower, add
        self.sizes = facts.constants(facts.word("buffer_size"))
        self.triggered = facts.named("TRIGGERMODE")
        # The axes that the parent task and each task and handler start.
        self.started = {root: facts.touched(root, GO) for root in facts.functions if root.kind != "sub"}

    def check(self, function: Function) -> None:
        """Run both checks on a function."""
        before = self.follower.before[function]
        for p, node in self.facts.nodes_of(function):
            if p in before:
                self._loads(p, before[p])
                if type(node) is nodes.For:
                    self._counted(function, node, before[p])
        self._never_started(function)

    # ------------------------------------------------------------------------------------- too many entries

    def _loads(self, p: int, state: State) -> None:
        """Report a load into a full buffer if only a later GO could empty it."""
        for act in self.facts.acts[p]:
            if act.role in _LOADS:
                for key in act.axes[:1] if act.role == "path" else act.axes:
                    size = self._size(key)
                    if size is not None and self.follower.known(state, key).waiting >= size:
                        self._overfilled(act, key, size)

    def _size(self, key: Key) -> float | None:
        """Return the number of entries that the buffer of an axis holds, None if unknown."""
        if self._may_trigger(key):
            return None
        sizes = self.sizes.get(key, [])
        if sizes is None or None in self.sizes or (isinstance(key, str) and self.sizes):
            return None
        return max([DEFAULT_SIZE, *sizes])

    def _overfilled(self, act: Use, key: Key, size: float) -> None:
        self.add(
            "buffer-overfilled",
            f"axis {spelt(key)} already has {size:.10g} moves in its buffer and no GO: this waits forever",
            act.at,
            f"write GO before this, or set MOVEBUFFERSIZE above {size:.10g}",
        )

    def _may_trigger(self, key: Key) -> bool:
        """True if moves of the axis may start without a GO."""
        return key in self.triggered or None in self.triggered

    def _counted(self, function: Function, node: nodes.For, state: State) -> None:
        iterations = self._iterations(node)
        if iterations is None or not self._counts_itself(node):
            return
        acts = [act for p in self._inside(function, node) for act in self.facts.acts.get(p, ())]
        if any(act.role in ("go", "stop", "act", "course", "path", "call") for act in acts):
            return
        loads: dict[Key, list[Use]] = {}
        direct = {inner.target.start for inner in node.body if type(inner) is nodes.Assign}
        for act in acts:
            if act.role in ("move", "entry") and act.at in direct:
                for key in act.axes:
                    loads.setdefault(key, []).append(act)
        for key, found in loads.items():
            size = self._size(key)
            known = self.follower.known(state, key)
            if key is None or size is None or known.motion != IDLE:
                continue
            if known.waiting + iterations * len(found) > size and known.waiting + len(found) <= size:
                self._overfilled(found[0], key, size)

    def _counts_itself(self, node: nodes.For) -> bool:
        """True if nothing in the body of a For leaves the loop or changes its counter."""
        counter = meaning(node.variable)
        for inner in walk(node.body):
            if type(inner) in _BREAKS:
                return False
            if any(meaning(name) is counter for name in changed(inner)):
                return False
        return True

    def _iterations(self, node: nodes.For) -> int | None:
        start, stop = self.facts.number(node.first), self.facts.number(node.stop)
        step = 1.0 if node.step is None else self.facts.number(node.step)
        return None if start is None or stop is None or not step else int((stop - start) // step) + 1

    def _inside(self, function: Function, node: nodes.For) -> range:
        """Return the points of a loop's body."""
        points = self.facts.graph.points
        roles = {points[p].role: p for p in self.facts.points[function] if points[p].at == node.start}
        return range(roles[HEAD] + 1, roles[NEXT])

    # -------------------------------------------------------------------------------------- moves without a GO

    def _never_started(self, function: Function) -> None:
        keys = self._keys(function)
        if not keys:
            return
        number = {key: 1 << n for n, key in enumerate(keys)}
        last = self._behind_the_end(function, number, set().union(*self.started.values()))
        behind = self.facts.graph.backward(
            self.facts.points[function],
            lambda p: last if self.facts.leaves(p) else 0,
            partial(self._goes, number),
        )
        for p, _ in self.facts.nodes_of(function):
            for act in self.facts.acts[p]:
                if act.role in _LOADS and p in self.follower.before[function]:
                    bits = sum(number[key] for key in set(act.axes))
                    if not behind[p] & bits and not self._started_elsewhere(function, act):
                        self._not_started(act)

    def _behind_the_end(self, function: Function, number: dict[Key, int], started: set[Key]) -> int:
        """Return the axes that may be started after a function returns, as bits.

        The caller of a sub may start them, or the code that a v4 handler has interrupted.
        """
        if function.kind != "sub" and not self.facts.entries[function][1:]:
            return 0
        return sum(
            bit for key, bit in number.items() if {key, None} & started or (isinstance(key, str) and started)
        )

    def _not_started(self, act: Use) -> None:
        assert act.row is not None
        names = ", ".join(map(spelt, act.axes))
        self.add(
            "never-started",
            f"the {act.role if act.role == 'entry' else 'move'} is loaded, but no GO for it follows",
            act.at,
            f"GO({names}) starts the buffered moves",
        )

    def _started_elsewhere(self, function: Function, act: Use) -> bool:
        """True if another task, a handler or a trigger may start the move."""
        if any(self._may_trigger(key) for key in act.axes) or None in act.axes:
            return True
        mine = self.facts.roots[function]
        others = set().union(*(keys for root, keys in self.started.items() if root not in mine))
        any_axis = any(isinstance(key, str) for key in act.axes)
        return bool(others & {*act.axes, None}) or (any_axis and bool(others))

    def _goes(self, number: dict[Key, int], p: int, bits: int) -> int:
        for act in reversed(self.facts.acts.get(p, ())):
            if act.role == "go":
                bits = self._with(bits, act.axes, number)
            elif act.role == "stop" and None not in act.axes:
                for key in act.axes:
                    bits &= ~number.get(key, 0)
            elif act.callee:
                started = {
                    self.facts.outer(act, key) for key in self.facts.touched(self.facts.callee(act), GO)
                }
                bits = self._with(bits, tuple(started), number)
        return bits

    def _with(self, bits: int, axes: tuple[Key, ...], number: dict[Key, int]) -> int:
        for key in axes:
            if key is None or isinstance(key, str) is not any(isinstance(each, str) for each in number):
                return bits | (sum(number.values()))
            bits |= number.get(key, 0)
        return bits

    def _keys(self, function: Function) -> list[Key]:
        found: dict[Key, None] = {}
        for act in self.facts.acts_of[function]:
            if act.role in _LOADS:
                found.update(dict.fromkeys(act.axes))
        return list(found)
