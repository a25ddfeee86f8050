"""The flow of a program: all steps of its lists of steps, and which may follow each.

Problem. The check, the map, the coverage and the search for a shorter cycle ask what may have happened before a
statement or may happen after it: which code is unreachable, where an axis is, whether a move is ever started, what a
task waits for next. Both languages have loops, jumps and calls, and all of that is in their steps.

Idea. The steps are the graph: `Steps.following` says which may follow a step, and the writer of the steps has marked
those that a reader has to know (`steps.TEST` and the like). A client describes what one step does; the graph iterates
to a fixed point.

    n = 3                   DO n = 3
    While n > 0             BRANCH n > 0 (test) ──── false ────┐
      n = n - 1             DO n = n - 1                       │
    End While               BACK to the test                   │
    Print n                 DO Print n  <──────────────────────┘

Data. A point is a step of one of the lists; its number is its index in `points`. `Point.next` passes over calls, so a
client that knows what a call does stays in one list. `within` is the same, but what has no parameters is entered: a
Gosub leads to its label, and a Return of that subroutine leads behind every Gosub of it. In a graph that `enters` all
calls, as for the macros of MCCL, this holds for every list. Calls of one subroutine are not matched with its Returns.
Several Returns and several calls share a junction: a point that is no step, behind all lists, which the Returns lead to
and which leads behind the calls. Only `within` leads to it.

Invariants. The points of a list are in the order of the text, and every cycle has an edge to the same or a lower point:
that edge leads back. A junction counts as its last Return.

Cost. Linking is linear in the steps, since a junction has as many edges as there are Returns and calls, not their
product. `forward` visits a point again whenever its state grows, so the client's join has to stop growing; a state is
stored only where paths meet. `backward` visits a point at most once for each bit, and once more.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from functools import cached_property
from heapq import heappop, heappush
from itertools import pairwise
from typing import NamedTuple, TypeVar

from motionlang.kernel.lang.steps import (
    BACK,
    BEGIN,
    CALL,
    ENTER,
    GO,
    JUMP,
    NOTE,
    NOW,
    RETURN,
    TURN,
    Steps,
    Uses,
)

State = TypeVar("State")

# Steps at which nothing happens that a reader of the program sees.
SILENT = frozenset((NOW, JUMP, NOTE, TURN, BEGIN))


class GraphPoint(NamedTuple):
    """A step: its kind, the offset of its statement or -1, and the indices of the points that may follow it.

    `key` is the name of its list of steps and its index there: another writing of the same program, such as that of a
    run, has the same keys. The first point that follows a BRANCH or a BACK with a condition is that of a true
    condition. `calls` is the first point of what a CALL calls, -1 if it is unknown or if there is none. `role` is that
    of the step.
    """

    key: tuple[str, int]
    kind: int
    at: int
    next: tuple[int, ...]
    calls: int = -1
    role: str = ""

    @property
    def is_silent(self) -> bool:
        """True if nothing happens here, and one point follows."""
        return self.kind in SILENT or (self.kind in (BACK, GO, ENTER) and len(self.next) == 1)

    @property
    def branches(self) -> bool:
        """True if more than one point may follow."""
        return len(self.next) > 1


class StepGraph:
    """The points of some lists of steps, linked.

    The lists `in_sequence` run one after the other: a RETURN leads to the first step of the next one. `computed`
    returns the steps that may follow a GO whose target is known only at run time. `enters`: calls have no parameters.
    """

    def __init__(
        self,
        lists: Sequence[Steps],
        in_sequence: Sequence[Steps] = (),
        computed: Callable[[Steps, int], Iterable[int]] | None = None,
        enters: bool = False,
    ) -> None:
        self.enters = enters
        # The lists for people to read: not the bodies of macros, whose lines have them, nor what ends a sequence.
        self.listed = [each for each in in_sequence[:-1] or lists if each]
        # The points of each list, by its name.
        self.ranges: dict[str, range] = {}
        self.points: list[GraphPoint] = []
        # What each of them does with variables, None if that is unknown; junctions do nothing.
        self.uses: list[Uses | None] = [use for steps in lists for use in steps.uses]
        length = 0
        for steps in lists:
            self.ranges[steps.name] = range(length, length + len(steps))
            length += len(steps)
        after = {id(one): self.first(two) for one, two in pairwise(in_sequence)}
        # The names of labels, by their points, and the points that lead back in the loops that statements write.
        self.labels: dict[int, str] = {}
        self.closing: set[int] = set()
        for steps in lists:
            self.points += self._linked(steps, after.get(id(steps)), computed)
            self.labels |= {self.first(steps) + pc: name for pc, name in steps.labels.items()}
            self.closing.update(self.first(steps) + pc for pc in steps.loops)
        # The junctions, each with its last Return.
        self._junctions: dict[int, int] = {}
        self.within = self._entered(enters)
        # The points to which an edge leads back, and the labels.
        self.heads = {*self.labels} | {
            after
            for p, found in enumerate(self.within)
            for after in found
            if after <= self._junctions.get(p, p)
        }

    def first(self, steps: Steps) -> int:
        """Return the first point of a list, -1 if the list is not part of the graph."""
        found = self.ranges.get(steps.name)
        return -1 if found is None else found.start

    def _linked(
        self,
        steps: Steps,
        after: int | None,
        computed: Callable[[Steps, int], Iterable[int]] | None,
    ) -> Iterator[GraphPoint]:
        first = self.first(steps)
        for pc, step in enumerate(steps):
            kind, following = step.kind, steps.following(pc)
            called = -1
            if pc in steps.called:
                target, at = steps.called[pc]
                called = self.first(target) + at
            if kind == GO and step.to < 0 and computed is not None:
                following = list(computed(steps, pc))
            elif kind == ENTER:
                # The caller of lists in sequence goes on behind what they enter.
                following, called = (
                    ([called - first], -1) if after is None and called >= 0 else ([len(steps) - 1], called)
                )
            found = [first + each for each in following]
            if kind == RETURN and after is not None:
                found = [after]
            if after is not None:
                kind = JUMP if kind == RETURN else CALL if kind == ENTER else kind
            yield GraphPoint(
                (steps.name, pc), kind, step.at, tuple(dict.fromkeys(found)), called, steps.roles.get(pc, "")
            )

    def _entered(self, enters: bool) -> list[tuple[int, ...]]:
        """Return the points that may follow each point, in its list or in what it enters."""
        found = [each.next for each in self.points]
        # The points behind the calls that enter at each point.
        behind: dict[int, list[int]] = {}
        for own in self.ranges.values():
            # A list that defines a macro has its commands, too, but never carries them out.
            for p in self._led_to(own.start, own) if enters else own:
                called = self.points[p].calls
                is_call = self.points[p].kind in (CALL, ENTER) and called >= 0
                if is_call and (enters or own.start < called < own.stop):
                    behind.setdefault(called, []).extend(self.points[p].next)
                    found[p] = (called,)
        if enters:
            groups = [(self._returns(self._led_to(entry)), points) for entry, points in behind.items()]
        else:
            groups = [each for own in self.ranges.values() for each in self._subroutines(own, behind)]
        for returns, points in groups:
            if len(returns) > 1 and len(points) > 1:
                self._junctions[len(found)] = returns[-1]
                self.points.append(GraphPoint((self.points[returns[0]].key[0], -1), NOTE, -1, ()))
                found.append(tuple(dict.fromkeys(points)))
                points = [len(found) - 1]
            for p in returns:
                found[p] = tuple(dict.fromkeys([*found[p], *points]))
        return found

    def _returns(self, points: Iterable[int]) -> list[int]:
        return [p for p in points if self.points[p].kind == RETURN]

    def _subroutines(self, own: range, behind: dict[int, list[int]]) -> Iterator[tuple[list[int], list[int]]]:
        """Yield the Returns of the subroutines of a list, and the points behind their Gosubs.

        Labels that lead to the same point are one subroutine. What the list leads to by itself is part of any, since
        each may jump there. The last point is the end of the text, and no Return.
        """
        entries = [p for p in own if p in behind]
        if not entries:
            return
        seen = set(self._led_to(own.start, own))
        yield self._returns(sorted(seen - {own[-1]})), [each for p in entries for each in behind[p]]
        beside: dict[int, list[int]] = {p: [] for p in own if p not in seen}
        for p, others in beside.items():
            for after in self.points[p].next:
                if after in beside:
                    others.append(after)
                    beside[after].append(p)
        for first in entries:
            part, stack = list[int](), [first]
            while stack:
                p = stack.pop()
                if p not in seen:
                    seen.add(p)
                    part.append(p)
                    stack += beside[p]
            gosubs = [each for p in sorted(part) for each in behind.get(p, ())]
            yield self._returns(sorted({*part} - {own[-1]})), gosubs

    def _led_to(self, first: int, own: range | None = None) -> list[int]:
        """Return the points, of all or of a list, that a point leads to, without those in what is called."""
        found: set[int] = set()
        stack = [first]
        while stack:
            p = stack.pop()
            if p not in found and (own is None or p in own):
                found.add(p)
                stack += self.points[p].next
        return sorted(found)

    # ------------------------------------------------------------------------------------------------ analyses

    def reached(self, *roots: int, known: Container[int] = ()) -> set[int]:
        """Return the points that can be reached from some points, including these, also through calls.

        Points that are `known` already are left out, and so is what is only reached through these.
        """
        found: set[int] = set()
        stack = list(roots)
        while stack:
            p = stack.pop()
            if p >= 0 and p not in found and p not in known:
                found.add(p)
                stack += self.points[p].next
                stack.append(self.points[p].calls)
        return found

    def reached_within(self, *roots: int) -> set[int]:
        """Return the points of a list that can be reached from some of its points, including these."""
        found: set[int] = set()
        stack = list(roots)
        while stack:
            p = stack.pop()
            if p not in found:
                found.add(p)
                stack += self.within[p]
        return found

    @cached_property
    def cycles(self) -> list[set[int]]:
        """The largest sets of points that all lead to one another, in no particular order."""
        finished: list[int] = []
        seen: set[int] = set()
        for root in range(len(self.points)):
            stack = [(root, False)]
            while stack:
                p, is_done = stack.pop()
                if is_done:
                    finished.append(p)
                elif p not in seen:
                    seen.add(p)
                    stack.append((p, True))
                    stack += ((after, False) for after in self.within[p])
        came: list[list[int]] = [[] for _ in self.points]
        for p, found in enumerate(self.within):
            for after in found:
                came[after].append(p)
        cycles: list[set[int]] = []
        taken: set[int] = set()
        for root in reversed(finished):
            component, left = set(), [root]
            while left:
                p = left.pop()
                if p not in taken:
                    taken.add(p)
                    component.add(p)
                    left += came[p]
            if len(component) > 1 or root in self.within[root]:
                cycles.append(component)
        return cycles

    def forward(
        self,
        first: dict[int, State],
        follow: Callable[[int, State], tuple[State | None, State | None]],
        join: Callable[[State, State, int], State],
    ) -> None:
        """Compute the facts before each point of a list, to a fixed point.

        `first` are the facts at the points where the list is entered. `follow(p, state)` returns the states for the
        first point that follows and for the others, None for a side that no path takes. `join(a, b, p)` returns the
        facts common to both before a point, and `a` itself if `b` adds nothing new. On the last visit of a point its
        facts are final.
        """
        before, single = dict(first), self._single(first)
        waiting = sorted(before)
        queued = set(waiting)
        while waiting:
            p = heappop(waiting)
            queued.discard(p)
            yes, no = follow(p, before[p])
            while len(self.within[p]) == 1 and self.within[p][0] in single and yes is not None:
                p = self.within[p][0]
                yes, no = follow(p, yes)
            for k, after in enumerate(self.within[p]):
                state = no if k else yes
                if state is None:
                    continue
                old = before.get(after)
                new = state if old is None else join(old, state, after)
                if new is not old:
                    before[after] = new
                    if after not in queued:
                        queued.add(after)
                        heappush(waiting, after)

    def backward(
        self, own: Sequence[int], last: Callable[[int], int], follow: Callable[[int, int], int]
    ) -> dict[int, int]:
        """Compute, as bits, what can happen on some path after each point of a list, in their order.

        `last(p)` are the bits behind a point that no point follows.
        """
        junctions = {after for p in own for after in self.within[p] if after in self._junctions}
        own = sorted(junctions.union(own))
        came: dict[int, list[int]] = {p: [] for p in own}
        behind = dict.fromkeys(own, 0)
        for p in own:
            for after in self.within[p]:
                came.setdefault(after, []).append(p)
            if not self.within[p]:
                behind[p] = last(p)
        waiting = [-p for p in reversed(own)]
        queued = set(own)
        while waiting:
            p = -heappop(waiting)
            queued.discard(p)
            bits = follow(p, behind[p])
            for earlier in came[p]:
                if behind[earlier] | bits != behind[earlier]:
                    behind[earlier] |= bits
                    if earlier not in queued:
                        queued.add(earlier)
                        heappush(waiting, -earlier)
        return behind

    def _single(self, entries: Iterable[int]) -> set[int]:
        """Return the points with one edge into them, from a point with no other edge out."""
        incoming: dict[int, int] = dict.fromkeys(entries, 2)
        for p in self.reached_within(*entries):
            for after in self.within[p]:
                incoming[after] = incoming.get(after, 0) + 1 + self.points[p].branches
        return {p for p, count in incoming.items() if count == 1}
