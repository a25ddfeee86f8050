"""The time profile of a run: tasks, critical path by line, sub and cause, slack."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import fsum
from operator import attrgetter
from typing import Any

from motionlang.commands.profile.critical_path import About, CriticalPath, Link, grouped
from motionlang.commands.profile.motions import Motions
from motionlang.commands.profile.tasks import TaskTime, Wait, parent_of, reported, task_times
from motionlang.kernel import Run
from motionlang.kernel.log import Waited
from motionlang.kernel.tools import exact_terms

# The root of all calls, which contains the lines outside subs.
PROGRAM = "the program"


@dataclass(eq=False, slots=True)
class Share:
    """Seconds of the path due to one line, sub or axis; `total` includes its calls."""

    name: str
    line: int
    seconds: float
    total: float
    causes: dict[str, float]


class TimeProfile:
    """The time profile of a run; all sums are exact."""

    def __init__(self, run: Run) -> None:
        self.run = run
        self._chain = CriticalPath(run)
        self._waits = self._chain.waits
        self._positions = self._chain.positions
        self._groups = _summed(self._chain.grouped())

    def __getstate__(self) -> dict[str, object]:
        """Return the figures without the run, which is a living machine."""
        figures = {name: getattr(self, name) for name in ("tasks", "has_tasks", "_slacks")}
        return {**vars(self), **figures, "run": None}

    @cached_property
    def tasks(self) -> list[TaskTime]:
        return task_times(self.run, self._waits)

    @cached_property
    def has_tasks(self) -> bool:
        """True if there are tasks in addition to the parent."""
        return bool(self._waits.keys() - {parent_of(self.run)}) or bool(self.run.machine.log.slices)

    def waits(self) -> dict[str, Iterator[Waited]]:
        """Return the waits of each task in order of time, including loops that waited."""
        return {name: map(Waited._make, reported(waits)) for name, waits in self._waits.items()}

    @property
    def links(self) -> list[Link]:
        """The links of the critical path, from the start of the run to its end."""
        return self._chain.links

    def spans(self) -> list[tuple[float, float, About]]:
        """Return times and shared fields of the links, without creating `Link` objects."""
        return self._chain.spans()

    @property
    def seconds(self) -> float:
        """The length of the critical path, which is the time of the run."""
        return fsum(term for _, terms in self._groups for term in terms)

    def lines(self) -> list[Share]:
        """Return the path by line of the program, the longest first."""
        return self._shares(lambda link: ((str(link.position.line), link.position.line),), own=True)

    def subs(self) -> list[Share]:
        """Return the path by sub: `seconds` in the sub itself, `total` with its calls.

        Lines outside all subs belong to the program.
        """
        positions = self._positions

        def names(link: Link) -> Iterable[tuple[str, int]]:
            yield link.position.sub or PROGRAM, 0
            for line in reversed(link.position.callers):
                yield positions.sub(line) or PROGRAM, 0
            yield PROGRAM, 0

        return self._shares(names)

    def kinds(self) -> list[Share]:
        """Return the path by kind: travel by axes, dwells, waits, computing."""
        return self._shares(lambda link: ((_kind(link), 0),), own=True)

    def waited_lines(self) -> list[Share]:
        """Return the path by the line at which a task waited; `causes` splits it by kind."""
        lines = self._shares(lambda link: ((str(link.waited), link.waited),), own=True, cause=_kind)
        return [share for share in lines if share.line]

    def slacks(self) -> list[Slack]:
        """Return which axis finished early although a task waited for several axes.

        The axes had begun together.
        """
        return self._slacks

    @cached_property
    def _slacks(self) -> list[Slack]:
        return slacks(self._chain.motions, self._waits)

    def sub(self, line: int) -> str:
        """Return the sub that contains a line, "" for none."""
        return self._positions.sub(line)

    def total(self, links: Iterable[Link]) -> float:
        """Return the total duration of some links, seconds."""
        return fsum(link.duration for link in links)

    def shares_of(self, links: Iterable[Link]) -> list[Share]:
        """Return some links by line, the longest first, without links that have no line."""
        made = self._shares(lambda link: ((str(link.position.line), link.position.line),), True, links)
        return [share for share in made if share.line]

    def _shares(
        self,
        names: Any,
        own: bool = False,
        links: Iterable[Link] | None = None,
        cause: Callable[[Link], str] = attrgetter("cause"),
    ) -> list[Share]:
        """Return the path grouped by the names of each link.

        A link counts towards the own time of its first name, and towards the total of all of them.
        """
        mine: dict[str, dict[str, list[float]]] = {}
        totals: dict[str, list[float]] = {}
        lines: dict[str, int] = {}
        for link, terms in self._groups if links is None else _summed(grouped(links)):
            for k, (name, line) in enumerate(dict.fromkeys(names(link))):
                lines[name] = line
                causes = mine.setdefault(name, {})
                if k == 0:
                    causes.setdefault(cause(link), []).extend(terms)
                totals.setdefault(name, []).extend(terms)
        shares = [
            Share(
                name,
                lines[name],
                fsum(term for terms in causes.values() for term in terms),
                fsum(totals[name]),
                {cause: fsum(terms) for cause, terms in causes.items()},
            )
            for name, causes in mine.items()
        ]
        return sorted(
            shares, key=lambda share: (-(share.seconds if own else share.total), share.line, share.name)
        )


def _summed(links: Iterable[tuple[Link, list[float]]]) -> list[tuple[Link, list[float]]]:
    """Replace many durations of a link by a few terms with the same exact sum."""
    return [(link, exact_terms(times)) for link, times in links]


def _kind(link: Link) -> str:
    if not link.is_motion:
        return link.cause
    axes = ", ".join(map(str, link.axes))
    return f"travel of axis {axes}" if len(link.axes) == 1 else f"travel of axes {axes}"


@dataclass(eq=False, slots=True)
class Slack:
    """Slack: how much longer `axis` could take without delaying the cycle.

    It was at rest while `other` still moved.
    """

    axis: int
    other: int
    seconds: float


def slacks(motions: Motions, waits: Mapping[str, Sequence[Wait]]) -> list[Slack]:
    """Return the slacks, the longest first, where a task waited for several axes.

    The axes had begun together, and the task waited for the last one.
    """
    waited: set[int] = set()  # in milliseconds
    for mine in waits.values():
        waited.update([int(wait[3] * 1000.0) for wait in mine if wait[4] != "time"])
    found: dict[tuple[int, int], list[float]] = defaultdict(list)
    for moves in motions.together():
        last = next(move for move in moves if move.end == moves[-1].end)
        if not waited.isdisjoint((int(last.end * 1000.0), int(last.end * 1000.0) + 1)):
            for move in moves:
                if move is not last:
                    found[move.axes[0], last.axes[0]].append(last.end - move.end)
    rows = [Slack(axis, other, fsum(times)) for (axis, other), times in found.items() if any(times)]
    return sorted(rows, key=lambda row: (-row.seconds, row.axis, row.other))
