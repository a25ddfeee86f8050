"""The memory of a program at rest: the variables whose values decide its later branches.

Problem. A machine that waits at the same statement need not be in the same state: after a look that failed, `good = 0`
decides minutes later that the part is bad. Most variables decide nothing, or are written again before they do.

Idea. A variable counts at a statement if some path from there comes to a decision that depends on its value: a branch,
a conditional wait, the limit of a loop, a computed jump. That is the analysis of faint variables, backward over the
steps: a decision needs what it reads; an assignment needs what it reads only if what it sets is needed.

    good = 1            good is not needed before this
    Pause INX(3)        good: the If below reads it
    n = n + 1           n is needed by nothing but itself, and so it is faint
    If good = 1 Then …

The calls of a unit are not matched with its returns, so a variable may be needed on a path that no call takes. A
variable that counts, as `n = n + 1` does, is left out, since each value would be a new state, and so is a copy of a
level, a clock or a position. Of one that takes a number of the world, as `n = COMMS(2)` does, only counts if it has: a
menu remembers an answer.

Invariants. The numbers of variables are those of `Uses`, and so of the list of shared variables of any run of the
program. Variables of a call are part of the analysis and of no result; of the registers that each task of MCCL has,
those of the first task are.

Cost. Each point is visited once for each bit that reaches it.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Iterable
from functools import cached_property

from motionlang.kernel.lang import CALL, ENTER, GO, READ, RETURN, Structure, Uses

# The channels with two levels.
INPUTS = ("input", "input bank")
# Variables with larger numbers stand for what is outside, such as the memory of a host.
MAX_SHARED = 1 << 20
# A variable is counted through another one within so many steps.
MAX_CHAIN = 12


class Memory:
    """The variables that decide later, by the source offset of a statement."""

    def __init__(self, structure: Structure) -> None:
        self._graph = structure.graph
        self._structure = structure
        self._bits: dict[tuple[str, int], int] = {}
        needed = self._needed()
        given, measured = self._given(needed[0] if needed else 0)
        counting = self._counting() | measured
        self._at: defaultdict[int, int] = defaultdict(int)
        for p, point in enumerate(self._graph.points):
            self._at[point.at] |= needed[p]
        self._shared = {
            bit: n
            for (call, n), bit in self._bits.items()
            if not call and n < MAX_SHARED and not bit & counting
        }
        # Those of which only counts if they are zero.
        self._signs = {n for bit, n in self._shared.items() if bit & given}

    def variables(self, offsets: Iterable[int]) -> list[int]:
        """Return the variables that count at each of some statements, in order.

        A loop that assigns to a variable before it reads it does not remember it.
        """
        found = -1
        for each in offsets:
            found &= self._at.get(each, 0)
        return sorted(n for bit, n in self._shared.items() if bit & found)

    def value(self, n: int, value: object) -> object:
        """Return what counts of the value of a variable."""
        return value not in (0, "") if n in self._signs else value

    @cached_property
    def all(self) -> list[int]:
        """All variables that count anywhere, in order."""
        found = 0
        for bits in self._at.values():
            found |= bits
        return sorted(n for bit, n in self._shared.items() if bit & found)

    @cached_property
    def steps(self) -> frozenset[int]:
        """The variables that are only ever set to numbers in the text, as the step of a machine is."""
        plain, worked_out = set[int](), set[int]()
        for p, use in enumerate(self._graph.uses):
            if use is not None:
                statement = self._structure.statements.get(self._graph.points[p].at)
                is_read = statement is not None and any(each.access == READ for each in statement.channels)
                (worked_out if use.reads or is_read else plain).update(use.sets)
        return frozenset(plain - worked_out)

    def _given(self, at_start: int) -> tuple[int, int]:
        """Return the bits of the variables that may not have taken a number, a key or an answer, and of all others.

        Others have always taken one before they decide, or take a level or a copy of one. `at_start` are those that the
        program needs before its first statement.
        """
        found = unset = 0
        measured: set[int] = set()
        # What is set from which shared variables alone.
        copies: list[tuple[set[int], frozenset[int]]] = []
        for p, use in enumerate(self._graph.uses):
            statement = self._structure.statements.get(self._graph.points[p].at)
            read = [] if statement is None else [each for each in statement.channels if each.access == READ]
            if use is not None and any(each.channel not in INPUTS for each in read):
                if any(each.channel == "analogue input" for each in read):
                    measured |= use.sets
                else:
                    found |= self._mask(p, use.sets)
            elif use is not None and use.copies:
                measured |= use.copies
            elif use is not None:
                unset |= self._mask(p, use.sets)
                if use.reads and min((*use.reads, *use.sets)) >= 0:
                    copies.append((set(use.reads), use.sets))
        readers: defaultdict[int, list[int]] = defaultdict(list)
        for k, (reads, _) in enumerate(copies):
            for n in reads:
                readers[n].append(k)
        waiting = deque(n for n in measured if n >= 0)
        while waiting:
            n = waiting.popleft()
            for k in readers[n]:
                reads, sets = copies[k]
                reads.discard(n)
                if not reads:
                    waiting += sets - measured
                    measured |= sets
        unset = found & (unset | at_start)
        return unset, found & ~unset | self._mask(0, [n for n in measured if n >= 0])

    def _counting(self) -> int:
        """Return the bits of the variables that are set to a sum with themselves, at once or through another one."""
        found = 0
        for p, use in enumerate(self._graph.uses):
            if use is None:
                continue
            found |= self._mask(p, (use.reads - use.nonlinear) & use.sets)
            # MCCL counts in its accumulator: RA20,AA1,AR20.
            held, q, has_changed = use.sets, p, False
            for _ in range(MAX_CHAIN if use.reads else 0):
                if not held or len(self._graph.within[q]) != 1:
                    break
                q = self._graph.within[q][0]
                later = self._graph.uses[q] if q < len(self._graph.uses) else None
                if later is None or later.nonlinear & held:
                    break
                if held <= later.sets:
                    if not held <= later.reads:
                        break
                    has_changed = True
                elif held <= later.reads:
                    found |= self._mask(q, later.sets & use.reads) if has_changed else 0
        return found

    def _mask(self, p: int, variables: Iterable[int]) -> int:
        """Return the bits of the variables of a point; one of a call has a bit for each list of steps."""
        own = "" if self._graph.enters else self._graph.points[p].key[0]
        found = 0
        for n in variables:
            key = (own if n < 0 else "", n)
            found |= self._bits.setdefault(key, 1 << len(self._bits))
        return found

    def _needed(self) -> list[int]:
        """Return the bits of the variables that are needed before each point, to a fixed point."""
        points, uses, statements = self._graph.points, self._graph.uses, self._structure.statements
        following = self._following()
        before: list[list[int]] = [[] for _ in following]
        for p, onward in enumerate(following):
            for q in onward:
                before[q].append(p)
        decides: list[int] = []
        carries: list[tuple[int, int, int]] = []
        for p, point in enumerate(points):
            use = (uses[p] if p < len(uses) else None) or Uses()
            statement = statements.get(point.at)
            waits = statement is not None and bool(statement.waits) and bool(statement.condition)
            is_decision = point.branches or waits or point.kind in (CALL, GO)
            decides.append(self._mask(p, use.reads) if is_decision else 0)
            carries.append((self._mask(p, use.sets), self._mask(p, use.parts), self._mask(p, use.reads)))
        joints = len(following) - len(points)
        decides += [0] * joints
        carries += [(0, 0, 0)] * joints
        needed = [0] * len(following)
        waiting = deque(reversed(range(len(following))))
        queued = set(waiting)
        while waiting:
            p = waiting.popleft()
            queued.discard(p)
            after = 0
            for q in following[p]:
                after |= needed[q]
            sets, parts, reads = carries[p]
            bits = decides[p] | (after & ~sets) | (reads if after & (sets | parts) else 0)
            if bits | needed[p] != needed[p]:
                needed[p] |= bits
                for q in before[p]:
                    if q not in queued:
                        queued.add(q)
                        waiting.append(q)
        return needed

    def _following(self) -> list[list[int]]:
        """Return the points that may follow each point, into calls and behind all calls of a list that returns.

        A register that a program computes may call any macro. All such calls go through one joint after the points,
        and come back through another one, so that the work is linear.
        """
        points = self._graph.points
        lists = {p: name for name, own in self._graph.ranges.items() for p in own}
        macros = [unit.entry for unit in self._structure.units if unit.kind == "macro"]
        behind: defaultdict[str, list[int]] = defaultdict(list)
        into, back = len(points), len(points) + 1
        following = [*(list(self._graph.within[p]) for p in range(len(points))), macros, []]
        for p, point in enumerate(points):
            # A call that is entered is linked with its Returns.
            if point.kind not in (CALL, ENTER) or point.calls in self._graph.within[p]:
                continue
            if point.calls >= 0:
                following[p].append(point.calls)
                behind[lists.get(point.calls, "")] += point.next
            else:
                following[p].append(into)
                following[back] += point.next
        for name in {lists.get(entry, ""): None for entry in macros}:
            behind[name].append(back)
        for p, point in enumerate(points):
            if point.kind == RETURN or not following[p]:
                following[p] += behind.get(lists.get(p, ""), ())
        return following
