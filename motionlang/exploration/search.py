"""The search of an exploration: what is tried from which state, and where it leads."""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter, defaultdict
from collections.abc import Callable, Collection, Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import chain
from math import inf
from operator import attrgetter, itemgetter
from typing import NamedTuple

from motionlang.exploration.rests import BODY, QUIET, SHORTEST_REST, Rest, RestState, rests
from motionlang.exploration.switches import FoundSwitches
from motionlang.exploration.trials import (
    AT_REST,
    HANDLERS,
    Act,
    Change,
    Moment,
    Timeline,
    Trial,
    TrialMotion,
    Trials,
    given_in,
    levels_at,
    made_at,
    plain,
    without_figures,
)
from motionlang.exploration.values import (
    ANSWERS,
    compared_in,
    counts,
    is_probe,
    level_of_bit,
    printed_for,
    probes,
    solved,
    usual_answers,
)
from motionlang.kernel import Program
from motionlang.kernel.lang import WRITE, Structure, Unit
from motionlang.kernel.log import Printed, Switched

MAX_TRIALS = 500
# A change comes so long after the program is at rest, s.
DELAY = 0.3
# So many trials show that a program counts how often an input comes: without it, once, twice.
ENOUGH = 3
# The period of an input that comes and goes at rest, s.
PERIOD = 0.4

Causes = tuple[Change, ...]


class Visit(NamedTuple):
    """A way to a state: the timeline that leads there, and when the stay begins and ends, at infinity if it lasts.

    `moved` are the lines that moved an axis on the way. `question` is that of an INPUT.
    """

    timeline: Timeline
    time: float
    end: float = inf
    moved: frozenset[int] = frozenset()
    question: str | None = None

    @property
    def lasts(self) -> bool:
        """True if only a change of the world ends the stay."""
        return self.end == inf

    @property
    def change_time(self) -> float:
        """When a change comes; an answer is taken when the program asks."""
        if self.question is not None:
            return self.time
        return round(max(self.time + delay(self.time, self.end), 0.0), 4)

    @property
    def levels(self) -> dict[int, float]:
        """The levels of the inputs that have changed by then."""
        return levels_at(self.timeline, self.change_time)

    def changed(self, causes: Causes) -> Timeline:
        """Return the timeline with changes of the stay."""
        time = self.change_time
        return (*(each for each in self.timeline if each[0] <= time), *made_at(time, causes))


def delay(begin: float, end: float) -> float:
    """Return the time from the begin of a rest to a change: it comes before the rest ends by itself."""
    return min(DELAY, (end - begin) / 2.0)


@dataclass
class Transition:
    """A way from a state to the next one.

    `causes` are the changes of the world, none if it comes by itself. `target` is None if the program ends. `lines` are
    those that move an axis, in order, `work` those that do more than a homing, and `outputs` are switched on. `acts`
    are the moves, outputs and printed lines in order. `is_cut` is True if a handler ran that commands anything, or a
    fault cut off a move. `visit` is that of the source from which it was found, `is_later` if that is no shortest one.
    `is_by_itself` is True if the stay ends without the changes at that time. Two transitions do the same if `does` is
    equal: the lines that move, how they were cut off, the outputs that are switched, and words. `variants` are other
    values of the same channels with which the same happens.
    """

    source: RestState | None
    causes: Causes
    target: RestState | None
    seconds: float
    lines: tuple[int, ...]
    work: frozenset[int]
    outputs: frozenset[int]
    acts: tuple[Act, ...]
    is_cut: bool
    visit: Visit
    is_later: bool
    is_by_itself: bool
    does: Hashable
    variants: dict[Causes, None] = field(default_factory=dict)


@dataclass(eq=False)
class Departure:
    """Changes that are still to be tried from a visit, so many at once; None for each change by itself.

    `tried` are those that have been tried from the visit.
    """

    visit: Visit
    changes: Iterator[Causes] | None = None
    depth: int = 1
    tried: set[Causes] = field(default_factory=set)


