"""Runs of one program in a changing world: each has a timeline of changes, and records what its tasks did.

Most trials change something at the same moment. The run is brought there once, a snapshot is taken shortly before it,
and each of these trials puts it back, adds its changes to the world, and goes on. Only the last such start is stored.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from math import inf
from typing import NamedTuple

from motionlang.kernel import Checked, Hook, Machine, Program, Run, Task, dialect, run, run_on
from motionlang.kernel.lang import Snapshot
from motionlang.kernel.log import Printed, Switched, Waited

# A trial lasts until so long after its last change, s, and longer while an axis is on its way to an end.
HORIZON, MAX_HORIZON, LONGER = 12.0, 200.0, 3.0
# An axis that was on its way so short before the end of a trial still moves, s.
GAP = 0.25
# A snapshot is taken so long before the changes of its trials, s: longer than a time slice and a few statements.
LEAD = 0.002
# A trial ends after so many statements, or if none of so many is the first at its place and none starts a move.
MAX_STATEMENTS, MAX_REPEATED = 300_000, 20_000
# The changes of the world, by the table of the machine file: the key of the number, and that of the value.
TABLES = {
    "input": ("channel", "value"),
    "analogue": ("channel", "value"),
    "comms": ("element", "value"),
    "key": ("", "text"),
}
# Where the name of a task would be, in a record of what handlers do.
HANDLERS = "!"


class Change(NamedTuple):
    """A change of the world: an input, an analogue input, an element of the comms array, or a key.

    A key has the number 0, and its text as the value.
    """

    table: str
    number: int
    value: float | str

    def __str__(self) -> str:
        if self.table == "input":
            return f"input {self.number} {'on' if self.value else 'off'}"
        if self.table == "key":
            return "key Enter" if self.value == "\r" else f"key {self.value}"
        assert isinstance(self.value, (int, float))
        name = "analogue input" if self.table == "analogue" else self.table
        return f"{name} {self.number} = {self.value:.10g}"


# Changes with their times, in order.
Timeline = tuple[tuple[float, Change], ...]


class Begun(NamedTuple):
    """A statement that began: its time, its source offset, and the offsets of the calls that led there."""

    time: float
    at: int
    callers: tuple[int, ...]


class Recorder(Hook):
    """A record of the tasks of a run from a time on: their statements, the inputs that they read, comparisons."""

    def __init__(self, since: float, snapshot_at: float = inf) -> None:
        super().__init__(lambda task, time, offset: None, between=self._between)
        self.since, self._snapshot_at = since, snapshot_at
        # The state of the run at `snapshot_at`, and the statement that had begun last.
        self.snapshot: Snapshot | None = None
        self._snapshot_after = -1
        self._machine: Machine | None = None
        self._begin(-1)

    def _begin(self, at: int) -> None:
        """Begin an empty record; the statement at an offset has begun last."""
        self.count = 0
        self.statements: dict[str, list[Begun]] = defaultdict(list)
        # By source offset: left and right side of each comparison, in order.
        self.comparisons: dict[int, list[tuple[object, object]]] = defaultdict(list)
        # By source offset: the inputs that the statement there has read.
        self.readings: dict[int, dict[int, None]] = defaultdict(dict)
        self.seen: set[int] = set()
        self._at = at
        self._is_recorded = False
        # The places since `since`, the moves so far, and the number of the last statement with something new.
        self._places: set[int] = set()
        self._moves = self._news = 0
        # The calls of the last statement of each task: how many, the innermost one, and their offsets.
        self._callers: dict[str, tuple[int, object, tuple[int, ...]]] = {}

    def attach(self, machine: Machine) -> None:
        """Watch a run that is about to begin on a machine."""
        self._machine = machine
        machine.controller.inputs.observer = self._reads
        if self._snapshot_at < inf:
            machine.clock.at(self.since, _nothing)  # no wait before the changes is hopeless

    def _between(self) -> None:
        assert self._machine is not None
        if self.snapshot is None and self._machine.clock.now >= self._snapshot_at:
            self.snapshot, self._snapshot_after = Snapshot(self._machine.scheduler), self._at

    def go_back(self, to: Snapshot) -> None:
        """Put the snapshot back and begin another record."""
        to.restore()
        self._begin(self._snapshot_after)

    def _reads(self, channel: int) -> None:
        if self._at >= 0:
            self.readings[self._at][channel] = None

    def begins(self, task: Task, time: float, offset: int) -> bool:
        """Record a statement, and end the run if it only repeats."""
        self.count += 1
        self._at, self._is_recorded = offset, time >= self.since
        assert self._machine is not None
        scheduler = self._machine.scheduler
        if not self._is_recorded:
            self.seen.add(offset)
            self._news = self.count
            return False
        assert scheduler is not None
        name = HANDLERS if scheduler.interrupts and task in scheduler.interrupts else task.name
        self.statements[name].append(Begun(time, offset, self._callers_of(task)))
        if offset not in self._places or self._machine.moves_made != self._moves:
            self._places.add(offset)
            self.seen.add(offset)
            self._moves, self._news = self._machine.moves_made, self.count
        if self.count < MAX_STATEMENTS and self.count - self._news < MAX_REPEATED:
            return False
        scheduler.until = time
        return True

    def _callers_of(self, task: Task) -> tuple[int, ...]:
        """Return the calls that lead to the present statement, worked out once for each call."""
        calls = task.calls  # type: ignore[attr-defined]  # tasks of a program run on steps
        if not calls:
            return ()
        depth, innermost, callers = self._callers.get(task.name, (0, None, ()))
        if depth != len(calls) or innermost is not calls[-1]:
            callers = task.stack[:-1]
            self._callers[task.name] = len(calls), calls[-1], callers
        return callers

    def compared(self, left: object, right: object) -> None:
        assert self._machine is not None
        if self._is_recorded or self._machine.clock.now >= self.since:  # a wait compares after it has begun
            self.comparisons[self._at].append((left, right))


class Motion(NamedTuple):
    """A move of a trial: when it began, s, its axis and its line, and how it was cut off, as in the log.

    `end` is infinite if it has no end of its own: a jog and a follower have none, a homing has. `act` is what it does,
    with its target in user units if it has one; it is empty for an entry of the move buffer that moves nothing.
    """

    begin: float
    end: float
    axis: int
    line: int
    act: str
    ended: str


class Trial(NamedTuple):
    """What a run with a timeline did: nothing in it changes when another one begins.

    `time` and `status` are those of its end. `is_stuck` is True if it ended because nothing could change any more.
    `waits` are in the order of their ends; those that go on end at infinity. `statements`, `comparisons` and
    `readings` are those of the `Recorder`, from `since` on.
    """

    timeline: Timeline
    since: float
    time: float
    status: str
    is_stuck: bool
    moves: Sequence[Motion]
    outputs: Sequence[Switched]
    prints: Sequence[Printed]
    waits: Sequence[Waited]
    statements: Mapping[str, Sequence[Begun]]
    comparisons: Mapping[int, Sequence[tuple[object, object]]]
    readings: Mapping[int, Mapping[int, None]]

    @property
    def has_ended(self) -> bool:
        """True if the program ended, or failed."""
        return self.status in ("ended", "fault", "stopped") and not self.is_stuck

    @property
    def motions(self) -> list[Motion]:
        """The moves that have an end of their own."""
        return [each for each in self.moves if each.end < inf]

    @property
    def is_busy(self) -> bool:
        """True if an axis was on its way to an end when time was up."""
        return self.status == "until" and any(each.end > self.time - GAP for each in self.motions)


class Start(NamedTuple):
    """A moment shortly before changes, from which trials start: earlier changes, its time, and the run up to it."""

    before: Timeline
    since: float
    recorder: Recorder
    run: Run


class Trials:
    """Runs of one program, a debug build; `base` are the settings that no change replaces."""

    def __init__(self, program: Program, base: Mapping[str, object], most: int) -> None:
        self.program, self.base, self.most = program.on(base), dict(base), most
        self.count = 0
        # The run of the last trial, as it is until the next one.
        self.last: Run
        # The source offsets of all statements that any trial has begun.
        self.seen: set[int] = set()
        # Where the last trial started, if not at power-up.
        self._start: Start | None = None

    @property
    def is_over(self) -> bool:
        """True if the budget is used up."""
        return self.count >= self.most

    def give(self, settings: Mapping[str, object]) -> None:
        """Add settings for all later trials."""
        self.base |= settings
        self._start = None

    def play(self, timeline: Timeline, since: float) -> Trial:
        """Run the program with a timeline, until nothing is on its way to an end any more."""
        self.count += 1
        end = max((since, *(at for at, _ in timeline)))
        if since > 0.0:
            recorder = self._continue(timeline, since, end + HORIZON)
        else:  # what is on at power-up changes no input
            recorder = Recorder(since)
            self.last = self._run(tables_of(timeline), end + HORIZON, recorder)
        trial, horizon = _trial(timeline, since, self.last, recorder), HORIZON
        while trial.is_busy and horizon < MAX_HORIZON:
            horizon *= LONGER
            self.last = self._run_on(self.last.machine, end + horizon)
            trial = _trial(timeline, since, self.last, recorder)
        self.seen |= recorder.seen
        return trial

    def _continue(self, timeline: Timeline, since: float, until: float) -> Recorder:
        """Play on from shortly before the changes; bring the run there first if it is not the last start."""
        before = tuple(each for each in timeline if each[0] < since)
        start = self._start
        if start is None or (start.before, start.since) != (before, since):
            at = max(since - LEAD, 0.0)
            recorder = Recorder(since, at)
            start = self._start = Start(before, since, recorder, self._run(tables_of(before), at, recorder))
            self.seen |= recorder.seen
        recorder, self.last = start.recorder, start.run
        if recorder.snapshot is not None:  # the program has not ended before
            recorder.go_back(recorder.snapshot)
            machine = start.run.machine
            changes = tuple(each for each in timeline if each[0] >= since)
            machine.add_entries(tables_of(changes, machine.clock.now))
            self.last = self._run_on(machine, until)
        return recorder

    def _run(self, tables: Mapping[str, object], until: float, recorder: Recorder) -> Run:
        settings = Checked({**self.base, **tables})
        return run(self.program, machine=settings, until=until, hook=recorder, begun=recorder.attach)

    def _run_on(self, machine: Machine, until: float) -> Run:
        program = self.program
        return run_on(program.source, dialect(program.language), program, machine, until)

    def run_in(self, tables: Mapping[str, object], until: float) -> Run:
        """Run the program with some tables of the machine file up to a time."""
        self.count += 1
        return self._run(tables, until, Recorder(inf))


def tables_of(timeline: Timeline, since: float = 0.0) -> dict[str, object]:
    """Return the tables of a machine file with the changes of a timeline; their times count from `since`."""
    tables: dict[str, list[dict[str, object]]] = defaultdict(list)
    for time, change in timeline:
        number, value = TABLES[change.table]
        entry: dict[str, object] = {number: change.number} if number else {}
        tables[change.table].append(entry | {"at": time - since, value: change.value})
    return dict(tables)


def levels_at(timeline: Timeline, time: float) -> dict[int, float]:
    """Return the levels of the inputs that a timeline has changed by a time."""
    return {
        change.number: float(change.value)
        for at, change in timeline
        if change.table == "input" and at <= time + 1e-9
    }


def _nothing() -> None:
    """Do nothing; an event at which something may change."""


# The shapes of profiles without an end of their own.
ENDLESS = frozenset(("jog", "gear"))


def _trial(timeline: Timeline, since: float, result: Run, recorder: Recorder) -> Trial:
    """Return what a run did that has just ended."""
    log = result.machine.log
    return Trial(
        timeline,
        since,
        result.time,
        result.status,
        any(each.code == "never" for each in result.diagnostics),
        list(_moves(result)),
        list(log.outputs),
        list(log.prints),
        [*log.waits.written(), *_open_waits(result)],
        recorder.statements,
        recorder.comparisons,
        recorder.readings,
    )


def _moves(result: Run) -> Iterator[Motion]:
    homes = result.dialect.table().homes
    for move in result.machine.log.moves:
        profile, end, act = move.profile, inf, ""
        if profile is not None:
            act = f"axis {move.axis} {move.command}"
            if profile.duration < inf:
                act = f"axis {move.axis} to {(profile.end - move.zero) / (move.scale or 1.0):.4g}"
                if profile.shape not in ENDLESS or homes(move.command):
                    end = move.start_time + profile.duration
        yield Motion(move.start_time, end, move.axis, move.line, act, move.ended)


def _open_waits(result: Run) -> Iterator[Waited]:
    """Yield the waits that no time ends."""
    scheduler = result.machine.scheduler
    for task in scheduler.tasks if scheduler is not None else ():
        wait = task.wait
        if not task.done and wait is not None and wait.due() == inf:
            yield Waited(*task.waited(wait, inf))  # type: ignore[arg-type]
