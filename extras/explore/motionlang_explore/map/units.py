"""Who calls whom in a program, its variables, and what is never reached."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import groupby

from motionlang.kernel.lang import CALL, ENTER, Definition, Named, Structure, Unit

# Why lines never run that nothing calls, jumps to or starts.
UNREACHED = "nothing leads here"
# A comment of more lines than this is a heading.
MAX_COMMENT = 3
# What a comment above a macro has before its meaning: a line, and its definition again: "---- macro 1:".
_MACRO = re.compile(r"^[\s*=-]*(?:(?:macro|md)\s*\d+\b[\s:.=-]*)?", re.IGNORECASE)
# The kinds of definitions that hold a value.
_VALUES = ("variable", "parameter", "constant", "define", "register")


@dataclass(eq=False, slots=True)
class UnitMap:
    """A unit of a program: what it calls and starts, by title with the lines, and what calls and starts it.

    `is_reached` is False if nothing leads to it. `meaning` is the comment above a macro.
    """

    title: str
    kind: str
    line: int
    calls: dict[str, list[int]] = field(default_factory=dict)
    called_by: dict[str, list[int]] = field(default_factory=dict)
    starts: dict[str, list[int]] = field(default_factory=dict)
    started_by: dict[str, list[int]] = field(default_factory=dict)
    is_reached: bool = True
    meaning: str = ""


@dataclass(eq=False, slots=True)
class MapVariable:
    """A name with a value, and the lines that read and write it.

    `home` is the sub that declares it, "" for all. `meaning` is the name that a comment gives a register. `given` are
    the numbers, texts and names that it is set to, each with its lines; `decides` are the conditions that read it.
    """

    name: str
    kind: str
    home: str
    value: str
    reads: list[int]
    writes: list[int]
    is_retained: bool = False
    meaning: str = ""
    given: Mapping[str, list[int]] = field(default_factory=dict)
    decides: Sequence[str] = ()

    @property
    def is_used(self) -> bool:
        """False if nothing reads or writes it."""
        return bool(self.reads or self.writes)


@dataclass(eq=False, slots=True)
class UnreachedRow:
    """Lines that never ran, with the text of the first one, and the reason: a condition, a handler, or no way there."""

    first: int
    last: int
    text: str
    why: str


def units(structure: Structure, comments: Mapping[int, str]) -> tuple[list[UnitMap], list[UnreachedRow]]:
    """Return the units of a program, and the lines of statements that nothing reaches.

    `comments` are those with a line of their own.
    """
    reader = Reachability(structure)
    made = {id(unit): UnitMap(unit.title, unit.kind, unit.line) for unit in structure.units}
    by_title = {each.title: each for each in made.values()}
    meant = meant_by(by_title)
    for k, unit in enumerate(structure.units):
        own = made[id(unit)]
        for trigger in unit.triggers:
            own.started_by.setdefault(f"{trigger.channel} {trigger.number}".strip(), [])
        own.is_reached = k in reader.reached_units
        if unit.kind == "macro":
            own.meaning = _comment_above(unit.line, comments)
        for at, callee in reader.calls[k]:
            title = structure.units[callee].title
            line = structure.line(at)
            _add(own.calls, title, line)
            _add(by_title[title].called_by, own.title, line)
        for at, title in reader.starts[k]:
            _add(own.starts, title, structure.line(at))
            for each in meant.get(title, ()):
                _add(by_title[each].started_by, own.title, structure.line(at))
    unreached = [
        UnreachedRow(first, last, structure.source.line(first).strip(), UNREACHED)
        for first, last in reader.unreached_lines
    ]
    return list(made.values()), unreached


def _comment_above(line: int, comments: Mapping[int, str]) -> str:
    """Return the comment of some lines above a line, the last one of a heading."""
    above = list[str]()
    while len(above) <= MAX_COMMENT and line - 1 - len(above) in comments:
        above.insert(0, comments[line - 1 - len(above)])
    parts = (_MACRO.sub("", each).strip() for each in (above if len(above) <= MAX_COMMENT else above[-1:]))
    return " ".join(filter(None, parts))


def variables(
    structure: Structure, definitions: Iterable[Definition], names: Iterable[Named]
) -> list[MapVariable]:
    """Return the variables, constants and registers of a program, in the order of the text."""
    retained = {
        use.number
        for each in structure.statements.values()
        for use in each.channels
        if use.channel == "nv word"
    }
    registers = {str(each.number): each.name for each in names if each.kind == "register"}
    starts = sorted(structure.statements)
    found = []
    for each in definitions:
        if each.kind not in _VALUES:
            continue
        given: dict[str, list[int]] = {}
        decides: dict[str, None] = {}
        for start, end in each.uses:
            line, value = structure.line(start), structure.writes.get(start)
            if value:
                _add(given, value, line)
            k = bisect_right(starts, start) - 1
            is_read = value is None and (start, end) != each.span and each.kind not in ("constant", "define")
            condition = structure.statements[starts[k]].condition if is_read and k >= 0 else ""
            decides |= {f"{line}: {condition}": None} if condition else {}
        writes = sorted({structure.line(start) for start, _ in each.uses if start in structure.writes})
        reads = sorted(
            {
                structure.line(start)
                for start, end in each.uses
                if start not in structure.writes and (start, end) != each.span
            }
        )
        found.append(
            MapVariable(
                each.name,
                each.kind,
                each.home,
                each.value,
                reads,
                writes,
                each.kind == "variable" and each.name in retained,
                registers.get(each.name, "") if each.kind == "register" else "",
                given,
                list(decides),
            )
        )
    return sorted(
        found, key=lambda each: (_VALUES.index(each.kind), min([*each.reads, *each.writes, 10**9]), each.name)
    )


def meant_by(titles: Iterable[str]) -> dict[str, list[str]]:
    """Map what statements start to the titles that each may mean: a macro may be defined more than once."""
    found: dict[str, list[str]] = {}
    for title in titles:
        for started in dict.fromkeys((title, title.partition(" of line ")[0])):
            found.setdefault(started, []).append(title)
    return found


def _add(to: dict[str, list[int]], title: str, line: int) -> None:
    lines = to.setdefault(title, [])
    if line not in lines:
        lines.append(line)


class Reachability:
    """The units and statements of a program that the program, a handler or a task leads to."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure
        # What each unit calls and starts: the offset of the statement, and the unit.
        self.calls: list[list[tuple[int, int]]] = [[] for _ in structure.units]
        self.starts: list[list[tuple[int, str]]] = [[] for _ in structure.units]
        entries = {unit.entry: k for k, unit in enumerate(structure.units)}
        self._reached: set[int] = set()
        self.reached_units: set[int] = set()
        by_title = {unit.title: k for k, unit in enumerate(structure.units)}
        meant = meant_by(by_title)
        calls_unknown = False
        bodies = [self._body(unit, entries) for unit in structure.units]
        for k, body in enumerate(bodies):
            for p in sorted(body):
                point = structure.points[p]
                if point.calls in entries:
                    self.calls[k].append((point.at, entries[point.calls]))
                elif point.kind in (CALL, ENTER) and point.calls < 0 and not point.next[1:]:
                    calls_unknown = calls_unknown or point.kind == CALL
                for each in point.next:
                    if each in entries and each not in (structure.units[k].entry,) and entries[each] != k:
                        self.calls[k].append((point.at, entries[each]))
                statement = structure.statements.get(point.at)
                if statement is not None:
                    self.starts[k] += [(point.at, title) for title in statement.starts]
                    calls_unknown = calls_unknown or any("@" in title for title in statement.starts)
            self.calls[k] = list(dict.fromkeys(self.calls[k]))
            self.starts[k] = list(dict.fromkeys(self.starts[k]))
        roots = [k for k, unit in enumerate(structure.units) if unit.kind in ("program", "event")]
        stack = list(range(len(structure.units))) if calls_unknown else roots
        while stack:
            k = stack.pop()
            if k not in self.reached_units:
                self.reached_units.add(k)
                self._reached |= bodies[k]
                stack += [callee for _, callee in self.calls[k]]
                for _, title in self.starts[k]:
                    stack += [by_title[each] for each in meant.get(title, ())]

    def _body(self, unit: Unit, entries: dict[int, int]) -> set[int]:
        """Return the points of a unit, up to the entries of others."""
        found, stack = {unit.entry}, [unit.entry]
        while stack:
            for each in self.structure.points[stack.pop()].next:
                if each not in found and each not in entries:
                    found.add(each)
                    stack.append(each)
        return found

    @property
    def reached(self) -> set[int]:
        """The offsets of the statements that something leads to."""
        return {self.structure.points[p].at for p in self._reached}

    @property
    def unreached_lines(self) -> list[tuple[int, int]]:
        """The first and last lines of statements that nothing leads to."""
        points, reached = self.structure.points, self.reached
        written = {point.at for point in points}
        lines: dict[int, bool] = {}
        for at, statement in self.structure.statements.items():
            if at in written and not statement.is_silent:
                lines[statement.line] = lines.get(statement.line, False) or at in reached
        groups = [
            (is_reached, list(same)) for is_reached, same in groupby(sorted(lines), key=lines.__getitem__)
        ]
        return [(same[0], same[-1]) for is_reached, same in groups if not is_reached]