@dataclass
class StateNode:
    """A state: the shortest way there, and a later one with further moves, since these may decide what follows.

    `printed` is what the program prints before it asks the question of the state, `refused` what it does with answers
    after which it asks again.
    """

    state: RestState | None
    first: Visit
    later: Visit | None = None
    printed: str = ""
    refused: dict[Causes, tuple[Act, ...]] = field(default_factory=dict)
    # What was tried, and what is still to be tried.
    tried: dict[Causes, None] = field(default_factory=dict)
    left: list[Departure] = field(default_factory=list)
    transitions: list[Transition] = field(default_factory=list)

    @property
    def moved(self) -> frozenset[int]:
        """The lines that moved an axis on the shortest way there."""
        return self.first.moved

    def knows(self, causes: Causes, target: RestState | None, does: Hashable) -> bool:
        """True if the same happens by these causes, by some of them, or by other values or moments of their channels.

        Other values are noted, since what they do may differ later.
        """
        kinds = {each.kind for each in causes}
        for each in self.transitions:
            known = {one.kind for one in each.causes}
            if each.target == target and each.does == does and known <= kinds:
                values = [one._replace(moment=AT_REST) for one in causes]
                others = [one._replace(moment=AT_REST) for one in each.causes]
                if known == kinds and others != values and not any(map(is_probe, causes)):
                    each.variants[causes] = None
                return True
        return False


class Work(NamedTuple):
    """Work that a program repeats without a rest: its period, s, the lines that move an axis, and the outputs."""

    timeline: Timeline
    period: float
    lines: frozenset[int]
    outputs: frozenset[int]


class ChangeInMove(NamedTuple):
    """An input that may change in the middle of a move; `onward` are the lines that move an axis later."""

    change: Change
    motion: TrialMotion
    onward: frozenset[int]

    @property
    def key(self) -> Hashable:
        """The input, the line that moves the axis, and what comes after it: the change is tried once in each."""
        return self.change.number, self.motion.line, self.onward

    def added(self, causes: Causes, since: float, times: int = 0) -> Causes:
        """Return changes at a time, and this one in the middle of the move after it, or so many times in the move."""
        begin, end, axis, line = self.motion[:4]
        every = (end - begin) / times if times else 0.0
        first = begin + (every / 4 if times else (end - begin) / 2)
        moment = Moment(round(first - since, 4), axis, line, times or 1, every)
        return (*causes, self.change._replace(moment=moment))


