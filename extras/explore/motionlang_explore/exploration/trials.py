"""Runs of one program in a changing world: each has a timeline of changes, and records what its tasks did.

Most trials change something at the same moment. The run is brought there once, a snapshot is taken shortly before it,
and each of these trials puts it back, adds its changes to the world, and goes on. Only the last such start is stored; a
later one with the same changes before it is reached from there.

A trial is split at the times of `HORIZONS`, where it ends if its caller has seen enough.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from itertools import pairwise
from math import inf
from typing import NamedTuple

from motionlang.comparison.texts import described, plain
from motionlang.kernel import CheckedSettings, Machine, Program, Run, dialect, run, run_on
from motionlang.kernel.lang import Snapshot
from motionlang.kernel.log import LoggedMove, Printed, Switched, Waited
from motionlang.kernel.planners import Profile
from motionlang_explore.exploration.changes import Channel, Timeline, in_words, merged, tables_of
from motionlang_explore.exploration.memory import Memory
from motionlang_explore.exploration.recorder import (
    Begun,
    Comparison,
    Outcome,
    Readings,
    ReadSpan,
    Seen,
    TrialRecorder,
)
from motionlang_explore.exploration.roles import written_at

# A world without an entry.
NOWHERE: Mapping[str, object] = {}
# A trial lasts until so long after its last change, s; shorter if it is settled by one of the times before, and longer
# while an axis is on its way to an end.
HORIZON = 12.0
HORIZONS = (0.5, 1.5, 3.0, 6.0, HORIZON, 36.0, 108.0, 324.0)
# An axis that was on its way so short before the end of a trial still moves, s.
GAP = 0.25
# A snapshot is taken so long before the changes of its trials, s: longer than a time slice and a few statements.
LEAD = 0.002
# The work that an ordinary core does in a second, in statements; that of a program that is written again, for each of
# its lines; and that of a run that goes on.
SECOND, LINE, GO_ON = 300_000, 32, 350
# The share of the user's time after which the search ends; the rest is for the world.
SEARCH = 0.6
# A trial is no longer than usual if it has made so many moves.
MAX_MOVES = 300


class Act(NamedTuple):
    """An act of a program: its time, s, its line, 0 if that is unknown, its subject, and the rest in words.

    It moves an axis, switches an output, or prints a line, which has no `subject`.
    """

    time: float
    line: int
    subject: str
    words: str

    def __str__(self) -> str:
        return f"{self.subject} {self.words}".strip()


# A move to where the axis is takes no longer, s.
SHORTEST_MOVE = 0.01


class TrialMotion(NamedTuple):
    """A move of a trial: when it began, s, its axis and its line, and how it was cut off, as in the log.

    `end` is infinite if it has no end of its own: a jog and a follower have none, a homing has. `is_short` is True if
    it took no longer than a move to where the axis is, since it had no way to go or was cut off. `profile` is None for
    an entry of the move buffer that moves nothing.
    """

    begin: float
    end: float
    axis: int
    line: int
    ended: str
    is_homing: bool
    is_short: bool
    command: str
    profile: Profile | None
    scale: float
    zero: float

    @property
    def words(self) -> str:
        """Its target if it has one, and its highest speed, both in user units; "" if it moves nothing."""
        return described(self, self.is_homing)

    @property
    def is_work(self) -> bool:
        """True if it is no homing, and takes longer than a move to where the axis is."""
        return not (self.is_homing or self.is_short)


class Trial(NamedTuple):
    """The record of a run with a timeline: nothing in it changes when another one begins.

    `time` and `status` are those of its end. `is_stuck` is True if it ended because nothing could change any more,
    `is_homing` if an axis still homes, `is_idle` if it was ended since it only repeated. `question` is that of an INPUT
    for which it has no answer. `waits` are in the order of their ends; those that go on end at infinity. `outputs`, and
    `statements`, `comparisons`, `decided`, `readings` and `seen` of the `TrialRecorder`, are those from `since` on.
    `begun` are the statements that began at any time, `outcomes` those of conditions if they are observed.
    """

    timeline: Timeline
    since: float
    time: float
    status: str
    is_stuck: bool
    is_homing: bool
    is_idle: bool
    question: str | None
    moves: Sequence[TrialMotion]
    outputs: Sequence[Switched]
    prints: Sequence[Printed]
    waits: Sequence[Waited]
    statements: Mapping[str, Sequence[Begun]]
    comparisons: Mapping[Comparison, Sequence[tuple[object, object]]]
    decided: Mapping[int, Set[Channel]]
    readings: Readings
    memory: Sequence[tuple[float, tuple[object, ...]]]
    seen: Set[Seen]
    begun: Set[int]
    outcomes: Set[Outcome]

    def part(self, since: float, until: float) -> Trial:
        """Return the trial with only the moves, outputs and prints between two times."""
        first, last = since - 1e-9, until + 1e-9
        return self._replace(
            moves=[each for each in self.moves if first <= each.begin < last],
            outputs=[each for each in self.outputs if first <= each.time <= last],
            prints=[each for each in self.prints if first <= each.time <= last],
        )

    @property
    def has_ended(self) -> bool:
        """True if the program ended, or failed."""
        return self.status in ("ended", "fault", "stopped") and not self.is_stuck

    @property
    def motions(self) -> list[TrialMotion]:
        """The moves that have an end of their own."""
        return [each for each in self.moves if each.end < inf]

    @property
    def is_busy(self) -> bool:
        """True if an axis was on its way to an end when time was up."""
        return self.status == "until" and (
            self.is_homing or any(each.end > self.time - GAP for each in self.motions)
        )


class Start(NamedTuple):
    """A moment shortly before changes, from which trials start: earlier changes, its time, and the run up to it."""

    before: Timeline
    since: float
    recorder: TrialRecorder
    run: Run

    def leads_to(self, before: Timeline, since: float) -> bool:
        """True if a later moment with these changes before it can be reached from here."""
        return self.since < since and self.before == tuple(each for each in before if each[0] < self.since)


class PowerUp(NamedTuple):
    """A run before its first statement, and what is on then; every trial with the same goes on from here."""

    on: Timeline
    snapshot: Snapshot
    recorder: TrialRecorder
    run: Run


class Interrupted(Exception):
    """The user has interrupted a run of an exploration."""

    def __init__(self, result: Run) -> None:
        super().__init__("interrupted")
        self.result = result


def nothing_used() -> float:
    """Return the share of a time that no user has limited."""
    return 0.0


def untold(words: str) -> None:
    """Tell nobody what is played."""


class Trials:
    """Runs of one program, a debug build; `base` are the settings that no change replaces.

    They are over when they have done so much work as `most`: the statements that they have begun, and what runs, rounds
    and readings cost. The work is the same on every machine. `used` is the share of the user's time that is over: a
    run that is still going on when all of it is ends there. `tell` is called with what is played.
    """

    def __init__(
        self,
        program: Program,
        base: Mapping[str, object],
        most: float,
        used: Callable[[], float] = nothing_used,
    ) -> None:
        self.program, self.base, self.most = program.on(base), dict(base), most
        self._used = used
        self.tell: Callable[[str], object] = untold
        # The work at which a run ends that is still going on.
        self.limit = inf
        self.memory = Memory(self.program.structure)
        self._written = written_at(self.program)
        self._lines = program.source.text.count("\n") + 1
        self.count = self.work = 0
        # The run of the last trial, as it is until the next one.
        self.last: Run
        # What any trial has seen.
        self.seen: set[Seen] = set()
        # True if trials record how conditions come out.
        self.observes = False
        self._world = NOWHERE
        self._forget()

    def __getstate__(self) -> dict[str, object]:
        """Return what another process needs to play on; the last run, a living machine, stays here."""
        return {
            name: value
            for name, value in vars(self).items()
            if name not in ("_used", "tell", "memory", "last", "_start", "_power_up")
        }

    def __setstate__(self, state: dict[str, object]) -> None:
        vars(self).update(state, _used=nothing_used, tell=untold)
        self.memory = Memory(self.program.structure)
        self._forget()

    def _forget(self) -> None:
        """Begin the next trial anew, since what is the same in all of them has changed."""
        # Where the last trial started, and the power-up before it.
        self._start: Start | None = None
        self._power_up: PowerUp | None = None

    @property
    def is_over(self) -> bool:
        """True if the budget is used up, or the user has ended the exploration."""
        return self.work >= self.most or self._used() >= SEARCH

    def _recorder(self, since: float, snapshot_at: float = inf, *, is_plain: bool = False) -> TrialRecorder:
        """Return a recorder that ends a run at the limit; one that `is_plain` records no variables."""

        def is_cut() -> bool:
            return self._used() >= 1.0 or self.work + recorder.work > self.limit

        remembered, written = ((), {}) if is_plain else (self.memory.all, self._written)
        recorder = TrialRecorder(remembered, written, since, snapshot_at, is_cut)
        return recorder

    def observe(self) -> None:
        """Let all later trials record how conditions come out."""
        self.observes = True
        self._forget()

    def give(self, settings: Mapping[str, object]) -> None:
        """Add settings for all later trials."""
        self.base |= settings
        self._forget()

    def play(
        self,
        timeline: Timeline,
        since: float,
        is_settled: Callable[[Trial], bool] = lambda trial: False,
        patience: float = HORIZON,
        world: Mapping[str, object] = NOWHERE,
    ) -> Trial:
        """Run the program with a timeline, for `patience`, s, and until no axis is on its way to an end any more.

        It ends earlier if `is_settled` is true of what it has done so far. The entries of a `world` come with it.
        """
        if world != self._world:
            self._world = world
            self._forget()
        # No more than three changes come at once.
        self.tell(in_words(each for at, each in timeline[-3:] if at == timeline[-1][0]) or "start")
        self.count += 1
        last = max((since, *(at + each.moment.times * each.moment.every for at, each in timeline)))
        horizons = iter(HORIZONS)
        until = last + next(horizons)
        if since > 0.0:
            recorder = self._continue(timeline, since, until)
        else:  # what is on at power-up changes no input
            recorder, power_up = self._powered_up(timeline, since)
            recorder.last_change = last
            self.last = self._run_on(power_up.machine, until)
        trial = _trial(timeline, since, self.last, recorder, self.base)
        for horizon in horizons:
            is_enough = is_settled(trial) or (
                horizon > patience and (not trial.is_busy or len(trial.moves) > MAX_MOVES)
            )
            if trial.status != "until" or trial.time < until or is_enough:
                break
            until = last + horizon
            self.last = self._run_on(self.last.machine, until)
            trial = _trial(timeline, since, self.last, recorder, self.base)
        self._note_work(recorder)
        return trial

    def _note_work(self, recorder: TrialRecorder) -> None:
        self.seen |= recorder.seen
        self.work += recorder.work

    def _continue(self, timeline: Timeline, since: float, until: float) -> TrialRecorder:
        """Play on from shortly before the changes; bring the run there first if it is not the last start."""
        start = self._start = self._start_before(timeline, since)
        self.last = start.run
        if start.recorder.go_back():
            self._change(start, timeline)
            self.last = self._run_on(start.run.machine, until)
        return start.recorder

    def _start_before(self, timeline: Timeline, since: float) -> Start:
        """Return the moment before the changes at a time: the last one, one reached from there, or from power-up."""
        before, start = tuple(each for each in timeline if each[0] < since), self._start
        if start is not None and (start.before, start.since) == (before, since):
            return start
        at = max(since - LEAD, 0.0)
        if start is not None and start.leads_to(before, since) and start.recorder.go_back():
            recorder = start.recorder
            recorder.begin(since, at)
            recorder.expect_changes()
            self._change(start, before)
            result = self._run_on(start.run.machine, at)
        else:
            recorder, power_up = self._powered_up(before, since, at)
            recorder.expect_changes()
            result = self._run_on(power_up.machine, at)
        self._note_work(recorder)
        return Start(before, since, recorder, result)

    def _powered_up(
        self, timeline: Timeline, since: float, snapshot_at: float = inf
    ) -> tuple[TrialRecorder, Run]:
        """Return a run before its first statement, to which the changes of a timeline come, and its recorder."""
        on, self._start = tuple(each for each in timeline if each[0] <= 0.0), None
        if self._power_up is None or self._power_up.on != on:
            recorder = self._recorder(0.0)
            made = self._run(merged(self._world, tables_of(on)), 0.0, recorder)
            self._power_up = PowerUp(on, Snapshot(made.machine.scheduler), recorder, made)
        recorder, made = self._power_up.recorder, self._power_up.run
        self._power_up.snapshot.restore()
        recorder.restart(since, snapshot_at)
        made.machine.add_entries(tables_of(tuple(each for each in timeline if each[0] > 0.0)))
        return recorder, made

    def _change(self, start: Start, timeline: Timeline) -> None:
        machine = start.run.machine
        changes = tuple(each for each in timeline if each[0] >= start.since)
        machine.add_entries(tables_of(changes, machine.clock.now))

    def _run(self, tables: Mapping[str, object], until: float | None, recorder: TrialRecorder) -> Run:
        settings = CheckedSettings(merged(self.base, tables))
        self.work += LINE * self._lines
        observer = recorder if self.observes else None
        return self._noted(
            run(
                self.program,
                machine=settings,
                until=until,
                hook=recorder,
                observer=observer,
                begun=recorder.attach,
            )
        )

    def _run_on(self, machine: Machine, until: float) -> Run:
        program = self.program
        self.work += GO_ON
        language = dialect(program.language)
        return self._noted(run_on(program.source, language, program, machine, until, has_notes=False))

    def _noted(self, result: Run) -> Run:
        if result.status == "interrupted":
            raise Interrupted(result)
        return result

    def play_in(self, tables: Mapping[str, object], until: float) -> Trial:
        """Run the program with some tables of the machine file up to a time, or as long as a trial may be."""
        self.tell("a world")
        self.count += 1
        recorder = self._recorder(0.0)
        self.last = self._run(tables, until, recorder)
        self._note_work(recorder)
        return _trial((), 0.0, self.last, recorder, self.base)

    def run_in(
        self, tables: Mapping[str, object], *until: float, stands: Callable[[Run], bool] = lambda run: False
    ) -> tuple[Run, Mapping[int, Set[str]], dict[Channel, list[ReadSpan]]]:
        """Run the program with some tables of the machine file up to a time, or the first of some at which it `stands`.

        Without a time the run ends where that of a machine file does. Returns also what has begun, with the tasks in
        which it has, and when each channel was read, in the order in which they were read first.
        """
        self.tell("a world")
        self.count += 1
        recorder = self._recorder(inf, is_plain=True)
        result = self._run(tables, until[0] if until else None, recorder)
        for before, time in pairwise(until):
            if result.status != "until" or result.time < before or stands(result):
                break
            result = self._run_on(result.machine, time)
        self._note_work(recorder)
        spans: dict[Channel, list[ReadSpan]] = defaultdict(list)
        for each in recorder.readings.values():
            for channel, read in each.items():
                spans[channel] += read
        firsts = sorted(spans, key=lambda channel: (min(spans[channel]).first, channel))
        return result, recorder.tasks, {channel: spans[channel] for channel in firsts}


def _question(result: Run) -> str | None:
    """Return what an INPUT asks, from where the program has moved the cursor last; None if none asks."""
    text = result.machine.operator.question
    return plain(text[max(text.rfind("\x1b"), 0) :]).strip(" ?:") if asks(result) else None


# The shapes of profiles without an end of their own.
ENDLESS = frozenset(("jog", "gear"))


def _trial(
    timeline: Timeline, since: float, result: Run, recorder: TrialRecorder, base: Mapping[str, object]
) -> Trial:
    log = result.machine.log
    return Trial(
        timeline,
        since,
        result.time,
        result.status,
        _is_stuck(result),
        _is_homing(result, base),
        recorder.is_idle,
        _question(result),
        list(_moves(result)),
        [each for each in log.outputs if each.time >= since],
        list(log.prints),
        [*log.waits.written(), *_open_waits(result)],
        recorder.statements,
        recorder.comparisons,
        recorder.decided,
        recorder.readings,
        recorder.memory,
        recorder.seen,
        recorder.before | {each for each in recorder.seen if isinstance(each, int)},
        set(recorder.outcomes),
    )


def _is_homing(result: Run, base: Mapping[str, object]) -> bool:
    """True if an axis homes, or a task waits for a switch or mark of an axis that the settings have."""
    scheduler = result.machine.scheduler
    waits = [task.wait for task in scheduler.tasks if not task.done] if scheduler is not None else []
    wanted = (key for wait in waits if wait is not None for key in result.dialect.driven_by(wait.why))
    return any(axis.homing is not None for axis in result.controller.axes.values()) or any(
        key.startswith("axis.") and key in base for key in wanted
    )


def asks(result: Run) -> bool:
    """True if a run ended because the program asks for a line and no answer is left."""
    scheduler = result.machine.scheduler
    tasks = () if scheduler is None else scheduler.tasks
    waits = [task.wait for task in tasks if not task.done and task.wait is not None]
    return result.status in ("fault", "until") and any(wait.cause == "operator" for wait in waits)


def _is_stuck(result: Run) -> bool:
    """True if a run ended for lack of a change of the world; a motion that never comes is no such lack."""
    scheduler = result.machine.scheduler
    waits = [task.wait for task in scheduler.tasks if not task.done] if scheduler is not None else []
    if all(wait is not None and wait.cause == "axis" for wait in waits):
        return False
    return asks(result) or result.has_run_out or any(each.code == "never" for each in result.diagnostics)


def _moves(result: Run) -> Iterator[TrialMotion]:
    homes = result.dialect.table().homes
    for move in result.machine.log.moves:
        profile, end = move.profile, inf
        is_homing = homes(move.command)
        if profile is not None and profile.duration < inf and (profile.shape not in ENDLESS or is_homing):
            end = move.start_time + profile.duration
        yield TrialMotion(
            move.start_time,
            end,
            move.axis,
            move.line,
            move.ended,
            is_homing,
            is_short_move(move),
            move.command,
            profile,
            move.scale,
            move.zero,
        )


def is_short_move(move: LoggedMove) -> bool:
    """True if a move took no longer than one to where the axis is."""
    return move.profile is not None and move.profile.duration <= SHORTEST_MOVE


def _open_waits(result: Run) -> Iterator[Waited]:
    scheduler = result.machine.scheduler
    for task in scheduler.tasks if scheduler is not None else ():
        wait = task.wait
        if not task.done and wait is not None and (wait.cause != "time" or wait.due() == inf):
            yield task.waited(wait, inf)
