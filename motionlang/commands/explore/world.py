"""The world around a cycle: the cycle is played, and each input is then described by the simplest rule that keeps it.

    on from the start          where it makes no difference
    on from a time             a change that is made once
    follows an output          each of its changes comes after one of the output; inverted, too
    its changes one by one     for anything else

A rule holds if every axis makes the moves of the played run in the same order.
"""

from __future__ import annotations

from collections import defaultdict, deque
from collections.abc import Iterator, Mapping
from math import fsum, inf
from typing import NamedTuple

from motionlang.commands.explore.cycles import Cycle
from motionlang.commands.explore.rests import Rest, RestState, rests
from motionlang.commands.explore.search import DELAY, Causes, Explorer
from motionlang.commands.explore.trials import Timeline, Trial, levels_at, tables_of
from motionlang.kernel import Run

# So often a cycle is played, with so many changes that lead back to it.
TIMES, EXTRA = 5, 3
# A rest that is shorter than this, s, is over before a change comes.
SHORT = DELAY + 0.02
# What happens so close to the ends of a rest, s, led there or leads on.
MOMENT = 0.02
# A world is compared for this much longer than the played run.
LONGER = 1.5
Entry = dict[str, object]


class World(NamedTuple):
    """The entries of a machine file with which a cycle runs, and the run."""

    settings: Mapping[str, object]
    run: Run


def played(explorer: Explorer, cycle: Cycle) -> Trial:
    """Play a cycle several times: each change at the state that it leads on from."""
    policy: dict[RestState | None, Causes] = {
        each.source: each.causes for each in cycle.transitions if each.causes
    }
    timeline, at = cycle.timeline, explorer.nodes[cycle.states[0]].time if cycle.transitions else 0.0
    trial = explorer.play(timeline, 0.0)
    for _ in range(TIMES * len(policy) + EXTRA):
        found = rests(trial)
        due = next(_due(found, policy, at), None)
        changes = () if due is None else _missing(policy[due.state], timeline)
        if not changes:  # elsewhere, or the levels are there already: go round by other transitions
            due = next((rest for rest in found if rest.end == inf and rest.state in explorer.nodes), None)
            changes = () if due is None else _missing(_onward(explorer, due.state, policy), timeline)
        if due is None or not changes:
            return trial
        at = round(max(due.begin, at) + DELAY, 4)
        timeline = (*timeline, *((at, each) for each in changes))
        trial = explorer.play(timeline, 0.0)
    return trial


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


def _due(found: list[Rest], policy: Mapping[RestState | None, Causes], at: float) -> Iterator[Rest]:
    """Yield the rests from a time on that last until a change of the policy."""
    for rest in found:
        if rest.state in policy and rest.end > at and rest.end - max(rest.begin, at) > SHORT:
            yield rest


def world_of(explorer: Explorer, cycle: Cycle) -> World:
    """Return the simplest world in which a cycle runs as it was played."""
    trial = played(explorer, cycle)
    wanted = [(each.axis, each.line) for each in trial.moves]
    flips: dict[int, list[tuple[float, float]]] = defaultdict(list)
    for time, change in trial.timeline:
        if change.table == "input":
            flips[change.number].append((time, float(change.value)))
    others = tables_of(tuple(each for each in trial.timeline if each[1].table != "input"))
    chosen: dict[int, list[Entry]] = {number: _one_by_one(number, each) for number, each in flips.items()}
    until = LONGER * trial.time
    switched = _steady_outputs(trial)
    for number, changes in sorted(flips.items(), key=lambda each: (len(each[1]), each[0])):
        for entry in _rules(number, changes, switched):
            result = explorer.trials.run_in(_settings({**chosen, number: [entry]}, others), until)
            if _moves(result)[: len(wanted)] == wanted:
                chosen[number] = [entry]
                break
    settings = _settings(chosen, others)
    return World(settings, explorer.trials.run_in(settings, until))


def _settings(inputs: Mapping[int, list[Entry]], others: Mapping[str, object]) -> dict[str, object]:
    entries = [entry for number in sorted(inputs) for entry in inputs[number]]
    return {**others, **({"input": entries} if entries else {})}


def _one_by_one(number: int, changes: list[tuple[float, float]]) -> list[Entry]:
    return [{"channel": number, "at": time, "value": value} for time, value in changes]


def _steady_outputs(trial: Trial) -> dict[int, list[tuple[float, int]]]:
    """Return the changes of the outputs of a trial, but for those that blink while the program is at rest."""
    switched: dict[int, list[tuple[float, int]]] = defaultdict(list)
    for each in trial.outputs:
        switched[each.channel].append((each.time, int(bool(each.value))))
    stays = [(rest.begin + MOMENT, min(rest.end, trial.time) - MOMENT) for rest in rests(trial)]
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
            yield {"channel": number, "at": changes[0][0]}
    latest = sorted(switched, key=lambda output: (_lead(changes, switched[output]), output))
    for output in latest if len(changes) > 1 else ():
        for inverted in (0, 1):
            if _explains(changes, switched[output], inverted):
                entry: Entry = {"channel": number, "output": output, "delay": DELAY}
                yield {**entry, "value": 0} if inverted else entry


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


def _moves(result: Run) -> list[tuple[int, int]]:
    """Return axis and line of each move."""
    return [(each.axis, each.line) for each in result.machine.log.moves]
