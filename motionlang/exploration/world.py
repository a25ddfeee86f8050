"""The world around a cycle: the cycle is played, and each input is then described by the simplest rule that keeps it.

    on from the start          where it makes no difference, also if the cycle does not need it
    follows a position         it changes in the middle of moves: where the axis passes again, or at steps along its way
    on from a time             a change that is made once
    follows an output          each of its changes comes after one of the output; inverted, too
    when asked                 a person, a host or an unknown sensor answers as soon as the program asks
    on and off all the time    the program waits for the level that it needs
    its changes one by one     for anything else

At first all of them answer when they are asked, or at their times if the cycle does not repeat so. Keys and numbers of
a host that come again follow an output, or come when asked. A level that changes while an axis jogs rises with it.

A rule holds if each task does what it did in the played run, in the same order: moves, outputs, and prints but for
their figures; or if it moves so and says less of what is wrong. A task that moves no axis may come further or less far.
No other handler runs but one of a timer.
"""

from __future__ import annotations

from collections import Counter, defaultdict, deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise, product
from math import fsum, inf
from typing import NamedTuple

from motionlang.exploration.changes import (
    AT_REST,
    Change,
    Entry,
    Moment,
    Timeline,
    entries,
    is_about,
    levels_at,
    made_at,
    tables_of,
)
from motionlang.exploration.cycles import MachineCycle, wrong
from motionlang.exploration.questions import PERIOD
from motionlang.exploration.recorder import HANDLERS
from motionlang.exploration.rests import BODY, Rest, RestState
from motionlang.exploration.roles import written
from motionlang.exploration.search import Explorer
from motionlang.exploration.states import DELAY, Causes, Visit, delay
from motionlang.exploration.trials import Trial, TrialMotion, is_short_move, without_figures
from motionlang.exploration.values import first_write
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
# So many marks are on the way of an axis that goes on and on, and positions are the same within this, uu.
MARKS, SAME = 300, 0.01
# The tables of numbers of a host, and those whose entries may happen again by themselves.
NUMBERS = ("comms", "netdata", "modbus.register")
WRITES = (*NUMBERS, "key")


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
    for cycle in likeliest[:PLAYED]:
        trial = played(explorer, cycle, times=times)
        has_level = any(each.table == "analogue" for _, each in trial.timeline)
        if has_level and 0 < _count(cycle, trial) < min(times, ENOUGH) and cycle.repeats:
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
            found = _explained(explorer, count, cycle, trial)
            if _goes_on(found):
                return found
    if best is None:
        furthest = nowhere(explorer)
        best = (False, True, 0), furthest, explorer.play(furthest.visit.timeline, 0.0)
    (*_, count), cycle, trial = best
    return _explained(explorer, *_with_more_on(explorer, count, cycle, trial))


