"""The questions to a state: changes of the world that may lead on from it, the likeliest first.

Problem. A condition may need an input, a number, a key, or several of them at once, and no text says which.

Idea. What was read decides. A statement that has read a channel while the state lasted may wait for it, so that channel
changes: an input to its other level, a number to the values at which the comparisons turn that follow (`values.py`).

    one by one         each channel that was read, and each input or number of a host that starts a handler
    of conditions      the channels of one statement together: two of them, then three, then all that are needed
    behind             what has begun a statement or turned a comparison for the first time, with one more channel that
                       was read on the way, such as a look that decides, and with all inputs of the way that together
                       bring something new
    with more          what did not lead on, with one more channel that was read only then, at rest or on the way:
                       `A And B`, an If in an If
    in a move          an input that was read while an axis moved, starts a handler or stops an axis, in its middle; at
                       first once for each line that moves an axis and what moves after it, late from each state
    as often           an input that is read again behind its change, at rest or in a move, comes and goes one to three
                       times, and as often as the comparisons ask for that differ by the same each time
    other answers      an answer before, on which a comparison behind a later question has depended

Cost. A number takes a trial with an unusual value to be solved. Of one statement not more than `MAX_TOGETHER`
channels are combined; if all its inputs at once lead on, each that is needed takes some more trials to be told apart.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import chain, combinations, pairwise, product
from math import inf
from typing import TYPE_CHECKING

from motionlang_explore.exploration.changes import AT_REST, TEXTS, Change, Channel, Moment, levels_at
from motionlang_explore.exploration.rests import BODY, EXACT, SHORTEST_REST, Rest
from motionlang_explore.exploration.states import Causes, ChangeInMove, StateNode, Visit
from motionlang_explore.exploration.trials import Trial, TrialMotion
from motionlang_explore.exploration.values import (
    counts,
    first_write,
    is_number,
    probe_of,
    solved,
    turning_at,
    usual_answers,
)
from motionlang_explore.identification import place

if TYPE_CHECKING:
    from motionlang_explore.exploration.search import Explorer

# So many trials show that a program counts how often an input comes.
ENOUGH = 3
# The period of an input that comes and goes at rest, s.
PERIOD = 0.4
# A mark of a latch comes at these shares of a move; a place where a comparison turns is left by so much of the way.
MARKED, NEAR = (0.4, 0.6), 0.03
# So many channels of one condition change at once, and so many values of a number are tried with another channel.
MAX_TOGETHER, MAX_SOLVED = 3, 6
# A condition has so many channels; a statement that has read more of them contains several conditions.
MAX_CONDITION = 4
# A statement that has read more inputs than this reads a bank.
MAX_READ = 8


def at_power_up(explorer: Explorer, trial: Trial, rest: Rest | None) -> Iterator[Causes]:
    """Yield the changes at power-up: of each input that is read before the first rest."""
    read = read_on_way(explorer, trial, rest)
    yield from ((_flipped(each, {}),) for each in read if each[0] == "input")


def one_by_one(explorer: Explorer, node: StateNode, visit: Visit) -> Iterator[Causes]:
    """Yield the changes of each channel that was read in a state, and the answers to its question."""
    levels = visit.levels
    read = _channels(explorer, node)
    inputs = [each for each in read if each[0] == "input"]
    inputs += [("input", each) for each in sorted(explorer.triggers)]
    for channel in dict.fromkeys(inputs):
        yield (_flipped(channel, levels),)
    if visit.question is not None:
        yield from _answers(explorer, node, visit)
        return
    for channel in explorer.started_by:  # the write starts the handler, whatever the value
        yield (first_write(channel),)
    for channel in dict.fromkeys((*read, *explorer.started_by)):
        if channel[0] not in ("input", *TEXTS[1:]):
            yield from _values(explorer, node, visit, channel)


def as_before(explorer: Explorer, node: StateNode) -> Iterator[Causes]:
    """Yield what leads on from the states at the same place, where the program remembers something else."""
    for other in explorer.same_place(node):
        yield from dict.fromkeys(each.causes for each in list(other.transitions) if each.causes)


def pulses(
    explorer: Explorer, node: StateNode, visit: Visit, change: Change, trial: Trial
) -> Iterator[Causes]:
    """Yield an input that comes and goes: as often as it is counted, or once if its change alone leads nowhere."""
    once = explorer.changed(visit, _pulses(change, 1))
    if not _leads_on(explorer, node, visit, once):
        yield from _counted(explorer, node, visit, partial(_pulses, change), [once])
    elif not _leads_on(explorer, node, visit, trial):
        yield _pulses(change, 1)


def _leads_on(explorer: Explorer, node: StateNode, visit: Visit, trial: Trial) -> bool:
    last = [each.state for each in explorer.rests(trial)[-1:]]
    return last != [node.state] or bool(trial.part(visit.change_time, inf).moves)


def is_read_again(explorer: Explorer, trial: Trial, change: Change) -> bool:
    """True if a program at rest reads an input also behind its change, or it starts a handler: it may be counted."""
    if change.table != "input" or change.moment != AT_REST:
        return False
    if change.number in explorer.counters:
        return True
    return any(change.channel in read for rest in explorer.rests(trial) for read in rest.reads.values())


def of_conditions(explorer: Explorer, node: StateNode, visit: Visit) -> Iterator[Causes]:
    """Yield the changes of several channels that one statement of a state has read, or on which it depends."""
    levels = visit.levels
    yield from node.codes
    for at in [*node.reads, *sorted(node.places - node.reads.keys())]:
        depends = explorer.decided.get(at, set()).intersection(node.channels)
        read = list(dict.fromkeys((*node.reads.get(at, ()), *sorted(depends))))
        channels = that_matter(explorer, read, node.places)
        choices = [each for channel in channels if (each := _choices(node, channel, levels))]
        # No comparison has used these numbers yet: the rest of the condition decides first.
        unsolved = [each for each in channels if each[0] not in ("input", *TEXTS) and each not in node.solved]
        most = MAX_TOGETHER if len(channels) <= MAX_CONDITION else 2
        for count in range(2, min(len(channels), most) + 1):
            for some in combinations(choices, count):
                yield from (tuple(sorted(each)) for each in product(*some))
            for some in combinations(choices, count - 1):
                for others, channel in product(product(*some), unsolved):
                    yield from _compared(explorer, node, visit, others, channel)
        inputs = [each for each in channels if each[0] == "input"]
        leads_on = partial(_leads_on, explorer, node, visit)
        if len(inputs) > MAX_TOGETHER and (needed := _fewest(explorer, visit, (), inputs, leads_on)):
            yield needed


def _fewest(
    explorer: Explorer,
    visit: Visit,
    causes: Causes,
    inputs: list[Channel],
    leads_on: Callable[[Trial], bool],
) -> Causes:
    """Return changes with those inputs that lead on together, none if none do; by halves others are left out."""

    def changes(inputs: Iterable[Channel]) -> Causes:
        return tuple(sorted((*causes, *(_flipped(each, visit.levels) for each in inputs))))

    def succeeds(inputs: list[Channel]) -> bool:
        trial = explorer.changed(visit, changes(inputs))
        return not explorer.trials.is_over and leads_on(trial)

    if not succeeds(inputs):
        return ()
    needed, size = inputs, len(inputs)
    while size > 1:
        size = (size + 1) // 2
        for first in reversed(range(0, len(needed), size)):
            fewer = needed[:first] + needed[first + size :]
            needed = fewer if fewer and succeeds(fewer) else needed
    return changes(needed)


def behind(
    explorer: Explorer, node: StateNode, visit: Visit, causes: Causes, trial: Trial, rest: Rest | None
) -> Iterator[Causes]:
    """Yield changes that lead on with one more channel that was read behind them, until the next rest, or with more."""
    read = read_on_way(explorer, trial, rest)
    yield from with_more(explorer, node, visit, causes, read)
    changed = {each.channel for each in causes}
    inputs = [each for each in read if each[0] == "input" and each not in changed]
    if len(inputs) > 1 and (needed := _fewest(explorer, visit, causes, inputs, explorer.is_news)):
        yield needed


def with_more(
    explorer: Explorer, node: StateNode, visit: Visit, causes: Causes, read: Iterable[Channel]
) -> Iterator[Causes]:
    """Yield changes with one more of some channels."""
    changed = {each.channel for each in causes}
    for channel in read:
        if channel in changed or channel in explorer.given or channel[0] in TEXTS:
            continue
        if channel[0] == "input":
            yield tuple(sorted((*causes, _flipped(channel, visit.levels))))
        else:
            yield from _compared(explorer, node, visit, causes, channel)


def _read(
    explorer: Explorer, trial: Trial, since: float, until: float, without: frozenset[int] = frozenset()
) -> list[Channel]:
    """Return the channels that a trial has read between two times, but for some statements."""
    found: dict[Channel, None] = {}
    for at, channels in trial.readings.items():
        read = [
            channel
            for channel, spans in channels.items()
            if any(since - EXACT <= each.last and each.first <= until for each in spans)
        ]
        if at not in without:
            found |= dict.fromkeys(that_matter(explorer, read, trial.decided))
    return list(found)


def read_on_way(explorer: Explorer, trial: Trial, rest: Rest | None) -> list[Channel]:
    """Return the channels that lead to a rest: those that other statements than its own have read until then."""
    until = inf if rest is None else rest.begin + BODY
    places = frozenset[int]().union(*(each.statements for each in (rest.state if rest else ())))
    return _read(explorer, trial, trial.since, until, places)


def _channels(explorer: Explorer, node: StateNode) -> list[Channel]:
    """Return the channels that were read in a state; of a bank those that matter."""
    read = (that_matter(explorer, channels, node.places) for channels in node.reads.values())
    return list(dict.fromkeys(chain.from_iterable(read)))


def that_matter(explorer: Explorer, read: Iterable[Channel], places: Iterable[int]) -> list[Channel]:
    """Return the channels of a statement that no person has given; of a bank those that decide at some statements."""
    free = [each for each in read if each not in explorer.given]
    if len(free) <= MAX_READ:
        return free
    decided = set[Channel]().union(*(explorer.decided.get(at, ()) for at in places))
    return [each for each in free if each in decided]


def _flipped(channel: Channel, levels: dict[int, float]) -> Change:
    return Change("input", channel[1], 1.0 - levels.get(channel[1], 0.0))


def _choices(node: StateNode, channel: Channel, levels: dict[int, float]) -> tuple[Change, ...]:
    """Return the changes of a channel that a condition may need."""
    if channel[0] == "input":
        return (_flipped(channel, levels),)
    return node.solved.get(channel, ())[:MAX_SOLVED]


# ------------------------------------------------------------------------------------------------------- numbers


def _values(explorer: Explorer, node: StateNode, visit: Visit, channel: Channel) -> Iterator[Causes]:
    """Yield the changes of a channel with more than two levels, by the comparisons that follow."""
    for causes in _compared(explorer, node, visit, (), channel):
        node.solved[channel] = (*node.solved.get(channel, ()), *causes)
        yield causes


def _compared(
    explorer: Explorer, node: StateNode, visit: Visit, others: Causes, channel: Channel, question: str = ""
) -> Iterator[Causes]:
    """Yield the changes to values at which the comparisons behind an unusual one of a channel turn."""
    if explorer.trials.is_over:
        return
    probe = probe_of(channel, question)
    causes = tuple(sorted((*others, probe)))
    trial = explorer.changed(visit, causes)
    yield from (tuple(sorted((*others, each))) for each in solved(probe, trial))
    # Last, so that what an unusual value does is known of a value that a person would give.
    explorer.take(node, visit, causes, trial)


def _answers(explorer: Explorer, node: StateNode, visit: Visit) -> Iterator[Causes]:
    """Yield answers to the question of a state: usual ones, and those that comparisons tell apart."""
    assert visit.question is not None
    first = probe_of(("answer", 0), visit.question)
    given: set[str] = set()
    # A rejected answer may print the range of the right ones.
    while left := [each for each in usual_answers(node.printed) if each not in given]:
        given.add(left[0])
        yield (first._replace(value=left[0]),)
    yield from _compared(explorer, node, visit, (), ("answer", 0), visit.question)


def with_other_answers(
    explorer: Explorer, visit: Visit, causes: Causes, trial: Trial
) -> Iterator[tuple[StateNode, Causes]]:
    """Yield a state that has asked before, with an answer at which a comparison of a trial turns, and those since."""
    asking = {node.first.question: node for node in explorer.nodes.values()}
    given = [*(change for _, change in visit.timeline), *causes]
    for k, change in enumerate(given[: len(visit.timeline)]):
        since = given[k + 1 :]
        prompts = {one.prompt for one in given[k:] if one.table == "answer"}
        if change.prompt in asking and is_number(change) and len(prompts) == len(since) + 1:
            for other in solved(change, trial):
                yield asking[change.prompt], (other, *since)


# ------------------------------------------------------------------------------------------------------ in moves


def changes_in_moves(
    explorer: Explorer, trial: Trial, since: float, until: float, causes: Causes
) -> list[ChangeInMove]:
    """Return the inputs that are read in moves, start a handler, stop an axis or trigger a latch."""
    if any(each.moment.line for each in causes):
        return []
    motions: dict[int, TrialMotion] = {}
    part = trial.part(since, until)
    for each in part.motions:
        if each.end - each.begin > SHORTEST_REST:
            motions.setdefault(each.line, each)
    found = []
    for motion in motions.values():
        levels = levels_at(trial.timeline, motion.begin)
        onward = frozenset(each.line for each in part.motions if each.begin > motion.begin)
        read = _read(explorer, trial, motion.begin + 2 * EXACT, motion.end - EXACT)
        inputs = [number for table, number in read if table == "input"]
        inputs += sorted(explorer.triggers | explorer.stops | explorer.latches)
        for number in dict.fromkeys(inputs):
            found.append(ChangeInMove(_flipped(("input", number), levels), motion, onward))
    return found


def in_moves(
    explorer: Explorer, node: StateNode, visit: Visit, causes: Causes, possible: Sequence[ChangeInMove]
) -> Iterator[Causes]:
    """Yield changes with one more in the middle of a move, once or as often as it is counted."""
    for each in possible:
        if (each.key, node.state) in explorer.changed_in:
            continue
        explorer.changed_in |= {each.key, (each.key, node.state)}
        yield each.added(causes, visit.change_time)
        if each.change.number in explorer.latches:
            places = explorer.marks.setdefault(each.change.number, {})
            places |= dict.fromkeys(_places(explorer, visit, causes, each))
        if each.change.number in explorer.triggers - explorer.counters:
            continue
        yield from _counted(explorer, node, visit, partial(each.added, causes, visit.change_time))


def _places(explorer: Explorer, visit: Visit, causes: Causes, mark: ChangeInMove) -> list[float]:
    """Return the shares of the way of a move where a mark turns comparisons of its place, and between them."""
    begin, end, axis = mark.motion[:3]
    seen: list[tuple[float, Trial]] = []
    for share in MARKED:
        trial = explorer.changed(visit, mark.added(causes, visit.change_time, share=share))
        moved = explorer.trials.last.controller.axes[axis]
        first, last, at = (place(moved, time) for time in (begin, end, begin + (end - begin) * share))
        seen.append(((at - first) / (last - first) if last != first else 0.0, trial))
    (one, before), (other, after) = seen
    roots = sorted(turning_at(one, other, before, after)) if one != other else []
    roots = [each for each in roots if 0.0 < each < 1.0]
    middles = ((low + high) / 2 for low, high in pairwise(roots))
    beside = (root + NEAR * side for root in roots for side in (1, -1))
    return [round(each, 3) for each in chain(middles, beside)][:MAX_SOLVED]


def _counted(
    explorer: Explorer,
    node: StateNode,
    visit: Visit,
    often: Callable[[int], Causes],
    known: Sequence[Trial] = (),
) -> Iterator[Causes]:
    """Yield changes with an input that comes and goes as often as a program counts it."""
    trials = list(known)
    wanted: list[int] = []
    while len(trials) < ENOUGH and (len(trials) < 2 or wanted):
        if explorer.trials.is_over:
            return
        trials.append(explorer.changed(visit, often(len(trials) + 1)))
        # What is over after two times counts no third one.
        wanted = [*(each for each in wanted if each <= ENOUGH), *counts(trials)]
    yield from map(often, (each for each in wanted if each > ENOUGH))
    # Last, so that what too few do is known of enough.
    for times, trial in enumerate(trials, 1):
        if max(wanted, default=0) > ENOUGH or (times in wanted and explorer.is_news(trial)):
            explorer.take(node, visit, often(times), trial)


def _pulses(change: Change, times: int) -> Causes:
    """Return an input that comes and goes so many times at rest."""
    return (change._replace(moment=Moment(times=times, every=PERIOD)),)
