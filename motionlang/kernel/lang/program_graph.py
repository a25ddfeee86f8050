"""The structure of a program, described alike for both languages: statements, units, and the graph of its steps.

A language fills a `Structure` from a program that it has checked (`Program.structure`). The map of a program
(`commands/map`) reads nothing else of the text.

    statements   by source offset: text, what they read and write, what a task waits for at them
    points       all steps of all lists of steps, with the points that may follow each
    units        the program, subs, tasks, handlers, labels that a Gosub calls, macros: where each begins in `points`

A point is identified by the name of its list of steps and its index there (`Point.key`). Another writing of the same
program, such as that of a run, has the same keys.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.steps import (
    BACK,
    BEGIN,
    BRANCH,
    CALL,
    END,
    ENTER,
    GO,
    JUMP,
    NOTE,
    NOW,
    RETURN,
    TURN,
    Steps,
)
from motionlang.kernel.lang.wait_causes import LoopDependencies
from motionlang.kernel.source import Source

# The kinds of access to a channel or a variable.
READ, WRITE, SET_UP = "read", "write", "set up"
# Steps at which nothing happens that a reader of the program sees.
SILENT = frozenset((NOW, JUMP, NOTE, TURN, BEGIN))


@dataclass(eq=False, slots=True)
class ChannelUse:
    """One access of a statement to a channel.

    `channel` is one of `keyword.CHANNELS`. `number` is the text of its number, such as "3" or "1, 5" for several
    indices, "?" if it is known only at run time. `alias` is the name that the program has for it, "" if none. `value`
    is what is written, as in the program. `name_at` is the offset of the keyword, -1 if it has none.
    """

    channel: str
    number: str
    access: str
    at: int
    alias: str = ""
    value: str = ""
    name_at: int = -1


@dataclass(eq=False, slots=True)
class AxisUse:
    """One command or setting of a statement for one axis.

    `axis` is None if it is known only at run time or if all are meant. `value` is the text of what is written,
    `number` its value if that is known before the run.
    """

    axis: int | None
    row: Keyword
    at: int
    value: str = ""
    number: float | None = None


@dataclass(eq=False, slots=True)
class Statement:
    """A statement, or the head of a block.

    `condition` is the text of what it tests, "" if it tests nothing. `waits` is one of `record.records.CAUSES` if a
    task waits at it, and `what` has the numbers of the axes that it waits for. `is_silent` is True for a declaration
    and the like, `select` is the offset of the Select of a Case, -1 for any other statement.
    `starts` and `ends` are the tasks
    that it starts and ends.
    """

    at: int
    line: int
    text: str
    condition: str = ""
    waits: str = ""
    what: tuple[int, ...] = ()
    is_silent: bool = False
    select: int = -1
    channels: list[ChannelUse] = field(default_factory=list)
    axes: list[AxisUse] = field(default_factory=list)
    starts: list[str] = field(default_factory=list)
    ends: list[str] = field(default_factory=list)


class Point(NamedTuple):
    """A step: its kind, the offset of its statement or -1, and the indices of the points that may follow it.

    The first one that follows a BRANCH or a BACK with a condition is that of a true condition. `calls` is the first
    point of what a CALL calls, -1 if it is unknown or if there is none.
    """

    key: tuple[str, int]
    kind: int
    at: int
    next: tuple[int, ...]
    calls: int = -1

    @property
    def is_silent(self) -> bool:
        """True if nothing happens here, and one point follows."""
        return self.kind in SILENT or (self.kind in (BACK, GO, ENTER) and len(self.next) == 1)

    @property
    def branches(self) -> bool:
        """True if more than one point may follow."""
        return len(self.next) > 1


@dataclass(eq=False, slots=True)
class Unit:
    """A part of a program that is started or called by itself.

    `kind` is "program", "sub", "function", "task", "event", "subroutine" (a label that a Gosub calls) or "macro".
    `triggers` are the channels that start a handler. `line` is 0 for the program.
    """

    name: str
    kind: str
    line: int
    entry: int
    triggers: Sequence[ChannelUse] = ()

    @property
    def title(self) -> str:
        """Its kind and name, such as "sub Fill"."""
        return self.name if self.kind == "program" else f"{self.kind} {self.name}"


@dataclass(eq=False, slots=True)
class Structure:
    """The structure of a program.

    `writes` are the offsets of the names of variables that a statement assigns to. `polls` maps the offset of a loop to
    the readings that it waits for, None if it waits for none. `has_one_series` is True if inputs and outputs have one
    series of numbers, so that an output can be read as an input is.
    """

    source: Source
    statements: Mapping[int, Statement]
    points: Sequence[Point]
    units: Sequence[Unit]
    writes: frozenset[int]
    polls: Callable[[int], LoopDependencies | None]
    has_one_series: bool = False

    def line(self, at: int) -> int:
        """Return the line of an offset."""
        return self.source.location(at)[0]


class Graph:
    """The points of several lists of steps.

    `add` appends a list and returns the index of its first point; `points` links them all.
    """

    def __init__(self) -> None:
        self._lists: list[tuple[Steps, int]] = []
        self._first: dict[int, int] = {}
        self._length = 0

    def add(self, steps: Steps) -> int:
        """Append the points of a list of steps."""
        self._first[id(steps)] = first = self._length
        self._lists.append((steps, first))
        self._length += len(steps)
        return first

    def index(self, steps: Steps, pc: int) -> int:
        """Return the index of a step; -1 if its list is not part of the graph."""
        first = self._first.get(id(steps), -1)
        return first + pc if first >= 0 else -1

    def points(
        self,
        inlined: Mapping[int, int] | None = None,
        computed: Callable[[Steps, int], Iterable[int]] | None = None,
    ) -> list[Point]:
        """Return all points.

        `inlined` maps the first point of a list that ends with a RETURN to the point that then follows. `computed`
        returns the steps that may follow a GO whose target is known only at run time.
        """
        found: list[Point] = []
        for steps, first in self._lists:
            after = (inlined or {}).get(first)
            for pc, step in enumerate(steps):
                following, called = self._following(steps, pc, after, computed)
                found.append(
                    Point(
                        (steps.name, pc),
                        _kind(step.kind, after),
                        step.at,
                        tuple(dict.fromkeys(following)),
                        called,
                    )
                )
        return found

    def _following(
        self,
        steps: Steps,
        pc: int,
        after: int | None,
        computed: Callable[[Steps, int], Iterable[int]] | None,
    ) -> tuple[list[int], int]:
        """Return the points that may follow a step, and the one that it calls."""
        first = self._first[id(steps)]
        step, following = steps[pc], first + pc + 1
        called = self.index(*steps.called[pc]) if pc in steps.called else -1
        if step.kind == JUMP:
            return [first + step.to], -1
        if step.kind == BRANCH:
            return [following, first + step.to], -1
        if step.kind == BACK:
            return [first + step.to, *([] if step.do is None else [following])], -1
        if step.kind == GO:
            to = [step.to] if step.to >= 0 else computed(steps, pc) if computed else ()
            return [first + each for each in to], -1
        if step.kind == ENTER:
            # The caller of inlined steps goes on after what they enter.
            return ([called], -1) if after is None and called >= 0 else ([first + len(steps) - 1], called)
        if step.kind == RETURN:
            return ([] if after is None else [after]), -1
        if step.kind == END:
            return [], -1
        return [following], called if step.kind == CALL else -1


def _kind(kind: int, after: int | None) -> int:
    """Return the kind of a step in a list that may be inlined."""
    if after is None:
        return kind
    return JUMP if kind == RETURN else CALL if kind == ENTER else kind