def nowhere(explorer: Explorer) -> MachineCycle:
    """Return what stands for a cycle where none was found: the way to the state that took most changes."""
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
    """Return how often a trial has come through a cycle: how often each of its lines has moved an axis."""
    since = cycle.visit.time if cycle.repeats else 0.0
    counts = Counter(each.line for each in trial.moves if each.begin >= since)
    return min((counts[line] for line in cycle.work), default=0)


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

    With `goes_back` a level that has led on is 0 again at the next change.
    """
    policy: dict[RestState | None, Causes] = {
        each.source: each.causes for each in cycle.transitions if each.causes
    }
    from_start = policy.pop(None, ())
    timeline: Timeline = (*((0.0, each) for each in others), *made_at(0.0, from_start), *cycle.visit.timeline)
    at = cycle.visit.time

    def is_due(trial: Trial) -> bool:
        found = explorer.rests(trial)
        return any(trial.time - max(rest.begin, at) > SHORT for rest in _due(found, policy, at, before))

    before: RestState | None = None
    back: list[Change] = []
    trial = explorer.play(timeline, max(at, 0.0), is_due)
    most = times * len(policy) + EXTRA
    for turn in range(SLOW * most):
        if turn >= most and not 0 < _count(cycle, trial) < times:
            break
        found = explorer.rests(trial)
        due = next(_due(found, policy, at, before), None)
        changes = () if due is None else _missing(policy[due.state], timeline) or _again(policy[due.state])
        if not changes:  # elsewhere: go round by other transitions
            due = next((rest for rest in found if rest.end == inf and rest.state in explorer.nodes), None)
            changes = () if due is None else _missing(_onward(explorer, due.state, policy), timeline)
        if due is None or (not changes and due.question is None):
            due = next((rest for rest in found if rest.end == inf), None)
            changes = () if due is None else _leading_on(explorer, timeline, due, at)
        if due is None or not changes:
            break
        reset = _reset(explorer, changes, timeline) if _is_same(due, at, before) else ()
        before, begin = due.state, max(due.begin, at)
        at = round(begin + delay(begin, due.end), 4) if due.question is None else begin
        new = {each.channel for each in changes}
        made = made_at(at, (*(each for each in back if each.channel not in new), *reset))
        made = (*made, *made_at(round(at + (PERIOD / 2 if reset else 0.0), 4), changes))
        timeline = (*timeline, *made)
        back = [each._replace(value=0.0) for each in changes if each.table == "analogue" and goes_back]
        since = at
        # An input that comes and goes passes rests that are no new ones.
        at = max([at, *(each.levels(time)[-1][0] for time, each in made if each.moment.every)])
        trial = explorer.play(timeline, since, is_due)
    return explorer.play(timeline, 0.0, lambda trial: at <= trial.time and _count(cycle, trial) >= COMPARED)


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


def _onward(explorer: Explorer, state: RestState, policy: Mapping[RestState | None, Causes]) -> Causes:
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
    found: list[Rest], policy: Mapping[RestState | None, Causes], at: float, before: RestState | None
) -> Iterator[Rest]:
    """Yield the rests from a time on that last until a change of the policy, but for the stay that was just changed."""
    for rest in found:
        if rest.state in policy and not _is_same(rest, at, before) and rest.end - max(rest.begin, at) > SHORT:
            yield rest


def _is_same(rest: Rest, at: float, before: RestState | None) -> bool:
    """True if a rest is the stay that was changed last, at a time."""
    return rest.state == before and rest.begin <= at + BODY


# -------------------------------------------------------------------------------------------------- explaining


def _explained(explorer: Explorer, count: int, cycle: MachineCycle, trial: Trial) -> FoundWorld:
    """Return the simplest world in which each task does what it did in a played run."""
    orders = _Orders(explorer)
    end = _end_of(cycle, trial)
    wanted = orders.of(
        (each for each in trial.moves if each.begin < end),
        (each for each in trial.outputs if each.time < end),
        (each for each in trial.prints if each.time < end),
    )
    flips: dict[int, list[tuple[float, float]]] = defaultdict(list)
    for time, change in trial.timeline:
        if change.table == "input":
            flips[change.number] += change.levels(time)
    writes: dict[Change, list[float]] = defaultdict(list)
    for time, change in trial.timeline:
        if change.table in WRITES:
            writes[change].append(time)
    until = LONGER * end + PULSES["every"] * max(map(len, flips.values()), default=0)
    others = tables_of(tuple(each for each in trial.timeline if each[1].table != "input"))
    chosen = {number: _one_by_one(number, each) for number, each in flips.items()}

    handled = {each.at for each in trial.statements.get(HANDLERS, ())}

    def holds(settings: Mapping[str, object], *, nothing_more: bool = False) -> bool:
        result, begun = explorer.trials.run_in(settings, until)
        log = result.machine.log
        moves = (
            TrialMotion(each.start_time, inf, each.axis, each.line, "", "", False, is_short_move(each))
            for each in log.moves
        )
        if trial.status == "ended" and result.status != "ended":
            return False
        found = orders.of(moves, log.outputs, log.prints)
        if nothing_more and any(own and not wanted.get(task) for task, own in found.items()):
            return False
        return begun & explorer.handlers <= handled and _is_as_good(wanted, found)

    along = _along(explorer, trial)
    switched = _switched(trial)
    blinking = _blinking(switched, trial, explorer.rests(trial))
    asked = {number: _when_asked(number, each, along.get(number)) for number, each in flips.items()}
    answers = _answers(explorer, trial) if count > 1 else {}
    if holds(_settings(asked, {**others, **answers})):
        chosen, others = asked, {**others, **answers}
    for _ in range(PASSES):  # what is on too early for one input may be in time when another one is on, too
        for number, changes in sorted(flips.items(), key=lambda each: (len(each[1]), each[0])):
            for entry in _rules(number, changes, along.get(number), switched, blinking):
                if chosen[number] == [entry] or holds(_settings({**chosen, number: [entry]}, others)):
                    chosen[number] = [entry]
                    break
    left = [number for number, each in chosen.items() if len(each) > 1]
    # The times of one fit those of the others, so all of them must come and go by themselves.
    together: dict[int, list[Entry]] = {number: [{"channel": number, **PULSES}] for number in left}
    if left and holds(_settings(chosen | together, others)):
        chosen |= together
    for change, times in writes.items():
        for entry in _repetitions(change, times, switched, blinking) if len(times) > 1 else ():
            rest = [each for each in entries(others, change.table) if not is_about(change, each)]
            tried = {**others, change.table: [*rest, entry]}
            if holds(_settings(chosen, tried)):
                others = tried
                break
    others_read = set(explorer.channels) - flips.keys() - explorer.triggers
    for number in sorted(others_read) if cycle.repeats else ():
        on: list[Entry] = [{"channel": number, "at": 0.0}]
        if holds(_settings({**chosen, number: on}, others), nothing_more=True):
            chosen[number] = on
    for given in _numbers(explorer, trial):
        tried = {**others, **{table: [*given[table], *entries(others, table)] for table in given}}
        if holds(_settings(chosen, tried)):
            others = tried
    for number, entry in _released(explorer, _settings(chosen, others), chosen):
        if holds(_settings({**chosen, number: [entry]}, others)):
            chosen[number] = [entry]
            break
    settings = _settings(chosen, others)
    return FoundWorld(cycle, settings, explorer.trials.run_in(settings, until)[0], count)


def _end_of(cycle: MachineCycle, trial: Trial) -> float:
    """Return when a trial has come through a cycle often enough to compare, but not before its last change."""
    starts: dict[int, list[float]] = defaultdict(list)
    for each in trial.moves:
        if each.line in cycle.work and each.begin >= cycle.visit.time:
            starts[each.line].append(each.begin)
    often = [times[COMPARED - 1] for times in starts.values() if len(times) >= COMPARED]
    last = max((time for time, _ in trial.timeline), default=0.0)
    return min(trial.time, max([last, *often]) + MOMENT) if len(often) == len(cycle.work) > 0 else trial.time


def _released(
    explorer: Explorer, settings: Mapping[str, object], chosen: Mapping[int, list[Entry]]
) -> Iterator[tuple[int, Entry]]:
    """Yield rules with which the run does not end in a wait for an input that is always on to be off.

    It follows the output that was switched last.
    """
    result = explorer.trials.run_in(settings, WHOLE)[0]
    scheduler = result.machine.scheduler
    waits = [task.wait for task in scheduler.tasks if not task.done] if scheduler is not None else []
    stuck = {number for wait in waits if wait is not None and wait.cause == "input" for number in wait.what}
    latest = dict.fromkeys(each.channel for each in reversed(list(result.machine.log.outputs)))
    for number in sorted(stuck & chosen.keys()):
        for output in latest if chosen[number] == [{"channel": number, "at": 0.0}] else ():
            entry: Entry = {"channel": number, "output": output, "delay": DELAY}
            for tried in (entry, {**entry, "value": 0}):
                again = explorer.trials.run_in({**settings, "input": _replaced(settings, tried)}, WHOLE)[0]
                if again.status != "fault":
                    yield number, tried


def _replaced(settings: Mapping[str, object], entry: Entry) -> list[Entry]:
    """Return the inputs of settings with another entry for one of them."""
    return [*(each for each in entries(settings, "input") if each["channel"] != entry["channel"]), entry]


def _settings(inputs: Mapping[int, list[Entry]], others: Mapping[str, object]) -> dict[str, object]:
    entries = [entry for number in sorted(inputs) for entry in inputs[number]]
    return {**others, **({"input": entries} if entries else {})}


def _one_by_one(number: int, changes: list[tuple[float, float]]) -> list[Entry]:
    return [{"channel": number, "at": time, "value": int(value)} for time, value in changes]


def _numbers(explorer: Explorer, trial: Trial) -> Iterator[dict[str, list[Entry]]]:
    """Yield the entries of the numbers of a host that the program reads, and that nothing has changed."""
    given = {each.channel for _, each in trial.timeline}
    for channel in explorer.read:
        if channel[0] in NUMBERS and channel not in given and channel not in written(explorer.program):
            yield tables_of(((0.0, first_write(channel)),))  # type: ignore[misc]


class _Orders:
    """The acts of the tasks of a program, each task's in its own order."""

    def __init__(self, explorer: Explorer) -> None:
        self._line = explorer.line
        self._owners = explorer.program.structure.owners()

    def of(
        self, moves: Iterable[TrialMotion], outputs: Iterable[Switched], prints: Iterable[Printed]
    ) -> dict[str, list[tuple[object, ...]]]:
        """Return the moves, outputs and prints of each task in order; prints with True if they say what is wrong."""
        acts: list[tuple[float, int, tuple[object, ...]]] = []
        acts += ((each.begin, each.line, ("move", each.axis, each.line, each.is_short)) for each in moves)
        acts += (
            (each.time, self._line(each.at), ("output", each.channel, bool(each.value)))
            for each in outputs
            if each.at >= 0
        )
        acts += (
            (each.time, self._line(each.at), ("print", without_figures(each.text), bool(wrong([each.text]))))
            for each in prints
            if each.at >= 0
        )
        found: dict[str, list[tuple[object, ...]]] = defaultdict(list)
        for _, line, act in sorted(acts, key=lambda each: each[0]):
            found[self._owners.get(line, "")].append(act)
        return found


