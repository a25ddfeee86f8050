"""The world around a cycle: the cycle is played, and each input is then described by the simplest rule that keeps it.

    on from the start          where it makes no difference, also if the cycle does not need it and comes again
    follows a position         it changes in the middle of moves: where the axis passes again, or at steps along its way
    on from a time             a change that is made once
    follows an output          each of its changes comes after one of the output; inverted, too
    when asked                 a person, a host or an unknown sensor answers as soon as the program asks
    follows it as measured     the delays of on and off differ, or it is on for some time after a change of the output
    on and off all the time    the program waits for the level that it needs
    its changes one by one     for anything else

At first all of them answer when they are asked, or at their times if the cycle does not repeat so. Keys and numbers of
a host that come again follow an output, or come when asked. A level that changes while an axis jogs rises with it.

A rule holds if each task does what it did in the played run, in the same order: moves, outputs, and prints but for
their figures; or if it moves so and says less of what is wrong. A move that is over at once is another one than a move
with a way. A task that moves no axis may come further or less far. No other handler runs but one of a timer.
"""

from __future__ import annotations

from collections import Counter, defaultdict, deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from itertools import product
from math import fsum, inf
from typing import NamedTuple

from motionlang.exploration.changes import (
    AT_REST,
    Change,
    Moment,
    Timeline,
    entries,
    is_about,
    levels_at,
    made_at,
    number_in,
    tables_of,
)
from motionlang.exploration.cycles import MachineCycle, wrong
from motionlang.exploration.questions import PERIOD
from motionlang.exploration.recorder import HANDLERS
from motionlang.exploration.rests import BODY, Rest, RestState
from motionlang.exploration.roles import written
from motionlang.exploration.search import Explorer
from motionlang.exploration.states import DELAY, Causes, Transition, Visit, delay
from motionlang.exploration.trials import Trial, TrialMotion, is_short_move, plain, without_figures
from motionlang.exploration.values import first_write
from motionlang.identification import Digital, Entry, Observation, channels, place, rules_of
from motionlang.kernel import Axis, Run
from motionlang.kernel.log import Printed, Switched

# So often a cycle is played, with so many changes that lead back to it; it repeats if each of its lines does so often.
TIMES, EXTRA, ENOUGH = 5, 3, 3
# A cycle with something that only each fourth turn brings, such as a full layer, is played for so many times as long.
SLOW = 5
# Each input is described so often, since its rule may depend on those of the others.
PASSES = 2
# So many turns of a cycle are compared.
COMPARED = 6
# A world is tried for so long, s.
WHOLE = 300.0
# So many cycles are played until one repeats, and of those that do not, so many are played in the world that it takes.
PLAYED, EXPLAINED = 6, 2
# An input that answers an output soon, s: some programs look only once.
SOON = 0.1
# A rest that is shorter than this, s, is over before a change comes.
SHORT = 0.1
# What happens so close to the ends of a rest, s, led there or leads on.
MOMENT = 0.02
# A world is compared for this much longer than the played run.
LONGER = 1.5
# An input that comes and goes, s.
PULSES = {"at": 1.0, "for": 1.0, "every": 2.0}
# An input that is on from the start, and one that answers.
ON, ASKED = {"at": 0.0}, {"asked": DELAY}
# So many marks are on the way of an axis that goes on and on, and positions are the same within this, uu.
MARKS, SAME = 300, 0.01
# The tables of numbers of a host, and those whose entries may happen again by themselves.
NUMBERS = ("comms", "netdata", "modbus.register")
WRITES = (*NUMBERS, "key")


Settings = Mapping[str, object]
# Times and levels of a channel.
Levels = list[tuple[float, float]]
# Something that a task has done: a move, an output or a print; and those of each task.
Act = tuple[object, ...]
Acts = Mapping[str, list[Act]]


class FoundWorld(NamedTuple):
    """The entries of a machine file with which a cycle runs, and the run; `times` is how often the cycle was played."""

    cycle: MachineCycle
    settings: Mapping[str, object]
    run: Run
    times: int


