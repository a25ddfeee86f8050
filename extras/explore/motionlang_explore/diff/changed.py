"""The statements that differ between two programs, and what has to be played of them.

Problem. Two programs that did the same in each way that was played are only the same if the ways could have told.

Idea. Statements are compared by their forms, which all spellings share, and by where they lead. One without a
counterpart has changed. Assignments that follow each other have one order if none depends on another one. A changed
statement must be carried out in a way that was compared; if it is a condition, it must come out both
true and false there; and of what it computes something must show. In a way in which both programs have carried out the
same statements, or others of the same forms, in the same order, all values were equal. In any other way a difference
must show, or the changed statements in it are named.

A way that carries out no changed statement in one program, nor one behind which the other leads elsewhere, is the same
in the other by its text.

Cost. Linear in the statements, but for the alignment.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from itertools import chain
from math import inf

from motionlang.comparison.acts import ComparedActs, PlayedWay
from motionlang.comparison.align import aligned
from motionlang.kernel import Program
from motionlang.kernel.lang import ACTS, NAME, PRINTS, STARTS, UNTIL, Uses
from motionlang_explore.cover import coverage
from motionlang_explore.exploration import Trial

_NAMES = re.compile(rf"{NAME}\w+")
# An assignment to a variable.
_ASSIGNS = re.compile(rf"{NAME}\w+ = ")
# The formats of a value that is printed.
_FORMATS = re.compile(r"(?<=PrintItem )\S* \([^()]*\)")
# A statement in a comparison: the number of its pair, or its form.
Key = int | str
# A handler that no channel and no time starts: it may ask for the line of an error, which no form has.
_FAULT = "fault"
# The kinds of units that run beside each other, and any variable.
_STARTED, _ANY = ("program", "task", "event"), -(10**9)
# Leads to a statement that has changed itself.
_CHANGED = -1


class ChangedProgram:
    """One of two programs: the forms of its statements by source offset, and those that have changed."""

    def __init__(self, program: Program) -> None:
        self.program, self.structure = program, program.structure
        statements = self.structure.statements
        self.forms = {
            at: each.normal or each.form for at, each in statements.items() if each.effect != STARTS
        }
        # The offsets of assignments whose forms are in another place, since they may change places.
        self._written: dict[int, int] = {}
        # How it starts, which no run shows: forms by source offset.
        self.starts = {at: each.form for at, each in statements.items() if each.effect == STARTS}
        # The heads of subs and handlers.
        self.heads = {unit.head: unit.line for unit in self.structure.units if unit.head}
        self.changed_heads: set[str] = set()
        self.changed_starts: set[int] = set()
        # The pairs of statements that both programs have, by number; another statement is known by its form.
        self.pairs: dict[int, int] = {}
        # What a run carries out, but for what nothing leads to: debug builds begin statements, and the tests of a Case
        # and of an Until come out.
        offsets = program.offsets  # worked out anew at each access
        self._offsets = {each.at for each in coverage(self.structure, offsets, {}).statements}
        tests = {at for at, each in statements.items() if each.condition and at not in offsets}
        self._played = self._offsets | tests
        self.changed: set[int] = set()
        # The statements behind which the other program leads elsewhere. If the two are not `alike` but for statements
        # that a run carries out, they may part anywhere.
        self.parting: set[int] = set()
        self.is_alike = True
        # Those of them that print the same values in another format, which the text shows whenever they print.
        self.formats: set[int] = set()
        # The statements that began in the ways so far, and how conditions came out there.
        self.begun: set[int] = set()
        self.outcomes: set[tuple[int, int, bool]] = set()
        # The changed statements that began where something differs, and those that did otherwise where nothing does.
        self._shown: set[int] = set()
        self._silent: set[int] = set()
        self._is_shown = False

    def lines(self, some: Iterable[int]) -> list[int]:
        """Return the lines of some statements."""
        return sorted({self.structure.line(self._written.get(at, at)) for at in some})

    def order_assignments(self) -> None:
        """Give assignments that follow each other one order if each could be made before the others."""
        points, uses = self.structure.points, self._assigned()
        following: dict[int, set[int]] = {}
        for p, point in enumerate(points if uses else ()):
            following.setdefault(point.at, set()).update(at for at in self._next(p) if at != point.at)
        leading = Counter(after for some in following.values() for after in some)
        group: list[int] = []
        sets, reads = set[int](), set[int]()
        for at in [*sorted(uses), -1]:
            joins = group and at in uses and following[group[-1]] == {at} and leading[at] == 1
            if joins and sets.isdisjoint(uses[at].sets | uses[at].reads) and reads.isdisjoint(uses[at].sets):
                group.append(at)
            else:
                ordered = sorted(group, key=self.forms.__getitem__)
                self._written.update(zip(group, ordered, strict=True))
                self.forms.update(zip(group, [self.forms[each] for each in ordered], strict=True))
                group, sets, reads = [at], set(), set()
            if at in uses:
                sets |= uses[at].sets
                reads |= uses[at].reads

    def _assigned(self) -> dict[int, Uses]:
        """Return the assignments to one variable, from variables alone, that no other task or handler reads."""
        structure, graph = self.structure, self.structure.graph
        # What begins by itself, by the point that only it reaches; what is behind a shared point is shared.
        owners: dict[int, int] = {}
        shared: set[int] = set()
        for unit in structure.units:
            if unit.kind in _STARTED:
                reached = graph.reached(unit.entry, known=shared)
                shared |= reached & owners.keys()
                owners.update(dict.fromkeys(reached, unit.entry))
        readers: dict[int, set[int]] = {}
        for p, owner in owners.items():
            use = graph.uses[p]
            for n in (_ANY,) if use is None else use.reads:
                readers.setdefault(n, set()).add(-1 if p in shared else owner)
        found: dict[int, Uses] = {}
        for p in owners.keys() - shared:
            use, at = graph.uses[p], graph.points[p].at
            if use is None or len(use.sets) != 1 or use.parts or not _ASSIGNS.match(self.forms.get(at, "")):
                continue
            others = {k for n in (*use.sets, _ANY) for k in readers.get(n, ())} - {owners[p]}
            statement = structure.statements[at]
            if not others and not statement.uses and not statement.channels:
                found[at] = use
        return found

    @property
    def uncompared(self) -> set[int]:
        """The changed statements that no way has carried out."""
        return (self.changed & self._played) - self.begun

    @property
    def one_sided(self) -> dict[int, bool]:
        """The lines of changed conditions that came out in one way only, with the outcome that is missing."""
        counts = dict.fromkeys(self.outcomes, 1)
        found = coverage(self.structure, self.program.offsets, counts).conditions
        # The step of a loop that ends where its condition is true goes on if that is false.
        ends = {point.at for point in self.structure.points if point.role == UNTIL}
        return {
            each.line: bool(each.false) is (each.at not in ends)
            for each in found
            if each.at in self.changed and bool(each.true) is not bool(each.false)
        }

    @property
    def hidden(self) -> list[int]:
        """The lines of the changed statements, declarations and heads on which nothing depends that was played."""
        declared = (
            set[int]() if self._is_shown else self.changed.difference(self.program.offsets) - self._played
        )
        heads = set[str]() if self._is_shown else self.changed_heads
        found = (self._silent - self._shown) | {at for at in declared if self._effect(at) == ACTS}
        found |= self.changed_starts
        return sorted({*self.lines(found), *(self.heads[each] for each in heads)})

    def _effect(self, at: int) -> str:
        return self.structure.statements[at].effect

    @property
    def _values(self) -> set[int]:
        return {at for at in self.changed - self.formats if self._effect(at) == PRINTS}

    def printed(self) -> dict[int, str]:
        """Return the forms of the changed statements that print, without their formats."""
        return {at: _FORMATS.sub("", self.forms[at]) for at in self._values}

    def is_untouched(self, played: PlayedWay | Trial) -> bool:
        """True if a way that was played in this program alone is the same in the other one by its text."""
        return self.is_alike and _carried_out(played).isdisjoint(self.parting | self.changed)

    def parts_at(self, played: PlayedWay) -> float:
        """Return until when a way, recorded from its start, is the same in the other program by its text, s."""
        touched = self.parting | self.changed
        if not self.is_alike or not touched.isdisjoint(_carried_out(played) - played.begun):
            return 0.0
        return min(
            (time for some in played.order.values() for at, time in some.items() if at in touched),
            default=inf,
        )

    def note(self, played: PlayedWay, is_usual: bool, undecided: Set[int], differs: bool) -> None:
        """Take note of a way.

        `is_usual` is True if both programs have carried out the same in the same order. `undecided` are the lines of
        acts that the end of the way may have cut off in one of them.
        """
        begun = _carried_out(played)
        self.begun |= begun
        self.outcomes |= played.outcomes
        self._is_shown |= differs
        some = self.changed & begun
        if differs:
            self._shown |= some
        elif not is_usual:
            self._silent |= some - self.formats
        self._silent |= {at for at in some if self.structure.line(at) in undecided}

    def acted(self, played: PlayedWay) -> tuple[set[Key], dict[str, list[Key]]]:
        """Return what acted in a way, or printed changed values, and for each task the order in which it began."""
        begun = _carried_out(played)
        keys = {at: self.pairs.get(at, self.forms[at]) for at in begun if at in self.forms}
        acts = {at for at in keys if self._effect(at) == ACTS or at in self._values}
        order = {task: [keys[at] for at in some if at in acts] for task, some in played.order.items()}
        return {keys[at] for at in acts}, order

    def following(self, pairs: Mapping[int, int]) -> dict[int, list[int]]:
        """Return where each statement leads: to the pairs with these numbers, or to what has changed."""
        points = self.structure.points
        found: dict[int, list[int]] = {}
        for p, point in enumerate(points):
            if point.at in self.forms:
                found.setdefault(point.at, []).extend(
                    pairs.get(at, _CHANGED) for at in self._next(p) if at != point.at
                )
        return found

    @property
    def is_played(self) -> bool:
        """True if all that has changed are statements that a run carries out, or that show in such statements."""
        tests = {at for at, each in self.structure.statements.items() if each.condition}
        others = self.changed - tests.union(self.program.offsets)
        return (
            not self.changed_heads
            and not self.changed_starts
            and all(self._effect(at) != ACTS for at in others)
        )

    def beginnings(self) -> dict[str, list[int]]:
        """Return the statements with which what runs beside the rest, or a macro, begins, by a name for it."""
        points, found = self.structure.points, dict[str, list[int]]()
        for k, unit in enumerate(each for each in self.structure.units if each.kind in (*_STARTED, "macro")):
            at = points[unit.entry].at
            name = unit.head or (unit.name if unit.kind == "macro" else str(k))
            is_fault = unit.kind == "event" and not (unit.triggers or unit.is_timed)
            found[f"{_FAULT if is_fault else unit.kind} {name}"] = (
                [at] if at in self._offsets else [*self._next(unit.entry)]
            )
        return found

    def _next(self, p: int) -> Iterator[int]:
        """Yield the next statements that begin behind a point, through all that does nothing."""
        points, seen = self.structure.points, set[int]()
        stack = [p]
        while stack:
            here = points[stack.pop()]
            for after in (*here.next, here.calls):
                at = points[after].at if after >= 0 else -1
                if after < 0 or after in seen:
                    continue
                seen.add(after)
                if at != points[p].at and at in self._offsets:
                    yield at
                elif at != points[p].at:
                    stack.append(after)


def changed_programs(a: Program, b: Program) -> tuple[ChangedProgram, ChangedProgram]:
    """Return two programs with the statements of each that the other one does not have, or that lead elsewhere."""
    first, second = ChangedProgram(a), ChangedProgram(b)
    renamed = _renamed(first, second)

    def same(text: str) -> str:
        return _NAMES.sub(lambda name: renamed.get(name[0], name[0]), text)

    second.forms = {at: same(text) for at, text in second.forms.items()}
    second.heads = {same(text): line for text, line in second.heads.items()}
    first.changed_heads = first.heads.keys() - second.heads.keys()
    second.changed_heads = second.heads.keys() - first.heads.keys()
    first.order_assignments()
    second.order_assignments()
    for one, other in ((first, second), (second, first)):
        one.changed_starts = {at for at, each in one.starts.items() if each not in other.starts.values()}
    old, new = first.forms, second.forms
    mine, others = sorted(old), sorted(new)
    rows = aligned([old[at] for at in mine], [new[at] for at in others], str)
    pairs = [(mine[i], others[j]) for i, j in rows if i is not None and j is not None]
    numbers = [{both[side]: k for k, both in enumerate(pairs)} for side in (0, 1)]
    first.pairs, second.pairs = numbers
    first.changed, second.changed = old.keys() - numbers[0].keys(), new.keys() - numbers[1].keys()
    bare = first.printed(), second.printed()
    for text, texts, others_texts in ((first, *bare), (second, *bare[::-1])):
        text.formats = {at for at, each in texts.items() if each in others_texts.values()}
    leads = first.following(numbers[0]), second.following(numbers[1])
    for at, other_at in pairs:
        here, there = leads[0].get(at, []), leads[1].get(other_at, [])
        if here != there:
            first.parting.add(at)
            second.parting.add(other_at)
        if here != there and _CHANGED not in (*here, *there):
            first.changed.add(at)
            second.changed.add(other_at)
    first.is_alike = second.is_alike = _begin_alike(first, second)
    return first, second


def _begin_alike(a: ChangedProgram, b: ChangedProgram) -> bool:
    """True if two programs differ only in statements that a run carries out; note what begins with others."""
    begins, programs = (a.beginnings(), b.beginnings()), (a.program, b.program)
    is_moved = any(
        a.structure.line(at) != b.structure.line(other) for at, other in zip(a.pairs, b.pairs, strict=True)
    )
    for name in begins[0].keys() & begins[1].keys():
        first, second = (
            [text.pairs.get(at, _CHANGED) for at in each[name]]
            for text, each in zip((a, b), begins, strict=True)
        )
        if first != second or (is_moved and name.startswith(_FAULT)):
            a.parting.update(begins[0][name])
            b.parting.update(begins[1][name])
    one, other = ((each.language, each.target.model, each.values) for each in programs)
    return one == other and begins[0].keys() == begins[1].keys() and a.is_played and b.is_played


def _carried_out(played: PlayedWay | Trial) -> Set[int]:
    """Return the statements that began in a way, or whose conditions came out."""
    return played.begun | {at for at, _, _ in played.outcomes}


def note_untouched(texts: tuple[ChangedProgram, ChangedProgram], side: int, played: PlayedWay) -> None:
    """Take note of a way that was played in one of two programs, the first or the second, and touches no change."""
    begun = _carried_out(played)
    numbers = {texts[side].pairs[at] for at in begun if at in texts[side].pairs}
    texts[side].begun |= begun
    texts[1 - side].begun |= {at for at, number in texts[1 - side].pairs.items() if number in numbers}


def note_played(
    texts: tuple[ChangedProgram, ChangedProgram], played: tuple[PlayedWay, PlayedWay], result: ComparedActs
) -> None:
    """Take note of a way that was played in both programs, and of what differed in it."""
    undecided = {each.line for each in result.undecided}
    differs = bool(result.differences or result.later)
    (own, order), (others, other_order) = (text.acted(each) for text, each in zip(texts, played, strict=True))
    both = own & others
    is_usual = own == others and all(
        [each for each in some if each in both] == [each for each in other_order[task] if each in both]
        for task, some in order.items()
        if task in other_order
    )
    for text, each in zip(texts, played, strict=True):
        text.note(each, is_usual, undecided, differs)


def _renamed(a: ChangedProgram, b: ChangedProgram) -> dict[str, str]:
    """Return the names that only the second program has, with those of the first one in the same order."""
    handlers = {
        f"{NAME}{each.head}" for one in (a, b) for each in one.structure.units if each.kind == "event"
    }
    names: Sequence[dict[str, None]] = [
        dict.fromkeys(chain.from_iterable(map(_NAMES.findall, each.forms.values()))) for each in (a, b)
    ]
    known = [each.keys() | handlers for each in names]
    own, other = ([each for each in names[k] if each not in known[1 - k]] for k in (0, 1))
    return dict(zip(other, own, strict=False))
