"""The dependencies of the waits and loops of a program, found from its steps, for both languages.

Problem. Hints, the map, the profile and the exploration ask what a wait or a loop may wait for: inputs, axes, time,
other tasks. A loop polls in many forms: While, Goto, a jump of MCCL, a call of a sub that reads the input.

Idea. A statement reads what the column `reads` of its keywords says (`keyword.py`), and what it calls reads. A loop is
what lies between an edge back and its target: the points below the target that lead to the edge. It ends at the points
that lead out, and at the branches that decide whether an iteration comes to them. For a variable in one of these tests,
the values that the loop assigns to it count, and the branches that decide whether it does so. A variable that only
other tasks assign counts as a reading of these tasks, unless the loop counts to a limit.

    While Not done              leads out: it tests `done`
      If INX(2) Then            decides whether `done` is assigned: the loop waits for input 2
        done = IDLE(0)          and for axis 0
      End If
    End While

Invariants. An array or a record is one variable. The limit of a For is worked out before its loop, so it ends no loop.

Cost. A question takes time in proportion to the loop and what it calls, times the depth of the loops in it. Nothing in
the inner loops calls a function.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

from motionlang.kernel.lang.steps import HEAD, NOTE
from motionlang.kernel.lang.wait_causes import KINDS, LoopDependencies, Read

if TYPE_CHECKING:
    from motionlang.kernel.lang.structure import Statement, Structure, Use

# A variable: its number; if each call has its own, also the list of steps that it belongs to.
Variable = tuple[str, int]
# In place of a variable: the points that end a loop.
_END: Variable = ("end", 0)
# The readings that the brackets number unless they have a bank or an axis.
_NUMBERED = ("input", "analogue", "encoder", "latch")


class _Loop(NamedTuple):
    """A loop: its first point, the points that lead back to it, and the offsets at which it is asked for.

    These are the offset of its begin, if a step notes that, and those of the points that lead back.
    """

    head: int
    edges: list[int]
    offsets: list[int]


class WaitAnalysis:
    """The readings that end the waits and loops of a program."""

    def __init__(self, structure: Structure) -> None:
        self._structure, self._graph = structure, structure.graph
        self._points, self._statements = structure.graph.points, structure.statements
        # The points of each statement, and the variables that it reads; the variables that each point assigns to.
        self._at: defaultdict[int, list[int]] = defaultdict(list)
        self._variables: defaultdict[int, set[Variable]] = defaultdict(set)
        self._assigned: dict[int, set[Variable]] = {}
        for p, use in enumerate(structure.graph.uses):
            point = self._points[p]
            self._at[point.at].append(p)
            if use is not None:
                name = "" if structure.graph.enters else point.key[0]
                self._variables[point.at] |= {(name if n < 0 else "", n) for n in use.reads}
                if use.sets or use.parts:
                    self._assigned[p] = {(name if n < 0 else "", n) for n in use.sets | use.parts}
        self._readings = {at: _readings(made) for at, made in self._statements.items()}

    def all(self) -> Iterator[LoopDependencies]:
        """Yield the dependencies of all conditional waits and loops."""
        for at, made in self._statements.items():
            if made.waits and made.condition:
                yield self._wait(made)
            elif at in self._loops and self._loops[at].offsets[0] == at:
                found = self._loop(self._loops[at])
                if found is not None:
                    yield found

    def at(self, offset: int) -> LoopDependencies | None:
        """Return the dependencies of the loop or of the conditional wait at a source offset, None if there is none."""
        made = self._statements.get(offset)
        if made is not None and made.waits:
            return self._wait(made) if made.condition else None
        return self._loop(self._loops[offset]) if offset in self._loops else None

    def _wait(self, made: Statement) -> LoopDependencies:
        points = self._at[made.at]
        reads = self._reads(points, points, {}, lambda variable: [])
        return LoopDependencies(reads, lines=frozenset((made.line,)), why=f"until {made.condition}")

    # ---------------------------------------------------------------------------------------------------- loops

    @cached_property
    def _loops(self) -> dict[int, _Loop]:
        """The loop at each offset.

        The steps of a macro are those of the last list that has its commands: the line that defines it has them, too,
        but never carries them out.
        """
        ranges, points = self._graph.ranges, self._points
        found = sorted(
            self._edges_back(), key=lambda each: (ranges[points[each.head].key[0]].start, -each.head)
        )
        return {at: loop for loop in found for at in loop.offsets}

    def _edges_back(self) -> Iterator[_Loop]:
        """Yield the loops of statements, and those of jumps.

        Jumps back to one label are one loop, and so are those whose ranges overlap, unless one is within the other.
        """
        points, closing = self._points, self._graph.closing
        cycle_of = {p: number for number, cycle in enumerate(self._graph.cycles) for p in cycle}
        jumps: defaultdict[int, list[int]] = defaultdict(list)
        for p, point in enumerate(points):
            for head in point.next:
                if head <= p and p in closing:
                    # A label may be the first statement of a loop.
                    within = jumps.get(head, [])
                    yield _Loop(head, [*within, p], [points[head - 1].at, point.at])
                elif head <= p and p in cycle_of and cycle_of.get(head) == cycle_of[p]:
                    jumps[head].append(p)
        around: list[_Loop] = []
        for head in sorted(jumps):
            while around and around[-1].edges[-1] < head:
                yield around.pop()
            begins = [points[head].at] if points[head].kind == NOTE else []
            around.append(_Loop(head, jumps[head], [*begins, *(points[p].at for p in jumps[head])]))
            while len(around) > 1 and around[-2].edges[-1] < around[-1].edges[-1]:
                inner = around.pop()
                around[-1].edges.extend(inner.edges)
                around[-1].offsets.extend(inner.offsets)
        yield from around

    @cached_property
    def _before(self) -> list[list[int]]:
        """The points that lead to each point."""
        found: list[list[int]] = [[] for _ in self._points]
        for p, point in enumerate(self._points):
            for after in point.next:
                found[after].append(p)
        return found

    @cached_property
    def _tests(self) -> set[int]:
        """The branches that test readings: not those of a For, nor of a wait, which ends by itself."""
        waiting = {at for at, made in self._statements.items() if made.waits}
        return {
            p
            for p, point in enumerate(self._points)
            if len(point.next) > 1 and point.role != HEAD and point.at not in waiting
        }

    def _loop(self, loop: _Loop) -> LoopDependencies | None:
        """Return the dependencies of a loop, None if its head never leads to its edges."""
        points, before, head = self._points, self._before, loop.head
        body, stack = set[int](), list(loop.edges)
        for p in stack:  # the list grows during the loop
            if p >= head and p not in body:
                body |= {p}
                stack += before[p] if p > head else []
        if head not in body:
            return None
        reached = sorted(self._with_calls(body))
        assigning = self._assigning(reached)
        leaving = [p for p in reached if p in body for after in points[p].next if after not in body]
        tests = self._tests
        ends = [p for p in leaving if p in tests]
        made = [
            self._statements[at]
            for at in dict.fromkeys([points[p].at for p in reached])
            if at in self._statements
        ]
        deciding = self._deciding(head, reached, {**assigning, _END: ends})
        tested = [*ends, *deciding(_END)]
        return LoopDependencies(
            self._reads(tested, reached, assigning, deciding),
            self._reads([p for p in reached if p in tests], reached, assigning, deciding),
            frozenset([each.line for each in made]),
            self._why(ends, [points[p].at for p in loop.edges]),
            HEAD in [points[p].role for p in leaving],
            any(each in assigning for p in tested for each in self._variables[points[p].at]),
        )

    def _with_calls(self, points: Collection[int]) -> set[int]:
        called = [self._points[p].calls for p in points if self._points[p].calls >= 0]
        return self._graph.reached(*called).union(points)

    def _why(self, ends: Iterable[int], edges: Collection[int]) -> str:
        """Return the condition by which a loop ends, in words: its own one, or those of what leaves it."""
        offsets = dict.fromkeys([self._points[p].at for p in ends])
        made = [self._statements[at] for at in offsets if at in self._statements]
        own = [each.text for each in made if each.at in edges and each.condition]
        if own:
            return own[0][:1].lower() + own[0][1:]
        return " or ".join(dict.fromkeys([each.condition for each in made if each.condition]))

    # ------------------------------------------------------------------------------------------------- readings

    def _assigning(self, inside: list[int]) -> dict[Variable, list[int]]:
        found: defaultdict[Variable, list[int]] = defaultdict(list)
        for p in inside:
            if p in self._assigned:
                for variable in self._assigned[p]:
                    found[variable] += [p]
        return found

    def _reads(
        self,
        tested: list[int],
        inside: list[int],
        assigning: Mapping[Variable, list[int]],
        deciding: Callable[[Variable], list[int]],
    ) -> frozenset[Read]:
        """Return what some points test, in a loop of the points `inside`."""
        points, statements = self._points, self._statements
        found: set[Read] = set()
        variables: set[Variable] = set()
        seen: set[int] = set()
        counts = False
        offsets = [points[p].at for p in tested]
        for at in offsets:  # the list grows during the loop
            if at in seen:
                continue
            seen |= {at}
            for each in self._called_by(at) if at in self._calling else (at,):
                if each in statements:
                    found |= self._readings[each]
                new = self._variables[each] - variables
                variables |= new
                for variable in new:
                    if variable in assigning:
                        counts |= variable in [
                            v for p in assigning[variable] for v in self._variables[points[p].at]
                        ]
                        offsets += [points[p].at for p in (*assigning[variable], *deciding(variable))]
        others = {each for each in variables if each not in assigning and each[1] >= 0}
        if others and not counts and self._is_assigned_elsewhere(others, inside):
            found.add(("task", None))
        return frozenset(found)

    @cached_property
    def _calling(self) -> set[int]:
        """The offsets of statements that call."""
        return {point.at for point in self._points if point.calls >= 0}

    def _called_by(self, at: int) -> dict[int, None]:
        """Return the offset of a statement and those of what it calls."""
        return dict.fromkeys(self._points[p].at for p in self._with_calls(self._at[at]))

    def _deciding(
        self, head: int, inside: list[int], ends: dict[Variable, list[int]]
    ) -> Callable[[Variable], list[int]]:
        """Return a function for the branches that decide in an iteration whether it comes to any of some points.

        One side of such a branch leads to such a point, and another side does not. `ends` has the points by variable.
        """
        # Each point has a bit, and each variable those of its points.
        own, masks, bit = dict.fromkeys(inside, 0), dict.fromkeys(ends, 0), 1
        for variable, points in ends.items():
            for p in points:
                own[p] |= bit
                masks[variable] |= bit
                bit <<= 1
        # What an iteration may still come to from each point: it ends at the head.
        bits, changed = dict(own), True
        while changed:
            changed = False
            for p in reversed(inside):
                point, found = self._points[p], own[p]
                for after in (*point.next, point.calls):
                    if after != head and after in bits:
                        found |= bits[after]
                if found != bits[p]:
                    bits[p], changed = found, True
        differing: dict[int, int] = {}
        for p in inside:
            if p in self._tests:
                sides = [
                    bits[after] if after in bits and after != head else 0 for after in self._points[p].next
                ]
                differing[p] = 0
                for side in sides:
                    differing[p] |= side ^ sides[0]
        return lambda variable: [p for p, found in differing.items() if found & masks[variable]]

    # -------------------------------------------------------------------------------------------- other tasks

    @cached_property
    def _tasks(self) -> tuple[dict[int, set[str]], dict[Variable, set[str]]]:
        """The tasks and handlers that carry out each point, and those that assign to each variable."""
        units = [*self._structure.tasks(), *(each for each in self._structure.units if each.kind == "event")]
        carrying: defaultdict[int, set[str]] = defaultdict(set)
        assigning: defaultdict[Variable, set[str]] = defaultdict(set)
        for unit in units:
            for p in self._graph.reached(unit.entry):
                carrying[p].add(unit.title)
                for variable in self._assigned.get(p, ()):
                    assigning[variable].add(unit.title)
        return carrying, assigning

    def _is_assigned_elsewhere(self, variables: set[Variable], points: list[int]) -> bool:
        """True if a task other than the one that carries out some points assigns to one of the variables."""
        carrying, assigning = self._tasks
        home = {task for p in points if p in carrying for task in carrying[p]}
        by = {task for variable in variables if variable in assigning for task in assigning[variable]}
        return bool(by - home if len(home) == 1 else by)


def _readings(made: Statement) -> set[Read]:
    found = {read for use in made.uses for read in _read(use)}
    if made.waits and not made.condition:
        found |= {(made.waits, axis) for axis in made.what or (None,)}
    return found


def _read(use: Use) -> list[Read]:
    """Return the readings of the use of a keyword."""
    row = use.row
    if row is None or row.reads in ("", "variable") or (use.role != "read" and "R" in row.access):
        return []
    numbers: tuple[object, ...] = ()
    if KINDS.get(row.reads) == "axis":
        numbers = use.axes
    elif row.reads in _NUMBERED and row.index not in ("bank", "axis"):
        numbers = use.numbers
    return [(row.reads, each if isinstance(each, int) else None) for each in numbers or (None,)]