def world_of(explorer: Explorer, likeliest: Sequence[MachineCycle], times: int = TIMES) -> FoundWorld:
    """Return the world of the likeliest cycle that repeats as it was found, or of one that comes furthest.

    A cycle that ends after a turn or two, such as a batch of one, may go on in the world of these turns.
    Without a cycle it is the world in which the program comes furthest.
    """
    best: tuple[tuple[bool, bool, int], MachineCycle, Trial] | None = None
    explained = 0
    for cycle in _latest_first(explorer, likeliest)[:PLAYED]:
        trial = played(explorer, cycle, times=times)
        has_level = any(each.table == "analogue" for _, each in trial.timeline)
        jogs = any(each.end == inf for each in trial.moves)
        if (has_level or jogs) and 0 < _count(cycle, trial) < min(times, ENOUGH) and cycle.repeats:
            back = played(explorer, cycle, times=times, goes_back=True)
            trial = max(trial, back, key=lambda each: _count(cycle, each))
        found_with, wanted = _found_with(cycle), (True, True, min(times, ENOUGH))
        if found_with and cycle.repeats and _quality(cycle, trial) < wanted:
            other = played(explorer, cycle, found_with, times=times)
            trial = max(trial, other, key=lambda each: _quality(cycle, each))
        quality, count = _quality(cycle, trial), _count(cycle, trial)
        is_worse = best is not None and best[0][0] and wrong(cycle.said) > wrong(best[1].said)
        if best is None or (quality > best[0] and cycle.repeats and not is_worse):
            best = quality, cycle, trial
        if quality >= wanted or (count >= wanted[2] and _faults(cycle, trial) * ENOUGH <= count):
            break
        if 0 < count < times and cycle.repeats and cycle.work and explained < EXPLAINED:
            # The changes of the next turn are other ones, but they may be the same answers.
            explained += 1
            found = _Description(explorer, count, cycle, trial).world()
            if _goes_on(found):
                return found
    if best is None:
        furthest = nowhere(explorer)
        best = (False, True, 0), furthest, explorer.play(furthest.visit.timeline, 0.0)
    (*_, count), cycle, trial = best
    return _Description(explorer, *_with_more_on(explorer, count, cycle, trial)).world()


def _latest_first(explorer: Explorer, likeliest: Sequence[MachineCycle]) -> Sequence[MachineCycle]:
    """Return cycles; of runs that jog and need the changes of the first one, the one with the latest changes is first.

    A change that comes earlier cuts the jog off.
    """
    if not likeliest or likeliest[0].repeats:
        return likeliest
    same = [each for each in likeliest if not each.repeats and each.made == likeliest[0].made]
    trials = [played(explorer, each) for each in same if len(same) > 1]
    if not any(each.end == inf for trial in trials for each in trial.moves):
        return likeliest
    best = max(zip(same, trials, strict=True), key=lambda each: (each[1].begun, each[1].time))[0]
    return [best, *(each for each in likeliest if each is not best)]


def nowhere(explorer: Explorer) -> MachineCycle:
    """Return the path to the state that took most changes, for a program without a cycle."""
    visits = [node.first for node in explorer.nodes.values()]
    furthest = max(visits, key=lambda visit: len(visit.timeline), default=Visit((), 0.0))
    none = frozenset[int]()
    return MachineCycle((), furthest, (), none, none, none, 0.0)


def _goes_on(found: FoundWorld) -> bool:
    """True if the work of a cycle comes again and again in its world."""
    often = Counter(each.line for each in found.run.machine.log.moves)
    return all(often[line] >= ENOUGH for line in found.cycle.work)


def _with_more_on(
    explorer: Explorer, count: int, cycle: MachineCycle, trial: Trial
) -> tuple[int, MachineCycle, Trial]:
    """Play a cycle with the inputs on from the start that only come on once, if it runs as often and as well then.

    What they would have ended, such as an alarm, does not happen at all then.
    """
    changes = [each for _, each in trial.timeline if each.table == "input"]
    once = [each for each, times in Counter(each.number for each in changes).items() if times == 1]
    later = [
        each._replace(moment=AT_REST)
        for time, each in trial.timeline
        if each.table == "input" and each.number in once and each.value and time > 0.0
    ]
    later = [each for each in later if each.number not in explorer.triggers]
    if cycle.repeats and later:
        other = played(explorer, cycle, tuple(later))
        faults, before = (wrong(one.text for one in each.prints) for each in (other, trial))
        if _count(cycle, other) >= min(count, COMPARED) and faults <= before:
            return _count(cycle, other), cycle, other
    return count, cycle, trial


# ----------------------------------------------------------------------------------------------------- playing


def _count(cycle: MachineCycle, trial: Trial) -> int:
    """Return how often a trial has come through a cycle: how often each of its lines has moved an axis.

    If none moves one, it is how often each line was printed.
    """
    since = cycle.visit.time if cycle.repeats else 0.0
    if not cycle.work:
        printed = Counter(_words(each.text) for each in trial.prints if each.time >= since)
        return min((printed[without_figures(each)] for each in cycle.said), default=0)
    counts = Counter(each.line for each in trial.moves if each.begin >= since and not each.is_short)
    return min((counts[line] for line in cycle.work), default=0)


