"""Playing a cycle: each change at the state that it leads on from, some times.

A state may have several changes, such as the choices of a menu, one for each time that the machine comes there. Where
the machine is elsewhere than expected, it goes round by other transitions, or an input that was read leads on.
"""

from __future__ import annotations

from collections import Counter, defaultdict, deque
from collections.abc import Collection, Iterator
from math import inf

from motionlang.comparison.texts import plain, without_figures
from motionlang_explore.exploration.changes import (
    AT_REST,
    Change,
    Moment,
    Timeline,
    channel_levels,
    levels_at,
    made_at,
)
from motionlang_explore.exploration.cycles import MachineCycle
from motionlang_explore.exploration.questions import PERIOD
from motionlang_explore.exploration.rests import BODY, Rest, RestState
from motionlang_explore.exploration.search import Explorer
from motionlang_explore.exploration.states import DELAY, Causes, Transition, delay
from motionlang_explore.exploration.trials import Trial
from motionlang_explore.exploration.words import wrong

# So often a cycle is played, with so many changes that lead back to it.
TIMES, EXTRA = 5, 3
# A cycle with something that only each fourth turn brings, such as a full layer, is played for so many times as long.
SLOW = 5
# What has done nothing after so many turns never will.
NEVER = 3
# So many turns of a cycle are compared.
COMPARED = 6
# A rest that is shorter than this, s, is over before a change comes.
SHORT = 0.1


def count(cycle: MachineCycle, trial: Trial) -> int:
    """Return how often a trial has come through a cycle: how often each of its lines has moved an axis.

    If none moves one, it is how often each line was printed.
    """
    since = cycle.visit.time if cycle.repeats else 0.0
    if not cycle.work:
        printed = Counter(_words(each.text) for each in trial.prints if each.time >= since)
        return min((printed[without_figures(each)] for each in cycle.said), default=0)
    moves = (each for each in trial.moves if each.begin >= since and not (each.is_short and each.ended))
    counts = Counter(each.line for each in moves)
    return min((counts[line] for line in cycle.work), default=0)


def _words(text: str) -> str:
    return without_figures(repr(plain(text)))


def quality(cycle: MachineCycle, trial: Trial) -> tuple[bool, bool, int]:
    """Return if a trial has come through a cycle, if it says nothing wrong unless the cycle does, and how often."""
    often = count(cycle, trial)
    return often > 0, bool(wrong(cycle.said)) or not faults(cycle, trial), often


def faults(cycle: MachineCycle, trial: Trial) -> int:
    """Return how often a trial says that something is wrong once a cycle has begun."""
    return wrong(each.text for each in trial.prints if each.time >= cycle.visit.time)


def played(
    explorer: Explorer,
    cycle: MachineCycle,
    others: Causes = (),
    times: int = TIMES,
    *,
    as_found: bool = False,
) -> Trial:
    """Play a cycle some times: each change at the state that it leads on from, and others from the start.

    With `as_found` all inputs have the levels with which each transition was found.
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
        return any(
            trial.time - max(rest.begin, at) > SHORT for rest in _due(trial, found, policy, at, before)
        )

    before: RestState | None = None
    trial = explorer.play(timeline, max(at, 0.0), is_due)
    choices = sum(map(len, policy.values()))
    for turn in range(SLOW * (times * choices + EXTRA)):
        often = count(cycle, trial)
        if not explorer.has_work:
            break
        if turn >= (times if often else NEVER) * choices + EXTRA and not 0 < often < times:
            break
        found = explorer.rests(trial)
        due = next(_due(trial, found, policy, at, before), None)
        changes: Causes = ()
        goes_on = False
        if due is not None:
            chosen = policy[due.state][0]
            policy[due.state].rotate(-1)
            changes = _missing(chosen.causes, timeline)
            if changes and as_found:
                changes += _others(explorer, chosen, timeline)
            changes = changes or _again(chosen.causes)
            goes_on = chosen.goes_on
        if not changes:  # elsewhere: go round by other transitions
            due = next((rest for rest in found if rest.end == inf and rest.state in explorer.nodes), None)
            onward = policy.keys() - {before}  # back there would be round and round
            changes = () if due is None else _missing(_onward(explorer, due.state, onward), timeline)
        if due is None or (not changes and due.question is None):
            due = next((rest for rest in found if rest.end == inf), None)
            changes = () if due is None else _leading_on(explorer, timeline, due, at)
        if due is None or not changes:
            break
        before, begin = None if goes_on else due.state, max(due.begin, at)
        at = round(begin + delay(begin, due.end), 4) if due.question is None else begin
        made = made_at(at, changes)
        timeline = (*timeline, *made)
        since = at
        # An input that comes and goes passes rests that are no new ones.
        at = max([at, *(each.levels(time)[-1][0] for time, each in made if each.moment.every)])
        trial = explorer.play(timeline, since, is_due)
    return explorer.play(timeline, 0.0, lambda trial: at <= trial.time and count(cycle, trial) >= COMPARED)


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


def _others(explorer: Explorer, chosen: Transition, timeline: Timeline) -> Causes:
    """Return the changes that give all other inputs the levels with which a transition was found."""
    levels = channel_levels(timeline, inf)
    wanted = dict.fromkeys(levels, 0.0) | channel_levels(chosen.visit.timeline, chosen.visit.change_time)
    left = {*(each.channel for each in chosen.causes), *(("input", each) for each in explorer.triggers)}
    return tuple(
        Change(*channel, level)
        for channel, level in wanted.items()
        if level != levels.get(channel, 0.0) and channel not in left
    )


def _again(causes: Causes) -> Causes:
    """Return changes to levels that are there already: the inputs go and come, since the program waits for an edge."""
    moment = Moment(times=1, every=PERIOD)
    return tuple(
        each._replace(value=1.0 - each.value, moment=moment)
        for each in causes
        if each.table == "input" and isinstance(each.value, float)
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
    trial: Trial, found: list[Rest], policy: Collection[RestState | None], at: float, before: RestState | None
) -> Iterator[Rest]:
    """Yield the rests from a time on that last until a change of the policy, but for the stay that was just changed."""
    for rest in found:
        is_due = rest.state in policy and rest.end - max(rest.begin, at) > SHORT
        if is_due and not _is_same(trial, rest, at, before):
            yield rest


def _is_same(trial: Trial, rest: Rest, at: float, before: RestState | None) -> bool:
    is_soon = rest.state == before and rest.begin <= at + BODY
    return is_soon and not any(at <= each.begin < rest.begin and not each.is_short for each in trial.moves)
