"""The states in which a program waits, and the transitions between them.

Problem. An engineer asks what the machine waits for now, and what happens next. The text answers in the order in which
it was written; a list of all paths through it would be exponential.

Idea. The graph of the steps of the program (`kernel/lang/facts.py`) has everything: a wait is a step, and
branches, jumps and calls link the steps. Each unit becomes one diagram. Its states are the statements at which a task
waits, and the paths between them become transitions, with the conditions that hold and the actions on the way.

    SPEED(0) = 250                         start
    VECTORA(0, 1) = 10, 10 : GO(0)           │  SPEED(0) = 250; VECTORA(0, 1) = 10, 10; GO(0)
    PAUSE IDLE(0)                          PAUSE IDLE(0)
    If n > 5 Then OUTX(2) = 1                │  if n > 5: OUTX(2) = 1; OUTX(0) = 0
    OUTX(0) = 0 : PAUSE INX(0)             PAUSE INX(0)

Rules, in this order:

1. A statement at which a task waits is a state, with all of its steps.
2. A call of a unit that may wait is a state; another call is an action. What is called has its own diagram.
3. A branch whose sides meet again after at most `MAX_FOLDED` steps, with no state between, is one action with its
   conditions (`_fold`). A loop without a state is one action if it computes, and a state if it waits for a reading: it
   polls.
4. A loop that is left over has no state and no end; its first step is a state.
5. A step that more than `MAX_PATHS` paths lead to is a state ("meet"), and so is a branch behind `MAX_BRANCHES` others
   ("branch"), so that the paths after it are counted again from one.
6. A step belongs to the diagram of one unit. A jump into the steps of another one is a state of its own.

Invariants. Every path of the program passes the same states in the same order; a transition is identified by its source
and the branches on its way (`Transition.branches`), which lead to one target. `observed.py` follows a run by these.

Cost. Rule 5 bounds the paths to a step and the branches of a path, so states, transitions and actions together are
linear in the number of steps. Folding visits at most `MAX_FOLDED` steps for each branch.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from motionlang.commands.map.channels import DEVICES
from motionlang.commands.map.paths import components, ordered, postdominators
from motionlang.kernel.lang import (
    CALL,
    END,
    KINDS,
    RETURN,
    LoopDependencies,
    Read,
    Statement,
    Structure,
    Unit,
)

# The number of paths that may meet at a step.
MAX_PATHS = 4
# The number of branches on a path.
MAX_BRANCHES = 6
# The number of steps that are folded into one action.
MAX_FOLDED = 200
# The kinds of states, with what a reader sees of each.
KINDS_OF_STATES = {
    "start": "the unit begins",
    "wait": "a task waits",
    "poll": "a loop tests a reading until it changes",
    "call": "another unit runs",
    "loop": "a loop without a wait and without an end",
    "meet": "many paths meet",
    "branch": "a path goes on that has many branches before it",
    "return": "the unit returns to its caller",
    "end": "the task ends",
    "jump": "another unit goes on",
}
# Those at which the program does not stop: what their step does is an action behind them.
_PASSED = ("loop", "meet", "branch")
_LEAVING = ("return", "end", "jump")
# A condition on the path of a transition, or an action.
Step = TypeVar("Step", "Action", "Action | Condition")
# The branches on a path: the key of each point, and which of its successors follows.
Branches = tuple[tuple[tuple[str, int], int], ...]


@dataclass(eq=False, slots=True)
class Action:
    """A statement on a transition, under `depth` conditions; `text` is the statement as written.

    With `is_condition` it is the condition of the deeper ones that follow.
    """

    at: int
    text: str
    depth: int = 0
    is_condition: bool = False


@dataclass(eq=False, slots=True)
class Condition:
    """A condition on a transition, and whether it holds; `select` is the offset of the Select that it is a Case of."""

    at: int
    text: str
    holds: bool
    select: int = -1

    def __str__(self) -> str:
        if self.holds:
            return self.text
        inner = self.text.removeprefix("not (").removesuffix(")")
        return inner if self.text.startswith("not (") else f"not ({self.text})"


@dataclass(eq=False, slots=True)
class State:
    """A state of a diagram: `kind` is one of `KINDS_OF_STATES`.

    `cause` is one of `record.records.CAUSES`, "" if it does not wait. `unit` is the title of what a call or a jump
    enters. A loop that polls has its readings, and `meanwhile` is what it does in each iteration.
    """

    id: str
    kind: str
    at: int
    line: int
    text: str
    cause: str = ""
    unit: str = ""
    readings: frozenset[Read] = frozenset()
    meanwhile: list[Action] = field(default_factory=list)


@dataclass(eq=False, slots=True)
class Transition:
    """A path from one state to another: conditions and actions in the order of a run, and its branches."""

    source: State
    target: State
    path: list[Action | Condition]
    branches: Branches


@dataclass(eq=False, slots=True)
class Diagram:
    """The states and transitions of one unit; the first state is its start."""

    unit: Unit
    states: list[State]
    transitions: list[Transition]


@dataclass(eq=False, slots=True)
class Diagrams:
    """All diagrams of a program, and where a run is seen.

    `states` has the state of each point at which one is entered, `owners` the number of the diagram of each point.
    `branches` maps each point whose choice matters to the steps to which it may lead, `polled` the offset of each
    statement of a loop that polls to the readings that the loop tests.
    """

    diagrams: list[Diagram]
    states: dict[tuple[str, int], State]
    branches: dict[tuple[str, int], list[int]]
    owners: dict[tuple[str, int], int]
    polled: dict[int, frozenset[Read]] = field(default_factory=dict)


def diagrams(structure: Structure) -> Diagrams:
    """Return the diagrams of all units of a program."""
    return _Builder(structure).built()


class _Builder:
    """Builds the diagrams of a program."""

    def __init__(self, structure: Structure) -> None:
        self.structure, self.points = structure, structure.points
        # The point at which something happens next, for each point; and the statements of the silent ones before it.
        self._next_of: dict[int, int] = {}
        self.entries = [self.next_point(unit.entry) for unit in structure.units]
        self.owner: dict[int, int] = {}
        self._claim()
        # The points of each unit, in the order of their lists.
        self.owned: list[list[int]] = [[] for _ in structure.units]
        for p, number in sorted(self.owner.items()):
            self.owned[number].append(p)
        self.waiting = self._waiting_units()

    def built(self) -> Diagrams:
        found = Diagrams([], {}, {}, {self.points[p].key: k for p, k in self.owner.items()})
        targets = {q for p in self.owner for q in self.following(p) if self.owner[q] != self.owner[p]}
        for number, unit in enumerate(self.structure.units):
            made = _DiagramBuilder(self, number, unit, targets)
            found.diagrams.append(made.diagram)
            found.polled |= made.polled
            found.states |= {self.points[p].key: state for p, state in made.states.items()}
            for p in made.branches:
                found.branches[self.points[p].key] = [self.points[q].key[1] for q in self.points[p].next]
        return found

    def next_point(self, p: int) -> int:
        """Return the first point from `p` on at which something happens; one of a silent loop if nothing does."""
        seen: list[int] = []
        while p not in self._next_of and self.points[p].is_silent and self.points[p].next and p not in seen:
            seen.append(p)
            p = self.points[p].next[0]
        p = self._next_of.get(p, p)
        for each in seen:
            self._next_of[each] = p
        return p

    def silent(self, p: int) -> Iterator[int]:
        """Yield the silent points from `p` on, up to the next one at which something happens."""
        end = self.next_point(p)
        while p != end:
            yield p
            p = self.points[p].next[0]

    def following(self, p: int) -> list[int]:
        """Return the points at which something happens next."""
        return [self.next_point(each) for each in self.points[p].next]

    def statement(self, p: int) -> Statement | None:
        """Return the statement of a point."""
        return self.structure.statements.get(self.points[p].at)

    def _claim(self) -> None:
        """Give each point to the first unit that leads to it; the first point of a unit is its own."""
        for number, entry in enumerate(self.entries):
            self.owner.setdefault(entry, number)
        for number, entry in enumerate(self.entries):
            stack = [entry] if self.owner[entry] == number else []
            while stack:
                for each in self.following(stack.pop()):
                    if each not in self.owner:
                        self.owner[each] = number
                        stack.append(each)

    def callee(self, p: int) -> int | None:
        """Return the number of the unit that a point calls, None if it is unknown."""
        called = self.points[p].calls
        return self.owner.get(self.next_point(called)) if called >= 0 else None

    def _waiting_units(self) -> set[int]:
        """Return the units that may wait, directly or in what they call or jump to."""
        found: set[int] = set()
        leads: dict[int, set[int]] = {}
        for p, number in self.owner.items():
            statement = self.statement(p)
            ats = {
                self.points[p].at,
                *(self.points[q].at for n in self.points[p].next for q in self.silent(n)),
            }
            if (statement is not None and statement.waits) or any(self.polled([at]) for at in ats if at >= 0):
                found.add(number)
            for other in [self.callee(p), *(self.owner[q] for q in self.following(p))]:
                if other is not None and other != number:
                    leads.setdefault(other, set()).add(number)
        stack = list(found)
        while stack:
            for each in leads.get(stack.pop(), ()):
                if each not in found:
                    found.add(each)
                    stack.append(each)
        return found

    def polled(self, ats: Iterable[int]) -> LoopDependencies | None:
        """Return what a loop with statements at these offsets waits for, None if it waits for nothing."""
        for at in ats:
            found = self.structure.polls(at) if at >= 0 else None
            if found is not None and found.leaves:
                return found
        return None


class _DiagramBuilder:
    """Builds the diagram of one unit."""

    def __init__(self, program: _Builder, number: int, unit: Unit, targets: set[int]) -> None:
        self.program, self.number, self.points = program, number, program.points
        self.states: dict[int, State] = {}
        self.branches: set[int] = set()
        self._targets = targets
        # The first point of each statement at which a task waits; and the points of its other steps.
        self._merged = self._merge()
        self._members: dict[int, list[int]] = {}
        for q, first in self._merged.items():
            self._members.setdefault(first, []).append(q)
        self._after: dict[int, list[int]] = {}
        self.polled: dict[int, frozenset[Read]] = {}
        # What is folded into one action at a point.
        self._folded: dict[int, list[Action]] = {}
        entry = program.entries[number]
        start = State(f"u{number}", "start", -1, unit.line, unit.title)
        self.diagram = Diagram(unit, [start], [])
        self._jumps: dict[int, State] = {}
        if program.owner[entry] != number:
            self._add(start, self._jump(entry), [], ())
            return
        self.entry = self._merged.get(entry, entry)
        order, back = ordered([self.entry], self.after)
        self._mark(order)
        self._dominators = postdominators(order, back, self.after)
        self._components = components(order, self.after)
        leads_back: dict[int, list[int]] = {}
        for one, other in back:
            leads_back.setdefault(one, []).append(other)
        regions = [(p, region) for p in order if (region := self._region(p)) is not None]
        for p, _ in sorted(regions, key=lambda each: len(each[1])):  # inner ones first
            self._fold(p, leads_back)
        self._cut_loops()
        self._cut_paths()
        for p in self.states:
            self._poll_in_steps(p)
        self._walk(start, [self.entry])
        for p in order:
            if p in self.states:
                self.diagram.states.append(self.states[p])
                self._walk(self.states[p], self.after(p), p)
        for each in self.diagram.transitions:
            if each.source.kind == "loop" and not each.source.cause and each.target is not each.source:
                each.source.kind = "meet"  # the loop has an end
        self.diagram.states += self._jumps.values()
        reached = {id(each.target) for each in self.diagram.transitions}
        shown = [each for each in self.diagram.states[1:] if id(each) in reached]
        self.diagram.states[1:] = sorted(shown, key=lambda each: (each.kind in _LEAVING, each.at))

    # ------------------------------------------------------------------------------------------------ the graph

    def _merge(self) -> dict[int, int]:
        firsts: dict[int, int] = {}
        merged: dict[int, int] = {}
        for p in self.program.owned[self.number]:
            statement = self.program.statement(p)
            if statement is not None and statement.waits:
                merged[p] = firsts.setdefault(self.points[p].at, p)
        return merged

    def after(self, p: int) -> list[int]:
        """Return the points after a point, or after a whole statement at which a task waits."""
        found = self._after.get(p)
        if found is None:
            members = self._members.get(p) or [p]
            if p >= 0 and self._is_foreign(p):
                members = []
            found = [self._merged.get(q, q) for member in members for q in self.program.following(member)]
            if len(members) > 1:
                found = list(dict.fromkeys(q for q in found if q != p))
            self._after[p] = found
        return found

    def _is_foreign(self, p: int) -> bool:
        return self.program.owner[p] != self.number

    def _mark(self, order: Sequence[int]) -> None:
        """Make states of waits, calls that may wait, ends, and what another unit jumps to."""
        for p in order:
            if self._is_foreign(p):
                continue
            point, statement = self.points[p], self.program.statement(p)
            callee = self.program.callee(p) if point.kind == CALL else None
            is_call = point.kind == CALL and (callee is None or callee in self.program.waiting)
            if statement is not None and statement.waits:
                self._state(p, "wait", statement.waits)
            elif is_call:
                self._state(p, "call")
                if callee is not None:
                    self.states[p].unit = self.program.structure.units[callee].title
            elif point.kind == RETURN or (point.kind == END and not point.next):
                self._state(p, "return" if point.kind == RETURN else "end")
            elif not self.after(p):
                self._state(p, "end")
            elif p in self._targets and p != self.entry:
                self._state(p, "meet")

    def _state(self, p: int, kind: str, cause: str = "") -> None:
        statement = self.program.statement(p)
        line = statement.line if statement is not None else 0
        text = statement.text if statement is not None and kind not in _LEAVING else kind
        self.states[p] = State(f"n{p}", kind, self.points[p].at, line, text, cause)

    def _jump(self, p: int) -> State:
        """Return the state for a point of another unit."""
        if p not in self._jumps:
            other = self.program.structure.units[self.program.owner[p]]
            statement = self.program.statement(p)
            line = statement.line if statement is not None else other.line
            self._jumps[p] = State(
                f"j{self.number}_{p}",
                "jump",
                self.points[p].at,
                line,
                f"goes on in {other.title}",
                unit=other.title,
            )
        return self._jumps[p]

    # ------------------------------------------------------------------------------------------------- folding

    def _region(self, p: int) -> set[int] | None:
        """Return a branch and all points before its sides meet; None if they do not, or if there is a state."""
        sides = self.after(p)
        end = self._dominators.get(p, -1)
        if p in self.states or len(set(sides)) < 2 or end < 0 or self._is_foreign(end):
            return None
        region, stack = {p}, list(sides)
        while stack:
            each = stack.pop()
            if each in region or each == end:
                continue
            if each in self.states or self._is_foreign(each) or len(region) == MAX_FOLDED:
                return None
            region.add(each)
            stack += self.after(each)
        return region

    def _fold(self, p: int, leads_back: dict[int, list[int]]) -> None:
        """Make one action, or one polling state, of a branch whose sides meet again."""
        inside, end = self._region(p), self._dominators.get(p, -1)
        if inside is None:
            return
        heads = {other for one in inside for other in leads_back.get(one, ()) if other in inside}
        loops = bool(heads)
        polled = self.program.polled(sorted(self._offsets(inside))) if loops else None
        acts = any(not each.is_condition for q in inside - {p} for each in self._acts(q))
        if acts and self._returns(end, heads):
            return  # This is a branch of a larger loop with the same head, and acts in it.
        actions = self._outline(p, end, inside, loops)
        self._after[p] = [end]
        if polled is None:
            self._folded[p] = actions
            return
        self._state(p, "poll")
        self._poll(self.states[p], polled.leaves, self._offsets(inside))
        self.states[p].meanwhile = [
            each
            for each in actions
            if not each.is_condition or each.depth or not each.text.startswith(("while", "repeat"))
        ]

    def _leads(self, first: int, to: int, inside: set[int]) -> bool:
        """True if a path within a region leads from a point to another one."""
        seen, stack = {first}, [first]
        while stack:
            for each in self.after(stack.pop()):
                if each == to:
                    return True
                if each in inside and each not in seen:
                    seen.add(each)
                    stack.append(each)
        return False

    def _returns(self, first: int, heads: set[int]) -> bool:
        """True if a path without a state leads from a point to one of `heads`."""
        last = max((self._components[each] for each in heads), default=-1)
        seen, stack = {first}, [first]
        while stack:
            p = stack.pop()
            if self._components[p] > last:
                continue  # Nothing behind it leads back to the heads.
            for each in self._between(p):
                if each in heads:
                    return True
                if each not in seen:
                    seen.add(each)
                    stack.append(each)
        return False

    def _poll(self, state: State, readings: frozenset[Read], offsets: Iterable[int]) -> None:
        """Let a state wait for the readings that its loop tests."""
        causes = {KINDS[kind] for kind, _ in readings}
        state.cause = causes.pop() if len(causes) == 1 else "condition" if causes else ""
        state.readings = readings
        self.polled |= dict.fromkeys(offsets, readings)

    def _offsets(self, inside: set[int]) -> set[int]:
        """Return the offsets of points and of the silent points between them."""
        found = {self.points[p].at for p in inside}
        for p in inside:
            for first in self.points[p].next:
                if self.program.next_point(first) in inside:
                    found |= {self.points[q].at for q in self.program.silent(first)}
        return found

    def _outline(self, p: int, end: int, inside: set[int], loops: bool) -> list[Action]:
        """Return the actions of a branch, in the order of the text, under their conditions."""
        found: list[Action] = []
        seen: set[int] = set()

        def add(p: int, depth: int) -> None:
            found.extend(
                Action(each.at, each.text, each.depth + depth, each.is_condition) for each in self._acts(p)
            )

        def side(p: int, stop: int, depth: int) -> None:
            while p != stop and p in inside and p not in seen:
                seen.add(p)
                if p in self._folded:
                    add(p, depth)
                    p = self.after(p)[0]
                    continue
                sides = self.after(p)
                if len(set(sides)) > 1:
                    p = branch(p, stop, depth)
                else:
                    add(p, depth)
                    p = sides[0]

        def branch(p: int, stop: int, depth: int) -> int:
            meets, sides = self._dominators.get(p, stop), self.after(p)
            seen.add(p)
            has_first = False
            for k, each in enumerate(sides):
                if each == meets or each in seen:
                    continue
                word = "while" if loops and p == first and self._leads(each, first, inside) else "if"
                condition = Condition(self.points[p].at, self._condition(p), k == 0)
                text = "else" if has_first else f"{word} {condition}"
                heading = Action(self.points[p].at, text, depth, True)
                found.append(heading)
                side(each, meets, depth + 1)
                if found[-1] is heading:
                    found.pop()  # Nothing is done on this side.
                else:
                    has_first = True
            return meets

        first = p
        branch(p, end, 0)
        if not found:
            found.append(Action(self.points[p].at, f"repeat while {self._condition(p)}", 0, True))
        return _without_repeats(found)

    def _conditions(self, p: int, side: int) -> list[Action | Condition]:
        """Return the condition of a branch on one of its sides."""
        statement = self.program.statement(p)
        select = statement.select if statement is not None else -1
        return [Condition(self.points[p].at, self._condition(p), side == 0, select)]

    def _condition(self, p: int) -> str:
        statement = self.program.statement(p)
        return (statement.condition or statement.text) if statement is not None else "?"

    def _acts(self, p: int) -> list[Action]:
        """Return the actions of a point."""
        if p in self._folded:
            return self._folded[p]
        statement = self.program.statement(p)
        if statement is None or statement.is_silent or statement.condition:
            return []
        return [Action(statement.at, statement.text)]

    # --------------------------------------------------------------------------------------------- cuts and paths

    def _between(self, p: int) -> list[int]:
        """Return the points after `p` that are no states."""
        return [q for q in self.after(p) if q not in self.states and not self._is_foreign(q)]

    def _roots(self) -> list[int]:
        roots = [self.entry] if self.entry not in self.states else []
        return roots + [q for p in self.states for q in self._between(p)]

    def _cut_loops(self) -> None:
        """Make a state of the first point of each loop that has none; it waits for what the loop tests."""
        order, back = ordered(self._roots(), self._between)
        number = {p: k for k, p in enumerate(order)}
        for first in sorted(
            {first for _, first in back}, key=number.__getitem__, reverse=True
        ):  # inner ones first
            inside = self._cycle(first, number)
            if inside:
                offsets = self._offsets(inside)
                self._state(first, "loop")
                self._poll(self.states[first], self._tested(offsets), offsets)

    def _cycle(self, first: int, number: dict[int, int]) -> set[int]:
        """Return the points of the paths without a state from a point to itself, by points of higher numbers."""
        before: dict[int, list[int]] = {}
        stack = [first]
        while stack:
            p = stack.pop()
            for each in self._between(p):
                if number[each] >= number[first] and self._components[each] == self._components[first]:
                    if each not in before:
                        before[each] = []
                        stack.append(each)
                    before[each].append(p)
        found: set[int] = set()
        stack = [first] if first in before else []
        while stack:
            p = stack.pop()
            if p not in found:
                found.add(p)
                stack += before[p]
        return found

    def _tested(self, offsets: Collection[int]) -> frozenset[Read]:
        """Return the readings that statements of a loop test, without those of a larger loop around them."""
        structure = self.program.structure
        statements = [structure.statements[at] for at in offsets if at in structure.statements]
        lines = {each.line for each in statements}
        used = {(use.channel, use.number) for each in statements for use in each.channels}
        found: set[Read] = set()
        for each in filter(None, (structure.polls(at) for at in sorted(offsets) if at >= 0)):
            inside = each.lines <= lines
            found |= {(kind, n) for kind, n in each.within if inside or (DEVICES.get(kind), str(n)) in used}
        return frozenset(found)

    def _poll_in_steps(self, p: int) -> None:
        """Find the readings that end a loop whose only state is a wait of a fixed time."""
        state, structure = self.states[p], self.program.structure
        if state.cause != "time":
            return
        order, _ = ordered(self._between(p), self._between)
        inside = {p}
        for q in reversed(order):
            inside |= {q} if inside.intersection(self.after(q)) else set()
        if not inside.intersection(self.after(p)):
            return
        offsets = self._offsets(inside)
        loops = filter(None, (structure.polls(at) for at in sorted(offsets) if at >= 0))
        lines = {structure.line(at) for at in offsets if at >= 0}
        state.readings = frozenset[Read]().union(*(each.leaves for each in loops if each.lines <= lines))
        self.polled |= dict.fromkeys(offsets, state.readings)

    def _cut_paths(self) -> None:
        """Make a state of each point to which too many paths lead."""
        order, _ = ordered(self._roots(), self._between)
        paths: dict[int, int] = dict.fromkeys(order, 0)
        branches: dict[int, int] = dict.fromkeys(order, 0)
        paths[self.entry] = paths.get(self.entry, 0) + 1
        for p in list(self.states):
            for q in self._between(p):
                paths[q] += 1
                branches[q] = max(branches[q], len(set(self.after(p))) > 1)
        for p in order:
            is_branch = len(set(self.after(p))) > 1
            if paths[p] > MAX_PATHS:
                self._state(p, "meet")
            elif is_branch and branches[p] >= MAX_BRANCHES:
                self._state(p, "branch")
            count, before = (1, 0) if p in self.states else (paths[p], branches[p])
            for q in self.after(p):
                if q in paths and q not in self.states:
                    paths[q] += count
                    branches[q] = max(branches[q], before + is_branch)

    def _walk(self, source: State, firsts: list[int], own: int | None = None) -> None:
        """Add the transitions from a state to the first states after it; `own` is the point of the state."""
        stack: list[tuple[int, Branches, list[Action | Condition]]] = []
        acts: list[Action | Condition] = []
        if own is not None and source.kind in _PASSED:
            acts += self._acts(own)
        if own is not None and len(set(firsts)) > 1:
            self.branches.add(own)
        for k, p in reversed(list(enumerate(firsts))):
            if own in self.branches and own is not None:
                stack.append((p, ((self.points[own].key, k),), [*acts, *self._conditions(own, k)]))
            else:
                stack.append((p, (), acts))
        while stack:
            p, branches, path = stack.pop()
            if self._is_foreign(p):
                self._add(source, self._jump(p), path, branches)
                continue
            if p in self.states:
                self._add(source, self.states[p], path, branches)
                continue
            path = [*path, *self._acts(p)]
            sides = self.after(p)
            is_branch = len(set(sides)) > 1
            if is_branch:
                self.branches.add(p)
            for k, each in reversed(list(enumerate(sides))):
                if is_branch:
                    more = (*branches, (self.points[p].key, k))
                    stack.append((each, more, [*path, *self._conditions(p, k)]))
                elif k == 0:
                    stack.append((each, branches, path))

    def _add(
        self,
        source: State,
        target: State,
        path: Sequence[Action | Condition],
        branches: Branches,
    ) -> None:
        own = list(path)
        # What a target does itself is no action on the way to it.
        while own and isinstance(own[-1], Action) and own[-1].at == target.at and target.kind != "jump":
            own.pop()
        self.diagram.transitions.append(Transition(source, target, _without_repeats(own), branches))


def _without_repeats(path: Sequence[Step]) -> list[Step]:
    """Return a path without further steps of the same statement."""
    found: list[Step] = []
    for each in path:
        if not found or found[-1].at != each.at or found[-1].text != each.text:
            found.append(each)
    return found