def _words(text: str) -> str:
    """Return a printed line as the acts of a transition have it, without figures."""
    return without_figures(repr(plain(text)))


def _quality(cycle: MachineCycle, trial: Trial) -> tuple[bool, bool, int]:
    """Return if a trial has come through a cycle, if it says nothing wrong unless the cycle does, and how often."""
    count = _count(cycle, trial)
    return count > 0, bool(wrong(cycle.said)) or not _faults(cycle, trial), count


def _faults(cycle: MachineCycle, trial: Trial) -> int:
    """Return how often a trial says that something is wrong once a cycle has begun."""
    return wrong(each.text for each in trial.prints if each.time >= cycle.visit.time)


def _found_with(cycle: MachineCycle) -> Causes:
    """Return the inputs that were on where the transitions of a cycle were found, and that are not changed in it."""
    changed = {one.number for each in cycle.transitions for one in each.causes if one.table == "input"}
    on = {number for each in cycle.transitions for number, level in each.visit.levels.items() if level}
    return tuple(Change("input", number, 1.0) for number in sorted(on - changed - cycle.visit.levels.keys()))


def played(
    explorer: Explorer,
    cycle: MachineCycle,
    others: Causes = (),
    times: int = TIMES,
    *,
    goes_back: bool = False,
) -> Trial:
    """Play a cycle some times: each change at the state that it leads on from, and others from the start.

    With `goes_back` a level or an input that has led on is 0 again at the next change.
    """
    policy: dict[RestState | None, deque[Transition]] = defaultdict(deque)
    for each in cycle.transitions:
        if each.causes:
            policy[each.source].append(each)
    from_start = policy.pop(None)[0].causes if None in policy else ()
    timeline: Timeline = (*((0.0, each) for each in others), *made_at(0.0, from_start), *cycle.visit.timeline)
    at = cycle.visit.time

    def is_due(trial: Trial) -> bool:
        found = explorer.rests(trial)
        return any(trial.time - max(rest.begin, at) > SHORT for rest in _due(found, policy, at, before))

    before: RestState | None = None
    back: list[Change] = []
    trial = explorer.play(timeline, max(at, 0.0), is_due)
    most = times * sum(map(len, policy.values())) + EXTRA
    for turn in range(SLOW * most):
        if turn >= most and not 0 < _count(cycle, trial) < times:
            break
        found = explorer.rests(trial)
        due = next(_due(found, policy, at, before), None)
        changes: Causes = ()
        goes_on = False
        if due is not None:
            chosen = policy[due.state][0]
            policy[due.state].rotate(-1)
            changes = _missing(chosen.causes, timeline) or _again(chosen.causes)
            goes_on = chosen.goes_on
        if not changes:  # elsewhere: go round by other transitions
            due = next((rest for rest in found if rest.end == inf and rest.state in explorer.nodes), None)
            changes = () if due is None else _missing(_onward(explorer, due.state, policy), timeline)
        if due is None or (not changes and due.question is None):
            due = next((rest for rest in found if rest.end == inf), None)
            changes = () if due is None else _leading_on(explorer, timeline, due, at)
        if due is None or not changes:
            break
        reset = _reset(explorer, changes, timeline) if _is_same(due, at, before) else ()
        before, begin = None if goes_on else due.state, max(due.begin, at)
        at = round(begin + delay(begin, due.end), 4) if due.question is None else begin
        new = {each.channel for each in changes}
        made = made_at(at, (*(each for each in back if each.channel not in new), *reset))
        made = (*made, *made_at(round(at + (PERIOD / 2 if reset else 0.0), 4), changes))
        timeline = (*timeline, *made)
        back = [each._replace(value=0.0) for each in changes if goes_back and _goes_back(each)]
        since = at
        # An input that comes and goes passes rests that are no new ones.
        at = max([at, *(each.levels(time)[-1][0] for time, each in made if each.moment.every)])
        trial = explorer.play(timeline, since, is_due)
    return explorer.play(timeline, 0.0, lambda trial: at <= trial.time and _count(cycle, trial) >= COMPARED)


def _goes_back(change: Change) -> bool:
    return change.table == "analogue" or (
        change.table == "input" and change.value == 1.0 and change.moment == AT_REST
    )


