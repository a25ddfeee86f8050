"""How often the runs of a program reach its statements, conditions, handlers and macros.

A debug build counts statements as they begin, and conditions as they turn out; it runs exactly like any other run.
Iterations of a loop that are skipped count like those that are carried out. Counts of several runs add up.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

from motionlang.commands.scenarios import Scenario, scenario_files
from motionlang.kernel import Dialect, Source, dialect_for, settings_next_to
from motionlang.kernel.lang import Step, Structure, Values, conditions
from motionlang_explore.cover.worlds import BEGINS, CutOff, Event, Worlds
from motionlang_explore.map.units import Reachability


@dataclass
class CoveredCondition:
    """A condition of a statement, and how often it was true and false."""

    at: int
    line: int
    text: str
    true: int
    false: int


@dataclass
class CoveredPart:
    """A sub, task, handler or macro, and how often it began."""

    kind: str
    name: str
    line: int
    count: int


@dataclass
class CoveredStatement:
    """A statement, and how often it began."""

    at: int
    line: int
    text: str
    count: int


@dataclass
class Coverage:
    """The statements, conditions and parts that the runs of a program have reached.

    `worlds` are the scenarios that it ran in, "" for its own world. `unreached` are the first and last lines of
    statements that nothing leads to; those do not count. `cut` are the worlds whose runs a signal has ended, so that
    nothing counts as missed.
    """

    file: str
    source: Source
    worlds: Sequence[str]
    statements: list[CoveredStatement]
    conditions: list[CoveredCondition]
    parts: list[CoveredPart]
    unreached: list[tuple[int, int]]
    cut: Sequence[str] = ()

    @property
    def lines(self) -> dict[int, int]:
        """How often each line with statements was reached: as often as the first statement that begins on it."""
        found: dict[int, int] = {}
        for each in self.statements:
            found.setdefault(each.line, each.count)
        return found

    @property
    def missed(self) -> dict[int, str]:
        """The reason for each line that is not covered: a statement, or an outcome of a condition."""
        if self.cut:
            return {}
        found: dict[int, str] = {}
        lines = self.lines
        for each in self.statements:
            if not each.count:
                text = f"not reached: {each.text}" if lines[each.line] else "not reached"
                found.setdefault(each.line, text)
        for one in self.conditions:
            if bool(one.true) is not bool(one.false):
                found.setdefault(one.line, f"never {'false' if one.true else 'true'}: {one.text}")
        for first, last in self.unreached:
            found |= dict.fromkeys(range(first, last + 1), "nothing leads here")
        return dict(sorted(found.items()))

    @property
    def statements_reached(self) -> int:
        """The number of statements that were reached."""
        return len([each for each in self.statements if each.count])

    @property
    def outcomes_reached(self) -> int:
        """The number of outcomes of conditions that came about."""
        return len([count for each in self.conditions for count in (each.true, each.false) if count])

    @property
    def reached(self) -> int:
        """The number of statements that were reached, and of outcomes of conditions."""
        return self.statements_reached + self.outcomes_reached

    @property
    def total(self) -> int:
        """The number of statements, and of outcomes that conditions can have."""
        return len(self.statements) + 2 * len(self.conditions)


def coverage(
    structure: Structure, offsets: Iterable[int], counts: Mapping[Event, int], worlds: Sequence[str] = ("",)
) -> Coverage:
    """Return what events of runs mean for a program with statements at these offsets."""
    graph = Reachability(structure)
    reached = graph.reached
    begun = {at: counts.get((at, BEGINS, True), 0) for at in sorted(offsets) if at in reached}
    statements = [
        CoveredStatement(at, structure.line(at), structure.statements[at].text, count)
        for at, count in begun.items()
    ]
    parts = [
        CoveredPart(unit.kind, unit.name, unit.line, begun.get(_first(structure, unit.entry, begun), 0))
        for unit in structure.units
        if unit.kind != "program"
    ]
    source = structure.source
    outcomes = [each for each in _outcomes(structure, counts) if each.at in reached]
    return Coverage(source.name, source, worlds, statements, outcomes, parts, graph.unreached_lines)


def _outcomes(structure: Structure, counts: Mapping[Event, int]) -> Iterator[CoveredCondition]:
    """Yield the conditions of a program in the order of its text; what a task waits for is none."""
    found: dict[tuple[int, int], CoveredCondition] = {}
    for _, points in groupby(structure.points, lambda point: point.key[0]):
        steps = [Step(each.kind, _nothing if each.branches else None, at=each.at) for each in points]
        for pc, number in conditions(steps):
            at = steps[pc].at
            statement = structure.statements.get(at)
            if statement is not None and not statement.waits:
                true, false = (counts.get((at, number, holds), 0) for holds in (True, False))
                text = statement.condition or statement.text
                found[at, number] = CoveredCondition(at, statement.line, text, true, false)
    yield from (found[key] for key in sorted(found))


def _first(structure: Structure, entry: int, statements: Container[int]) -> int:
    points, seen = structure.points, set[int]()
    while entry not in seen and points[entry].at not in statements and points[entry].next:
        seen.add(entry)
        entry = points[entry].next[0]
    return points[entry].at


def covered(
    program: str | Source, *, dialect: str | Dialect | None = None, until: float | None = None
) -> Coverage:
    """Run a program in its own world and in all its scenarios; return what the runs have reached together.

    Raises OSError if a file cannot be read, and ProgramError if the program or a machine file has errors.
    """
    source = program if isinstance(program, Source) else Source.read(program)
    language = dialect_for(source, dialect)
    worlds = worlds_of(program)
    events: Counter[Event] = Counter()
    own = language.program(source, worlds[""], is_debug=True)
    runs = Worlds(own, language)
    cut = []
    for name, settings in worlds.items():
        try:
            events += runs.run(settings, until).events
        except CutOff as at:
            events += at.events
            cut.append(name)
            break
    found = replace(coverage(own.structure, own.offsets, events, list(worlds)), cut=cut)
    return found if isinstance(program, Source) else replace(found, file=program)


def worlds_of(program: str | Source) -> dict[str, dict[str, object]]:
    """Return the settings of a program's own world, "", and those of its scenarios, by path."""
    found = {"": dict(settings_next_to(program))}
    if isinstance(program, Source):
        return found
    return found | {path: Scenario(program, path).settings for path in scenario_files(program)}


def _nothing(values: Values) -> None:
    pass