Acts = Mapping[str, list[tuple[object, ...]]]


def _is_as_good(wanted: Acts, found: Acts) -> bool:
    """True if each task does what is wanted in its order, or moves so and says as much, but less of what is wrong."""
    if _same(wanted, found):
        return True
    moves = _of(wanted, "move")
    (right, faults), (others, fewer) = _said(wanted), _said(found)
    is_better = fewer < faults and right <= others
    return is_better and any(moves.values()) and _same(moves, _of(found, "move"))


def _of(acts: Acts, kind: str) -> Acts:
    """Return the acts of one kind of each task."""
    return {task: [each for each in own if each[0] == kind] for task, own in acts.items()}


def _said(acts: Acts) -> tuple[set[object], int]:
    """Return the printed lines of all tasks that say nothing wrong, and how many others there are."""
    prints = [each for own in _of(acts, "print").values() for each in own]
    right = [text for _, text, is_wrong in prints if not is_wrong]
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


Switches = Mapping[int, list[tuple[float, int]]]


def _switched(trial: Trial) -> Switches:
    """Return the times and levels of the outputs of a trial."""
    switched: dict[int, list[tuple[float, int]]] = defaultdict(list)
    for each in trial.outputs:
        switched[each.channel].append((each.time, int(bool(each.value))))
    return switched