def _leading_on(explorer: Explorer, timeline: Timeline, rest: Rest, at: float) -> Causes:
    """Return the change of an input that was read at rest and leads on; none if there is no such input."""
    time = round(max(rest.begin, at) + DELAY, 4)
    levels = levels_at(timeline, inf)
    read = dict.fromkeys(channel for channels in rest.reads.values() for channel in channels)
    for table, number in read:
        if table != "input" or (table, number) in explorer.given:
            continue
        change = Change(table, number, 1.0 - levels.get(number, 0.0))
        tried = explorer.rests(explorer.play((*timeline, (time, change)), time))
        if tried and tried[-1].state != rest.state:
            return (change,)
    return ()


def _missing(causes: Causes, timeline: Timeline) -> Causes:
    """Return the changes of some that change anything at the end of a timeline.

    An input that changes in a move, and has that level already, has the other one until then.
    """
    levels = levels_at(timeline, inf)
    missing: list[Change] = []
    for each in causes:
        is_there = each.table == "input" and levels.get(each.number, 0.0) == each.value
        if is_there and each.moment != AT_REST:
            missing.append(each._replace(value=1 - levels.get(each.number, 0.0), moment=AT_REST))
        if not is_there or each.moment != AT_REST:
            missing.append(each)
    return tuple(missing)


def _again(causes: Causes) -> Causes:
    """Return changes to levels that are there already: the inputs go and come, since the program waits for an edge."""
    moment = Moment(times=1, every=PERIOD)
    return tuple(
        each._replace(value=1.0 - each.value, moment=moment)
        for each in causes
        if each.table == "input" and isinstance(each.value, float)
    )


def _reset(explorer: Explorer, causes: Causes, timeline: Timeline) -> Causes:
    """Return the numbers of a host that start a handler as 0 where they have the same value as before.

    Some controllers start the handler only if the value changes, so the same value has led nowhere.
    """
    before = {each.channel: each.value for _, each in timeline}
    return tuple(
        each._replace(value=type(each.value)(0))
        for each in causes
        if each.channel in explorer.started_by and before.get(each.channel) == each.value
    )


def _onward(explorer: Explorer, state: RestState, policy: Collection[RestState | None]) -> Causes:
    """Return the first changes on the shortest way from a state to one of a policy; none if there is no way."""
    ways: deque[tuple[RestState, Causes]] = deque([(state, ())])
    known = {state}
    while ways:
        here, first = ways.popleft()
        for each in explorer.nodes[here].transitions:
            if each.target is None or not each.causes or each.target in known:
                continue
            if each.target in policy:
                return first or each.causes
            known.add(each.target)
            ways.append((each.target, first or each.causes))
    return ()


def _due(
    found: list[Rest], policy: Collection[RestState | None], at: float, before: RestState | None
) -> Iterator[Rest]:
    """Yield the rests from a time on that last until a change of the policy, but for the stay that was just changed."""
    for rest in found:
        if rest.state in policy and not _is_same(rest, at, before) and rest.end - max(rest.begin, at) > SHORT:
            yield rest


def _is_same(rest: Rest, at: float, before: RestState | None) -> bool:
    """True if a rest is the stay that was changed last, at a time."""
    return rest.state == before and rest.begin <= at + BODY


# -------------------------------------------------------------------------------------------------- explaining


