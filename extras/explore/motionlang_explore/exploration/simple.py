"""Simple worlds, tried where the world of the likeliest cycle does little or no good work.

Problem. A program of ten lines that runs once may wait for nothing: it looks at an input once, counts it while an axis
jogs, or takes what a host has written. No state asks for what it needs. Or the likeliest cycle is a side job of a menu.

Idea. The program runs in simple worlds. Where no good one is known, each input first has the rule that its name and
its place suggest (`likely.py`). Then other inputs than those of a cycle are off, on, answer when they are asked for, or
come and go. From the worlds in which most of the program is carried out each channel takes the rule with which a run
is worth most, until none is worth more. The channel that a run has read last may stop it, and is first.
A program measures a part by a level: where it does at one within limits what it does at no other, that one is taken.
It judges a part by an input: where a run does something else with it never on, always on or behind an output, the
branch is taken that is worth more. An input without which nothing but texts is missing, such as a stop, is off.
What goes wrong late, such as behind a full batch, a long run shows: one more input may be what is missing there.

What a run is worth: the share of the program that it carries out, each line that moves an axis, each output, each
printed line; much less if it says that something is wrong, or waits for ever. Handlers do not count.

Cost. What is left of the work of the exploration, but a share of it in any case, which also limits each run; where the
world that was found is a good one, two runs for each input, for each output two more of each that is off, and some for
each level.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import partial, reduce
from itertools import product
from math import fsum, inf
from typing import Any, NamedTuple

from motionlang.comparison.texts import plain, without_figures
from motionlang.kernel import Run
from motionlang_explore.exploration.changes import TABLES, Channel, entries, keys_of, made_by, number_in
from motionlang_explore.exploration.cycles import RIGHT, MachineCycle
from motionlang_explore.exploration.likely import ASKED, ON, PUSH, QUICK, SOON
from motionlang_explore.exploration.recorder import ReadSpan
from motionlang_explore.exploration.search import Explorer
from motionlang_explore.exploration.states import DELAY
from motionlang_explore.exploration.trials import (
    ENDLESS,
    SHORTEST_MOVE,
    asks,
    is_short_move,
)
from motionlang_explore.exploration.values import is_probe, levels, probe_of, solved
from motionlang_explore.exploration.words import is_right, is_wrong, names_alarm, speaks, wrong
from motionlang_explore.exploration.world import PULSES, WHOLE, WRITES, FoundWorld, world_of
from motionlang_explore.identification import Entry, place

# So much of the work of an exploration simple worlds may take where a good one was found, in so many runs each time, of
# this length, s. They have a share of their own, a larger one where none was found, and those that names suggest may
# take so much.
GOOD, OWN, SEARCHED, LIKELY, TRIES, LENGTH = 0.2, 0.15, 0.3, 0.6, 250, 60.0
# A run that stands still, or says again and again what is wrong, ends at this time, s.
STANDS = 20.0
# A world in which less of the program is carried out does little. Then so many other cycles are tried, and another one
# must be worth so much more.
LITTLE, OTHERS, MORE = 0.4, 2, 1.0
# A channel with more entries changes one by one. From so many worlds other ones are looked for.
LISTED, STARTS = 2, 3
# A text in a program, and what is wrong with a run without one.
_TEXT = re.compile('"([^"]*[A-Za-z][^"]*)"')
SILENT = "prints nothing"
# What is done so often counts in full. A machine works that says what is wrong at most half as often as what is right.
ENOUGH, HALF = 3, 0.5
# What counts for a run: all statements, its end, a line that moves to a target, another motion, an output, a printed
# line. Against it: a line that says what is wrong, a wait that never ends, no motion where axes should move, and each
# entry of the machine file, less for a number or a key that comes whenever it is asked for, more for what pulses, and
# much more for a level that follows an axis.
SHARE, ENDS = 4.0, 2.0
MOVE, JOG, OUTPUT, SAID = "move", "jog", "output", "said"
WORTH = {MOVE: 1.5, JOG: 0.5, OUTPUT: 0.5, SAID: 2.0}
WRONG, NEVER, NOTHING, ENTRY, ANSWERS, PULSED, MOVING = 4.0, 3.0, 5.0, 0.01, 0.5, 1.5, 20.0
# A flow meter or a tachometer comes and goes so fast, s.
COUNTED: Entry = {"at": 0.02, "for": 0.02, "every": 0.04}
# So many marks are on the way of an axis, or one in each move of one of so many lengths, up to so many in all.
MARKS, LENGTHS, ALL = 7, 3, 1000
# So many rules of each channel are tried first, then of pairs, and then the rest of each channel.
FIRST, PAIRS, REST = 8, 1, 2
# The tables of the numbers that a host writes.
HOSTS = ("comms", "netdata")
# Levels and numbers that are tried; the size of a lot comes first, since a lot of one has no next piece.
USUAL, ABOVE, NUMBERS, LOT = 50.0, 100.0, (1, 2, 10, 100), 3

Settings = Mapping[str, object]


class Tried(NamedTuple):
    """A run in a world: the statements that begin, their share of the program, its worth, and if its work is good.

    `read` is when it reads each channel, in the order in which it reads them first, or last before it says what is
    wrong or waits for ever.
    `times` is how often the line moves an axis that does so most often, `faults` how much it says of what is wrong.
    It `stands` if it waits for ever, but for a person's answer, or once what comes one by one is over.
    """

    settings: Settings
    run: Run
    begun: frozenset[int]
    read: dict[Channel, list[ReadSpan]]
    times: int
    faults: float
    share: float
    value: float
    is_good: bool
    stands: bool


def better_world(explorer: Explorer, found: FoundWorld, likeliest: Sequence[MachineCycle]) -> FoundWorld:
    """Return the world that was found, or a better one if it does little or no good work.

    It is the world of another cycle that carries out what this one does not, or a simple one.
    """
    # The search may have left no work.
    work = explorer.trials.work
    explorer.trials.limit = explorer.whole = max(explorer.whole, work + OWN * explorer.whole)
    first = _tried(explorer, found.settings)
    if not _does_work(explorer, first):
        explorer.trials.limit = explorer.whole = max(explorer.whole, work + SEARCHED * explorer.whole)
    channels, least = _channels(explorer), max(min(first.times, ENOUGH), 1)
    if not first.stands:
        first = _within_limits(explorer, channels, first, least)
    if first.is_good:
        lacking = [each for each in channels if each in listed(first.settings)]
        lacking += _unwritten(channels, first)
        first = _climbed(explorer, lacking, first, least, inf, GOOD)
        given = {number_in("input", each) for each in entries(first.settings, "input")}
        off = [
            each for each in first.read if each[0] == "input" and each in channels and each[1] not in given
        ]
        first = _right_branch(explorer, off, first, least)
    if works := _does_work(explorer, first):
        first = _with_less(explorer, first, least)
    if first.settings != found.settings:
        found = found._replace(settings=first.settings, run=first.run)
    best, world = first, found
    # Rejects are more different lines: what does good work is left as it is.
    likely = () if works else _likely_starts(explorer, channels, found)
    simple = _simple_starts(explorer, channels, found, likeliest, first)
    for starts, share in ((likely, LIKELY), (simple, 1.0)):
        does_enough = best is first or _is_enough(best)
        if (does_enough and _does_much(explorer, best)) or not explorer.has_work:
            break
        tried = []
        for settings, other in starts:
            if explorer.has_work:
                tried.append((_tried(explorer, settings, least), other))
        others = (each for each in tried if not (works and _gives_up(each[0], first)))
        best, world = max([(best, world), *others], key=lambda each: _rank(each[0]))
        # Where less answers the program waits sooner.
        starting = {each[0].begun: each for each in tried}.values()
        most = explorer.most(share)
        for start, other in sorted(starting, key=lambda each: (not each[0].is_good, -each[0].share))[:STARTS]:
            if _does_much(explorer, best):
                break
            start = _within_limits(explorer, channels, start, least)
            climbed = _climbed(explorer, channels, start, least, most)
            if _rank(climbed) > _rank(best) and not (works and _gives_up(climbed, first)):
                best, world = climbed, other
    is_better = best.is_good > first.is_good or best.value >= first.value + MORE
    if best is first or best.is_good < first.is_good or not is_better:
        return found
    best = _climbed(explorer, _unwritten(channels, best), best, least, inf, GOOD)
    best = _with_less(explorer, _within_limits(explorer, channels, best, least), least)
    return world._replace(settings=best.settings, run=best.run)


def lasting_world(explorer: Explorer, found: FoundWorld) -> FoundWorld:
    """Return a world with one more input where a long run in it goes wrong late, such as behind a full batch.

    The input is on, or follows an output, and the run then does at least as much, and nothing wrong.
    """
    given = {number_in("input", each) for each in entries(found.settings, "input")}
    left = [each for each in _channels(explorer) if each[0] == "input" and each[1] not in given]
    if not left or fault_of(explorer, found.run) or not explorer.has_work:
        return found
    run, tasks, read = explorer.trials.run_in(found.settings, WHOLE)
    if not fault_of(explorer, run):
        return found
    first = Tried(found.settings, run, frozenset(tasks), read, 0, 0.0, 0.0, 0.0, False, False)
    for channel in (each for each in left if each in read):
        for rule in (*_followed(first, channel), {**ON}):
            settings = _with(found.settings, channel, rule)
            if explorer.has_work:
                other = explorer.trials.run_in(settings, WHOLE)[0]
                does_more = len(other.machine.log.moves) >= len(run.machine.log.moves)
                if does_more and not fault_of(explorer, other):
                    return found._replace(settings=settings, run=other)
    return found


def _likely_starts(
    explorer: Explorer, channels: Sequence[Channel], found: FoundWorld
) -> Iterator[tuple[Settings, FoundWorld]]:
    """Yield worlds in which each input has its likeliest rule by name, or by place; what is likely off is so, or on."""
    bare, starts = _bare(channels, found), list[Settings]()
    inputs = sorted(number for table, number in channels if table == "input")
    ways = ((True, True), (True, False), (False, True))
    for more, (by_name, by_place), off in product(({}, _asked(bare)), ways, ({}, ON)):
        own = ((each, explorer.likely.rules(each, by_name=by_name, by_place=by_place)) for each in inputs)
        rules = ((number, each[0] or off) for number, each in own)
        made = [{"channel": number, **rule} for number, rule in rules if rule]
        starts.append({**bare, **more, "input": made})
    yield from ((each, found) for k, each in enumerate(starts) if each not in starts[:k])


def _simple_starts(
    explorer: Explorer,
    channels: Sequence[Channel],
    found: FoundWorld,
    likeliest: Sequence[MachineCycle],
    first: Tried,
) -> Iterator[tuple[Settings, FoundWorld]]:
    """Yield worlds in which all inputs without an entry follow the same rule."""
    # What says what is wrong may only lack a rule, such as marks on the way.
    others = [each for each in likeliest if each.repeats and not each.begun <= first.begun]
    others.sort(key=lambda each: bool(wrong(each.said)))
    worlds = [found, *(world_of(explorer, [each]) for each in others[:OTHERS])]
    inputs = [number for table, number in channels if table == "input"]
    # What has no entry yet is never on, always on, or answers.
    rules: tuple[tuple[Sequence[int], Entry], ...] = ((), ON), (inputs, ON), (inputs, QUICK)
    yield first.settings, found
    bare = _bare(channels, found)
    bases = ({**bare, **more} for more in ({}, _asked(bare)))
    starts = [(_with_others(each, inputs, rule), found) for each in bases for rule in (QUICK, ON, PULSES)]
    starts += [(_with_others(each.settings, *rule), each) for each in worlds for rule in rules]
    yield from (each for k, each in enumerate(starts) if each[0] not in [one for one, _ in starts[:k]])


def _bare(channels: Sequence[Channel], found: FoundWorld) -> Settings:
    """Return a world without its inputs, with a level for each analogue input if there are several."""
    bare = {**found.settings, "input": []}
    known = {number_in("analogue", each) for each in entries(bare, "analogue")}
    levels = [
        {**keys_of(*each), "value": USUAL, **ON}
        for each in channels
        if each[0] == "analogue" and each[1] not in known
    ]
    if len(levels) > 1:  # one by one they lead no further
        bare["analogue"] = [*entries(bare, "analogue"), *levels]
    return bare


def _right_branch(explorer: Explorer, off: Sequence[Channel], first: Tried, least: int) -> Tried:
    """Return the run that goes further of those that take another branch of a judgement by one more input."""
    rules = ((each, rule) for each in off for rule in ({**ON}, *_followed(first, each)))
    settings = (_with(first.settings, *each) for each in rules)
    flipped = [_tried(explorer, each, least) for each in settings if explorer.has_work]
    found = (first, *(each for each in flipped if _judges(explorer, first, each)))
    return max(found, key=lambda each: each.value)


def _unwritten(channels: Sequence[Channel], first: Tried) -> list[Channel]:
    """Return the numbers of a host that a run reads, and nobody writes, such as the size of a lot."""
    known = {(table, number_in(table, each)) for table in HOSTS for each in entries(first.settings, table)}
    return [each for each in channels if each[0] in HOSTS and each in first.read and each not in known]


def _with_less(explorer: Explorer, first: Tried, least: int) -> Tried:
    """Return a run with inputs never or always on where it only says less then, but something, or goes further.

    They are changed one by one, and both of a condition.
    """
    given = dict.fromkeys(("input", number_in("input", each)) for each in entries(first.settings, "input"))
    several = [*((each,) for each in given), *_pairs(explorer, [*given])]
    for some, rule in product(several, ({}, {**ON})):
        settings = reduce(partial(_with, rule=rule), some, first.settings)
        less = _tried(explorer, settings, least) if explorer.has_work else first
        usual, left = (_acts(explorer, each.run)[0].keys() for each in (first, less))
        only_says = less.times >= first.times and {kind for kind, _ in usual - left} == {SAID} <= {
            kind for kind, _ in left
        }
        goes_further = less.value > first.value and _judges(explorer, first, less)
        is_needless = not rule and usual <= left and first.read.keys() >= {*some}
        is_needless &= less.times > first.times or (less.times == first.times and left == usual)
        # What is on before it is asked for may spare an alarm.
        spares = bool(rule) and less.faults < first.faults and less.times >= first.times
        spares &= {kind for kind, _ in usual - left} <= {OUTPUT}
        if less.is_good and (only_says or goes_further or is_needless or spares):
            first = less
    return first


def _judges(explorer: Explorer, one: Tried, other: Tried) -> bool:
    """True if two runs take two branches of a judgement: each does something that the other does not, and is good.

    To say nothing but at the start is a branch, too, where the other one says what is right. What ends the program is
    none, nor what gives up.
    """
    mine, others = (_acts(explorer, each.run)[0] for each in (one, other))
    ends = other.run.status == "ended" != one.run.status or _gives_up(other, one)
    is_silent = not _says(mine) and _says(others)
    differs = bool(others.keys() - mine.keys()) and (is_silent or bool(mine.keys() - others.keys()))
    return other.is_good and not ends and differs


def _gives_up(other: Tried, good: Tried) -> bool:
    """True if a run moves much less often than a good one."""
    return good.is_good and other.times < HALF * good.times


def _says(right: Counter[tuple[str, object]]) -> bool:
    """True if a run says what is right again and again."""
    return any(kind == SAID and count > 1 for (kind, _), count in right.items())


def _within_limits(explorer: Explorer, channels: Sequence[Channel], first: Tried, least: int) -> Tried:
    """Return a good run with levels at which statements begin that begin at no others, or the first run.

    The program has measured a part then, and what is within limits is good. Rules of other channels may depend on it.
    """
    known = dict.fromkeys((*channels, *first.read))
    for channel in (each for each in known if each[0] == "analogue" and each not in explorer.given):
        if not explorer.has_work:
            break
        settings = partial(_with, first.settings, channel)
        ends = [_tried(explorer, settings({"value": level, **ON})) for level in (0.0, ABOVE)]
        usual = ends[0].begun | ends[1].begun
        if (first.is_good and not first.begun <= usual) or not explorer.has_work:
            continue
        probe = probe_of(channel)
        trial = explorer.trials.play_in(settings({"value": probe.value, **ON}), LENGTH)
        for level in (each.value for each in solved(probe, trial) if explorer.has_work):
            run = _tried(explorer, settings({"value": level, **ON}), least)
            if not run.begun <= usual:
                left = [each for each in channels if each != channel]
                run = run if run.is_good else _climbed(explorer, left, run, least, explorer.most(OWN))
                if run.is_good and not run.begun <= usual:
                    first = run
                    break
    return first


def neighbours(explorer: Explorer, settings: Settings) -> Iterator[tuple[Channel, Settings]]:
    """Yield the settings with another simple rule for one channel, or for both inputs of a statement, and the first."""
    first, channels = _tried(explorer, settings), _channels(explorer)
    for some in [*((each,) for each in channels), *_pairs(explorer, channels)]:
        yield from ((some[0], each) for each in _others(explorer, some, first))


def _with_others(settings: Settings, inputs: Sequence[int], rule: Entry) -> Settings:
    """Return settings in which all inputs without an entry have the same rule."""
    known = {number_in("input", each) for each in entries(settings, "input")}
    made: list[Entry] = [{"channel": each, **rule} for each in inputs if each not in known]
    return {**settings, "input": [*entries(settings, "input"), *made]}


def _asked(settings: Settings) -> Settings:
    """Return the numbers and the keys of a world, each with its first value and whenever it is asked for."""
    made: dict[str, list[Entry]] = {}
    for table in WRITES:
        firsts: dict[int, Entry] = {}
        for each in entries(settings, table):
            number = number_in(table, each)
            kept = {key: each[key] for key in (*keys_of(table, number), "value", "text") if key in each}
            firsts.setdefault(number, {**kept, **ASKED})
        made |= {table: [*firsts.values()]} if firsts else {}
    return made


def _climbed(
    explorer: Explorer, channels: Sequence[Channel], best: Tried, least: int, most: float, more: float = 0.0
) -> Tried:
    """Return the simple world that is worth most: channels take the best of their rules until none is better.

    What the run has read last comes first, since it may be what stops it; then what starts a handler. The first rules
    of all channels come first; if none is good, then one for both inputs of a condition, such as two hands, and then
    the others.
    """
    trials = explorer.trials
    last, enough = trials.count + TRIES, explorer.most(more)
    stage, before = 0, best.value
    while True:
        events = sorted(explorer.triggers | explorer.latches)
        read = [*reversed(best.read), *(("input", each) for each in events)]
        ones = [(each,) for each in dict.fromkeys(read) if each in channels]
        for some in _pairs(explorer, channels) if stage == PAIRS else ones:
            for settings in [*_others(explorer, some, best)][
                slice(FIRST, None) if stage == REST else slice(FIRST)
            ]:
                if trials.work > (min(enough, most) if _is_enough(best) else most) or trials.count > last:
                    return best
                run = _tried(explorer, settings, least)
                # What says what is wrong comes no further than what has begun to work, and does not say so.
                is_right = (
                    run.is_good or run.faults <= best.faults or best.times < ENOUGH or best.faults > 0.0
                )
                if (run.value, run.is_good) > (best.value, best.is_good) and is_right:
                    best = run
            if best.value > before + HALF:
                break
        if best.value <= before + HALF and (stage == REST or _is_enough(best)):
            return best
        stage = 0 if best.value > before + HALF else stage + 1
        before = best.value


def _rank(tried: Tried) -> tuple[bool, float]:
    """Return what decides which of two runs is better: a good one is."""
    return tried.is_good, tried.value


def _does_much(explorer: Explorer, tried: Tried) -> bool:
    """True if a run does good work that is not little of the program."""
    return _does_work(explorer, tried) and tried.share >= LITTLE


def _does_work(explorer: Explorer, tried: Tried) -> bool:
    """True if a run does good work; one that says nothing has to switch on most of the outputs of the work."""
    right, outputs = _acts(explorer, tried.run)[0], _outputs(explorer)
    switched = [each for each in outputs if (OUTPUT, each) in right]
    does_all = _says(right) or len(outputs) < 2 or 2 * len(switched) > len(outputs)
    return tried.is_good and not tried.stands and does_all


def _is_enough(tried: Tried) -> bool:
    """True if a run does good work several times, and does not stand then, or to the end of the program."""
    return tried.is_good and not tried.stands and (tried.times >= ENOUGH or tried.run.status == "ended")


def _pairs(explorer: Explorer, channels: Sequence[Channel]) -> list[tuple[Channel, ...]]:
    """Return the two inputs of each statement that reads two."""
    uses = (
        [use for use in each.channels if use.channel == "input"]
        for each in explorer.program.structure.statements.values()
    )
    found = dict.fromkeys(
        tuple(sorted({("input", int(use.number)) for use in some if use.number.isdecimal()})) for some in uses
    )
    return [each for each in found if len(each) == 2 and set(each) <= set(channels)]


def _channels(explorer: Explorer) -> list[Channel]:
    """Return the channels that the program reads, or names where the exploration has not come to."""
    uses = (use for _, use in explorer.program.structure.inputs())
    named = [("input", int(use.number)) for use in uses if use.channel == "input" and use.number.isdecimal()]
    numbers = (each for each in explorer.read if each[0] in ("key", "analogue", "comms", "netdata"))
    inputs = (("input", each) for each in (*explorer.channels, *sorted(explorer.latches)))
    known = dict.fromkeys([*numbers, *inputs, *named])
    return [each for each in known if each not in explorer.given]


def _tried(explorer: Explorer, settings: Settings, least: int = 1) -> Tried:
    """Return a run in a world with its worth; it works if it does something at least so often, or ends."""

    def is_known(run: Run) -> bool:
        return _stands(run) or _only_says_wrong(*_acts(explorer, run))

    run, tasks, read = explorer.trials.run_in(settings, STANDS, LENGTH, stands=is_known)
    begun = frozenset(tasks) - explorer.handlers
    right, faults = _acts(explorer, run)
    has_ended = run.status == "ended"
    # What was done some times has ended since the world has nothing more. Inputs that come and go hide a wait for ever.
    done = min((count for (kind, _), count in right.items() if kind == MOVE), default=0)
    is_stuck = run.status == "fault" or (run.status == "until" and _stands(run))
    trouble = min(_times(explorer, run, faults), default=run.time)
    if is_stuck or faults:
        read = {each: read[each] for each in sorted(read, key=partial(_last_read, read, trouble))}
    never = is_stuck and done < ENOUGH
    stands = (is_stuck and not asks(run)) or (not has_ended and bool(listed(settings)))
    kind = MOVE if any(each == MOVE for each, _ in right) else JOG
    times = max((count for (each, _), count in right.items() if each == kind), default=0)
    # A trial ends early if the program starts moves without time for them.
    is_over = run.status == "until" and run.time < (
        STANDS if is_stuck or _only_says_wrong(right, faults) else LENGTH
    )
    statements = explorer.program.structure.statements.values()
    is_motionless = not any(each.moves for each in statements)
    works = is_motionless or (times >= (1 if has_ended else least) and not is_over)
    often = 1 if has_ended else ENOUGH
    share = len(begun) / max(len(statements), 1)
    value = SHARE * share + ENDS * has_ended - NEVER * (never or stands) - NOTHING * (not works)
    value += fsum(WORTH[kind] * min(count / often, 1.0) for (kind, _), count in right.items())
    value += RIGHT * any(is_right(str(text)) for kind, text in right if kind == SAID)
    # What stops for ever behind what is wrong says it once.
    wrongs = fsum(1.0 if is_stuck else min(count / often, 1.0) for count in faults.values())
    value -= WRONG * wrongs
    made = [(table, each) for table in TABLES for each in entries(settings, table)]
    value -= ENTRY * fsum(_cost(*each) for each in made)
    is_good = works and not (never or fault_of(explorer, run))
    return Tried(settings, run, begun, read, times, wrongs, share, round(value, 6), is_good, stands)


def _stands(run: Run) -> bool:
    """True if a run has done nothing for at least as long as it did something before, and no task pauses for a time."""
    log, scheduler = run.machine.log, run.machine.scheduler
    others = (each.time for some in (log.prints, log.outputs) for each in some)
    last = max((each.start_time for each in log.moves), default=max(others, default=0.0))  # a lamp may blink
    waits = [] if scheduler is None else [task.wait for task in scheduler.tasks if not task.done]
    pauses = any(wait is not None and wait.cause == "time" and wait.due() > run.time + PUSH for wait in waits)
    return 2 * last < run.time and not pauses


def _only_says_wrong(right: Counter[tuple[str, object]], faults: Counter[str]) -> bool:
    """True if a run says again and again what is wrong, and nothing that is right."""
    return max(faults.values(), default=0) >= ENOUGH and not any(kind == SAID for kind, _ in right)


def listed(settings: Settings) -> set[Channel]:
    """Return the channels that change one by one, which is over soon; of a host and a key, by the same value."""
    tables = ((table, each) for table in TABLES if table != "answer" for each in entries(settings, table))
    often = Counter(
        (table, number_in(table, each), made_by(table, each)[1].value if table in WRITES else None)
        for table, each in tables
    )
    return {(table, number) for (table, number, _), count in often.items() if count > LISTED}


def _times(explorer: Explorer, run: Run, faults: Collection[str]) -> Iterator[float]:
    """Yield when a run says what is wrong."""
    for each in run.machine.log.prints:
        if without_figures(plain(each.text)) in faults:
            yield each.time
    for switched in run.machine.log.outputs:
        if switched.value and f"output {switched.channel}" in faults:
            yield switched.time


def _last_read(read: Mapping[Channel, Sequence[ReadSpan]], until: float, channel: Channel) -> int:
    """Return the second in which a channel was read last before a time, -1 if it was not."""
    return max((round(min(each.last, until)) for each in read[channel] if each.first <= until), default=-1)


def _cost(table: str, entry: Entry) -> float:
    """Return the cost of an entry: that of an answer is lower, that of what pulses or follows an axis is higher."""
    if table in WRITES and "asked" in entry:
        return ANSWERS
    if "per_unit" in entry:
        return MOVING
    return PULSED if "every" in entry and "axis" not in entry else 1.0


def fault_of(explorer: Explorer, run: Run) -> str:
    """Return what is wrong with the work of a run in words, "" if nothing is.

    A run that prints nothing once it moves, or only jogs, does no work if the program has texts, or moves, that no
    trial has reached, or if it soon stands still. One that switches no output does none if the program switches
    several. An alarm that comes once in several pieces, each of which makes the same move, calls for a change of tool.
    """
    right, faults = _acts(explorer, run)
    for each in run.machine.log.prints:
        text = without_figures(plain(each.text))
        if (SAID, text) in right and _is_on_alarm(explorer, each.at):
            faults[text] += right.pop((SAID, text))
    often = Counter[str]()
    for (kind, _), count in right.items():
        often[kind] = max(often[kind], count)
    texts = {without_figures(plain(each.text)): plain(each.text) for each in run.machine.log.prints}
    said = [repr(text) for each, text in texts.items() if each in faults]
    times = often[MOVE] if run.cycle is None else run.cycle.count
    is_named = any(is_wrong(text) for each, text in texts.items() if each in faults)
    if not is_named:
        homes = run.dialect.table().homes
        same = Counter(
            (each.line, each.axis, round(each.to_user(each.profile.end), 3))
            for each in run.machine.log.moves
            if each.profile is not None
            and each.profile.duration < inf
            and not (each.ended or homes(each.command))
        )
        times = max([times, often[SAID], *same.values()])
    # What a machine says is right overrules the name of an output.
    praised = {key: count for key, count in right.items() if key[0] == SAID and is_right(str(key[1]))}
    if not said and faults.total() <= Counter(praised).total():
        faults.clear()
    # A lamp and a text of one trouble are one.
    count = faults.total() if is_named else max(faults.values(), default=0)
    if count > HALF * (often[SAID] if is_named else times):
        if said:
            return f"prints {', '.join(said)}"
        first = next(iter(faults))
        is_alarm = first in {f"output {each}" for each in explorer.alarms}
        return f"switches on {first}, {'an alarm by its name' if is_alarm else 'and waits for a reset'}"
    if run.cycle is not None and run.cycle.period < SHORTEST_MOVE and often[MOVE] + often[JOG]:
        return "cuts off its moves at once"
    outputs = _outputs(explorer)
    if len(outputs) > 1 and not said and not any((OUTPUT, each) in right for each in outputs):
        return "switches no output"
    is_silent, is_still = _missed(explorer)
    if is_still and often[JOG] and not often[MOVE]:
        return "only jogs"
    moved = [each.start_time for each in run.machine.log.moves]
    if not moved or any(each.time >= min(moved) for each in run.machine.log.prints):
        return ""
    scheduler = run.machine.scheduler
    waits = scheduler is not None and not all(task.done for task in scheduler.tasks)
    is_stuck = waits and (run.status == "fault" or 2 * max(moved) < run.time)
    if run.status != "ended" and is_silent:
        return SILENT
    if is_stuck and often[MOVE] + often[JOG] < ENOUGH:
        return f"begins no move after {max(moved):.4g} s"
    if not (often[MOVE] or often[JOG]):
        return "only homes"
    return ""


def _is_on_alarm(explorer: Explorer, at: int) -> bool:
    """True if the condition on the same line before a statement names what is wrong, as in If alarm = 3 Then."""
    source = explorer.program.source
    line, column = source.location(at) if at >= 0 else (0, 0)
    condition = source.line(line)[: max(column - 1, 0)].lower() if line else ""
    words = condition.split()
    is_condition = {"if", "then"} <= {*words} and {"not", "else"}.isdisjoint(words)
    return is_condition and names_alarm(condition) and bool(wrong([condition]))


def _missed(explorer: Explorer) -> tuple[bool, bool]:
    """True if no trial has reached some text that says nothing wrong, and some motion."""
    statements = explorer.program.structure.statements.items()
    missed = [each for at, each in statements if not each.waits and at not in explorer.trials.seen]
    texts = (text for each in missed for text in _TEXT.findall(each.text))
    return not all(map(is_wrong, texts)), any(each.moves for each in missed)


def _outputs(explorer: Explorer) -> set[int]:
    """Return the outputs, but for alarms, that the statements of the work switch on."""
    statements, others = explorer.program.structure.statements.items(), explorer.beside | explorer.handlers
    work = (each for at, each in statements if at not in others)
    return set[int]().union(*(each.outputs for each in work)) - set(explorer.alarms)


def _acts(explorer: Explorer, run: Run) -> tuple[Counter[tuple[str, object]], Counter[str]]:
    """Return how often a run does each thing, and how often it says what is wrong."""
    right, faults, homes = Counter[tuple[str, object]](), Counter[str](), run.dialect.table().homes
    aside, trouble = explorer.beside | explorer.handlers, explorer.likely.trouble
    for move in run.machine.log.moves:
        if move.profile is not None and not (is_short_move(move) or homes(move.command)):
            is_done = move.profile.duration < inf and not move.ended and move.profile.shape not in ENDLESS
            right[MOVE if is_done else JOG, move.line] += 1
    for switched in run.machine.log.outputs:
        is_alarm = switched.channel in explorer.alarms or switched.at in trouble
        if switched.value and switched.at >= 0 and is_alarm:
            faults[f"output {switched.channel}"] += 1
        elif switched.value and switched.at >= 0 and switched.at not in aside:
            right[OUTPUT, switched.channel] += 1
    for each in run.machine.log.prints:
        if each.at not in explorer.beside:
            text = without_figures(plain(each.text))
            says_wrong = wrong([each.text]) or (run.status != "ended" and is_wrong(each.text))
            if each.at in trouble or (says_wrong and each.at not in explorer.likely.right):
                faults[text] += 1
            elif speaks(text) and each.at not in explorer.handlers:
                right[SAID, text] += 1
    return right, faults


def _others(explorer: Explorer, channels: Sequence[Channel], best: Tried) -> Iterator[Settings]:
    """Yield the settings of a run with another rule for some channels, the simplest first."""
    rules = _rules if channels[0][0] == "input" else _levels
    tried: list[Entry] = []
    for rule in rules(explorer, channels[0], best):
        if rule not in tried:
            tried.append(rule)
            yield reduce(partial(_with, rule=rule), channels, best.settings)


def _with(settings: Settings, channel: Channel, rule: Entry) -> Settings:
    """Return settings with a rule for a channel, the only one; none if it is empty."""
    table, number = channel
    others = {key: each for key, each in settings.items() if key != table}
    left = [each for each in entries(settings, table) if number_in(table, each) != number]
    made = sorted([*left, *([{**keys_of(*channel), **rule}] if rule else [])], key=partial(number_in, table))
    return {**others, **({table: made} if made else {})}


def _rules(explorer: Explorer, channel: Channel, best: Tried) -> Iterator[Entry]:
    """Yield the simple rules of an input: never, always, a person, a sensor behind an output, marks, a position."""
    if channel[1] in explorer.triggers:
        for every in explorer.periods[channel[1]]:
            yield {"at": every, "for": SOON, "every": every}
        yield {**COUNTED}
    middle = (0.5,) if channel[1] in explorer.latches else ()  # a latch looks for a mark in a move
    yield from _marks(best.run, explorer.marks.get(channel[1]) or middle)
    yield from explorer.likely.rules(channel[1])
    followed = [*_followed(best, channel)]
    yield from ({}, *followed[:1], {**PULSES}, {**ON, "for": PUSH}, *followed[1:])
    for axis, way in _ways(best.run).items():
        half = round((min(way.places) + max(way.places)) / 2, 2)
        yield {"axis": axis, "above": half}
        yield {"axis": axis, "below": half}
    yield from _marks(best.run, (0.5,))


def _followed(best: Tried, channel: Channel) -> Iterator[Entry]:
    """Yield the rules of a sensor behind each output, on with it and on without it.

    That one comes first which is switched last before the input is read most often.
    """
    switched = [each for each in best.run.machine.log.outputs if each.at >= 0]
    times = [each.time for each in switched]
    before = (bisect_right(times, span.first) for span in best.read.get(channel, ()))
    often = Counter(switched[k - 1].channel for k in before if k)
    for output in sorted({each.channel for each in switched}, key=lambda each: (-often[each], each)):
        yield {"output": output, "delay": SOON}
        yield {"output": output, "delay": SOON, "value": 0}


def _marks(run: Run, shares: Iterable[float]) -> Iterator[Entry]:
    """Yield the marks along the way of each axis, at shares of its moves."""
    for share, (axis, way) in product(shares, _ways(run).items()):
        for step in (*way.lengths[:LENGTHS], (max(way.places) - min(way.places)) / MARKS):
            first = (way.places[0] + share * step) % step if step > 0.0 else 0.0
            mark = [round(first + each * step, 2) for each in (0.0, 0.1)]
            if mark[0] < mark[1]:
                yield {"axis": axis, "between": mark, "every": round(step, 2), "times": ALL}


def _levels(explorer: Explorer, channel: Channel, best: Tried) -> Iterator[Entry]:
    """Yield the rules of a level, or of a number of a host: values at which comparisons turn, and usual ones."""
    key, values = "text" if channel[0] == "key" else "value", _values(explorer, channel, best)
    if channel[0] != "analogue":
        for value in values:
            yield {key: value, **ASKED}
            yield {key: value, "at": DELAY}
        return
    yield from ({"value": value, **ON} for value in values)
    # An axis that comes back carries what is measured.
    ways = sorted(_ways(best.run).items(), key=lambda each: len({*each[1].places}))
    ends = [USUAL, ABOVE, *values]
    for value, (axis, way) in product(ends, ways):
        low, high = min(way.places), max(way.places)
        per_unit = round(value / (high - low), 4)
        yield {"axis": axis, "above": low, "value": 0.0, "per_unit": per_unit}


def _values(explorer: Explorer, channel: Channel, best: Tried) -> list[Any]:
    """Return the values of a key, a number or a level at which comparisons turn, and usual ones."""
    tried = (each for node in explorer.nodes.values() for causes in node.tried for each in causes)
    solved = dict.fromkeys(each.value for each in tried if each.channel == channel and not is_probe(each))
    if channel[0] == "key":
        return list(solved)
    if channel[0] == "analogue":
        usual = _with(best.settings, channel, {"value": USUAL, **ON})
        # Without a level the peak of what is read would be no reading.
        compared = levels(explorer.trials.play_in(usual, LENGTH))
        read = (each.value for each in compared if each.channel == channel)
        return sorted({*map(float, (*solved, *read, *explorer.levels[channel])), USUAL})
    is_real = channel[0] != "netdata" or any(isinstance(each, float) for each in solved)
    return list(dict.fromkeys((float if is_real else int)(each) for each in (LOT, *solved, *NUMBERS)))


class Way(NamedTuple):
    """The places, in user units, where moves of an axis began and ended, and the different lengths of the moves."""

    places: Sequence[float]
    lengths: Sequence[float]


def _ways(run: Run) -> dict[int, Way]:
    """Return the way of each axis that moved."""
    places: dict[int, list[float]] = defaultdict(list)
    lengths: dict[int, dict[float, None]] = defaultdict(dict)
    for move in run.machine.log.moves:
        if move.profile is not None and not is_short_move(move):
            axis = run.controller.axes[move.axis]
            end = min(move.start_time + move.profile.duration, max(run.time, move.start_time + PUSH))
            begin, end = place(axis, move.start_time), place(axis, end)
            places[move.axis] += [begin, end]
            lengths[move.axis][round(abs(end - begin), 2)] = None
    return {axis: Way(each, list(lengths[axis])) for axis, each in places.items() if max(each) > min(each)}
