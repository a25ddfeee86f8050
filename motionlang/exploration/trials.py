"""Runs of one program in a changing world: each has a timeline of changes, and records what its tasks did.

Most trials change something at the same moment. The run is brought there once, a snapshot is taken shortly before it,
and each of these trials puts it back, adds its changes to the world, and goes on. Only the last such start is stored; a
later one with the same changes before it is reached from there.

A trial is split at the times of `HORIZONS`, where it ends if its caller has seen enough.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import defaultdict
from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping, Sequence
from math import inf
from operator import attrgetter
from typing import NamedTuple

from motionlang.kernel import CheckedSettings, Hook, Machine, Program, Run, Task, dialect, run, run_on
from motionlang.kernel.lang import DRIVES, Snapshot
from motionlang.kernel.log import LoggedMove, Printed, Switched, Waited
from motionlang.kernel.tools import count_of

# A trial lasts until so long after its last change, s; shorter if it is settled by one of the times before, and longer
# while an axis is on its way to an end.
HORIZON = 12.0
HORIZONS = (0.5, 1.5, 3.0, 6.0, HORIZON, 36.0, 108.0, 324.0)
# An axis that was on its way so short before the end of a trial still moves, s.
GAP = 0.25
# A snapshot is taken so long before the changes of its trials, s: longer than a time slice and a few statements.
LEAD = 0.002
# A trial ends after so many statements, or if none of so many is the first at its place and none starts a move.
MAX_STATEMENTS, MAX_REPEATED = 60_000, 20_000
# A trial is no longer than usual if it has made so many moves.
MAX_MOVES = 300
# The tables of the machine file with the changes of the world, and those of them that have texts, and no numbers.
TABLES = ("input", "analogue", "comms", "netdata", "dpr", "modbus.register", "coil", "key", "answer")
TEXTS = ("key", "answer")
Entry = dict[str, object]
# The number of a Modbus register is that in its server, and so many for each number of the server.
REGISTERS = 65536
# Where the name of a task would be, in a record of what handlers do.
HANDLERS = "!"

_ESCAPES = re.compile(r"\x1b(?:\[[0-9;?]*[A-Za-z]|[^\[])|[\x00-\x08\x0b-\x1f\x7f]")
_FIGURE = re.compile(r"[-+]?\d[\d.]*")


class Moment(NamedTuple):
    """The moment of a change of an input: so long after a change at rest, s, while a line moves an axis.

    With a period, `every`, s, the input comes and goes so many times. `line` is 0 at rest.
    """

    delay: float = 0.0
    axis: int = 0
    line: int = 0
    times: int = 1
    every: float = 0.0

    def __str__(self) -> str:
        often = f" {count_of(self.times, 'time')}" if self.every else ""
        return f"{often} while axis {self.axis} moves (line {self.line})" if self.line else often


AT_REST = Moment()


class Change(NamedTuple):
    """A change of the world: an input, an analogue input, a number of a host, a Modbus register, a key, or an answer.

    A key and an answer have the number 0, and their text as the value; `prompt` is the question. `keys_of` splits the
    number of a register. Only an input changes at another `moment` than at rest.
    """

    table: str
    number: int
    value: float | str
    prompt: str = ""
    moment: Moment = AT_REST

    @property
    def kind(self) -> Hashable:
        """An input and its level, or another channel and any value of it, at whatever moment."""
        value = self.value if self.table == "input" else None
        return self.table, self.number, self.prompt, value

    def levels(self, time: float) -> list[tuple[float, float]]:
        """Return the times and levels of an input that changes at a time, and comes and goes from then on."""
        assert isinstance(self.value, (int, float))
        every = self.moment.every
        if not every:
            return [(time, self.value)]
        return [
            each
            for start in (time + k * every for k in range(self.moment.times))
            for each in ((start, self.value), (start + every / 2, 1 - self.value))
        ]

    @property
    def subject(self) -> str:
        """The name of what is changed."""
        if self.table in TEXTS:
            return "a key" if self.table == "key" else f"an answer to {self.prompt!r}"
        keys = keys_of(self.table, self.number)
        server = f" of server {keys['server']}" if "server" in keys else ""
        return f"{DRIVES[self.table][0]} {keys[DRIVES[self.table][1]]}{server}"

    def __str__(self) -> str:
        if self.table == "input":
            return f"{self.subject} {'on' if self.value else 'off'}{self.moment}"
        if self.table == "key":
            return "key Enter" if self.value == "\r" else f"key {self.value}"
        if self.table == "answer":
            return f"{self.prompt!r} {self.value}"
        assert isinstance(self.value, (int, float))
        return f"{self.subject} = {self.value:.10g}"


def in_words(changes: Iterable[Change]) -> str:
    """Return changes in words; those in the middle of a move come later."""
    text = ""
    for each in changes:
        text += f"{', then ' if each.moment.line else ' and '}{each}" if text else str(each)
    return text


# Changes with their times, in order.
Timeline = tuple[tuple[float, Change], ...]


def made_at(time: float, changes: Iterable[Change]) -> Timeline:
    """Return changes with their times: at rest at a time, or at another moment that counts from it."""
    return tuple((time + each.moment.delay, each) for each in changes)


class Begun(NamedTuple):
    """A statement that began: its time, its source offset, and the offsets of the calls that led there."""

    time: float
    at: int
    callers: tuple[int, ...]


class TrialRecorder(Hook):
    """A record of the tasks of a run from a time on: their statements, the inputs that they read, comparisons."""

    def __init__(self, since: float, snapshot_at: float = inf) -> None:
        super().__init__(lambda task, time, offset: None, between=self._between)
        self._machine: Machine | None = None
        self._at = -1
        self.begin(since, snapshot_at)

    def begin(self, since: float, snapshot_at: float) -> None:
        """Begin an empty record from a time on, s, and take a snapshot at another one."""
        self.since, self._snapshot_at = since, snapshot_at
        # The state of the run at `snapshot_at`, and the statement that had begun last.
        self.snapshot: tuple[Snapshot, int] | None = None
        self._clear()

    def _clear(self) -> None:
        self.count = 0
        # True if so many statements were nothing new.
        self.is_idle = False
        self.statements: dict[str, list[Begun]] = defaultdict(list)
        # By source offset: left and right side of each comparison, in order.
        self.comparisons: dict[int, list[tuple[object, object]]] = defaultdict(list)
        # By source offset: the inputs that the statement there has read.
        self.readings: dict[int, dict[int, None]] = defaultdict(dict)
        # The offsets of the statements that began, and with the comparisons of one which side was the larger one.
        self.seen: set[int | tuple[int, int, int]] = set()
        self._comparisons = 0  # of the present statement
        # The statement that handlers have interrupted; -1 if none runs.
        self._interrupted = -1
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
        self.expect_changes()

    def expect_changes(self) -> None:
        """Let no wait before the changes be hopeless."""
        if self._snapshot_at < inf and self._machine is not None:
            self._machine.clock.at(self.since, _nothing)

    def _between(self) -> None:
        assert self._machine is not None
        if self.snapshot is None and self._machine.clock.now >= self._snapshot_at:
            self.snapshot = Snapshot(self._machine.scheduler), self._at

    def go_back(self) -> bool:
        """Put the snapshot back and begin another record; False if the program ended before."""
        if self.snapshot is None:
            return False
        snapshot, self._at = self.snapshot
        snapshot.restore()
        self._clear()
        return True

    def _reads(self, channel: int) -> None:
        self._come_back()
        if self._at >= 0:
            self.readings[self._at][channel] = None

    def _come_back(self) -> None:
        """Go back to the statement that handlers have interrupted when they have ended."""
        if self._interrupted >= 0 and self._machine is not None:
            scheduler = self._machine.scheduler
            if scheduler is None or not scheduler.interrupts:
                self._at, self._interrupted, self._comparisons = self._interrupted, -1, 0

    def begins(self, task: Task, time: float, offset: int) -> bool:
        """Record a statement, and end the run if it only repeats."""
        self.count += 1
        assert self._machine is not None
        scheduler = self._machine.scheduler
        if scheduler is None or not scheduler.interrupts:
            self._interrupted = -1
        elif self._interrupted < 0:
            self._interrupted = self._at
        self._at, self._is_recorded, self._comparisons = offset, time >= self.since, 0
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
        self.is_idle = self.count - self._news >= MAX_REPEATED
        if self.count < MAX_STATEMENTS and not self.is_idle:
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
        if self._machine.controller.inputs.is_supposed:
            return  # a hint asks what would end a wait
        self._come_back()
        if self._is_recorded or self._machine.clock.now >= self.since:  # a wait compares after it has begun
            self.comparisons[self._at].append((left, right))
            if isinstance(left, (int, float)) and isinstance(right, (int, float)):
                self._comparisons += 1
                self.seen.add((self._at, self._comparisons, (left > right) - (left < right)))


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


class TrialMotion(NamedTuple):
    """A move of a trial: when it began, s, its axis and its line, and how it was cut off, as in the log.

    `end` is infinite if it has no end of its own: a jog and a follower have none, a homing has. `words` are its target
    if it has one, and its highest speed, both in user units; none for an entry of the move buffer that moves nothing.
    """

    begin: float
    end: float
    axis: int
    line: int
    words: str
    ended: str
    is_homing: bool


class Trial(NamedTuple):
    """The record of a run with a timeline: nothing in it changes when another one begins.

    `time` and `status` are those of its end. `is_stuck` is True if it ended because nothing could change any more,
    `is_homing` if an axis still homes, `is_idle` if it was ended since it only repeated. `question` is that of an INPUT
    for which it has no answer.
    `waits` are in the order of their ends; those that go on end at infinity. `outputs` and, as the `TrialRecorder` has
    them, `statements`, `comparisons` and `readings` are those from `since` on.
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
    comparisons: Mapping[int, Sequence[tuple[object, object]]]
    readings: Mapping[int, Mapping[int, None]]

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