class _Description:
    """Settings in which each task does what it did in a played run, described by simpler rules pass by pass."""

    def __init__(self, explorer: Explorer, count: int, cycle: MachineCycle, trial: Trial) -> None:
        self._explorer, self._count, self._cycle, self._trial = explorer, count, cycle, trial
        self._owners = explorer.program.structure.owners()
        end = _end_of(cycle, trial)
        moves = ((each.begin, each.axis, each.line, each.is_short) for each in trial.moves)
        self._wanted = self._acts(moves, trial.outputs, trial.prints, end)
        self._handled = {each.at for each in trial.statements.get(HANDLERS, ())}
        self._flips: dict[int, Levels] = defaultdict(list)
        self._writes: dict[Change, list[float]] = defaultdict(list)
        for time, change in trial.timeline:
            if change.table == "input":
                self._flips[change.number] += change.levels(time)
            elif change.table in WRITES:
                self._writes[change].append(time)
        most = max(map(len, self._flips.values()), default=0)
        self._until = LONGER * end + PULSES["every"] * most
        self._along, self._beyond = _along(explorer, trial), _beyond(explorer, trial)
        self._outputs = channels((each.channel, each.time, each.value) for each in trial.outputs)
        self._blinking = _blinking(self._outputs, trial, explorer.rests(trial))
        others = tuple(each for each in trial.timeline if each[1].table != "input")
        self._settings: Settings = tables_of(others)
        for number, changes in self._flips.items():
            made: list[Entry] = [{"channel": number, "at": time, "value": int(on)} for time, on in changes]
            self._settings = self._with(made, number)

    def world(self) -> FoundWorld:
        """Return the simplest world."""
        self._describe_as_asked()
        # What is on too early for one input may be in time when another one is on, too.
        for _ in range(PASSES):
            for number, changes in sorted(self._flips.items(), key=lambda each: (len(each[1]), each[0])):
                first: Entry = {"channel": number, "at": round(changes[0][0], 1)}
                self._take(self._with(each, number) for each in self._rules(first, changes))
        self._describe_as_pulses()
        for change, times in self._writes.items():
            rest = [each for each in entries(self._settings, change.table) if not is_about(change, each)]
            (first,) = entries(tables_of(((times[0], change),)), change.table)
            pulses = [each for time in times for each in ((time, 1.0), (time + MOMENT, 0.0))]
            tried = self._rules(first, pulses, is_pulse=True) if len(times) > 1 else ()
            self._take({**self._settings, change.table: [*rest, *each]} for each in tried)
        others = set(self._explorer.channels) - self._flips.keys() - self._explorer.triggers
        # What makes no difference is on first: what then does more may need it.
        takes: tuple[Callable[[Settings], bool], ...] = (self._does_no_more, self._does_more)
        for takes_it, number in product(takes, sorted(others) if self._cycle.repeats else ()):
            settings = self._with([{"channel": number, **ON}], number)
            if settings != self._settings and takes_it(settings):
                self._settings = settings
        changed = {each.channel for _, each in self._trial.timeline} | written(self._explorer.program)
        for table, number in self._explorer.read:
            if table in NUMBERS and (table, number) not in changed:
                write = entries(tables_of(((0.0, first_write((table, number))),)), table)
                self._take([{**self._settings, table: [*write, *entries(self._settings, table)]}])
        self._take(self._released())
        settings = dict(self._settings)
        inputs = settings.pop("input", [])
        settings |= {"input": inputs} if inputs else {}
        result = self._explorer.trials.run_in(settings, self._until)[0]
        return FoundWorld(self._cycle, settings, result, self._count)

    def _with(self, made: Sequence[Entry], *numbers: int) -> Settings:
        """Return the settings with other entries for some inputs."""
        left = [each for each in entries(self._settings, "input") if each["channel"] not in numbers]
        return {**self._settings, "input": sorted((*left, *made), key=lambda each: number_in("input", each))}

    def _take(self, tried: Iterable[Settings]) -> None:
        """Take the first settings that hold."""
        for each in tried:
            if each == self._settings or self._holds(each):
                self._settings = each
                return

    def _holds(self, settings: Settings) -> bool:
        """True if each task does what it did in the played run."""
        result, begun, found = self._run(settings)
        if self._trial.status == "ended" and result.status != "ended":
            return False
        return begun & self._explorer.handlers <= self._handled and _is_as_good(self._wanted, found)

    def _does_no_more(self, settings: Settings) -> bool:
        """True if the same holds, and other tasks do nothing."""
        found = self._run(settings)[2]
        return self._holds(settings) and not any(
            own and not self._wanted.get(task) for task, own in found.items()
        )

    def _does_more(self, settings: Settings) -> bool:
        """True if a run says more than so far, but for what is wrong, and moves as often at least by half.

        What it does is wanted from then on.
        """
        had, (_, begun, found) = self._run(self._settings)[2], self._run(settings)
        (right, faults), (more, others) = _said(had), _said(found)
        moved, moves = (
            Counter(each[2] for own in _moves(acts).values() for each in own) for acts in (had, found)
        )
        if (
            right >= more
            or others > faults
            or begun & self._explorer.handlers - self._handled
            or any(2 * moves[line] < count for line, count in moved.items())
        ):
            return False
        self._wanted = found
        return True

    def _run(self, settings: Settings) -> tuple[Run, set[int], Acts]:
        """Return a run in a world, the statements that begin, and what it does."""
        result, begun = self._explorer.trials.run_in(settings, self._until)
        log = result.machine.log
        moves = ((each.start_time, each.axis, each.line, is_short_move(each)) for each in log.moves)
        return result, begun, self._acts(moves, log.outputs, log.prints)

    def _acts(
        self,
        moves: Iterable[tuple[float, int, int, bool]],
        outputs: Iterable[Switched],
        prints: Iterable[Printed],
        end: float = inf,
    ) -> Acts:
        """Return the acts of each task in order; a print is right or wrong.

        A move is its time, axis and line, and if it is a short one.
        """
        line = self._explorer.line
        acts: list[tuple[float, int, Act]] = [
            (time, at, ("move", axis, at, short)) for time, axis, at, short in moves
        ]
        acts += (
            (each.time, line(each.at), ("output", each.channel, bool(each.value)))
            for each in outputs
            if each.at >= 0
        )
        acts += (
            (each.time, line(each.at), ("print", without_figures(each.text), bool(wrong([each.text]))))
            for each in prints
            if each.at >= 0
        )
        found: dict[str, list[Act]] = defaultdict(list)
        for time, at, act in sorted(acts, key=lambda each: each[0]):
            if time < end:
                found[self._owners.get(at, "")].append(act)
        return found

    def _describe_as_asked(self) -> None:
        """Let all channels change when they are asked for, or where an axis passes."""
        asked: dict[int, Entry] = {}
        for number, changes in sorted(self._flips.items()):
            is_on = changes == [(0.0, 1.0)]
            asked[number] = self._along.get(number) or {"channel": number, **(ON if is_on else ASKED)}
        answers = _answers(self._explorer, self._trial) if self._count > 1 else {}
        tried = [asked, {**asked, **self._beyond}]
        self._take({**self._with([*each.values()], *each), **answers} for each in tried)

    def _describe_as_pulses(self) -> None:
        """Let all inputs without a rule come and go: the times of one fit those of the others."""
        entries_at = (each for each in entries(self._settings, "input") if "at" in each)
        often = Counter(number_in("input", each) for each in entries_at)
        left = [number for number, times in often.items() if times > 1]
        if left:
            self._take([self._with([{"channel": number, **PULSES} for number in left], *left)])

    def _rules(self, first: Entry, changes: Levels, *, is_pulse: bool = False) -> Iterator[Sequence[Entry]]:
        """Yield the rules that may explain the changes of a channel, the simplest first.

        `first` is the entry of the first change. With `is_pulse` a host writes a number, or a person presses a key.
        """
        base, along = {key: value for key, value in first.items() if key != "at"}, None
        if changes[0][1]:
            yield [{**first, **ON}]
        if not is_pulse and (along := self._along.get(number_in("input", first))) is not None:
            yield [along]
        if changes[0][1] and (is_pulse or len(changes) == 1):
            yield [first]
        if len(changes) == 1:
            return
        for entry in self._following(changes, is_pulse=is_pulse):
            yield [{**base, **entry}]
        yield [{**base, **ASKED}]
        seen = Observation(0.0, self._trial.time, outputs=self._outputs)
        for number, channel in channels((0, *each) for each in changes).items() if not is_pulse else ():
            for rule in sorted(rules_of(number, channel, seen), key=lambda rule: rule.delay):
                if "output" in rule.entries[0]:
                    yield [{**each, **base} for each in rule.entries]

    def _following(self, changes: Levels, *, is_pulse: bool) -> list[Entry]:
        """Return the keys by which changes follow an output, at any delay; outputs that blink are last.

        Changes that were made together with another one may have come before the output that they follow.
        """
        seen = Observation(0.0, 0.0, outputs=self._outputs, reaction=inf)
        found = [
            {key: each for key, each in entry.items() if key not in ("channel", "for")} | {"delay": wait}
            for wait, earlier in ((DELAY, 0.0), (SOON, DELAY))[: 1 if is_pulse else 2]
            for channel in channels((0, time + earlier, level) for time, level in changes).values()
            for rule in rules_of(0, channel, seen)
            if "output" in (entry := rule.entries[0]) and ("for" in entry) == is_pulse
        ]

        def order(each: Entry) -> tuple[bool, float, int, bool]:
            output: int = each["output"]  # type: ignore[assignment]
            leads = [time - self._outputs[output].last(time + DELAY).time for time, _ in changes]
            return output in self._blinking, fsum(leads), output, "value" in each

        return sorted(found, key=order)

    def _released(self) -> Iterator[Settings]:
        """Yield rules with which the run does not end in a wait for an input that is always on to be off.

        It follows the output that was switched last.
        """
        result = self._explorer.trials.run_in(self._settings, WHOLE)[0]
        scheduler = result.machine.scheduler
        waits = [task.wait for task in scheduler.tasks if not task.done] if scheduler is not None else []
        stuck = {
            number for wait in waits if wait is not None and wait.cause == "input" for number in wait.what
        }
        latest = dict.fromkeys(each.channel for each in reversed(list(result.machine.log.outputs)))
        inputs = entries(self._settings, "input")
        on = [number for number in sorted(stuck) if {"channel": number, **ON} in inputs]
        for number, output, inverted in product(on, latest, ({}, {"value": 0})):
            entry: Entry = {"channel": number, "output": output, "delay": DELAY, **inverted}
            tried = self._with([entry], number)
            if self._explorer.trials.run_in(tried, WHOLE)[0].status != "fault":
                yield tried


