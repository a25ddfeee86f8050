"""The critical chain: what the end of a run waited for, and what that waited for, back to its begin.

It is followed from the end. A task that computes has come there from its last wait; a wait ended because a move ended,
time had passed, an input changed; a move began because a task started it, or because the one before it in the buffer
had ended. Whatever is shortened outside of the chain does not make the run shorter.
"""

from __future__ import annotations

from bisect import bisect_right
from operator import attrgetter
from typing import TYPE_CHECKING, NamedTuple

from motionlang.cycle.places import Place, Places
from motionlang.cycle.tasks import ended_at, parent_of, waits_of

if TYPE_CHECKING:
    from motionlang.controller.move import Move
    from motionlang.controller.record.records import Waited
    from motionlang.result import Run

# Times of a wait are whole statements behind those of what ends it; nothing else happens within so many.
STATEMENTS = 2.5
# Phases of a move, and what a stretch of the chain is called in which one runs.
PHASES = {"accel": "accelerating", "slew": "at speed", "decel": "decelerating", "stop": "stopping"}
MOVING = (*PHASES.values(), "in motion")
CAUSES = {
    "time": "dwell",
    "axis": "settling",
    "input": "waiting for an input",
    "operator": "waiting for the operator",
    "task": "waiting for a task",
    "host": "waiting for a host",
    "condition": "waiting for a condition",
}


class Link(NamedTuple):
    """One stretch of the chain: `cause` as a person would say it, the axes that move in it (none else)."""

    begin: float
    end: float
    cause: str
    place: Place
    task: str
    axes: tuple[int, ...]

    @property
    def duration(self) -> float:
        """Seconds of it."""
        return self.end - self.begin

    @property
    def is_motion(self) -> bool:
        """Whether it is a move that takes the time."""
        return bool(self.axes)


class Motion:
    """A move as the chain sees it: axes that move together are one, and `move` is that of the first."""

    __slots__ = ("axes", "begin", "end", "line", "move")

    def __init__(self, axes: tuple[int, ...], line: int, begin: float, end: float, move: Move) -> None:
        self.axes, self.line, self.begin, self.end, self.move = axes, line, begin, end, move


