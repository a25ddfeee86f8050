"""The search behind what only many cycles bring, such as a full pallet or the end of a batch.

Problem. A variable that counts is no part of a state, so nothing leads from the known states to what only the twelfth
part brings.

Idea. The world of the likeliest cycle is known by then. The program runs in it for a long time, and the changes of its
inputs are a timeline like any other. Where that leads to a new state, or begins a statement that no transition has, the
last change before is one of the state in which it came, and the search goes on behind it.
"""

from __future__ import annotations

from bisect import bisect_right

from motionlang_explore.exploration.changes import TABLES, Change, Timeline, entries, made_by
from motionlang_explore.exploration.search import Explorer
from motionlang_explore.exploration.simple import SILENT, fault_of
from motionlang_explore.exploration.states import Visit
from motionlang_explore.exploration.world import WHOLE, FoundWorld

# Where a program has said nothing, the run is so many times as long.
LONG = 5


def goes_further(explorer: Explorer, world: FoundWorld) -> bool:
    """Take note of the first thing that is new in a long run in a world, and what may follow; False if nothing is."""
    known, begun = set(explorer.nodes), _begun(explorer)
    trial = explorer.trials.play_in(world.settings, WHOLE)
    if fault_of(explorer, explorer.trials.last) == SILENT:  # it may only say that a tool is worn
        trial = explorer.trials.play_in(world.settings, LONG * WHOLE)
    timeline = _timeline(explorer, world)
    rests = explorer.rests(trial)
    news = [
        *(rest.begin for rest in rests if rest.state not in known),
        *(each.time for some in trial.statements.values() for each in some if each.at not in begun),
    ]
    begins, times = [rest.begin for rest in rests], [at for at, _ in timeline]
    for k in sorted({bisect_right(times, time) for time in news} - {0}):
        at = times[k - 1]
        stay = rests[max(bisect_right(begins, at) - 1, 0)] if rests and at > 0.0 else None
        node = explorer.nodes.get(stay.state) if stay is not None else None
        if stay is None or node is None:
            continue
        moved = frozenset(each.line for each in trial.motions if each.begin <= stay.begin)
        before = tuple(each for each in timeline if each[0] < at)
        visit = Visit(before, stay.begin, moved=moved, question=stay.question)
        causes = tuple(change for when, change in timeline if when == at)
        if visit.changed(causes) not in explorer.tried:
            explorer.take(node, visit, causes, explorer.changed(visit, causes))
            return True
    return False


def _timeline(explorer: Explorer, world: FoundWorld) -> Timeline:
    """Return the changes of the last run, in a world; of what comes when it is asked for, those of inputs."""
    made = [
        (each.time, Change("input", each.channel, float(each.value)))
        for each in explorer.trials.last.machine.log.inputs
        if ("input", each.channel) not in explorer.given
    ]
    others = [
        made_by(table, entry)
        for table in TABLES
        if table != "input"
        for entry in entries(world.settings, table)
        if "asked" not in entry
    ]
    return tuple(sorted([*made, *others], key=lambda each: each[0]))


def _begun(explorer: Explorer) -> set[int]:
    """Return the statements of all transitions and states, and of the tasks beside the work."""
    transitions = (each.begun for node in explorer.nodes.values() for each in node.transitions)
    places = (place.statements for state in explorer.nodes for place in state or ())
    return set(explorer.beside).union(*transitions, *places)