def _end_of(cycle: MachineCycle, trial: Trial) -> float:
    """Return when a trial has come through a cycle often enough to compare, but not before its last change."""
    starts: dict[int, list[float]] = defaultdict(list)
    for each in trial.moves:
        if each.line in cycle.work and each.begin >= cycle.visit.time:
            starts[each.line].append(each.begin)
    often = [times[COMPARED - 1] for times in starts.values() if len(times) >= COMPARED]
    last = max((time for time, _ in trial.timeline), default=0.0)
    return min(trial.time, max([last, *often]) + MOMENT) if len(often) == len(cycle.work) > 0 else trial.time


def _is_as_good(wanted: Acts, found: Acts) -> bool:
    """True if each task does what is wanted in its order, or moves so and says as much, but less of what is wrong."""
    if _same(wanted, found):
        return True
    (right, faults), (others, fewer) = _said(wanted), _said(found)
    moves = _moves(wanted)
    return fewer < faults and right <= others and any(moves.values()) and _same(moves, _moves(found))


def _moves(acts: Acts) -> Acts:
    return {task: [each for each in own if each[0] == "move"] for task, own in acts.items()}


def _said(acts: Acts) -> tuple[set[object], int]:
    """Return the printed lines of all tasks that say nothing wrong, and how many others there are."""
    prints = [each[1:] for own in acts.values() for each in own if each[0] == "print"]
    right = [text for text, is_wrong in prints if not is_wrong]
    return set(right), len(prints) - len(right)


