"""The world around a cycle: the cycle is played, and each input is then described by the simplest rule that keeps it.

    on from the start          where it makes no difference, also if the cycle does not need it
    on from a time             a change that is made once
    follows an output          each of its changes comes after one of the output; inverted, too
    on and off all the time    the program waits for the level that it needs
    its changes one by one     for anything else

A rule holds if each task does what it did in the played run, in the same order: moves, outputs, and prints but for
their figures. A task that moves no axis may come further or less far. No other handler runs but one of a timer.
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict, deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import fsum, inf
from typing import NamedTuple

from motionlang.commands.explore.cycles import Cycle
from motionlang.commands.explore.rests import BODY, Rest, RestState
from motionlang.commands.explore.search import DELAY, Causes, Explorer, delay
from motionlang.commands.explore.trials import HANDLERS, Change, Motion, Timeline, Trial, levels_at, tables_of
from motionlang.commands.explore.values import written
from motionlang.kernel import Run
from motionlang.kernel.log import Printed, Switched

# So often a cycle is played, with so many changes that lead back to it; it repeats if each of its lines does so often.
TIMES, EXTRA, ENOUGH = 5, 3, 3
# Each input is described so often, since its rule may depend on those of the others.
PASSES = 2
# So many cycles are played until one repeats.
PLAYED = 6
# A rest that is shorter than this, s, is over before a change comes.
SHORT = 0.1
# What happens so close to the ends of a rest, s, led there or leads on.
MOMENT = 0.02
# A world is compared for this much longer than the played run.
LONGER = 1.5
# An input that comes and goes, s.
PULSES = {"at": 1.0, "for": 1.0, "every": 2.0}
_FIGURE = re.compile(r"[-+]?\d[\d.]*")
Entry = dict[str, object]


class World(NamedTuple):
    """The entries of a machine file with which a cycle runs, and the run; `times` is how often the cycle was played.

    `is_endless` is True if the entries let the cycle go on, and False if they are the changes of the played run.
    """

    cycle: Cycle
    settings: Mapping[str, object]
    run: Run
    times: int
    is_endless: bool


def world_of(explorer: Explorer, likeliest: Sequence[Cycle]) -> World | None:
    """Return the world of the likeliest cycle that repeats when it is played, or of one that comes furthest."""
    best: tuple[int, Cycle, Trial] | None = None
    for cycle in likeliest[:PLAYED]:
        trial = _played_on(explorer, cycle) if best is None else _played(explorer, cycle)
        count = _count(cycle, trial)
        if best is None or (count > best[0] and cycle.repeats):
            best = count, cycle, trial
        if count >= ENOUGH:
            break
    return None if best is None else _explained(explorer, *best)


# ----------------------------------------------------------------------------------------------------- playing


def _count(cycle: Cycle, trial: Trial) -> int:
    """Return how often a trial has come through a cycle: how often each of its lines has moved an axis."""
    since = cycle.visit.time if cycle.repeats else 0.0
    counts = Counter(each.line for each in trial.moves if each.begin >= since)
    return min(counts[line] for line in cycle.work)


def _played_on(explorer: Explorer, cycle: Cycle) -> Trial:
    """Play a cycle; if it stops after some turns, with one of the inputs that are in no transition of it."""
    trial = _played(explorer, cycle)
    count = _count(cycle, trial)
    if not cycle.repeats or not 0 < count < ENOUGH:
        return trial
    used = {each.number for _, each in trial.timeline if each.table == "input"}
    for channel in explorer.channels:
        if channel not in used:
            other = _played(explorer, cycle, (Change("input", channel, 1.0),))
            if _count(cycle, other) > count:
                return other
    return trial


def _played(explorer: Explorer, cycle: Cycle, others: Causes = ()) -> Trial:
    """Play a cycle several times: each change at the state that it leads on from, and others from the start."""
    policy: dict[RestState | None, Causes] = {
        each.source: each.causes for each in cycle.transitions if each.causes
    }
    timeline: Timeline = (*((0.0, each) for each in others), *cycle.visit.timeline)
    at = cycle.visit.time

    def is_due(trial: Trial) -> bool:
        found = explorer.rests(trial)
        return any(trial.time - max(rest.begin, at) > SHORT for rest in _due(found, policy, at, before))

    before: RestState | None = None
    trial = explorer.play(timeline, max(at, 0.0), is_due)
    for _ in range(TIMES * len(policy) + EXTRA):
        found = explorer.rests(trial)
        due = next(_due(found, policy, at, before), None)
        changes = () if due is None else _missing(policy[due.state], timeline)
        if not changes:  # elsewhere, or the levels are there already: go round by other transitions
            due = next((rest for rest in found if rest.end == inf and rest.state in explorer.nodes), None)
            changes = () if due is None else _missing(_onward(explorer, due.state, policy), timeline)
        if due is None or not changes:
            break
        before, begin = due.state, max(due.begin, at)
        at = round(begin + delay(begin, due.end), 4) if due.question is None else begin
        timeline = (*timeline, *((at, each) for each in changes))
        trial = explorer.play(timeline, at, is_due)
    return explorer.play(timeline, 0.0)


def _missing(causes: Causes, timeline: Timeline) -> Causes:
    """Return the changes of some that change anything at the end of a timeline."""
    levels = levels_at(timeline, inf)
    return tuple(
        each for each in causes if each.table != "input" or levels.get(each.number, 0.0) != each.value
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
        is_same = rest.state == before and rest.begin <= at + BODY
        if rest.state in policy and not is_same and rest.end - max(rest.begin, at) > SHORT:
            yield rest


# -------------------------------------------------------------------------------------------------- explaining


def _explained(explorer: Explorer, count: int, cycle: Cycle, trial: Trial) -> World:
    """Return the simplest world in which each task does what it did in a played run."""
    orders = _Orders(explorer)
    wanted = orders.of(trial.moves, trial.outputs, trial.prints)
    flips: dict[int, list[tuple[float, float]]] = defaultdict(list)
    for time, change in trial.timeline:
        if change.table == "input":
            flips[change.number].append((time, float(change.value)))
    until = LONGER * trial.time + PULSES["every"] * max(map(len, flips.values()), default=0)
    others = tables_of(tuple(each for each in trial.timeline if each[1].table != "input"))
    chosen = {number: _one_by_one(number, each) for number, each in flips.items()}

    handled = {each.at for each in trial.statements.get(HANDLERS, ())}

    def holds(settings: Mapping[str, object]) -> bool:
        result, begun = explorer.trials.run_in(settings, until)
        log = result.machine.log
        moves = (Motion(each.start_time, inf, each.axis, each.line, "", "", False) for each in log.moves)
        return begun & explorer.handlers <= handled and _same(
            wanted, orders.of(moves, log.outputs, log.prints)
        )

    switched = _steady_outputs(trial, explorer.rests(trial))
    for _ in range(PASSES):  # what is on too early for one input may be in time when another one is on, too
        for number, changes in sorted(flips.items(), key=lambda each: (len(each[1]), each[0])):
            for entry in _rules(number, changes, switched):
                if chosen[number] == [entry] or holds(_settings({**chosen, number: [entry]}, others)):
                    chosen[number] = [entry]
                    break
    for number in sorted(set(explorer.channels) - flips.keys() - explorer.triggers):
        on: list[Entry] = [{"channel": number, "at": 0.0}]
        if holds(_settings({**chosen, number: on}, others)):
            chosen[number] = on
    for given in _numbers(explorer, trial):
        tried = {**others, **{table: [*given[table], *_entries(others, table)] for table in given}}
        if holds(_settings(chosen, tried)):
            others = tried
    settings = _settings(chosen, others)
    is_endless = not others.keys() - {"analogue"} and all(len(each) == 1 for each in chosen.values())
    return World(cycle, settings, explorer.trials.run_in(settings, until)[0], count, is_endless)


def _settings(inputs: Mapping[int, list[Entry]], others: Mapping[str, object]) -> dict[str, object]:
    entries = [entry for number in sorted(inputs) for entry in inputs[number]]
    return {**others, **({"input": entries} if entries else {})}


def _entries(settings: Mapping[str, object], table: str) -> list[Entry]:
    found: list[Entry] = settings.get(table, [])  # type: ignore[assignment]
    return found


def _one_by_one(number: int, changes: list[tuple[float, float]]) -> list[Entry]:
    return [{"channel": number, "at": time, "value": int(value)} for time, value in changes]


def _numbers(explorer: Explorer, trial: Trial) -> Iterator[dict[str, list[Entry]]]:
    """Yield a number of each element of a host that the cycle reads, and that neither it nor the program gives."""
    lines = {explorer.line(each.at) for begun in trial.statements.values() for each in begun}
    given = {(each.table, each.number) for _, each in trial.timeline} | written(explorer.program)
    for first, _, read_in in explorer.probes:
        if first.table in NUMBERS and (first.table, first.number) not in given and read_in & lines:
            change = first._replace(value=1.0)
            yield {table: list(each) for table, each in tables_of(((0.0, change),)).items()}  # type: ignore[call-overload]


NUMBERS = ("comms",)


class _Orders:
    """What the tasks of a program do, each in its own order."""

    def __init__(self, explorer: Explorer) -> None:
        self._line = explorer.line
        self._owners = explorer.program.structure.owners()

    def of(
        self, moves: Iterable[Motion], outputs: Iterable[Switched], prints: Iterable[Printed]
    ) -> dict[str, list[tuple[object, ...]]]:
        """Return the moves, outputs and prints of each task in order."""
        acts: list[tuple[float, int, tuple[object, ...]]] = []
        acts += ((each.begin, each.line, ("move", each.axis, each.line)) for each in moves)
        acts += (
            (each.time, self._line(each.at), ("output", each.channel, bool(each.value)))
            for each in outputs
            if each.at >= 0
        )
        acts += (
            (each.time, self._line(each.at), ("print", _FIGURE.sub("#", each.text)))
            for each in prints
            if each.at >= 0
        )
        found: dict[str, list[tuple[object, ...]]] = defaultdict(list)
        for _, line, act in sorted(acts, key=lambda each: each[0]):
            found[self._owners.get(line, "")].append(act)
        return found


def _same(
    wanted: Mapping[str, list[tuple[object, ...]]], found: Mapping[str, list[tuple[object, ...]]]
) -> bool:
    """True if each task does what is wanted in its order; one that moves an axis, all of it."""
    for task, acts in wanted.items():
        others = found.get(task, [])
        least = len(acts) if any(each[0] == "move" for each in acts) else min(len(acts), len(others))
        if others[:least] != acts[:least]:
            return False
    return True


def _steady_outputs(trial: Trial, found: list[Rest]) -> dict[int, list[tuple[float, int]]]:
    """Return the changes of the outputs of a trial, but for those that blink while the program is at rest."""
    switched: dict[int, list[tuple[float, int]]] = defaultdict(list)
    for each in trial.outputs:
        switched[each.channel].append((each.time, int(bool(each.value))))
    stays = [(rest.begin + MOMENT, min(rest.end, trial.time) - MOMENT) for rest in found]
    return {
        output: changes
        for output, changes in switched.items()
        if all(sum(begin < time < end for time, _ in changes) < 2 for begin, end in stays)
    }


def _rules(
    number: int, changes: list[tuple[float, float]], switched: Mapping[int, list[tuple[float, int]]]
) -> Iterator[Entry]:
    """Yield the rules that may explain the changes of an input, the simplest first."""
    if changes[0][1]:
        yield {"channel": number, "at": 0.0}
        if len(changes) == 1:
            yield {"channel": number, "at": round(changes[0][0], 1)}
    latest = sorted(switched, key=lambda output: (_lead(changes, switched[output]), output))
    for output in latest if len(changes) > 1 else ():
        for inverted in (0, 1):
            if _explains(changes, switched[output], inverted):
                entry: Entry = {"channel": number, "output": output, "delay": DELAY}
                yield {**entry, "value": 0} if inverted else entry
    if len(changes) > 1:
        yield {"channel": number, **PULSES}


def _explains(changes: list[tuple[float, float]], switched: list[tuple[float, int]], inverted: int) -> bool:
    """True if each change of an input comes after a change of an output to that level, since the change before."""
    before = -inf
    for time, value in changes:
        if not any(before < at <= time and level ^ inverted == value for at, level in switched):
            return False
        before = time
    return True


def _lead(changes: list[tuple[float, float]], switched: list[tuple[float, int]]) -> float:
    """Return by how much an output changes before an input on average, s; infinite if it does not."""
    leads = [min((time - at for at, _ in switched if at <= time), default=inf) for time, _ in changes]
    return fsum(leads) / len(leads)
