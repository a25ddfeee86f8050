"""The time of each task: computing, waiting and ready, which add up to its life.

A single task has the processor whenever it does not wait. If several run, the log records which of them
computed between waits. For the rest of its life a task was ready while others had the processor, or its polls
without effect were skipped. A handler is never ready: the time between its calls is no part of its life.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby
from math import fsum
from operator import itemgetter

from motionlang.kernel import Run
from motionlang.kernel.lang import MOVING
from motionlang.kernel.log import Log

# A `Waited` as written.
Wait = tuple[str, int, float, float, str, tuple[int, ...], str, tuple[int, ...]]


# Skipped iterations of a run whose waits are listed one by one.
MAX_REPEATED = 100_000


@dataclass(eq=False, slots=True)
class TaskTime:
    """The time of one task, in seconds.

    It splits into `waiting` by cause, `computing`, and `ready` while other tasks computed. These add up to the time
    from `begin` to `end`, without that between the end of a task and its next start. A handler is there for the
    whole program; its times are those of its calls while there was more than one task.
    """

    name: str
    begin: float
    end: float
    waiting: dict[str, float]
    computing: float
    ready: float

    @property
    def life(self) -> float:
        """The sum of these times, seconds."""
        return fsum((*self.waiting.values(), self.computing, self.ready))


def reported(waits: Iterable[Wait]) -> Iterator[Wait]:
    """Yield waits in the form of the report.

    A wait that ended while its axis was in motion is reported as a wait for that axis.
    """
    for wait in waits:
        yield (*wait[:4], "axis", *wait[5:]) if wait[4] == MOVING else wait


def all_waits(run: Run) -> dict[str, list[Wait]]:
    """Return the waits of each task in order of time, with those open at the end.

    Those of skipped iterations are among them.
    """
    found: dict[str, list[Wait]] = {}
    for name, waits in groupby(_waits(run.machine.log), itemgetter(0)):
        found.setdefault(name, []).extend(waits)
    scheduler = run.machine.scheduler
    for task in (*scheduler.tasks, *scheduler.interrupts) if scheduler is not None else ():
        current, mine = task.wait, found.setdefault(task.name, [])
        if current is not None and current.since < run.time:
            *callers, at = task.stack
            about = current.cause, tuple(current.what), current.why, tuple(callers)
            mine.append((task.name, at, current.since, run.time, *about))
    return found


def _waits(log: Log) -> Iterator[Wait]:
    """Yield all waits.

    If more than `MAX_REPEATED` are of skipped iterations, those of several are one, as long as all of these.
    """
    ends: dict[str, float] = {}
    for wait, count in log.waits.condensed(MAX_REPEATED):
        if count > 1:
            since = max(wait.since, ends.get(wait.task, wait.since))
            ends[wait.task] = until = since + count * (wait.until - wait.since)
            wait = wait._replace(since=since, until=until)
        yield wait


def parent_of(run: Run) -> str:
    """Return the name of the task whose end is the end of the program."""
    return run.machine.scheduler.parent.name if run.machine.scheduler is not None else ""


def ended_at(run: Run) -> float:
    """Return when the program ended, or the end of the run if it had not ended.

    Motion may have continued after that.
    """
    scheduler = run.machine.scheduler
    return run.time if scheduler is None or scheduler.ended is None else scheduler.ended


def task_times(run: Run, waits: dict[str, list[Wait]]) -> list[TaskTime]:
    """Return the time of each task, given its `waits`.

    The parent comes first, then the others in order of their start.
    """
    parent, over, slices = parent_of(run), ended_at(run), run.machine.log.slices
    computed: dict[str, list[float]] = {}
    alone: list[tuple[float, float]] = []  # when the parent was
    for each in slices.up_to(run.time):
        if not each.tasks:
            alone.append((each.time, min(each.until, over)))
        for name, seconds in zip(each.tasks, each.seconds, strict=True):
            computed.setdefault(name, []).append(seconds)
    made = []
    for name in dict.fromkeys((parent, *slices.lives, *computed, *waits)):
        begin, end, lived = 0.0, over, over
        life = slices.lives.get(name)
        if life is not None:
            begin, end, lived = life.begin, life.end, life.lived
            if life.since is not None:
                end, lived = over, lived + over - life.since
        causes = _by_cause(run, waits.get(name, []), end)
        rest = max(fsum((lived, *(-time for time in causes.values()))), 0.0)
        computing = fsum(computed.get(name, ()))
        if name == parent:
            phases = fsum(until - since for since, until in alone) - _within(waits.get(name, []), alone)
            computing = computing + phases if slices else rest
        computing = min(computing, rest)
        is_handler = life is None and name != parent
        ready = 0.0 if is_handler else fsum((rest, -computing))
        made.append(TaskTime(name, begin, end, causes, computing, ready))
    return made


def _by_cause(run: Run, waits: list[Wait], end: float) -> dict[str, float]:
    """Return for how long a task waited for each cause, until its end."""
    times: dict[str, list[float]] = defaultdict(list)
    statements = run.program.structure.statements if run.program is not None else {}
    for _, at, since, until, cause, axes, _, _ in reported(waits):
        if since < end:
            statement = statements.get(at) if cause == "condition" else None
            if statement is not None and statement.waits:
                cause, axes = statement.waits, statement.what
            times[_named(cause, axes)].append((until if until < end else end) - since)
    return {cause: fsum(each) for cause, each in times.items()}


def _named(cause: str, axes: Sequence[int]) -> str:
    if cause != "axis" or not axes:
        return cause
    return f"{'axis' if len(axes) == 1 else 'axes'} {' and '.join(map(str, axes))}"


def _within(waits: list[Wait], phases: list[tuple[float, float]]) -> float:
    """Return for how long waits lasted within some phases, both in order of time."""
    lengths, first = [], 0
    for _, _, since, until, *_ in waits:
        while first < len(phases) and phases[first][1] <= since:
            first += 1
        for began, ended in phases[first:]:
            if began >= until:
                break
            lengths.append(min(until, ended) - max(since, began))
    return fsum(lengths)