class Explorer:
    """The exploration of a program in a world; `machine` are the settings that a person gave."""

    def __init__(
        self,
        program: Program,
        machine: Mapping[str, object],
        most: int = MAX_TRIALS,
        is_over: Callable[[], bool] = lambda: False,
        progress: Callable[[float], object] = lambda share: None,
    ) -> None:
        kept = {key: value for key, value in machine.items() if not key.startswith("run.")}
        target = program.target
        if target.model:
            kept.setdefault("controller.model", target.model)
        self.switches = FoundSwitches(kept)
        self.progress = progress
        self.trials = Trials(program, kept, most, is_over)
        self.program = program = self.trials.program
        self.nodes: dict[RestState | None, StateNode] = {}
        # What a person has given does not change.
        given = {number for table, number in given_in(kept) if table == "input"}
        self._given = given
        # The inputs that each line reads, and the level that leads on, if that is known.
        self._read_in: dict[int, dict[int, float]] = {}
        for line, use in sorted(program.structure.inputs(), key=itemgetter(0)):
            if use.channel == "input" and use.number.isdecimal() and int(use.number) not in given:
                self._read_in.setdefault(line, {})[int(use.number)] = 1.0
        self.channels = list(dict.fromkeys(channel for known in self._read_in.values() for channel in known))
        # The statements that read an input of a computed number.
        self._computed = {
            at
            for at, statement in program.structure.statements.items()
            if any(use.channel == "input" and not use.number.isdecimal() for use in statement.channels)
        }
        # The inputs that each statement has read that reads a whole bank, until those that matter are known.
        self._banks: dict[int, list[int]] = {
            at: []
            for at, statement in program.structure.statements.items()
            if any(use.channel == "input bank" for use in statement.channels)
        }
        # The statements of the handlers that more than time starts.
        units = program.structure.units
        events = [unit for unit in units if unit.kind == "event" and not unit.is_timed]
        self.handlers = frozenset[int]().union(*(_reached(program.structure, each) for each in events))
        self.beside = _beside(program.structure)
        # The inputs whose changes start a handler.
        self.triggers = _triggers(events)
        # Handlers that command nothing count or take note.
        quiet = [each for each in events if not _commands(program.structure, each)]
        self.counters = _triggers(quiet)
        self._commanding = self.handlers.difference(*(_reached(program.structure, each) for each in quiet))
        # The changes in the middle of a move that were tried.
        self._changed_in: set[Hashable] = set()
        # The lines that move an axis in any transition.
        self._moved: set[int] = set()
        # Two unusual values of each channel that has more than two, and the lines that read it.
        self.probes = [
            each for each in probes(program) if (each[0].table, each[0].number) not in given_in(kept)
        ]
        # The axes that each line moves.
        self.axes: dict[int, set[int]] = defaultdict(set)
        # Work that goes on without a rest.
        self.working: list[Work] = []

    # ------------------------------------------------------------------------------------------------- playing

    def line(self, at: int) -> int:
        """Return the line of a source offset."""
        return self.program.structure.line(at)

    def reads(self, state: RestState) -> list[str]:
        """Return the names of what the statements of a state read."""
        offsets = sorted(at for place in state for at in place.statements)
        lines = sorted(set(map(self.line, offsets)))
        found = [f"input {channel}" for line in lines for channel in sorted(self._read_in.get(line, ()))]
        loops = filter(None, map(self.program.structure.waits.at, offsets))
        leaves = sorted({read for loop in loops for read in loop.leaves}, key=str)
        found += [f"input {number}" for kind, number in leaves if kind == "input" and number is not None]
        found += [first.subject for first, _, read_in in self.probes if read_in & set(lines)]
        return list(dict.fromkeys(found))

    def play(
        self, timeline: Timeline, since: float, is_settled: Callable[[Trial], bool] = lambda trial: False
    ) -> Trial:
        """Run the program with a timeline, and with what leaves no choice; see `Trials.play`."""
        while True:
            self.progress(min(self.trials.count / self.trials.most, 1.0))
            trial = self.trials.play(timeline, since, is_settled)
            self._note_readings(trial)
            if self.trials.is_over or not self.switches.add(self.trials.last):
                return trial
            self.trials.give(self.switches.settings)

    def _is_settled(self, trial: Trial) -> bool:
        """True if the machine came to rest in a state that is known to last."""
        if trial.is_busy:
            return False
        last = next((rest for rest in self.rests(trial) if rest.end == inf), None)
        return (
            last is not None
            and last.begin < trial.time - QUIET
            and last.state in self.nodes
            and self.nodes[last.state].first.lasts
        )

    def _note_readings(self, trial: Trial) -> None:
        """Take note of the inputs that statements read whose numbers only a run can know."""
        for at, channels in trial.readings.items():
            if at in self._banks:
                self._banks[at] = [channel for channel in channels if channel not in self._given]
            if at not in self._computed:
                continue  # it reads what its text says; its other readings are those of limits and drives
            known = self._read_in.setdefault(self.line(at), {})
            for channel in channels:
                if channel not in known and channel not in self._given:
                    known[channel] = 1.0
                if channel not in self.channels and channel not in self._given:
                    self.channels.append(channel)

    # ----------------------------------------------------------------------------------------------- searching

    def explore(self) -> None:
        """Find the states and the transitions."""
        start = self.nodes[None] = StateNode(None, Visit((), -DELAY))
        trial = self.play((), 0.0)
        behind = self._behind(trial, self._arrive(start, start.first, (), trial)[1])
        read_first = dict.fromkeys(channel for line in behind for channel in self._read_in.get(line, ()))
        self._solve_banks(start.first, behind)
        start.left = [Departure(start.first, ((Change("input", each, 1.0),) for each in read_first))]
        while not self.trials.is_over:
            left = [(node, departure) for node in self.nodes.values() for departure in node.left]
            if not left:
                return
            node, departure = min(left, key=_urgency)
            node.left.remove(departure)
            self._leave(node, departure)

    def _leave(self, node: StateNode, departure: Departure) -> None:
        """Try the changes of a departure; what leads to something new is tried again with one more change."""
        visit, tried = departure.visit, departure.tried
        for causes in departure.changes or self._single(node, visit):
            if self.trials.is_over:
                return
            if causes in tried:
                continue
            tried.add(causes)
            node.tried[causes] = None
            before = len(self.trials.seen), len(self.nodes)
            trial = self._changed(visit, causes)
            news, rest = self._arrive(node, visit, causes, trial)
            if news or (len(self.trials.seen), len(self.nodes)) != before:
                behind = self._behind(trial, rest)
                self._solve_banks(visit, behind, causes)
                more = chain(
                    self._together(behind, causes, visit.levels),
                    self._values_behind(node, visit, behind, causes),
                )
                node.left.append(Departure(visit, more, departure.depth + 1, tried))

    def _single(self, node: StateNode, visit: Visit) -> Iterator[Causes]:
        """Yield each change once, and those of several inputs that one line reads."""
        self._solve_banks(visit, {self.line(at) for place in node.state or () for at in place.statements})
        levels = visit.levels
        for channel in self.channels:
            change = Change("input", channel, 1 - levels.get(channel, 0.0))
            yield (change,)
            if channel in self.counters and node.state is not None:
                yield from self._counted(node, visit, (), partial(_pulses, change))
        yield from self._read_together(node, levels)
        yield from self._values(node, visit) if visit.question is None else self._answers(node, visit)

    def _solve_banks(self, visit: Visit, lines: Collection[int], causes: Causes = ()) -> None:
        """Find the inputs that matter of the banks that some lines read, behind changes of a visit."""
        for at in sorted(at for at, channels in self._banks.items() if channels and self.line(at) in lines):
            self._read_bank(visit, at, self._banks.pop(at), causes)

    def _read_bank(self, visit: Visit, at: int, channels: Sequence[int], causes: Causes) -> None:
        """Find the inputs of a bank that make a difference where a statement reads it, by halves."""
        usual = compared_in(self._changed(visit, causes) if causes else self.play(visit.timeline, 0.0))
        left, wanted, levels = [channels], dict[int, float](), visit.levels
        while left and not self.trials.is_over:
            some = left.pop()
            changes = (Change("input", each, 1 - levels.get(each, 0.0)) for each in some)
            new = compared_in(self._changed(visit, (*causes, *changes))) - usual
            if not new:
                continue
            if len(some) == 1:
                wanted[some[0]] = level_of_bit(usual, new)
            else:
                middle = len(some) // 2
                left += [some[middle:], some[:middle]]
        self._read_in.setdefault(self.line(at), {}).update(wanted)
        self.channels += [each for each, level in wanted.items() if level and each not in self.channels]

    def _read_together(self, node: StateNode, levels: Mapping[int, float]) -> Iterator[Causes]:
        """Yield the changes of several inputs that a line of a state reads."""
        places = [at for each in node.state or () for at in sorted(each.statements)]
        lines = dict.fromkeys(map(self.line, places))
        for line in lines:
            wanted = self._read_in.get(line, {})
            for levels_of_line in (wanted, {channel: 1.0 - level for channel, level in wanted.items()}):
                changes = [
                    Change("input", channel, level)
                    for channel, level in sorted(levels_of_line.items())
                    if levels.get(channel, 0.0) != level
                ]
                if len(changes) > 1:
                    yield tuple(changes)

    def _answers(self, node: StateNode, visit: Visit) -> Iterator[Causes]:
        """Yield answers to the question of a state: usual ones, and those that comparisons tell apart."""
        assert visit.question is not None
        first, second = (Change("answer", 0, each, visit.question) for each in ANSWERS)
        given: set[str] = set()
        # A rejected answer may print the range of the right ones.
        while left := [each for each in usual_answers(node.printed) if each not in given]:
            given.add(left[0])
            yield (first._replace(value=left[0]),)
        yield from self._compared(node, visit, (), first, second)

    def _changed(self, visit: Visit, causes: Causes) -> Trial:
        """Play the changes from a visit on."""
        return self.play(visit.changed(causes), visit.change_time, self._is_settled)

    def _behind(self, trial: Trial, rest: Rest | None) -> list[int]:
        """Return the lines that run behind a change until the next rest, without those of the rest."""
        until = inf if rest is None else rest.begin + BODY
        places = frozenset[int]().union(*(each.statements for each in (rest.state if rest else ())))
        begun = chain.from_iterable(trial.statements.values())
        return sorted({self.line(each.at) for each in begun if each.time <= until and each.at not in places})

    def _together(self, behind: Sequence[int], causes: Causes, levels: Mapping[int, float]) -> list[Causes]:
        """Return the changes with one more of the inputs that the lines behind them read."""
        read = (channel for line in behind for channel in self._read_in.get(line, ()))
        changed = {each.number for each in causes if each.table == "input"}
        return [
            tuple(sorted((*causes, Change("input", channel, 1 - levels.get(channel, 0.0)))))
            for channel in dict.fromkeys(read)
            if channel not in changed
        ]

    def _in_moves(
        self, node: StateNode, visit: Visit, causes: Causes, possible: Sequence[ChangeInMove]
    ) -> Iterator[Causes]:
        """Play the changes with one more in the middle of a move, where none was yet; yield those that are counted."""
        for each in possible:
            if self.trials.is_over:
                return
            if each.key in self._changed_in:
                continue
            self._changed_in.add(each.key)
            once = each.added(causes, visit.change_time)
            self._arrive(node, visit, once, self._changed(visit, once))
            if each.change.number in self.triggers - self.counters:
                continue
            yield from self._counted(node, visit, causes, partial(each.added, causes, visit.change_time))

    def _counted(
        self, node: StateNode, visit: Visit, causes: Causes, often: Callable[[int], Causes]
    ) -> Iterator[Causes]:
        """Yield changes with one more, which comes as often as a program counts it."""
        tried = [causes, *map(often, range(1, ENOUGH))]
        trials: list[Trial] = []
        for each in tried:
            if self.trials.is_over:
                return
            trials.append(self._changed(visit, each))
            if len(trials) > 1 and not counts(trials):
                return
        yield from map(often, counts(trials))
        # Last, so that what too few do is known of enough.
        for each, trial in zip(tried[1:], trials[1:], strict=True):
            self._arrive(node, visit, each, trial)

    def _changes_in_moves(self, trial: Trial, since: float, until: float) -> list[ChangeInMove]:
        """Return the inputs that are read while an axis moves, or that start a handler."""
        motions: dict[int, TrialMotion] = {}
        for each in trial.part(since, until).motions:
            if each.words and each.end - each.begin > SHORTEST_REST:
                motions.setdefault(each.line, each)
        found = []
        for motion in motions.values():
            levels = levels_at(trial.timeline, motion.begin)
            onward = frozenset(each.line for each in motions.values() if each.begin > motion.begin)
            for channel in dict.fromkeys((*self._read_between(trial, motion), *sorted(self.triggers))):
                change = Change("input", channel, 1 - levels.get(channel, 0.0))
                possible = ChangeInMove(change, motion, onward)
                if channel in self.channels and possible.key not in self._changed_in:
                    found.append(possible)
        return found

    def _read_between(self, trial: Trial, motion: TrialMotion) -> Iterator[int]:
        """Yield the inputs that statements read while a move goes on."""
        begun = chain.from_iterable(trial.statements.values())
        places = [each.at for each in begun if motion.begin <= each.time < motion.end]
        places += [each.at for each in trial.waits if each.since < motion.end and motion.begin < each.until]
        for at in dict.fromkeys(places):
            known = self._read_in.get(self.line(at), {})
            yield from (channel for channel in trial.readings.get(at, ()) if channel in known)

    def _values_behind(
        self, node: StateNode, visit: Visit, behind: Sequence[int], causes: Causes
    ) -> Iterator[Causes]:
        """Yield the changes with a value of one more channel that the lines behind them read."""
        changed = {(each.table, each.number) for each in causes}
        for first, second, read_in in self.probes:
            if (first.table, first.number) not in changed and first.table != "key" and read_in & set(behind):
                yield from self._compared(node, visit, causes, first, second)

    def _values(self, node: StateNode, visit: Visit) -> Iterator[Causes]:
        """Yield the changes of what has more than two levels, by the comparisons that follow."""
        for first, second, _ in self.probes if node.state is not None else ():
            yield from self._compared(node, visit, (), first, second)

    def _compared(
        self, node: StateNode, visit: Visit, others: Causes, first: Change, second: Change
    ) -> Iterator[Causes]:
        """Yield the changes to values at which the comparisons behind two of a channel turn."""
        if self.trials.is_over:
            return
        both = [tuple(sorted((*others, probe))) for probe in (first, second)]
        trials = [self._changed(visit, causes) for causes in both]
        yield from (tuple(sorted((*others, each))) for each in solved(first, second, *trials))
        # Last, so that what an unusual value does is known of a value that a person would give.
        for causes, trial in zip(both, trials, strict=True):
            self._arrive(node, visit, causes, trial)

    # ------------------------------------------------------------------------------------------------ arriving

    def _arrive(
        self, node: StateNode, visit: Visit, causes: Causes, trial: Trial
    ) -> tuple[bool, Rest | None]:
        """Take the rests of a trial behind a change, and return the first one.

        The first result is True if it leads this state elsewhere for the first time.
        """
        news, known = False, {*self.nodes, None}
        first: Rest | None = None
        is_over = False  # the stay has ended by itself all the same
        source, back, how, since = node, visit, causes, trial.since
        found = self.rests(trial)
        if trial.status == "until" and not any(rest.end == inf for rest in found):
            self._note_work(trial)
        for rest in found:
            if source.state == rest.state and not _moves_between(trial, since, rest):
                if rest.question is not None:
                    source.printed += printed_for(trial, rest.question)
                    if any(each.table == "answer" for each in how):
                        source.refused.setdefault(how, self.acts(self.part(trial, since, rest.begin)))
                is_over |= rest.end < inf and rest.end > back.end - SHORTEST_REST
                handled = self._handled(trial, since, rest.end) if how else []
                if handled:
                    self._link(source, back, how, rest.state, trial, since, max(handled), known, is_over)
                continue  # the same stay
            reached, way = self._reached(rest, trial)
            first = first or rest
            until = self._arrival(trial, rest)
            news |= self._link(source, back, how, reached.state, trial, since, until, known, is_over)
            is_over = False
            source, back, how, since = reached, way, (), rest.end if rest.end < inf else trial.time
        if trial.has_ended and node.state is not None:
            news |= self._link(source, back, how, None, trial, since, trial.time, known, is_over)
        return news, first

    def _arrival(self, trial: Trial, rest: Rest) -> float:
        """Return when a rest is reached: what begins soon after the last move, and is none of the rest, leads there."""
        until = rest.begin
        for place in rest.state:
            begun = trial.statements.get(place.task, ())
            first, last = (
                bisect_left(begun, time, key=attrgetter("time"))
                for time in (rest.begin, min(rest.begin + BODY, rest.end))
            )
            until = max(
                [until, *(each.time for each in begun[first:last] if each.at not in place.statements)]
            )
        return until

    def _note_work(self, trial: Trial) -> None:
        """Take note of what the last trial repeats without a rest."""
        cycle = self.trials.last.cycle
        if cycle is None:
            return
        for move in trial.moves:
            self.axes[move.line].add(move.axis)
        # What all tasks do in every other cycle at least.
        often = 0.5 * cycle.count
        moves = Counter(each.line for each in trial.moves if not each.is_homing)
        switched = Counter(each.channel for each in trial.outputs if each.value)
        work = {line for line, count in moves.items() if count >= often}
        outputs = {channel for channel, count in switched.items() if count >= often}
        if work:
            self.working.append(Work(trial.timeline, cycle.period, frozenset(work), frozenset(outputs)))

    def rests(self, trial: Trial) -> list[Rest]:
        """Return the rests of the machine in a trial."""
        return rests(trial, self.beside)

    def _reached(self, rest: Rest, trial: Trial) -> tuple[StateNode, Visit]:
        """Return the node of a rest, and this visit; the shortest one is that of the node, and a later one is kept."""
        moved = frozenset(each.line for each in trial.motions if each.begin <= rest.begin)
        visit = Visit(trial.timeline, rest.begin, rest.end, moved, rest.question)
        node = self.nodes.get(rest.state)
        if node is None:
            node = self.nodes[rest.state] = StateNode(rest.state, visit, left=[Departure(visit)])
        elif (
            visit.lasts > node.first.lasts
            and trial.time - rest.begin > node.first.end - node.first.time + QUIET
        ):
            node.left = [Departure(visit)]
            node.first = visit
        elif visit.lasts == node.first.lasts and len(visit.timeline) < len(node.first.timeline):
            for each in node.left:
                if each.visit is node.first and each.changes is None:
                    each.visit = visit
            node.first = visit
        elif node.later is None and visit.lasts and not moved <= node.first.moved:
            node.later = visit
            node.left.append(Departure(visit))
        if rest.question is not None:
            node.printed += printed_for(trial, rest.question)
        return node, visit

    def _link(
        self,
        source: StateNode,
        visit: Visit,
        causes: Causes,
        target: RestState | None,
        trial: Trial,
        since: float,
        until: float,
        known: Collection[RestState | None],
        is_over: bool,
    ) -> bool:
        """Add a transition; True if it is new, and leads elsewhere, moves an axis, or starts a handler."""
        part = self.part(trial, since, until)
        lines = tuple(each.line for each in part.moves)
        does = _does(part, until)
        handled = self._handled(trial, since, until)
        if source.knows(causes, target, does) or (target == source.state and not lines and not handled):
            return False
        is_later = visit is source.later
        if is_later and target in known and self._moved.issuperset(lines):
            return False  # only its levels differ
        self._moved.update(lines)
        for move in trial.moves:
            self.axes[move.line].add(move.axis)
        fails = any(each.ended == "fault" for each in part.moves)
        possible = self._changes_in_moves(trial, since, until)
        if possible and (source.state is not None or not causes):
            changes = self._in_moves(source, visit, causes, possible)
            source.left.append(Departure(visit, changes))
        source.transitions.append(
            Transition(
                source.state,
                causes,
                target,
                until - (since if causes else max(visit.time, 0.0)),
                lines,
                frozenset(each.line for each in part.moves if not each.is_homing),
                frozenset(each.channel for each in part.outputs if each.value),
                self.acts(part),
                fails or bool(handled),
                visit,
                is_later,
                is_over or not causes,
                does,
            )
        )
        return True

    def _handled(self, trial: Trial, since: float, until: float) -> list[float]:
        """Return when statements of handlers began that command anything, between two times."""
        begun = trial.statements.get(HANDLERS, ())
        return [each.time for each in begun if each.at in self._commanding and since <= each.time <= until]

    def part(self, trial: Trial, since: float, until: float) -> Trial:
        """Return the trial with only what the tasks that work do between two times."""
        found = trial.part(since, until)
        return found._replace(
            outputs=[each for each in found.outputs if each.at not in self.beside],
            prints=[each for each in found.prints if each.at not in self.beside],
        )

    def acts(self, part: Trial) -> tuple[Act, ...]:
        """Return what a program does in a part of a trial, in order."""
        found = [
            *(
                Act(each.begin, each.line, f"axis {each.axis}", each.words)
                for each in part.moves
                if each.words
            ),
            *(
                self._act(each, f"output {each.channel}", "on" if each.value else "off")
                for each in part.outputs
            ),
            *(self._act(each, "", repr(plain(each.text))) for each in part.prints),
        ]
        return tuple(sorted(found, key=lambda each: each.time))

    def _act(self, each: Switched | Printed, subject: str, words: str) -> Act:
        return Act(each.time, self.line(each.at) if each.at >= 0 else 0, subject, words)


