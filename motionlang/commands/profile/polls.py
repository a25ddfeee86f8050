"""Loops in a profile: a polling loop is a wait for its cause, other loops compute.

A loop *waits* if an execution of it only reads, computes, sets outputs and lets time pass, and if the
conditions by which it ends read something other than its own variables. It waited for the last change of
what it reads: an axis came to rest, an input changed, or otherwise time passed or another task wrote a
variable. The rest of the loop after that change is charged to the loop itself: its WAITs, and computing.

A loop that also starts motion or waits in other ways *works*, and its actions are charged individually.
Between two such actions it may iterate like a state machine, which waits in the same way for anything that
one of its conditions reads.

A loop that reads nothing computes. Its time is charged to its own line, or to the line of the inner loop that
took the time.

The analysis uses only the log and the text of the program: when each loop ran, when motion ended and when
inputs changed.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from math import fsum, inf
from operator import itemgetter
from typing import Any

from motionlang.commands.profile.motions import Motions
from motionlang.commands.profile.tasks import Wait
from motionlang.kernel import Run
from motionlang.kernel.lang import KINDS, MOVING, ROUNDING, LoopDependencies, Read

# Task, position, begin, end, callers: the fields of `records.Looped`.
Row = tuple[str, int, float, float, tuple[int, ...]]

# Begin, end, position and callers of computing.
Span = tuple[float, float, int, tuple[int, ...]]

# When a wait was over, its cause, and the axes or channels.
Ended = tuple[float, str, tuple[int, ...]]

# Statements between a change and the end of the wait for it, if the loop has no WAIT of its own. A shorter
# stretch of a loop was no wait.
MIN_STATEMENTS = 100.0
_NOTHING = LoopDependencies(frozenset())
_SINCE: Callable[[Wait], float] = itemgetter(2)


class _Loop:
    """One execution of a loop: `items` are the waits in it, `inner` the loops.

    `acts` are the times at which it started motion, or waited for anything other than time.
    """

    def __init__(self, row: Row) -> None:
        _, self.at, self.since, self.until, self.callers = row
        self.items: list[Wait] = []
        self.acts: list[tuple[float, float]] = []
        self.inner: list[tuple[float, float]] = []


class Polls:
    """The waits of a run by task, including polling loops, and the computing in loops."""

    def __init__(self, run: Run, motions: Motions, waits: dict[str, list[Wait]]) -> None:
        self._run, self._motions = run, motions
        self._cost = run.machine.instruction_time
        self._dependencies: dict[int, LoopDependencies] = {}
        self._changes: dict[str, dict[int | None, list[float]]] | None = None
        self.waits = waits
        self.spans: dict[str, list[Span]] = {}
        loops = _loops(run)
        if loops:
            self._started = sorted((move.begin, move.line) for move in motions.moves)
            self.waits = dict(waits)
        for task, rows in loops.items():
            asking = {row[1] for row in rows}
            if any(
                dependencies.leaves or dependencies.within for dependencies in map(self.dependencies, asking)
            ):
                self.waits[task] = self._nested(task, rows, waits.get(task, []))
            spans = sorted(((row[2], -row[3], row) for row in reversed(rows)), key=itemgetter(0, 1))
            self.spans[task] = list(_innermost((row[2], row[3], row[1], row[-1]) for _, _, row in spans))

    def dependencies(self, at: int) -> LoopDependencies:
        """Return what the loop or the wait at a source offset reads."""
        found = self._dependencies.get(at)
        if found is None:
            assert self._run.program is not None
            found = self._dependencies[at] = self._run.program.structure.waits.at(at) or _NOTHING
        return found

    # ------------------------------------------------------------------------------------------- nesting

    def _nested(self, task: str, rows: list[Row], waits: list[Wait]) -> list[Wait]:
        """Return the waits of a task, with its loops resolved from the innermost outwards."""
        each: list[tuple[float, float, int, Row | Wait]] = [
            (row[2], -row[3], 0, row) for row in reversed(rows)
        ]
        each += [(wait[2], -wait[3], 1, wait) for wait in waits]
        each.sort(key=itemgetter(0, 1, 2))
        around: list[_Loop] = []
        whole = _Loop((task, 0, 0.0, self._run.time, ()))
        for since, end, is_wait, row in each:
            while around and around[-1].until < max(-end, since + ROUNDING) - ROUNDING:
                self._close(task, around, whole)
            if is_wait:
                wait: Any = row
                owner = around[-1] if around else whole
                owner.items.append(wait)
                if wait[4] != "time":
                    owner.acts.append((wait[2], wait[3]))
            else:
                around.append(_Loop(row))  # type: ignore[arg-type]
        while around:
            self._close(task, around, whole)
        return whole.items

    def _close(self, task: str, around: list[_Loop], whole: _Loop) -> None:
        loop = around.pop()
        outer = around[-1] if around else whole
        dependencies = self.dependencies(loop.at)
        if dependencies.leaves or dependencies.within:
            loop.acts += [
                (begin, begin) for begin in self._starts(dependencies.lines, loop.since, loop.until)
            ]
            if dependencies.leaves and not loop.acts:
                stretch = loop.since, loop.until
                loop.items = self._wait(
                    task,
                    loop,
                    dependencies,
                    stretch,
                    dependencies.leaves,
                    not dependencies.counts,
                    loop.items,
                )
            elif dependencies.within:
                self._between(task, loop, dependencies)
        outer.items += loop.items
        outer.acts += loop.acts
        outer.inner.append((loop.since, loop.until))

    def _between(self, task: str, loop: _Loop, dependencies: LoopDependencies) -> None:
        """Find the waits of a working loop, between its actions."""
        items, inner = sorted(loop.items, key=_SINCE), sorted(loop.inner)
        made: list[Wait] = []
        begin, index, number = loop.since, 0, 0
        for act, over in [*sorted(loop.acts), (loop.until, loop.until)]:
            first, index = index, _up_to(items, index, act, _SINCE)
            stretch = items[first:index]
            lower, number = number, _up_to(inner, number, act, itemgetter(0))
            if act - begin > MIN_STATEMENTS * self._cost + ROUNDING and _iterates(
                stretch, inner[lower:number], begin, act
            ):
                stretch = self._wait(
                    task, loop, dependencies, (begin, act), dependencies.within, False, stretch
                )
            first, index = index, _up_to(items, index, over, _SINCE)
            passed = stretch + items[first:index]
            made += passed
            # A move that was buffered may start during a WAIT, or while an inner loop waits.
            ends = [wait[3] for wait in passed] + [until for _, until in inner[lower:number]]
            begin = max([begin, over, *ends])
        loop.items = made + items[index:]

    def _wait(
        self,
        task: str,
        loop: _Loop,
        dependencies: LoopDependencies,
        stretch: tuple[float, float],
        reads: frozenset[Read],
        whole: bool,
        items: list[Wait],
    ) -> list[Wait]:
        """Return one wait for the loop up to its cause, in place of the `items`.

        The items after the cause are returned too.
        """
        begin, end = stretch
        longest = max((wait[3] - wait[2] for wait in items), default=0.0)
        late = MIN_STATEMENTS * self._cost + 2.0 * longest + ROUNDING
        found = self._ended(reads, begin, end, late, whole)
        if found is None or (dependencies.counts and end - found[0] > late):
            return items
        over, cause, what = found
        after = [wait for wait in items if wait[3] > over]
        if after and after[0][2] < over:
            after[0] = (*after[0][:2], over, *after[0][3:])
        if cause != "time":
            loop.acts.append((begin, over))
        return [(task, loop.at, begin, over, cause, what, dependencies.why, loop.callers), *after]

    # --------------------------------------------------------------------------------------- causes

    def _ended(
        self, reads: frozenset[Read], begin: float, end: float, late: float, whole: bool
    ) -> Ended | None:
        """Return what ended a wait that polls `reads`.

        The cause lies at most `late` before the end of the wait if other causes are possible. With `whole`
        the loop itself ended; without it, only a section of the loop ended, which did not necessarily wait
        for anything.
        """
        near = end + 2.5 * self._cost + ROUNDING
        found = [
            (min(moment, end), KINDS[kind], () if number is None else (number,))
            for kind, number in sorted(reads, key=str)
            if (moment := self._changed(kind, number, begin, near)) is not None
        ]
        last = max(found, key=itemgetter(0), default=None)
        if last is not None and (end - last[0] <= late):
            return last
        for kind, number in sorted(reads, key=str):
            if kind in ("position", "following"):
                axis = self._motions.moving_at(number, end)
                if axis is not None:
                    return end, MOVING, (axis,)
        others = [
            kind
            for kind in ("time", "task", "operator", "host", "encoder", "latch", "other")
            if _has(reads, kind)
        ]
        if others and (whole or others[0] == "time"):
            return end, KINDS[others[0]], ()
        if last is not None or not whole:
            return last
        if end >= self._run.time - ROUNDING:
            return end, "condition", ()  # the run was cut short: nothing has ended it
        numbers = {number for kind, number in reads if KINDS[kind] == "input"}
        if not numbers:
            return end, "condition", ()  # an axis that follows another one, or is not yet settled
        return end, "input", tuple(sorted(number for number in numbers if number is not None))

    def of_condition(self, wait: Wait, end: float) -> Ended | None:
        """Return what ended a wait for a condition."""
        reads = self.dependencies(wait[1]).leaves
        late = 2.5 * self._cost + ROUNDING
        return self._ended(reads, wait[2], end, late, True) if reads else None

    def _changed(self, kind: str, number: int | None, begin: float, end: float) -> float | None:
        """Return when something last changed after `begin` and up to `end`."""
        if KINDS[kind] == "axis":
            return self._motions.last_end(number, begin, end)
        if self._changes is None:
            log = self._run.controller.log
            self._changes = {"input": _by_channel(log.inputs), "analogue": _by_channel(log.analogue_inputs)}
        times = self._changes.get(kind, {}).get(number, [])
        index = bisect_right(times, end) - 1
        return times[index] if index >= 0 and times[index] > begin else None

    def _starts(self, lines: frozenset[int], begin: float, end: float) -> list[float]:
        first = bisect_left(self._started, (begin + ROUNDING,))
        last = bisect_left(self._started, (end - ROUNDING,))
        return [start for start, line in self._started[first:last] if line in lines]


def _has(reads: frozenset[Read], kind: str) -> bool:
    return any(each == kind for each, _ in reads)


def _loops(run: Run) -> dict[str, list[Row]]:
    """Return the loops of each task, including those still running at the end."""
    found: dict[str, list[Row]] = {}
    for row in run.machine.log.loops:
        found.setdefault(row[0], []).append(row)
    scheduler = run.machine.scheduler
    for task in (*scheduler.tasks, *scheduler.interrupts) if scheduler is not None else ():
        for at, since, callers in reversed(task.loops):
            if since < run.time:
                found.setdefault(task.name, []).append((task.name, at, since, run.time, callers))
    return found


def _up_to(rows: list[Any], index: int, time: float, since: Callable[[Any], float]) -> int:
    """Return the index of the first row, from `index` on, that is not before `time`."""
    while index < len(rows) and since(rows[index]) < time:
        index += 1
    return index


def _iterates(waits: list[Wait], loops: list[tuple[float, float]], begin: float, end: float) -> bool:
    """True if a loop iterated from `begin` to `end`.

    A single WAIT or a single inner loop does not count as an iteration.
    """
    inside = fsum(min(until, end) - since for since, until in loops)
    times = Counter(wait[1] for wait in waits)
    return inside < 0.5 * (end - begin) and all(count > 1 for count in times.values())


def _by_channel(changes: Iterable[object]) -> dict[int | None, list[float]]:
    """Return the times at which each channel changed; None has those of all channels."""
    found: dict[int | None, list[float]] = {None: []}
    for change in changes:
        found[None].append(change.time)  # type: ignore[attr-defined]
        found.setdefault(change.channel, []).append(change.time)  # type: ignore[attr-defined]
    return found


def _innermost(spans: Iterable[Span]) -> Iterator[Span]:
    """Convert nested spans, outer ones first, to disjoint ones.

    Each instant belongs to the innermost span.
    """
    around: list[Span] = []
    time = 0.0
    for span in [*spans, (inf, inf, 0, ())]:
        while around and around[-1][1] <= span[0] + ROUNDING:
            _, until, *about = around.pop()
            if until > time:
                yield time, until, *about  # type: ignore[misc]
                time = until
        if around and span[0] > time:
            yield time, span[0], *around[-1][2:]
        time = max(time, span[0])
        around.append(span)