def _same(wanted: Acts, found: Acts) -> bool:
    """True if each task does what is wanted in its order.

    One that moves an axis does all of it, and so does each one if none moves an axis.
    """
    moving = {task for task, acts in wanted.items() if any(each[0] == "move" for each in acts)}
    for task, acts in wanted.items():
        others = found.get(task, [])
        least = len(acts) if task in moving or not moving else min(len(acts), len(others))
        if others[:least] != acts[:least]:
            return False
    return True


def _blinking(outputs: Mapping[int, Digital], trial: Trial, found: list[Rest]) -> set[int]:
    """Return the outputs that change more than once while the program is at rest."""
    stays = [(rest.begin + MOMENT, min(rest.end, trial.time) - MOMENT) for rest in found]
    return {
        output
        for output, channel in outputs.items()
        if any(sum(begin < each.time < end for each in channel.changes) > 1 for begin, end in stays)
    }


def _along(explorer: Explorer, trial: Trial) -> dict[int, Entry]:
    """Return the entries by the position of an axis for inputs that come in the middle of moves, or while one jogs.

    A change that was found in a move may come at another time of the played run, when the axis is at rest.
    """
    changes: dict[int, list[tuple[float, Moment]]] = defaultdict(list)
    for time, each in trial.timeline:
        if each.table == "input" and each.value:
            changes[each.number].append((time, each.moment))
    axes = explorer.trials.run_in(tables_of(trial.timeline), trial.time)[0].controller.axes
    found: dict[int, Entry] = {}
    for number, moments in changes.items():
        passing = [(move, *each) for each in moments if (move := _passing(trial, axes, *each)) is not None]
        if not passing:
            continue
        move, time, (_, _, _, times, every) = passing[0]
        a = axes[move.axis]
        begins = [place(a, each.begin) for each, _, _ in passing if each.line == move.line]
        end = place(a, time + every / 2 if every else (time + min(move.end, time + 1.0)) / 2)
        between = [round(each, 2) for each in sorted((place(a, time), end))]
        entry: Entry = {"channel": number, "axis": move.axis, "between": between}
        if between[0] == between[1] and not every:  # it has cut the move off
            edge = "above" if place(a, time) > place(a, move.begin) else "below"
            entry = {"channel": number, "axis": move.axis, edge: between[0]}
        elif move.end == inf:  # a jog: as far as it goes
            entry |= {"every": round(abs(place(a, time + every) - place(a, time)), 2), "times": MARKS}
        elif max(begins) - min(begins) > SAME:
            entry |= {"every": round((begins[1] - begins[0]) / times, 2), "times": MARKS}
        elif times > 1:
            entry |= {"every": round((place(a, move.end) - begins[0]) / times, 2), "times": times}
        every_uu: float = entry.get("every", between[1] - between[0] + SAME)  # type: ignore[assignment]
        if every_uu > between[1] - between[0]:  # a mark ends before the next one
            found[number] = entry
    return found