class Chain:
    """The chain of one run: `links` from the begin to the end, without a gap."""

    def __init__(self, run: Run, waits: dict[str, list[Waited]] | None = None) -> None:
        self._run = run
        self._places = Places(run)
        self._near = STATEMENTS * run.machine.instruction_time + 1e-9
        self._waits = waits_of(run) if waits is None else waits
        self._untils = {name: [wait.until for wait in waits] for name, waits in self._waits.items()}
        self._motions = _motions(run)
        self._ends = [motion.end for motion in self._motions]
        self._switched = [change.time for change in run.controller.log.inputs]
        self.links: list[Link] = []
        self._follow()
        self.links.reverse()

    # ---------------------------------------------------------------------------------------- from the end

    @property
    def motions(self) -> list[Motion]:
        """Every motion of the run by its end."""
        return self._motions

    def _follow(self) -> None:
        """From the end of the run back to its begin."""
        task, time = parent_of(self._run), self._run.time
        over = ended_at(self._run)
        if time > over:
            time = self._motion_after(over, time, task)
        while time > 0.0:
            wait = self._wait_before(task, time)
            if wait is None:
                starter = self._starter(task)
                self._add(starter[1], time, "computing", self._first_place(task), task)
                task, time = starter
                continue
            if wait.until < time:
                self._add(wait.until, time, "computing", self._places.of(wait), task)
            task, time = self._through(wait, min(wait.until, time), task)

    def _through(self, wait: Waited, time: float, task: str) -> tuple[str, float]:
        """Whom to follow, and from when, behind a wait that was over at `time`."""
        motion = self._that_ended(wait, time) if wait.cause in ("axis", "condition") else None
        if motion is None:
            self._add(wait.since, time, self._cause(wait, time), self._places.of(wait), task)
            return task, wait.since
        if motion.end < time - self._near:
            self._add(motion.end, time, "settling", self._places.of(wait), task)
        elif motion.end < time:
            self._add(motion.end, time, "computing", self._places.of(wait), task)
        return self._back(motion, min(motion.end, time), task, self._places.of(wait))

    def _cause(self, wait: Waited, time: float) -> str:
        """What ended a wait that no move did: of a condition, the input that changed at that moment."""
        if wait.cause == "condition":
            first = bisect_right(self._switched, time - self._near)
            if first < len(self._switched) and self._switched[first] <= time:
                return CAUSES["input"]
        return CAUSES[wait.cause]

    def _back(self, motion: Motion, time: float, task: str, waited: Place) -> tuple[str, float]:
        """Charge a move to its line, and those before it in the buffer that it waited for; `waited` is who did."""
        while True:
            self._add_motion(motion, time, task, waited)
            begin = min(motion.begin, time)
            before = self._before(motion)
            task = self._who_acted(begin, task)
            waiting = self._waiting_at(task, begin)
            if waiting is None:
                return task, begin
            if before is None:
                # Something from outside has started it while everybody waited: the task waited for that.
                self._add(waiting.since, begin, self._cause(waiting, begin), self._places.of(waiting), task)
                return task, waiting.since
            if before.end < begin:
                self._add(before.end, begin, "waiting", self._places.at_line(motion.line), task)
            motion, time = before, min(before.end, begin)

    def _motion_after(self, over: float, time: float, task: str) -> float:
        """What moved on after the program had ended; the time at which it had."""
        motion = self._last_end(self._motions, time + self._near, over)
        if motion is None:
            self._add(over, time, "settling", Place(0, "", ()), task)
            return over
        if motion.end < time:
            self._add(motion.end, time, "settling", self._places.at_line(motion.line), task)
        begin = max(motion.begin, over)
        self._add_motion(motion, motion.end, task, Place(0, "", ()), begin)
        return begin

    # ---------------------------------------------------------------------------------------- what there is

    def _wait_before(self, task: str, time: float) -> Waited | None:
        """The last wait of a task that was over at `time`."""
        waits = self._waits.get(task, [])
        place = bisect_right(self._untils.get(task, []), time + 1e-12)
        while place and waits[place - 1].since >= time:
            place -= 1
        return waits[place - 1] if place else None

    def _waiting_at(self, task: str, time: float) -> Waited | None:
        """The wait that a task is in at `time`, its first and last moment not counted."""
        waits = self._waits.get(task, [])
        place = bisect_right(self._untils.get(task, []), time + self._near)
        if place < len(waits) and waits[place].since < time - self._near:
            return waits[place]
        return None

    def _who_acted(self, time: float, task: str) -> str:
        """The task that was not waiting at `time`: the one that is followed, if it was not, else another."""
        if self._waiting_at(task, time) is None:
            return task
        for name in self._waits:
            if name != task and self._waiting_at(name, time) is None and self._lives(name, time):
                return name
        return task

    def _lives(self, task: str, time: float) -> bool:
        waits = self._waits[task]
        return bool(waits) and waits[0].since <= time + self._near and time <= waits[-1].until + self._near

    def _starter(self, task: str) -> tuple[str, float]:
        """Who started a task, and when, as far as the log tells; the parent began with the run."""
        parent = parent_of(self._run)
        begin = next((turn.time for turn in self._run.machine.log.turns if task in turn.tasks), 0.0)
        return parent, 0.0 if task == parent else begin

    def _first_place(self, task: str) -> Place:
        waits = self._waits.get(task, [])
        return self._places.of(waits[0]) if waits else Place(0, "", ())

    def _that_ended(self, wait: Waited, time: float) -> Motion | None:
        """The move whose end let a wait go on: of those that ended then, the one that began last."""
        first = bisect_right(self._ends, wait.since)
        last = bisect_right(self._ends, time + self._near)
        found = [
            motion
            for motion in self._motions[first:last]
            if not wait.what or wait.cause != "axis" or set(motion.axes) & set(wait.what)
        ]
        near = [motion for motion in found if motion.end >= time - self._near]
        if near:
            return max(near, key=lambda motion: (motion.begin, motion.end))
        if wait.cause == "axis" and found:
            return found[-1]
        return None

    def _last_end(self, motions: list[Motion], time: float, after: float) -> Motion | None:
        found = [motion for motion in motions if after < motion.end <= time]
        return found[-1] if found else None

    def _before(self, motion: Motion) -> Motion | None:
        """The move of one of the same axes that ended when this one began."""
        place = bisect_right(self._ends, motion.begin + self._near)
        while place and self._ends[place - 1] >= motion.begin - self._near:
            place -= 1
            other = self._motions[place]
            if other is not motion and other.begin < motion.begin and set(other.axes) & set(motion.axes):
                return other
        return None

    # ---------------------------------------------------------------------------------------- what is charged

    def _add(
        self, begin: float, end: float, cause: str, place: Place, task: str, axes: tuple[int, ...] = ()
    ) -> None:
        if end > begin:
            self.links.append(Link(begin, end, cause, place, task, axes))

    def _add_motion(
        self, motion: Motion, time: float, task: str, waited: Place, begin: float | None = None
    ) -> None:
        """The phases of a move up to `time`, the last one first.

        Nobody has written down who called the line that ordered it; where its sub waited for it, it is who called that.
        """
        first = motion.begin if begin is None else begin
        place, edge = self._places.at_line(motion.line), motion.begin
        if place.sub == waited.sub and waited.callers:
            place = self._places.called(place.line, waited.callers)
        edges = []
        profile = motion.move.profile
        for phase in profile.phases if profile is not None else ():
            edges.append((edge, PHASES.get(phase.name, "in motion")))
            edge += phase.duration
        end = time
        for low, cause in reversed(edges):
            low = max(low, first)
            if low < end:
                self._add(low, end, cause, place, task, motion.axes)
                end = low
        self._add(first, end, "in motion", place, task, motion.axes)


def _motions(run: Run) -> list[Motion]:
    """Every move by its end; axes that begin and end together on one line are one."""
    found: list[Motion] = []
    same: Motion | None = None
    over = run.time
    for move in run.controller.log.moves:
        profile, begin, line = move.profile, move.start_time, move.line
        if profile is None:
            continue
        end = begin + profile.duration
        if end > over:
            end = over
        if same is not None and same.end == end and same.begin == begin and same.line == line:
            same.axes += (move.axis,)
        else:
            same = Motion((move.axis,), line, begin, end, move)
            found.append(same)
    found.sort(key=attrgetter("end", "begin"))
    return found
