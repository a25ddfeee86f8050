"""The critical path of a run, followed backwards from its end.

Computing of a task is followed back to the end of its last wait. A wait ended because a move ended, time had
passed, or an input changed. A move began because a task started it, or because the previous move in the
buffer had ended. If a task stopped, held or resumed a move, its end depends on that statement and not on its
begin. Saving time outside the critical path does not make the run shorter.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from operator import itemgetter, sub

from motionlang.commands.profile.motions import DWELL, Motion, Motions, Phases
from motionlang.commands.profile.polls import Polls
from motionlang.commands.profile.source_positions import SourcePosition, SourcePositions
from motionlang.commands.profile.tasks import Wait, all_waits, ended_at, parent_of
from motionlang.kernel import Run
from motionlang.kernel.lang import MOVING
from motionlang.kernel.tools import exact_terms

# One of several links that differ only in their times, with their durations: terms of an exact sum.
LinkGroup = tuple["Link", list[float]]

# Its cause, source position, task, axes and the line that waited.
About = tuple[str, SourcePosition, str, tuple[int, ...], int]

# A wait ends up to this many statements after its cause; nothing else happens in between.
STATEMENTS = 2.5
CAUSES = {
    "time": DWELL,
    "axis": "settling",
    "input": "waiting for an input",
    "operator": "waiting for the operator",
    "task": "waiting for a task",
    "host": "waiting for a host",
    "condition": "waiting for a condition",
    MOVING: "waiting for a condition",
}
# Waits for these end because a move ended, if one did.
MOVED = ("axis", "condition", MOVING)
NOWHERE = SourcePosition(0, "", ())
# The end of a wait.
_UNTIL: Callable[[Wait], float] = itemgetter(3)


@dataclass(eq=False, slots=True)
class Link:
    """One link of the path: its `cause` as text, and the axes that move in it.

    `waited` is the line at which the task waited during the link, 0 if the task computed.
    """

    begin: float
    end: float
    cause: str
    position: SourcePosition
    task: str
    axes: tuple[int, ...]
    waited: int = 0

    @property
    def duration(self) -> float:
        """The duration of the link, seconds."""
        return self.end - self.begin

    @property
    def is_motion(self) -> bool:
        """True if a move takes the time of the link."""
        return bool(self.axes)


class Strip:
    """Links of one task at one position that differ only in their times.

    They have the same phases. A long run has tens of thousands of links, but few strips.
    """

    def __init__(
        self, position: SourcePosition, task: str, phases: Phases, waited: int, axes: tuple[int, ...] = ()
    ) -> None:
        self.position, self.task, self.phases, self.axes, self.waited = position, task, phases, axes, waited
        self.begins: list[float] = []
        self.ends: list[float] = []

    def add(self, begin: float, end: float) -> None:
        """Add a link; the last phase extends to the end of the link."""
        self.begins.append(begin)
        self.ends.append(end)

    def by_phase(self) -> Iterator[tuple[About, list[float], list[float]]]:
        """Yield what the links of each phase share, with their start and end times."""
        lows, ends = self.begins, self.ends
        for name, seconds in self.phases[:-1]:
            highs = [
                high if (high := low + seconds) < end else end for low, end in zip(lows, ends, strict=True)
            ]
            yield self._about(name), lows, highs
            lows = highs
        yield self._about(self.phases[-1][0]), lows, ends

    def _about(self, name: str) -> About:
        return name, self.position, self.task, () if name == DWELL else self.axes, self.waited


class CriticalPath:
    """The critical path of one run, from its start to its end without a gap."""

    def __init__(self, run: Run) -> None:
        self.motions = Motions(run)
        self.positions = SourcePositions(run)
        self._run = run
        self._near = STATEMENTS * run.machine.instruction_time + 1e-9
        self._polls = Polls(run, self.motions, all_waits(run))
        self._waits = self._polls.waits
        # Their ends, for tasks other than the only one, which are searched repeatedly.
        self._untils = {
            name: list(map(_UNTIL, mine)) for name, mine in self._waits.items() if len(self._waits) > 1
        }
        self._switched = [change.time for change in run.controller.log.inputs]
        self._strips: dict[object, Strip] = {}
        self._follow()

    def __getstate__(self) -> dict[str, object]:
        return {"_strips": self._strips, "_waits": self._waits}

    @property
    def waits(self) -> dict[str, list[Wait]]:
        """The waits of each task, including loops that waited."""
        return self._waits

    @cached_property
    def links(self) -> list[Link]:
        """The links in order of time; motion is split into phases."""
        return [Link(low, high, *about) for low, high, about in self.spans()]

    def spans(self) -> list[tuple[float, float, About]]:
        """Return the start and end of each link, and its other fields, which are shared."""
        found: list[tuple[float, float, About]] = []
        for strip in self._strips.values():
            for about, lows, highs in strip.by_phase():
                found += [(low, high, about) for low, high in zip(lows, highs, strict=True) if low < high]
        found.sort(key=itemgetter(0))  # no two begin together
        return found

    def grouped(self) -> list[LinkGroup]:
        """Return the links grouped for a table, without creating each link."""
        found: dict[object, LinkGroup] = {}
        for strip in self._strips.values():
            for about, lows, highs in strip.by_phase():
                if lows:
                    link = Link(lows[0], highs[0], *about)
                    _put(found, link, exact_terms(map(sub, highs, lows)))
        return list(found.values())

    # ---------------------------------------------------------------------------------------- from the end

    def _follow(self) -> None:
        """Follow the path from the end of the run back to its start."""
        task, time = parent_of(self._run), self._run.time
        over = ended_at(self._run)
        if time > over:
            time = self._motion_after(over, time, task)
        while time > 0.0:
            task, time = self._follow_task(task, time)

    def _follow_task(self, task: str, time: float) -> tuple[str, float]:
        """Follow one task back from `time` to its start.

        Returns the task that started it, and when.
        """
        waits = self._waits.get(task, [])
        for last in range(bisect_right(waits, time + 1e-12, key=_UNTIL) - 1, -1, -1):
            _, at, since, until, cause, _, _, callers = wait = waits[last]
            if since >= time or until > time + 1e-12:
                continue  # it was not over by then
            position = self.positions.of(at, callers)
            self._compute(until, time, task, position)
            time = min(until, time)
            motion = self._awaited(wait, time) if cause in MOVED else None
            if motion is None:  # a wait that took no time is a link, too
                self._strip(self._cause(wait, time), position, task).add(since, time)
                time = since
                continue
            if motion.end < time:
                waited = "settling" if motion.end < time - self._near else "computing"
                self._add(motion.end, time, waited, position, task)
                time = motion.end
            other, time = self._back(motion, time, task, position)
            if other != task:
                return other, time
        return self._started(task, time) if time > 0.0 else (task, time)

    def _started(self, task: str, time: float) -> tuple[str, float]:
        """Go from `time`, before the first wait of a task, back to the start of the task.

        Return the task that started it, and when. A task may wait for a move that began before the task itself.
        """
        starter, begin = self._starter(task)
        self._compute(begin, time, task, self._first_location(task))
        return starter, min(begin, time)

    def _awaited(self, wait: Wait, time: float) -> Motion | None:
        """Return the motion that ended a wait at `time`, or was in progress at that time."""
        cause, axes = wait[4], wait[5]
        if cause == "axis":
            return self.motions.that_ended(wait[2], time, self._near, axes)
        found = None if cause == MOVING else self.motions.that_ended(wait[2], time, self._near)
        if found is None and cause == "condition":
            ended = self._polls.of_condition(wait, time)
            cause, axes = ended[1:] if ended is not None else ("", ())
        return self.motions.crossing(axes[0], time) if found is None and cause == MOVING else found

    def _compute(self, begin: float, end: float, task: str, position: SourcePosition) -> None:
        """Charge computing to its loops, and outside them to `position`.

        A position in a sub that a loop calls takes precedence over the loop, if the loop was running there.
        """
        waited = begin
        spans = self._polls.spans.get(task, [])
        number = bisect_right(spans, begin, key=itemgetter(1))
        while begin < end:
            since, until, at, callers = spans[number] if number < len(spans) else (end, end, 0, ())
            self._add(begin, min(since, end), "computing", position, task)
            begin = max(begin, since)
            if begin < end:
                loop = self.positions.of(at, callers)
                nearer = position if since < waited and len(position.callers) > len(loop.callers) else loop
                self._add(begin, min(until, end), "computing", nearer, task)
            begin = max(begin, until)
            number += 1

    def _cause(self, wait: Wait, time: float) -> str:
        """Return what ended a wait other than a move.

        For a condition it is the input that changed at that time.
        """
        if wait[4] == "condition":
            ended = self._polls.of_condition(wait, time)
            if ended is not None and ended[1] not in ("axis", MOVING):
                return CAUSES[ended[1]]
            first = bisect_right(self._switched, time - self._near)
            if first < len(self._switched) and self._switched[first] <= time:
                return CAUSES["input"]
        return CAUSES[wait[4]]

    def _back(self, motion: Motion, time: float, task: str, waited: SourcePosition) -> tuple[str, float]:
        """Charge a move to its line, and the earlier buffered moves that it waited for.

        Of a move that a task changed, only the rest is charged. `waited` is the position at which the task waited.
        """
        while True:
            _, begin, line, axes, _ = motion
            changes = self.motions.changes(motion, time)
            begin = next((each for each in changes if self._who_acted(each, task) is not None), begin)
            self._add_motion(motion, time, task, waited, begin)
            begin = min(begin, time)
            actor = self._who_acted(begin, task)
            if actor is not None:
                return actor, begin
            before = self.motions.before(axes, motion.begin, self._near)
            if before is None:
                # An outside event has started it while all tasks waited: the task waited for that.
                waiting = self._waiting_at(task, begin)
                assert waiting is not None
                _, at, since, _, _, _, _, callers = waiting
                self._add(since, begin, self._cause(waiting, begin), self.positions.of(at, callers), task)
                return task, since
            if before.end < begin:
                self._add(before.end, begin, "waiting", self.positions.at_line(line), task)
            motion, time = before, min(before.end, begin)

    def _motion_after(self, over: float, time: float, task: str) -> float:
        """Charge motion after the end of the program; return when the program ended."""
        motion = self.motions.last(over, time + self._near)
        if motion is None:
            self._add(over, time, "settling", NOWHERE, task)
            return over
        end, begin, line, _, _ = motion
        if end < time:
            self._add(end, time, "settling", self.positions.at_line(line), task)
        self._add_motion(motion, end, task, NOWHERE, max(begin, over))
        return max(begin, over)

    # ---------------------------------------------------------------------------------------- lookups

    def _waiting_at(self, task: str, time: float) -> Wait | None:
        """Return the wait of a task at `time`, excluding its first and last instant."""
        waits, soon = self._waits.get(task, []), time + self._near
        untils = self._untils.get(task)
        index = bisect_right(waits, soon, key=_UNTIL) if untils is None else bisect_right(untils, soon)
        if index < len(waits) and waits[index][2] < time - self._near:
            return waits[index]
        return None

    def _who_acted(self, time: float, task: str) -> str | None:
        if self._waiting_at(task, time) is None:
            return task
        for name in self._waits:
            if self._waiting_at(name, time) is None and self._lives(name, time):
                return name
        return None

    def _lives(self, task: str, time: float) -> bool:
        waits = self._waits[task]
        return bool(waits) and waits[0][2] <= time + self._near and time <= waits[-1][3] + self._near

    def _starter(self, task: str) -> tuple[str, float]:
        """Return the task that started another, and when; the parent started with the run."""
        parent = parent_of(self._run)
        begin = next(
            (each.time for each in self._run.machine.log.slices.up_to(self._run.time) if task in each.tasks),
            0.0,
        )
        return parent, 0.0 if task == parent else begin

    def _first_location(self, task: str) -> SourcePosition:
        """Return the start of a task, or its first wait if the start is not known."""
        begin = self.positions.begin(task)
        if begin is not None:
            return begin
        waits = self._waits.get(task, [])
        return self.positions.of(waits[0][1], waits[0][-1]) if waits else NOWHERE

    # ---------------------------------------------------------------------------------------- charging

    def _strip(self, cause: str, position: SourcePosition, task: str) -> Strip:
        """Return the strip of one phase.

        Each source position has exactly one `SourcePosition` object.
        """
        key = id(position), cause, task
        if key not in self._strips:
            waited = 0 if cause == "computing" else position.line
            self._strips[key] = Strip(position, task, ((cause, 0.0),), waited)
        return self._strips[key]

    def _add(self, begin: float, end: float, cause: str, position: SourcePosition, task: str) -> None:
        if end > begin:
            self._strip(cause, position, task).add(begin, end)

    def _add_motion(
        self, motion: Motion, time: float, task: str, waited: SourcePosition, begin: float
    ) -> None:
        """Add the part of a move from `begin` up to `time`.

        The log does not record the callers of a move's line. If the sub that commanded the move also waited
        for it, the callers of the wait are used.
        """
        if time > begin:
            self._strip_of(motion, task, waited, begin).add(begin, time)

    def _strip_of(self, motion: Motion, task: str, waited: SourcePosition, begin: float = 0.0) -> Strip:
        _, began, line, axes, shape = motion
        position = self.positions.at_line(line)
        if waited.callers and position.sub == waited.sub:
            position = self.positions.called(position.line, waited.callers)
        phases = self.motions.phases(shape)
        if begin > began:
            phases = _behind(phases, begin - began)
        key = id(position), id(phases), axes, task, waited.line
        strip = self._strips.get(key)
        if strip is None:
            strip = self._strips[key] = Strip(position, task, phases, waited.line, axes)
        return strip


def _behind(phases: Phases, seconds: float) -> Phases:
    for number, (name, duration) in enumerate(phases[:-1]):
        if seconds < duration:
            return (name, duration - seconds), *phases[number + 1 :]
        seconds -= duration
    return phases[-1:]


def _put(found: dict[object, LinkGroup], link: Link, times: list[float]) -> None:
    key = id(link.position), link.cause, link.axes, link.waited
    if key in found:
        found[key][1].extend(times)
    else:
        found[key] = link, times


def grouped(links: Iterable[Link]) -> list[LinkGroup]:
    """Group links by position, cause, axes and the line that waited."""
    found: dict[object, LinkGroup] = {}
    for link in links:
        _put(found, link, [link.duration])
    return list(found.values())