class Interrupted(Exception):
    """The user has interrupted a run of an exploration."""

    def __init__(self, result: Run) -> None:
        super().__init__("interrupted")
        self.result = result


class Trials:
    """Runs of one program, a debug build; `base` are the settings that no change replaces."""

    def __init__(
        self,
        program: Program,
        base: Mapping[str, object],
        most: int,
        is_over: Callable[[], bool] = lambda: False,
    ) -> None:
        self.program, self.base, self.most = program.on(base), dict(base), most
        self._is_over = is_over
        self.count = 0
        # True if so many statements were nothing new.
        self.is_idle = False
        # The run of the last trial, as it is until the next one.
        self.last: Run
        # What any trial has seen.
        self.seen: set[int | tuple[int, int, int]] = set()
        # Where the last trial started, if not at power-up.
        self._start: Start | None = None

    @property
    def is_over(self) -> bool:
        """True if the budget is used up, or the user has ended the exploration."""
        return self.count >= self.most or self._is_over()

    def give(self, settings: Mapping[str, object]) -> None:
        """Add settings for all later trials."""
        self.base |= settings
        self._start = None

    def play(
        self, timeline: Timeline, since: float, is_settled: Callable[[Trial], bool] = lambda trial: False
    ) -> Trial:
        """Run the program with a timeline, until nothing is on its way to an end any more.

        It ends earlier if `is_settled` is true of what it has done so far.
        """
        self.count += 1
        last = max((since, *(at + each.moment.times * each.moment.every for at, each in timeline)))
        horizons = iter(HORIZONS)
        until = last + next(horizons)
        if since > 0.0:
            recorder = self._continue(timeline, since, until)
        else:  # what is on at power-up changes no input
            recorder = TrialRecorder(since)
            self.last = self._run(tables_of(timeline), until, recorder)
        trial = _trial(timeline, since, self.last, recorder, self.base)
        for horizon in horizons:
            is_enough = is_settled(trial) or (
                horizon > HORIZON and (not trial.is_busy or len(trial.moves) > MAX_MOVES)
            )
            if trial.status != "until" or trial.time < until or is_enough:
                break
            until = last + horizon
            self.last = self._run_on(self.last.machine, until)
            trial = _trial(timeline, since, self.last, recorder, self.base)
        self.seen |= recorder.seen
        return trial

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
            recorder = TrialRecorder(since, at)
            result = self._run(tables_of(before), at, recorder)
        self.seen |= recorder.seen
        return Start(before, since, recorder, result)

    def _change(self, start: Start, timeline: Timeline) -> None:
        """Add the changes of a timeline to the world of a start that has been put back."""
        machine = start.run.machine
        changes = tuple(each for each in timeline if each[0] >= start.since)
        machine.add_entries(tables_of(changes, machine.clock.now))

    def _run(self, tables: Mapping[str, object], until: float | None, recorder: TrialRecorder) -> Run:
        settings = CheckedSettings(merged(self.base, tables))
        return self._noted(
            run(self.program, machine=settings, until=until, hook=recorder, begun=recorder.attach)
        )

    def _run_on(self, machine: Machine, until: float) -> Run:
        program = self.program
        return self._noted(run_on(program.source, dialect(program.language), program, machine, until))

    def _noted(self, result: Run) -> Run:
        if result.status == "interrupted":
            raise Interrupted(result)
        return result

    def run_in(self, tables: Mapping[str, object], until: float | None = None) -> tuple[Run, set[int]]:
        """Run the program with some tables of the machine file up to a time, and return what has begun, too.

        Without a time the run ends where that of a machine file does.
        """
        self.count += 1
        recorder = TrialRecorder(inf)
        result = self._run(tables, until, recorder)
        self.seen |= recorder.seen
        return result, {each for each in recorder.seen if isinstance(each, int)}