def _beyond(explorer: Explorer, trial: Trial) -> dict[int, Entry]:
    """Return the entries by the position of an axis for inputs that come on while it jogs: beyond it, or at steps."""
    axes = explorer.trials.run_in(tables_of(trial.timeline), trial.time)[0].controller.axes
    moves = [
        (time, each, _jogging(trial, axes, time)) for time, each in trial.timeline if each.table == "input"
    ]
    found: dict[int, Entry] = {}
    for number in sorted({each.number for _, each, move in moves if each.value and move is not None}):
        on = [(time, move) for time, each, move in moves if each.number == number and each.value]
        off = [
            time for time, each, _ in moves if each.number == number and not each.value and time > on[0][0]
        ]
        (time, move), *others = on
        if move is None or not off:
            continue
        a = axes[move.axis]
        first, middle = place(a, time), (place(a, time) + place(a, off[0])) / 2
        step = round(abs(place(a, others[0][0]) - first), 2) if others else 0.0
        entry: Entry = {"channel": number, "axis": move.axis}
        if step > abs(middle - first):
            between = [round(each, 2) for each in sorted((first, middle))]
            found[number] = {**entry, "between": between, "every": step, "times": MARKS}
        else:
            found[number] = {**entry, "above" if first > place(a, move.begin) else "below": round(first, 2)}
    return found


def _jogging(trial: Trial, axes: Mapping[int, Axis], time: float) -> TrialMotion | None:
    """Return the motion without an end of its own in which a time lies."""
    begun = [each for each in trial.moves if each.begin <= time and each.end == inf]
    return begun[-1] if begun and axes[begun[-1].axis].velocity(time) else None


def _passing(trial: Trial, axes: Mapping[int, Axis], time: float, moment: Moment) -> TrialMotion | None:
    """Return the move in whose middle an input comes: that of a line, or a jog in which it comes again and again."""
    for each in reversed(trial.moves):
        is_jog = moment.every and not moment.line and axes[each.axis].velocity(time)
        if each.begin <= time < each.end and (is_jog if each.end == inf else moment.line == each.line):
            return each
    return None


def _answers(explorer: Explorer, trial: Trial) -> dict[str, list[Entry]]:
    """Return the entries by which levels, numbers and keys that a trial changes come when they are asked for.

    A level that changes while an axis jogs rises with its position.
    """
    firsts: dict[tuple[object, ...], tuple[float, Change]] = {}
    for time, each in trial.timeline:
        if each.table not in ("input", "answer") and (each.value or each.table != "analogue"):
            of = (*each.channel, each.value) if each.table == "key" else each.channel
            firsts.setdefault(of, (time, each))
    found: dict[str, list[Entry]] = defaultdict(list)
    for time, each in firsts.values():
        entry = {**entries(tables_of(((0.0, each),)), each.table)[0], "asked": DELAY}
        del entry["at"]
        rising = _rising(explorer, trial, time, each) if each.table == "analogue" else None
        found[each.table].append(rising or entry)
    return dict(found)


def _rising(explorer: Explorer, trial: Trial, time: float, change: Change) -> Entry | None:
    """Return the entry of a level that rises with the position of an axis that jogs at a time; None if none does."""
    assert isinstance(change.value, float)
    axes = explorer.trials.run_in(tables_of(trial.timeline), time)[0].controller.axes
    move = _passing(trial, axes, time, Moment(every=inf))
    if move is None or move.end < inf:
        return None
    a = axes[move.axis]
    begin, end = place(a, move.begin), place(a, time)
    if begin == end:
        return None
    edge, rise = "above" if end > begin else "below", round(change.value / (end - begin), 3)
    base: Entry = {"channel": change.number, "axis": move.axis, edge: round(begin, 2)}
    return {**base, "value": 0.0, "per_unit": rise}