def _reached(structure: Structure, unit: Unit) -> frozenset[int]:
    """Return the statements of a unit, and of what it calls."""
    return frozenset(structure.points[point].at for point in structure.graph.reached(unit.entry)) - {-1}


def _commands(structure: Structure, unit: Unit) -> bool:
    """True if a unit commands an axis, or switches an output."""
    statements = (structure.statements.get(at) for at in _reached(structure, unit))
    return any(
        each is not None and (each.axes or any(use.access == WRITE for use in each.channels))
        for each in statements
    )


def _triggers(units: Iterable[Unit]) -> set[int]:
    """Return the inputs whose changes start handlers."""
    return {
        int(each.number)
        for unit in units
        for each in unit.triggers
        if each.channel == "input" and each.number.isdecimal()
    }


def _pulses(change: Change, times: int) -> Causes:
    """Return an input that comes and goes so many times at rest."""
    return (change._replace(moment=Moment(times=times, every=PERIOD)),)


def _beside(structure: Structure) -> frozenset[int]:
    """Return the statements of the tasks beside the work: those that command no motion and wait for nothing but time.

    They blink, regulate or watch. If no task works, none is beside it.
    """
    points, graph = structure.points, structure.graph
    work = {
        at
        for at, each in structure.statements.items()
        if each.waits not in ("", "time") or any(use.row.topic == "move" for use in each.axes)
    }
    working: set[int] = set()
    others: set[int] = set()
    for task in structure.tasks():
        reached = {points[point].at for point in graph.reached(task.entry)}
        (others if reached.isdisjoint(work) else working).update(reached)
    return frozenset(others - working) if working else frozenset()


def _urgency(left: tuple[StateNode, Departure]) -> tuple[bool, int, bool, int, int]:
    """Return the order in which states are left: by the fewest changes at once and before, and later visits last."""
    node, departure = left
    visit = departure.visit
    return (
        visit is node.later,
        departure.depth,
        node.state is not None,
        len(visit.timeline),
        -len(visit.moved),
    )


def _moves_between(trial: Trial, since: float, rest: Rest) -> bool:
    return any(since <= move.begin < rest.begin for move in trial.moves)


def _does(part: Trial, until: float) -> Hashable:
    """Return what a program does in a part of a trial, but for figures and for how often a lamp blinks."""
    return (
        tuple((each.line, each.ended if each.end <= until else "") for each in part.moves),
        frozenset((each.channel, bool(each.value)) for each in part.outputs),
        frozenset(without_figures(each.text) for each in part.prints),
    )