def merged(base: Mapping[str, object], tables: Mapping[str, object]) -> dict[str, object]:
    """Return settings with the entries of some tables added to their own."""
    added = {
        table: [*entries(base, table), *entries(tables, table)] if table in TABLES else value
        for table, value in tables.items()
    }
    return {**base, **added}


def entries(settings: Mapping[str, object], table: str) -> list[Entry]:
    """Return the entries of a table of settings."""
    found: list[Entry] = settings.get(table, [])  # type: ignore[assignment]
    return found


def given_in(settings: Mapping[str, object]) -> set[tuple[str, int]]:
    """Return the channels that settings have entries for, as table and number; answers and keys have the number 0."""
    return {(table, number_in(table, each)) for table in TABLES for each in entries(settings, table)}


def keys_of(table: str, number: int) -> Entry:
    """Return the keys of an entry that name a channel by its number, none for a key or an answer."""
    if table == "modbus.register":
        server, number = divmod(number, REGISTERS)
        return {"server": server, "register": number}
    return {DRIVES[table][1]: number} if DRIVES[table][1] else {}


def number_in(table: str, entry: Entry) -> int:
    """Return the number of the channel of an entry, 0 for a key or an answer."""
    server: int = entry.get("server", 0)  # type: ignore[assignment]
    number: int = entry.get(DRIVES[table][1], 0)  # type: ignore[assignment]
    return server * REGISTERS + number


