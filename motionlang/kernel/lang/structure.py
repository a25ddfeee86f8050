"""The facts of a program, described alike for both languages: statements, units, and the graph of its steps.

A language fills them from a program that it has checked (`Program.structure`), and whoever asks what a program says
reads them: the linters, the map, the coverage, `improve` and `init`.

    statements   by source offset: text, what they read and write, what a task waits for at them
    graph        all steps of all lists of steps, with those that may follow each (`step_graph.py`)
    units        the program, subs, tasks, handlers, labels that a Gosub calls, macros: where each begins in the graph
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.step_graph import GraphPoint, StepGraph
from motionlang.kernel.lang.steps import STOP
from motionlang.kernel.lang.wait_analysis import WaitAnalysis
from motionlang.kernel.source import Source

# The kinds of access to a channel or a variable.
READ, WRITE, SET_UP = "read", "write", "set up"
# The channels by which a program reads digital inputs.
INPUTS = ("input", "input bank")
# Marks a name of the program in the form of a statement.
NAME = "~"
# The effects of a statement: it only leads elsewhere or defines something, it only prints, it says how the program
# starts, which no run shows, or it has any other.
LEADS, PRINTS, STARTS, ACTS = "leads", "prints", "starts", "acts"
# The axis of a use: its number, the parameter of a sub that holds it, None if it is unknown or if all are meant.
AxisKey = int | str | None


class Written(NamedTuple):
    """A value that a statement writes: its text, "" if it is omitted, and its value if that is known before the run."""

    text: str
    value: float | str | None = None

    @property
    def number(self) -> float | None:
        """The value, if it is a known number."""
        return self.value if isinstance(self.value, (int, float)) else None


@dataclass(eq=False, slots=True)
class Use:
    """One use of a keyword by a statement, or one call of a unit.

    `role` is "read"; for any other use one of `keyword.ROLES`, or "slot" for a property of moves, or "use"; "call" for
    the call of the unit `callee`. `at` is the offset of the name. `axes` are the axes that the keyword names, none for
    a keyword without axes. `numbers` are those in its brackets, None if unknown. `values` are what is written,
    `arguments` the axes that the arguments of a call may be.
    """

    role: str
    row: Keyword | None
    at: int
    axes: tuple[AxisKey, ...] = ()
    values: Sequence[Written] = ()
    callee: str = ""
    arguments: tuple[AxisKey, ...] = ()
    numbers: tuple[int | None, ...] = ()

    def value(self, number: int) -> Written:
        """Return the value for the n-th axis; the last value applies to all further axes."""
        return self.values[min(number, len(self.values) - 1)] if self.values else _NOTHING

    def of_axis(self, number: int) -> Written:
        """Return the value for the n-th axis, with all further ones for the last, which may stand for those of AXES."""
        left = self.values[number:] if number == len(self.axes) - 1 else ()
        if len(left) < 2:
            return self.value(number)
        known = None if any(each.number is None for each in left) else left[0].value
        return Written(", ".join(each.text for each in left), known)

    def number(self, number: int) -> float | None:
        """Return the value for the n-th axis, None if it is unknown before the run."""
        return self.value(number).number


_NOTHING = Written("")


def role_of(row: Keyword, access: str) -> str:
    """Return the role of a keyword that a statement reads or writes."""
    return "read" if access == READ else row.role or ("slot" if row.gives else "use")


@dataclass(eq=False, slots=True)
class ChannelUse:
    """One access of a statement to a channel.

    `channel` is one of `keyword.CHANNELS`. `number` is the text of its number, such as "3" or "1, 5" for several
    indices, "?" if it is known only at run time. `alias` is the name that the program has for it, "" if none. `value`
    is what is written, as in the program; its `unit` is "ms" for a pulse. `name_at` is the offset of the keyword, -1 if
    it has none.
    """

    channel: str
    number: str
    access: str
    at: int
    alias: str = ""
    value: str = ""
    name_at: int = -1
    unit: str = ""


@dataclass(eq=False, slots=True)
class AxisUse:
    """One command or setting of a statement for one axis.

    `axis` is None if it is known only at run time or if all are meant. `value` is the text of what is written,
    `known` its value if that is known before the run.
    """

    axis: int | None
    row: Keyword
    at: int
    value: str = ""
    known: float | str | None = None

    @property
    def number(self) -> float | None:
        """The value, if it is a known number."""
        return self.known if isinstance(self.known, (int, float)) else None


@dataclass(eq=False, slots=True)
class Statement:
    """A statement, or the head of a block.

    `condition` is the text of what it tests, "" if it tests nothing. `waits` is one of `record.records.CAUSES` if a
    task waits at it, and `what` has the numbers of the axes that it waits for. `is_silent` is True for a declaration
    and the like, `select` is the offset of the Select of a Case, -1 for any other statement.
    `starts` and `ends` are the tasks that it starts and ends. `form` is a text that all spellings of the statement
    share, in which `NAME` marks the names of the program. In `normal` comparisons that are equal for every value are
    one, too; it is "" if it is the form. `effect` is one of `LEADS`, `PRINTS`, `STARTS` and `ACTS`.
    """

    at: int
    line: int
    text: str
    form: str = ""
    normal: str = ""
    effect: str = ACTS
    condition: str = ""
    waits: str = ""
    what: tuple[int, ...] = ()
    is_silent: bool = False
    select: int = -1
    uses: list[Use] = field(default_factory=list)
    channels: list[ChannelUse] = field(default_factory=list)
    starts: list[str] = field(default_factory=list)
    ends: list[str] = field(default_factory=list)

    @property
    def axes(self) -> list[AxisUse]:
        """The commands and settings for axes, each for one of them."""
        return [
            AxisUse(axis if isinstance(axis, int) else None, use.row, self.at, *use.of_axis(k))
            for use in self.uses
            if use.row is not None and use.row.topic and use.role != "read" and use.row.access != "R"
            for k, axis in enumerate(use.axes)
            if not use.values or use.value(k).text
        ]

    @property
    def moves(self) -> bool:
        """True if it commands motion."""
        return any(use.row.topic == "move" for use in self.axes)

    @property
    def outputs(self) -> set[int]:
        """The outputs with a known number that it may switch on."""
        written = [use for use in self.channels if use.channel == "output" and use.access == WRITE]
        return {int(use.number) for use in written if use.value != "0" and use.number.isdecimal()}


@dataclass(eq=False, slots=True)
class Unit:
    """A part of a program that is started or called by itself.

    `kind` is "program", "sub", "function", "task", "event", "subroutine" (a label that a Gosub calls) or "macro".
    `head` is the form of its parameters, or the name of a handler. `triggers` are the channels that start a handler;
    one that `is_timed` is started by time alone. `line` is 0 for the program.
    """

    name: str
    kind: str
    line: int
    entry: int
    triggers: Sequence[ChannelUse] = ()
    is_timed: bool = False
    head: str = ""

    @property
    def title(self) -> str:
        """Its kind and name, such as "sub Fill"."""
        return self.name if self.kind == "program" else f"{self.kind} {self.name}"


@dataclass(eq=False)
class Structure:
    """The structure of a program.

    `writes` maps the offset of each name of a variable that a statement assigns to, to the number, text or name that it
    assigns, as in the program, "" for anything else; an element of an array has its index first. `variables` are the
    names of the shared ones, by their numbers in `Uses`.
    """

    source: Source
    statements: Mapping[int, Statement]
    graph: StepGraph
    units: Sequence[Unit]
    writes: Mapping[int, str]
    variables: Mapping[int, str] = field(default_factory=dict)

    @cached_property
    def waits(self) -> WaitAnalysis:
        """The analysis of its waits and loops."""
        return WaitAnalysis(self)

    @property
    def points(self) -> Sequence[GraphPoint]:
        return self.graph.points

    @property
    def never_ends(self) -> bool:
        """True if no path through the text ends the program."""
        own = self.graph.reached_within(*(unit.entry for unit in self.units if unit.kind == "program"))
        known = self.graph.reached(*(unit.entry for unit in self.units))
        return all(self.graph.within[p] for p in own) and all(self.points[p].role != STOP for p in known)

    def inputs(self) -> Iterator[tuple[int, ChannelUse]]:
        """Yield the lines that read digital inputs or their banks, and those of handlers that inputs call."""
        for each in self.statements.values():
            yield from (
                (each.line, use) for use in each.channels if use.access == READ and use.channel in INPUTS
            )
        for unit in self.units:
            yield from ((unit.line, use) for use in unit.triggers if use.channel in INPUTS)

    def line(self, at: int) -> int:
        """Return the line of an offset."""
        return self.source.location(at)[0]

    def tasks(self) -> list[Unit]:
        """Return the program, its tasks, and the macros that are known to be started as tasks."""
        started = {name.lower() for each in self.statements.values() for name in each.starts}
        return [
            *(unit for unit in self.units if unit.kind in ("program", "task")),
            *(unit for unit in self.units if unit.kind == "macro" and unit.title.lower() in started),
        ]

    def owners(self, *, with_handlers: bool = False) -> dict[int, str]:
        """Return the lines that the program or a task carries out, each with the first of them that reaches it.

        A line that only a handler reaches has none, or that handler. A macro that nothing is known to start or call is
        of the program.
        """
        tasks = self.tasks()
        macros = [unit.entry for unit in self.units if unit.kind == "macro"]
        found: dict[int, str] = {}
        known: set[int] = set()
        units = [*tasks, *(unit for unit in self.units if with_handlers and unit.kind == "event")]
        entered = [(each.title, [each.entry]) for each in units]
        for owner, entries in [*entered[: len(tasks)], (tasks[0].title, macros), *entered[len(tasks) :]]:
            reached = self.graph.reached(*entries, known=known)
            known |= reached
            for at in sorted({self.points[p].at for p in reached}):
                statement = self.statements.get(at)
                if statement is not None and not statement.is_silent:
                    found.setdefault(statement.line, owner)
        return found
