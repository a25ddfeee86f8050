"""The rests of a trial: where each task waits, or repeats a loop while no axis is on its way to an end."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import Counter, defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import reduce
from itertools import accumulate, chain, pairwise
from math import inf
from operator import attrgetter, itemgetter
from typing import NamedTuple

from motionlang.kernel.lang import Structure
from motionlang.kernel.log import Waited
from motionlang.kernel.tools import ranges
from motionlang_explore.exploration.changes import Channel
from motionlang_explore.exploration.memory import Memory
from motionlang_explore.exploration.recorder import HANDLERS, Begun
from motionlang_explore.exploration.trials import Trial, TrialMotion

# What begins so soon after another statement of a loop belongs to it, s.
BODY = 0.1
# The shortest rest, s.
SHORTEST_REST = 0.15
# A rest that lasts has lasted for so long when a trial ends, s.
QUIET = 0.4
# Times that differ by less are the same, s.
EXACT = 1e-4


class TaskRest(NamedTuple):
    """The place where a task rests: the statements that it repeats or waits at, and the calls that lead there.

    `memory` are the variables that decide what it does later, by their numbers, with their values.
    """

    task: str
    statements: frozenset[int]
    callers: tuple[int, ...] = ()
    memory: tuple[tuple[int, object], ...] = ()


# The state of a machine at rest: that of each task that works, in the order of their names.
RestState = tuple[TaskRest, ...]


def without_memory(state: RestState | None) -> RestState | None:
    """Return a state without what the program remembers."""
    return None if state is None else tuple(each._replace(memory=()) for each in state)


class Rest(NamedTuple):
    """A stay in a rest state: its times, s; `end` is infinite if only a change of the world ends it.

    `question` is that of an INPUT that has no answer. `reads` are the channels that were read while it lasted, by the
    source offset of the statement that did.
    """

    begin: float
    end: float
    state: RestState
    question: str | None = None
    reads: Mapping[int, Sequence[Channel]] = {}


class _Stay(NamedTuple):
    """A stay of one task; its statements began to wait or to repeat at `since`, when axes may still have moved."""

    since: float
    begin: float
    end: float
    place: TaskRest
    question: str | None = None


def lines_of(state: RestState | None, line: Callable[[int], int], most: float = inf) -> str:
    """Return the lines of a state, with those of the calls that lead there; `line` is that of a source offset.

    Of more ranges of lines than `most` only the first and the last one are named.
    """
    if state is None:
        return "power-up"
    return " and ".join(_place(each, line, most) for each in state)


def _place(place: TaskRest, line: Callable[[int], int], most: float) -> str:
    lines = ranges(line(at) for at in place.statements).split(", ")
    shown = ", ".join(lines if len(lines) <= most else [lines[0], "…", lines[-1]])
    calls = ", ".join(str(line(at)) for at in place.callers)
    return f"{shown} called in {calls}" if calls else shown


def statements_of(state: RestState, structure: Structure) -> str:
    """Return the first statement of each place of a state."""
    return " | ".join(structure.statements[min(place.statements)].text for place in state)


def rests(
    trial: Trial, beside: frozenset[int], memory: Memory, forgotten: Collection[int] = ()
) -> list[Rest]:
    """Return the rests of a machine from `trial.since` on: the times at which each task rests that works.

    The statements `beside` are those of tasks that do not count. A task that never rests does not count either. The
    variables of the memory count, but for those that are `forgotten`.
    """
    moves = _Motions(trial.motions)
    stays: dict[str, list[_Stay]] = defaultdict(list)
    for stay in (*_waits(trial, moves), *_loops(trial, moves)):
        if not stay.place.statements <= beside:
            stays[stay.place.task].append(stay)
    active = {task: _activity(task, trial) for task in stays}
    times = sorted({time for each in chain.from_iterable(stays.values()) for time in (each.begin, each.end)})
    found: list[Rest] = []
    begun: list[float] = []
    for begin, end in pairwise(times):
        at_rest = [
            next((each for each in stays[task] if each.begin <= begin and end <= each.end), None)
            for task in sorted(stays)
            if active[task][0] < end and begin < active[task][1]
        ]
        known = [each for each in at_rest if each is not None]
        if not known or len(known) < len(at_rest):
            continue
        question = next((each.question for each in known if each.question is not None), None)
        rest = Rest(begin, end, tuple(each.place for each in known), question)
        since = min([begin, *(each.since for each in known)])
        if found and found[-1].state == rest.state and found[-1].end == begin:
            found[-1] = found[-1]._replace(end=end, question=question)
        else:
            found.append(rest)
            begun.append(since)
    is_cut = trial.status == "until" and not trial.is_stuck and not trial.is_idle
    return [
        each._replace(
            state=_with_memory(each, trial, memory, forgotten), reads=_reads(each, since, trial, beside)
        )
        for each, since in zip(found, begun, strict=True)
        if (
            trial.time - each.begin > QUIET
            if is_cut and each.end == inf
            else each.end - each.begin > SHORTEST_REST
        )
    ]


def _with_memory(rest: Rest, trial: Trial, memory: Memory, forgotten: Collection[int]) -> RestState:
    """Return the state of a rest with what the program remembers: variables that keep their values while it lasts.

    The first pass of a loop may still set what leads there.
    """
    first = bisect_right(trial.memory, rest.begin + BODY, key=itemgetter(0))
    last = bisect_left(trial.memory, min(rest.end, trial.time), key=itemgetter(0))
    values = [each for _, each in trial.memory[max(first - 1, 0) : max(last, first)]]
    state = []
    for place in rest.state:
        numbers = [(n, memory.all.index(n)) for n in memory.variables(place.statements) if n not in forgotten]
        kept = [
            (n, values[0][k])
            for n, k in numbers
            if values and all(each[k] == values[0][k] for each in values)
        ]
        state.append(
            place._replace(
                memory=tuple(
                    (n, memory.value(n, value)) for n, value in kept if isinstance(value, (int, float, str))
                )
            )
        )
    return tuple(state)


def _reads(rest: Rest, since: float, trial: Trial, beside: frozenset[int]) -> dict[int, list[Channel]]:
    """Return the channels that the statements of a rest have read, and those of tasks beside the work meanwhile."""
    places = frozenset[int]().union(*(each.statements for each in rest.state))
    found: dict[int, list[Channel]] = {}
    for at, channels in trial.readings.items():
        begin = since if at in places else rest.begin if at in beside else inf
        read = []
        for channel, spans in channels.items():
            k = bisect_left(spans, begin - EXACT, key=attrgetter("last"))
            if k < len(spans) and spans[k].first < rest.end:
                read.append(channel)
        if read:
            found[at] = read
    return found


def _activity(task: str, trial: Trial) -> tuple[float, float]:
    """Return when a task is known to run first and last; the last is infinite if it waits then or loops."""
    begun = trial.statements.get(task, ())
    waits = [each for each in trial.waits if each.task == task]
    first = min([*(each.time for each in begun[:1]), *(each.since for each in waits)])
    last = max([*(each.time for each in begun[-1:]), *(each.until for each in waits)])
    return first, last if trial.has_ended or last < trial.time - BODY else inf


def _waits(trial: Trial, moves: _Motions) -> Iterator[_Stay]:
    """Yield the waits that last, without the motion that goes on meanwhile; not those for nothing but a time."""
    for wait in trial.waits:
        end = wait.until
        if end <= trial.since or (end == inf and trial.has_ended):
            continue
        if wait.cause == "time" and end < inf and not _has_read(trial, wait):
            continue
        known = trial.time + 1.0 if trial.is_stuck and end == inf else min(end, trial.time)
        since = max(wait.since, trial.since)
        question = trial.question if end == inf and wait.cause == "operator" else None
        place = TaskRest(wait.task, frozenset((wait.at,)), _without_repeats(wait.callers))
        for begin, until in moves.gaps(since, known):
            if until - begin > SHORTEST_REST:
                yield _Stay(since, begin, end if until == known else until, place, question)


def _has_read(trial: Trial, wait: Waited) -> bool:
    """True if a wait has read a channel: its time ends it if nothing else does."""
    spans = chain.from_iterable(trial.readings.get(wait.at, {}).values())
    return any(wait.since - EXACT <= each.last and each.first <= wait.until for each in spans)


class _Stretch:
    """Statements of a task that may be a loop: from one statement on until it comes again, and as long as these repeat.

    A loop that is shorter than `BODY` has all statements of that time, since each pass may take another branch.
    """

    def __init__(self, first: Begun) -> None:
        self.first = first.time  # when what lies before it ends
        self.begin = first.time  # when its loop begins
        self.callers = first.callers
        # Each statement as it began last, when it began first, and how often it did.
        self.body = {first.at: first}
        self.firsts = {first.at: first.time}
        self.counts = Counter((first.at,))
        self.is_known = False
        self._pass = inf  # the shortest time from a statement to the same one
        self._last_pass = inf  # when the last statement began before
        self._long_pass = 0.0  # when one longer than `BODY` has ended before anything was known to repeat

    def take(self, begun: Begun, is_behind_skip: bool) -> bool:
        """Take a statement that belongs to the loop; False if it does not.

        Behind a skip of passes that only repeat, what began more than once just before it is the loop.
        """
        if is_behind_skip and not self.is_known:
            self._know(self._last_pass)
        before = self.body.get(begun.at)
        self._last_pass = inf if before is None else before.time
        if self.is_known and before is None:
            return False
        if before is not None:
            self._pass = min(self._pass, begun.time - before.time)
            if not self.is_known and begun.time - self.begin >= SHORTEST_REST:
                self._know(min(before.time, begun.time - BODY))
            if not self.is_known and begun.time - before.time > BODY:
                self._long_pass = begun.time
        self.body[begun.at] = begun
        self.firsts.setdefault(begun.at, begun.time)
        self.counts[begun.at] += 1
        if self.is_known:
            # Calls of the loop come and go; those that all of its statements have in common lead to it.
            self.callers = _common(self.callers, begun.callers)
        return True

    def _know(self, since: float) -> None:
        """Take what began since a time for the loop, if any of it repeats."""
        again = [each for at, each in self.body.items() if each.time >= since and self.counts[at] > 1]
        if not again:
            return
        before = (each.time for each in self.body.values() if each.time < since)
        self.begin = max((min(self.firsts[each.at] for each in again), *before))
        self.body = {at: each for at, each in self.body.items() if each.time >= since}
        self.callers = reduce(_common, (each.callers for each in again))
        self.is_known = True

    def loop(self, end: float) -> frozenset[int]:
        """Return the statements that repeat, none if they do not for another pass until a time."""
        if not self.is_known or end - self.begin < 1.5 * self._pass:
            return frozenset()
        return frozenset(at for at in self.body if self.counts[at] > 1)

    @property
    def since(self) -> float:
        """When the loop begins: behind a long first pass, if that did something else as well."""
        is_other = any(self.counts[at] == 1 for at in self.body)
        return max(self.begin, self._long_pass) if is_other else self.begin


def _loops(trial: Trial, moves: _Motions) -> Iterator[_Stay]:
    """Yield the loops that repeat the same statements while nothing moves to an end."""
    for name, statements in trial.statements.items():
        if name == HANDLERS:
            continue
        waits = [
            each for each in trial.waits if each.task == name and each.until - each.since > SHORTEST_REST
        ]
        starts = moves.begins
        stretches = list(_stretches(statements, starts, sorted(each.since for each in waits)))
        ends = [*(each.first for each in stretches[1:]), statements[-1].time if trial.has_ended else inf]
        for stretch, end in zip(stretches, ends, strict=True):
            known = min(end, trial.time)
            loop, since = stretch.loop(known), stretch.since
            begin = moves.at_rest(since, known)
            if loop and known - begin >= SHORTEST_REST:
                yield _Stay(since, begin, end, TaskRest(name, loop, _without_repeats(stretch.callers)))


def _stretches(
    statements: Iterable[Begun], starts: Sequence[float], waits: Sequence[float]
) -> Iterator[_Stretch]:
    """Yield the stretches of statements; where a move begins, the work goes on, and another one begins.

    Where no statement begins for long, and no wait, the interpreter has skipped passes of a loop.
    """
    stretch: _Stretch | None = None
    time, before = 0.0, bisect_right(starts, 0.0)
    for begun in statements:
        moved = bisect_right(starts, begun.time)
        has_moved, before = moved > before, moved
        is_behind_skip = begun.time - time > SHORTEST_REST and bisect_left(waits, time) == bisect_left(
            waits, begun.time
        )
        if stretch is None or has_moved or not stretch.take(begun, is_behind_skip):
            if stretch is not None:
                yield stretch
            stretch = _Stretch(begun)
        time = begun.time
    if stretch is not None:
        yield stretch


def _without_repeats(callers: Sequence[int]) -> tuple[int, ...]:
    """Return calls without what lies between a call and the same one again: jumps of macros only lead deeper."""
    found: dict[int, None] = {}
    for each in callers:
        if each in found:
            found = dict.fromkeys(list(found)[: list(found).index(each)])
        found[each] = None
    return tuple(found)


def _common(one: tuple[int, ...], other: tuple[int, ...]) -> tuple[int, ...]:
    """Return the calls that two statements have in common, the outermost first."""
    if one is other:
        return one
    count = next(
        (k for k, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other))
    )
    return one[:count]


class _Motions:
    """The times at which moves with an end of their own begin, in order, and the last end of those begun by each."""

    def __init__(self, moves: Sequence[TrialMotion]) -> None:
        ordered = sorted(moves, key=lambda each: each.begin)
        self.begins = [each.begin for each in ordered]
        self._ends = list(accumulate((each.end for each in ordered), max))

    def gaps(self, begin: float, end: float) -> Iterator[tuple[float, float]]:
        """Yield the stretches between two times in which nothing is on its way to an end."""
        first = bisect_left(self.begins, begin)
        since = max(begin, self._ends[first - 1]) if first else begin
        for k in range(first, bisect_left(self.begins, end)):
            if self.begins[k] > since:
                yield since, self.begins[k]
            since = max(since, self._ends[k])
        if since < end:
            yield since, end

    def at_rest(self, begin: float, end: float) -> float:
        """Return when the motion between two times that goes on last has ended, at most `end`."""
        begun = bisect_left(self.begins, end)
        last = self._ends[begun - 1] if begun else begin
        return max(begin, min(last, end))