def tables_of(timeline: Timeline, since: float = 0.0) -> dict[str, object]:
    """Return the tables of a machine file with the changes of a timeline; their times count from `since`."""
    tables: dict[str, list[dict[str, object]]] = defaultdict(list)
    for time, change in timeline:
        entry = keys_of(change.table, change.number)
        if change.table == "input":
            tables["input"] += (
                entry | {"at": at - since, "value": level} for at, level in change.levels(time)
            )
            continue
        if change.table != "answer":
            entry["at"] = time - since
        elif change.prompt:
            entry["prompt"] = change.prompt
        tables[change.table].append(entry | {_value_key(change.table): change.value})
    return dict(tables)


def _value_key(table: str) -> str:
    return "text" if table in TEXTS else "value"


def is_about(change: Change, entry: Entry) -> bool:
    """True if an entry makes a change."""
    value = entry[_value_key(change.table)]
    return value == change.value and number_in(change.table, entry) == change.number


def levels_at(timeline: Timeline, time: float) -> dict[int, float]:
    """Return the levels of the inputs that a timeline has changed by a time."""
    return {
        change.number: level
        for at, change in timeline
        if change.table == "input"
        for start, level in change.levels(at)
        if start <= time + 1e-9
    }


def _nothing() -> None:
    """Do nothing; an event at which something may change."""


# The shapes of profiles without an end of their own.
ENDLESS = frozenset(("jog", "gear"))


def _trial(
    timeline: Timeline, since: float, result: Run, recorder: TrialRecorder, base: Mapping[str, object]
) -> Trial:
    """Return what a run did that has just ended."""
    log = result.machine.log
    return Trial(
        timeline,
        since,
        result.time,
        result.status,
        _is_stuck(result),
        _is_homing(result, base),
        recorder.is_idle,
        plain(result.machine.operator.question).strip(" ?:") if asks(result) else None,
        list(_moves(result)),
        log.outputs[bisect_left(log.outputs, since, key=attrgetter("time")) :],
        list(log.prints),
        [*log.waits.written(), *_open_waits(result)],
        recorder.statements,
        recorder.comparisons,
        recorder.readings,
    )


def plain(text: str) -> str:
    """Return a printed line without escape codes and control characters."""
    return _ESCAPES.sub("", text).strip()


def without_figures(text: str) -> str:
    """Return a printed line with a mark for each of its figures, which differ from run to run."""
    return _FIGURE.sub("#", text)


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
    return asks(result) or any(each.code == "never" for each in result.diagnostics)


def _moves(result: Run) -> Iterator[TrialMotion]:
    homes = result.dialect.table().homes
    for move in result.machine.log.moves:
        profile, end = move.profile, inf
        is_homing = homes(move.command)
        if profile is not None and profile.duration < inf and (profile.shape not in ENDLESS or is_homing):
            end = move.start_time + profile.duration
        yield TrialMotion(
            move.start_time, end, move.axis, move.line, described(move, is_homing), move.ended, is_homing
        )


def described(move: LoggedMove, is_homing: bool) -> str:
    """Return where a move goes and how fast, in user units and words; "" for an entry that moves nothing."""
    profile = move.profile
    if profile is None:
        return ""
    words = [move.command] if is_homing or profile.duration == inf else []
    if profile.duration < inf:
        words.append(f"to {move.to_user(profile.end):.6g}")
    if profile.peak_speed:
        words.append(f"at {move.size_to_user(profile.peak_speed):.6g}")
    return " ".join(words)


def _open_waits(result: Run) -> Iterator[Waited]:
    """Yield the waits that go on, but for those that a time ends."""
    scheduler = result.machine.scheduler
    for task in scheduler.tasks if scheduler is not None else ():
        wait = task.wait
        if not task.done and wait is not None and (wait.cause != "time" or wait.due() == inf):
            yield Waited(*task.waited(wait, inf))  # type: ignore[arg-type]