def _blinking(switched: Switches, trial: Trial, found: list[Rest]) -> set[int]:
    """Return the outputs that change more than once while the program is at rest."""
    stays = [(rest.begin + MOMENT, min(rest.end, trial.time) - MOMENT) for rest in found]
    return {
        output
        for output, changes in switched.items()
        if any(sum(begin < time < end for time, _ in changes) > 1 for begin, end in stays)
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
        begins = [_place(a, each.begin) for each, _, _ in passing if each.line == move.line]
        end = _place(a, time + every / 2 if every else (time + min(move.end, time + 1.0)) / 2)
        between = [round(each, 2) for each in sorted((_place(a, time), end))]
        entry: Entry = {"channel": number, "axis": move.axis, "between": between}
        if move.end == inf:  # a jog: as far as it goes
            entry |= {"every": round(abs(_place(a, time + every) - _place(a, time)), 2), "times": MARKS}
        elif max(begins) - min(begins) > SAME:
            entry |= {"every": round((begins[1] - begins[0]) / times, 2), "times": MARKS}
        elif times > 1:
            entry |= {"every": round((_place(a, move.end) - begins[0]) / times, 2), "times": times}
        every_uu: float = entry.get("every", between[1] - between[0] + SAME)  # type: ignore[assignment]
        if every_uu > between[1] - between[0]:  # a mark ends before the next one
            found[number] = entry
    return found


def _passing(trial: Trial, axes: Mapping[int, Axis], time: float, moment: Moment) -> TrialMotion | None:
    """Return the move in whose middle an input comes: that of a line, or a jog in which it comes again and again."""
    for each in reversed(trial.moves):
        is_under_way = each.begin <= time < each.end
        if is_under_way and moment.line == each.line and each.end < inf:
            return each
        if (
            is_under_way
            and moment.every
            and not moment.line
            and each.end == inf
            and axes[each.axis].velocity(time)
        ):
            return each
    return None


def _when_asked(number: int, changes: list[tuple[float, float]], along: Entry | None) -> list[Entry]:
    """Return the rule of an input that changes when it is asked for, or where an axis passes."""
    if along is not None:
        return [along]
    if len(changes) == 1 and changes[0] == (0.0, 1.0):
        return [{"channel": number, "at": 0.0}]
    return [{"channel": number, "asked": DELAY}]


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


def _place(a: Axis, time: float) -> float:
    """Return where an axis was at a time, in user units from the zero of the machine, which a homing leaves."""
    return a.scale.to_user(a.position(time) - a.datum)


def _rising(explorer: Explorer, trial: Trial, time: float, change: Change) -> Entry | None:
    """Return the entry of a level that rises with the position of an axis that jogs at a time; None if none does."""
    assert isinstance(change.value, float)
    axes = explorer.trials.run_in(tables_of(trial.timeline), time)[0].controller.axes
    for move in reversed(trial.moves):
        if move.begin < time and move.end == inf and axes[move.axis].velocity(time):
            a = axes[move.axis]
            begin, end = _place(a, move.begin), _place(a, time)
            if begin != end:
                edge = "above" if end > begin else "below"
                rise = round(change.value / (end - begin), 3)
                return {
                    "channel": change.number,
                    "axis": move.axis,
                    edge: round(begin, 2),
                    "value": 0.0,
                    "per_unit": rise,
                }
    return None


def _rules(
    number: int,
    changes: list[tuple[float, float]],
    along: Entry | None,
    switched: Switches,
    blinking: set[int],
) -> Iterator[Entry]:
    """Yield the rules that may explain the changes of an input, the simplest first; outputs that blink are last."""
    if changes[0][1]:
        yield {"channel": number, "at": 0.0}
    if along is not None:
        yield along
    if len(changes) == 1 and changes[0][1]:
        yield {"channel": number, "at": round(changes[0][0], 1)}
    # What was changed together with another input may have come before the output that it follows.
    later = [(time + DELAY, level) for time, level in changes]
    latest = sorted(switched, key=lambda each: (each in blinking, lead(later, switched[each]), each))
    for output in latest if len(changes) > 1 else ():
        for inverted, (moved, wait) in product((0, 1), ((changes, DELAY), (later, SOON))):
            if explains(moved, switched[output], inverted):
                entry: Entry = {"channel": number, "output": output, "delay": wait}
                yield {**entry, "value": 0} if inverted else entry
    if len(changes) > 1:
        yield {"channel": number, "asked": DELAY}


def _repetitions(
    change: Change, times: Sequence[float], switched: Switches, blinking: set[int]
) -> Iterator[Entry]:
    """Yield the rules that may explain why a host writes a number again, or a person presses a key again."""
    first = entries(tables_of(((times[0], change),)), change.table)[0]
    yield {**first, "at": 0.0}
    yield first
    latest = sorted(
        switched, key=lambda each: (each in blinking, lead([(t, 1.0) for t in times], switched[each]))
    )
    for output in latest:
        for level in (1, 0):
            if all(
                _is_after(time, before, switched[output], level) for before, time in pairwise((-inf, *times))
            ):
                answer: Entry = {"output": output, "delay": DELAY, **({} if level else {"level": 0})}
                yield {key: value for key, value in first.items() if key != "at"} | answer
    yield {key: value for key, value in first.items() if key != "at"} | {"asked": DELAY}


def _is_after(time: float, before: float, switched: list[tuple[float, int]], level: int) -> bool:
    """True if an output changed to a level between two times."""
    return any(before < at <= time and value == level for at, value in switched)


def explains(changes: list[tuple[float, float]], switched: list[tuple[float, int]], inverted: int) -> bool:
    """True if each change of an input comes after a change of an output to that level, since the change before.

    An input that follows an output that is off has its level from power-up on.
    """
    before = -inf
    for time, value in changes[1:] if changes[0][1] == inverted or changes[0][0] == 0.0 else changes:
        if not any(before < at <= time and level ^ inverted == value for at, level in switched):
            return False
        before = time
    return True


def lead(changes: list[tuple[float, float]], switched: list[tuple[float, int]]) -> float:
    """Return by how much an output changes before an input on average, s; infinite if it does not."""
    leads = [min((time - at for at, _ in switched if at <= time), default=inf) for time, _ in changes]
    return fsum(leads) / len(leads)
