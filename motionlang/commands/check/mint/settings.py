"""The check for speeds and rates that no move uses.

No move comes between such a setting and the next one, or between it and the end of the program.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from motionlang.commands.check.axis_state import COMMANDS, IDLE, Follower
from motionlang.commands.check.facts import spelt
from motionlang.commands.check.mint.facts import MintFacts
from motionlang.kernel.lang import AxisKey as Key
from motionlang.kernel.lang import Use
from motionlang.kernel.mint.resolve.symbols import Function
from motionlang.kernel.mint.syntax import nodes

Add = Callable[..., None]
# A bit for each property of each axis.
Bits = dict[tuple[Key, str], int]

TOUCHES = COMMANDS | {"read", "slot", "use"}


class Settings:
    """The check for unused settings; `add` records a warning."""

    def __init__(self, facts: MintFacts, follower: Follower, add: Add) -> None:
        self.facts, self.follower, self.add = facts, follower, add

    def check(self, function: Function) -> None:
        """Report settings that are replaced, or left over, before a move can use them."""
        bits = self._slot_bits(function)
        if not bits:
            return
        everything = (1 << len(bits)) - 1
        last = self._left_over(function, bits) if function.kind == "main" else everything
        own = self.facts.points[function]
        behind = self.facts.graph.backward(own, lambda p: last, partial(self._used, bits, everything))
        for p, _ in self.facts.nodes_of(function):
            if p in self.follower.before[function]:
                self._useless(p, behind[p], bits)

    def _slot_bits(self, function: Function) -> Bits:
        """Assign a bit to each property of each axis that only this function uses."""
        found: Bits = {}
        others = self._others(function)
        if others is None:
            return found
        for act in self.facts.acts_of[function]:
            if act.role == "slot":
                assert act.row is not None
                for key in act.axes:
                    alone = not {key, None} & others and not (isinstance(key, str) and others)
                    if key is not None and alone:
                        found.setdefault((key, act.row.gives), 1 << len(found))
        return found

    def _others(self, function: Function) -> set[Key] | None:
        """Return the axes that functions running concurrently with this one use.

        Returns None if the function itself runs in more than one task or handler.
        """
        mine = self.facts.roots[function]
        if len(mine) > 1:
            return None
        others = [root for root in self.facts.functions if root.kind != "sub" and root not in mine]
        return set().union(*(self.facts.touched(root, TOUCHES) for root in others))

    def _left_over(self, function: Function, bits: Bits) -> int:
        """Return the settings that still matter at the end of the parent task, as bits.

        These are the settings of axes that may still be in motion.
        """
        found = 0
        before = self.follower.before[function]
        for p, state in before.items():
            if not self.facts.graph.within[p]:
                for (key, _), bit in bits.items():
                    if self.follower.known(state, key).motion != IDLE:
                        found |= bit
        return found

    def _used(self, bits: Bits, everything: int, p: int, found: int) -> int:
        if type(self.facts.nodes_at.get(p)) in (nodes.Pause, nodes.Input, nodes.Run, nodes.Return):
            return everything
        for act in reversed(self.facts.acts.get(p, ())):
            assert act.row is not None or act.role == "call"
            if act.role == "slot" and act.row is not None:
                if len(set(act.axes)) == len(act.axes):
                    for key in act.axes:
                        found &= ~bits.get((key, act.row.gives), 0)
            elif act.role == "call" or None in act.axes or (act.row is not None and act.row.verb == "wait"):
                found = everything
            elif act.role != "scale":
                for (key, _), bit in bits.items():
                    if key in act.axes or any(isinstance(each, str) for each in act.axes):
                        found |= bit
        return found

    def _useless(self, p: int, behind: int, bits: Bits) -> None:
        for act in self.facts.acts[p]:
            if act.role != "slot":
                continue
            assert act.row is not None
            slot = act.row.gives
            dead = [key for key in act.axes if (bit := bits.get((key, slot), 0)) and not behind & bit]
            # `SPEED(0, 1, 2) = 10;` followed by an exception for one of the axes is good style.
            if dead and len(dead) == len(act.axes):
                self._report_useless(p, act, dead[0], slot)

    def _report_useless(self, p: int, act: Use, key: Key, slot: str) -> None:
        assert act.row is not None
        later = self._next_setting(p, key, slot)
        if later is None:
            message = f"{act.row.name} of axis {spelt(key)} is set but no longer used"
            self.add("unused-setting", message, act.at, "remove it, or set it before the move that needs it")
            return
        assert later.row is not None
        by = f"{later.row.name} in line {{line}}"
        message = f"{act.row.name} of axis {spelt(key)} is replaced by {by} before any move"
        self.add("unused-setting", message, act.at, "remove one of the two", other=later.at)

    def _next_setting(self, p: int, key: Key, slot: str) -> Use | None:
        """Return the statement that replaces a setting."""
        seen: set[int] = set()
        stack = list(reversed(self.facts.graph.within[p]))
        while stack:
            each = stack.pop()
            if each in seen:
                continue
            seen.add(each)
            for act in self.facts.acts.get(each, ()):
                if act.role == "slot" and key in act.axes and act.row is not None and act.row.gives == slot:
                    return act
            stack.extend(reversed(self.facts.graph.within[each]))
        return None
