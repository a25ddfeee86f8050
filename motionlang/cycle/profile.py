"""The time profile of a run: its tasks, its critical chain by line, sub and cause, and which axis waits for which."""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from itertools import pairwise
from math import fsum
from operator import sub
from typing import TYPE_CHECKING, Any, NamedTuple

from motionlang.cycle.chain import Chain, Link, alike
from motionlang.cycle.tasks import TaskTime, kept_waits, task_times
from motionlang.profile.total import exact_terms

if TYPE_CHECKING:
    from collections.abc import Iterable

    from motionlang.result import Run

SCHEMA = "motionlang.cycle/1"
# What calls everything, and has what stands in no sub.
PROGRAM = "the program"


class Share(NamedTuple):
    """Seconds of the chain that belong together: of a line, a sub or an axis; `total` has what it called, too."""

    name: str
    line: int
    seconds: float
    total: float
    causes: dict[str, float]


class Slack(NamedTuple):
    """`axis` had ended its move and stood while `other` still moved: the seconds that it could have been slower."""

    axis: int
    other: int
    seconds: float


class TimeProfile:
    """Where the time of a run went; all sums are exact."""

    def __init__(self, run: Run) -> None:
        self.run = run
        self._waits = kept_waits(run)
        self.tasks: list[TaskTime] = task_times(run, self._waits)
        self._chain = Chain(run, self._waits)
        self._places = self._chain.places
        self._alike = _summed(self._chain.alike())

    @property
    def links(self) -> list[Link]:
        """The stretches of the chain, from the begin of the run to its end."""
        return self._chain.links

    @property
    def seconds(self) -> float:
        """What the chain adds up to: the run's time."""
        return fsum(term for _, terms in self._alike for term in terms)

    def lines(self) -> list[Share]:
        """The chain by the lines of the program, the longest first."""
        return self._shares(lambda link: ((str(link.place.line), link.place.line),), own=True)

    def subs(self) -> list[Share]:
        """By sub: `seconds` in the sub itself, `total` with what it called. What stands in none is the program."""

        places = self._places

        def names(link: Link) -> Iterable[tuple[str, int]]:
            yield link.place.sub or PROGRAM, 0
            for line in reversed(link.place.callers):
                yield places.sub(line) or PROGRAM, 0
            yield PROGRAM, 0

        return self._shares(names)

    def kinds(self) -> list[Share]:
        """By what takes the time: travel of which axes, dwells, waits, computing."""

        def name(link: Link) -> str:
            if link.is_motion:
                axes = ", ".join(map(str, link.axes))
                return f"travel of axis {axes}" if len(link.axes) == 1 else f"travel of axes {axes}"
            return link.cause

        return self._shares(lambda link: ((name(link), 0),), own=True)

    def slacks(self) -> list[Slack]:
        """Who stood and waited for whom, where a task waited for several axes that had begun together."""
        waited = {  # in milliseconds
            int(until * 1000.0)
            for waits in self._waits.values()
            for _, _, _, until, cause, _, _, _ in waits
            if cause != "time"
        }
        motions, cuts = self._chain.motions.together()
        ends = [motion[0] for motion in motions]
        axes = tuple([axis for _, _, _, _, (axis,), _ in motions])
        # By the axes of a group, and how many of them had ended before the last: when they ended, group after group.
        groups: dict[tuple[tuple[int, ...], int], list[float]] = {}
        for low, high in pairwise(cuts):
            last = ends[high - 1]
            if ends[low] < last:
                millis = int(last * 1000.0)
                if millis in waited or millis + 1 in waited:
                    kind = axes[low:high], bisect_left(ends, last, low, high) - low
                    times = groups.get(kind)
                    if times is None:
                        groups[kind] = ends[low:high]
                    else:
                        times += ends[low:high]
        found: dict[tuple[int, int], list[float]] = defaultdict(list)
        for (group, stood), times in groups.items():
            for k in range(stood):
                found[group[k], group[stood]] += map(sub, times[stood :: len(group)], times[k :: len(group)])
        rows = [Slack(axis, other, fsum(times)) for (axis, other), times in found.items()]
        return sorted(rows, key=lambda row: (-row.seconds, row.axis, row.other))

    def report(self) -> dict[str, Any]:
        """The profile as plain data, schema `motionlang.cycle/1`."""
        return {
            "schema": SCHEMA,
            "program": self.run.source.name,
            "time": self.run.time,
            "tasks": [task._asdict() for task in self.tasks],
            "kinds": [share._asdict() for share in self.kinds()],
            "lines": [share._asdict() for share in self.lines()],
            "subs": [share._asdict() for share in self.subs()],
            "slack": [slack._asdict() for slack in self.slacks()],
            "chain": [
                {
                    "begin": link.begin,
                    "end": link.end,
                    "cause": link.cause,
                    "line": link.place.line,
                    "sub": link.place.sub,
                    "callers": link.place.callers,
                    "task": link.task,
                    "axes": link.axes,
                }
                for link in self.links
            ],
        }

    def sub(self, line: int) -> str:
        """The sub that a line stands in, "" for none."""
        return self._places.sub(line)

    def total(self, links: Iterable[Link]) -> float:
        """The seconds of some of the chain."""
        return fsum(link.duration for link in links)

    def shares_of(self, links: Iterable[Link]) -> list[Share]:
        """Some of the chain by line, the longest first; what has no line left out."""
        made = self._shares(lambda link: ((str(link.place.line), link.place.line),), True, links)
        return [share for share in made if share.line]

    def _shares(self, names: Any, own: bool = False, links: Iterable[Link] | None = None) -> list[Share]:
        """The chain by the names that a link has: the first has it for its own, all of them have it in their totals."""
        mine: dict[str, dict[str, list[float]]] = {}
        totals: dict[str, list[float]] = {}
        lines: dict[str, int] = {}
        for link, terms in self._alike if links is None else _summed(alike(links)):
            for k, (name, line) in enumerate(dict.fromkeys(names(link))):
                lines[name] = line
                causes = mine.setdefault(name, {})
                if k == 0:
                    causes.setdefault(link.cause, []).extend(terms)
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
    """Links with a few terms in place of their many durations, which add up to the very same."""
    return [(link, exact_terms(times)) for link, times in links]
