"""Two programs compared in all ways that an exploration of either has found.

Problem. One run shows one way. A time-out, a reject or another key of a menu is in none.

Idea. Both programs are explored. A way is a timeline of changes that leads to a transition of either, a variant of it,
what was tried and led nowhere, or a cycle some times, until what the program counts to is full. Each way is played in
both, and what they do is compared (`acts.py`).

If B does something later, a change that A has answered would come too early. So where anything differs, the way is
played in B again with each change as long after B rests as it came after A rested. If no act differs then, the two
differ in time alone. A way that touches no change in the one that is played first is the same in the other by its text,
and is not played there.

A way that could tell of a change must have been played. Where a changed statement has not been carried out
(`changed.py`), or nothing that was played depends on it, the programs are played in more worlds: with long and short
times between the changes, in the world of the likeliest cycle with another rule for a channel, with encoders that turn.

Cost. Both explorations, at most `SECONDS` of an ordinary core each, and `PLAYED`, the work of both programs for the
ways. Ways beyond are named, and not compared.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby, islice, pairwise
from math import ceil, inf, isclose
from operator import itemgetter

from motionlang.comparison.acts import (
    WORLD,
    ActDifference,
    ComparedAct,
    ComparedActs,
    Later,
    PlayedWay,
    acts_of,
    compared,
    places_of,
    status_of,
)
from motionlang.kernel import Run, Source
from motionlang.kernel.lang import Structure
from motionlang.kernel.tools import total
from motionlang_explore.diff.changed import ChangedProgram, changed_programs, note_played, note_untouched
from motionlang_explore.exploration import (
    HORIZON,
    LENGTH,
    SECOND,
    SECONDS,
    Change,
    Exploration,
    MachineCycle,
    PlayedTimeline,
    Progress,
    Timeline,
    Trial,
    Visit,
    entries,
    explored,
    keys_of,
    number_in,
    tables_of,
)

# The work of both programs in the ways, as much as that of their explorations.
PLAYED = 2.0 * SECONDS * SECOND
# A cycle is played so often at first, and at most, and so many cycles of each program are.
TIMES, MAX_TIMES, CYCLES = 3, 40, 8
# What is counted further is played so often.
FULL = 200
# A way in which one program lacks an act is played for so long after its last change, s.
PATIENCE = 108.0
# So many ways of few changes are played with long times between the changes, s, and with short ones, and so many worlds
# of each program.
PACED, SLOW, FAST, WORLDS = 20, 200.0, 0.05, 60
# So many ways are played, whatever the explorations have cost.
LEAST = 3
# Times of a cycle that differ by less are the same, s.
TICK = 1e-3
# They take at most this share of the work.
FURTHER = 0.3
# A way with long times is played for so long after its last change, s.
LONG = 324.0
# No further cycle of a program is made a way after so much work.
CYCLE_WORK = SECOND


@dataclass
class Way:
    """A timeline of changes; `cycle` is the one that it repeats, and `of` has the programs that have it, "A" or "B".

    `pace` is the time between its changes if that was chosen, s. A way may have a `world` instead: the entries of a
    machine file, and what they are in words.
    """

    timeline: Timeline
    of: str
    cycle: MachineCycle | None = None
    pace: float = 0.0
    world: Mapping[str, object] | None = None
    words: str = ""

    @property
    def tables(self) -> Mapping[str, object]:
        """The tables of a machine file with its changes."""
        return tables_of(self.timeline) if self.world is None else self.world


@dataclass
class FoundDifference:
    """A difference, with the shortest way that shows it; `times` is the number of ways that do."""

    way: Way
    # The changes as they come in A and in B.
    timelines: tuple[Timeline, Timeline]
    difference: ActDifference
    a: PlayedWay
    b: PlayedWay
    times: int = 1


@dataclass
class FoundLater:
    """An act that comes later in B, or takes longer, with the shortest way that shows it."""

    way: Way
    later: Later
    times: int = 1


@dataclass
class CycleTime:
    """How long a cycle takes in both programs, for one piece, s."""

    way: Way
    a: float
    b: float


@dataclass
class WaysCompared:
    """The result: how many ways were played, and what differs in them.

    `differences` are those that are the first one of some way; `behind` are those that only follow another one in each
    way that shows them, and may be a consequence of it.

    `untouched`, `equal`, `differ`, `timed` and `only` count the ways: those that are the same by their text, since they
    touch no change, those in which B does the same, something else, or only the same at another time, and those that
    exist in one program alone, "A" or "B". `unreached` are the lines of each program that no way has reached,
    `partial` those of which only a part was.
    `left` are the ways that were not compared. Of the changed statements, `uncompared` are the lines that no way has
    carried out, `one_sided` the conditions that have not come out both ways, with the outcome that is missing, and
    `hidden` those on which nothing depends that was played.
    """

    a: Exploration
    b: Exploration
    untouched: int = 0
    equal: int = 0
    differ: int = 0
    timed: int = 0
    only: dict[str, int] = field(default_factory=lambda: {"A": 0, "B": 0})
    differences: list[FoundDifference] = field(default_factory=list)
    behind: list[FoundDifference] = field(default_factory=list)
    later: list[FoundLater] = field(default_factory=list)
    cycles: list[CycleTime] = field(default_factory=list)
    unreached: dict[str, list[int]] = field(default_factory=dict)
    partial: dict[str, list[int]] = field(default_factory=dict)
    uncompared: dict[str, list[int]] = field(default_factory=dict)
    one_sided: dict[str, dict[int, bool]] = field(default_factory=dict)
    hidden: dict[str, list[int]] = field(default_factory=dict)
    left: list[Way] = field(default_factory=list)

    @property
    def count(self) -> int:
        """The number of the ways that were compared."""
        return self.untouched + self.equal + self.differ + self.timed + self.only["A"] + self.only["B"]

    @property
    def same(self) -> bool:
        """True if nothing differs, and what was played could have told.

        Each changed statement was carried out in a way that was compared, each changed condition came out both true
        and false there, and each changed value was equal whenever it was worked out.
        """
        named = (self.uncompared, self.one_sided, self.hidden)
        return not (self.left or self.differences or self.later or any(any(each.values()) for each in named))


class Player:
    """An explored program, its ways, and what it does in one.

    `text` has its statements, and `names` those of its tasks, in a comparison with another one.
    """

    text: ChangedProgram
    names: Mapping[str, str]

    def __init__(self, exploration: Exploration) -> None:
        self.exploration = exploration
        self._owners = exploration.program.structure.owners(with_handlers=True)
        exploration.observe()

    def ways(self, full: dict[object, Timeline]) -> Iterator[tuple[Timeline, MachineCycle | None]]:
        """Yield the timelines of what leads on, or was tried, from each state, and those of the cycles.

        `full` are those of cycles that touch no change until they are full, so that both programs share them.
        """
        yield (), None
        for node in self.exploration.nodes:
            for each in node.transitions:
                for causes in (each.causes, *each.variants):
                    yield (each.visit.changed(causes) if causes else each.visit.timeline), None
            # What leads nowhere, back to where it was taken, or to work without a rest.
            for causes in node.tried:
                yield node.first.changed(causes), None
        begun = self.exploration.work
        for cycle in [each for each in self.exploration.cycles if each.work][:CYCLES]:
            yield self._until_full(cycle, full), cycle
            if self.exploration.work - begun > CYCLE_WORK:
                break
        for cycle in self._detours():
            if self.exploration.work - begun > CYCLE_WORK:
                break
            yield self._until_full(cycle, full), cycle

    def _until_full(self, cycle: MachineCycle, full: dict[object, Timeline]) -> Timeline:
        changes = tuple(each.causes for each in cycle.transitions)
        key = cycle.visit.timeline, cycle.visit.change_time, changes
        if key in full:
            return full[key]
        trial = until_full(self.exploration, cycle)
        if self.text.is_untouched(trial):
            full[key] = trial.timeline
        return trial.timeline

    def _detours(self) -> Iterator[MachineCycle]:
        """Yield the likeliest cycle behind each transition that returns to it, such as a reject or an alarm."""
        cycle = next((each for each in self.exploration.cycles if each.work and each.repeats), None)
        if cycle is None or not cycle.transitions:
            return
        inside = {(each.source, each.causes) for each in cycle.transitions}
        for node in self.exploration.nodes:
            for each in node.transitions:
                is_on_cycle = each.target in cycle.states and (each.source, each.causes) not in inside
                if is_on_cycle and each.causes and each.source is not None:
                    timeline = each.visit.changed(each.causes)
                    visit = Visit(timeline, each.visit.change_time + each.seconds)
                    yield replace(cycle, visit=visit)

    def play(self, timeline: Timeline, since: float = 0.0, patience: float = HORIZON) -> PlayedWay:
        """Return what it does in a way, followed for `patience`, s; the rests are those from a time on."""
        played = self.exploration.play(timeline, since, patience)
        return played_way(played, self.exploration.line, self._owner)

    def play_in(self, world: Mapping[str, object]) -> PlayedWay:
        """Return what it does in a world."""
        return played_way(self.exploration.play_in(world, LENGTH), self.exploration.line, self._owner)

    def worlds(self) -> Iterator[tuple[str, Mapping[str, object]]]:
        """Yield worlds with their words: that of the likeliest cycle, and with other rules for a channel in it."""
        own = self.exploration.world.settings
        yield "in the world of init", own
        turning = self.exploration.turning()
        if turning:
            yield "with encoders that turn", {**own, **turning}
        for (table, number), world in islice(self.exploration.neighbours(), WORLDS):
            own_entries = (each for each in entries(world, table) if number_in(table, each) == number)
            pairs = [
                pair for each in own_entries for pair in each.items() if pair[0] not in keys_of(table, number)
            ]
            rule = ", ".join(f"{key} {value}" for key, value in pairs) or "as it is"
            yield f"with {Change(table, number, 0.0).subject} {rule}", world

    def _owner(self, line: int) -> str:
        title = self._owners.get(line, WORLD)
        return self.names.get(title, title)


def played_way(played: PlayedTimeline, line: Callable[[int], int], owner: Callable[[int], str]) -> PlayedWay:
    """Return what a program did in a played timeline; `line` is that of a source offset, `owner` the task of a line."""
    run, trial = played.run, played.trial
    acts: dict[str, list[ComparedAct]] = defaultdict(list)
    for each in sorted(acts_of(run, line), key=lambda act: act.begin):
        acts[owner(each.line)].append(each)
    status = "waits" if not trial.has_ended else status_of(run, trial.status)
    places = places_of(run)
    until = inf if trial.is_stuck or trial.has_ended else run.time
    stays = [(each.begin, each.end) for each in played.rests]
    changed = max(
        (each.levels(at)[-1][0] if each.moment.every else at for at, each in trial.timeline), default=0.0
    )
    order: dict[str, dict[int, float]] = defaultdict(dict)
    for task, begun in trial.statements.items():
        for one in begun:
            order[task].setdefault(one.at, one.time)
    changes = [at for at, _ in trial.timeline]
    return PlayedWay(
        dict(acts),
        status,
        run.time,
        until,
        places,
        stays,
        changed,
        trial.begun,
        trial.outcomes,
        order,
        changes,
    )


def ways_of(a: Source, b: Source) -> WaysCompared:
    """Explore two programs with the settings of the machine files next to them, and compare them in all ways.

    Raises ProgramError for a program or a machine file with errors.
    """
    first = explored(a)
    return compared_ways(Player(first), Player(explored(b, first.switches.settings)))


def compared_ways(
    first: Player,
    second: Player,
    work: float = PLAYED,
    *,
    is_enough: Callable[[WaysCompared], bool] = lambda found: False,
    progress: Progress = lambda share, playing: None,
) -> WaysCompared:
    """Compare two explored programs in all ways that either exploration has found, by so much work.

    It ends earlier where `is_enough` is true of what was found so far.
    """
    a, b = first.exploration, second.exploration
    for one, other in ((a, b), (b, a)):
        missing = {key: value for key, value in other.switches.settings.items() if key not in one.settings}
        if missing:
            one.give(missing)
    first.names, second.names = _task_names(a.program.structure, b.program.structure)
    first.text, second.text = changed_programs(a.program, b.program)
    if a.settings != b.settings:
        first.text.is_alike = second.text.is_alike = False
    begun = a.work + b.work
    found = WaysCompared(a, b)
    for one in (a, b):
        one.show(lambda words: progress(min((a.work + b.work - begun) / work, 1.0), words))
    ways = all_ways(first, second)
    comparison = _Comparison(found, first, second)
    for k, way in enumerate(ways):
        if (a.work + b.work - begun >= work and k >= LEAST) or is_enough(found):
            found.left = ways[k:]
            break
        comparison.take(way)
    most = min(a.work + b.work + FURTHER * work, begun + work)
    for way in _further(first, second, ways):
        if found.left or comparison.is_settled or a.work + b.work >= most or is_enough(found):
            break
        ways.append(way)
        comparison.take(way)
    known = {each.difference.key for each in found.differences}
    found.behind = [each for each in found.behind if each.difference.key not in known]
    order = {id(way): k for k, way in enumerate(sorted(ways, key=_length))}
    for some in (found.differences, found.behind):
        some.sort(key=lambda each: order[id(each.way)])
    found.later.sort(key=lambda each: order[id(each.way)])
    comparison.conclude()
    return found


def _further(a: Player, b: Player, ways: list[Way]) -> Iterator[Way]:
    """Yield ways of few changes at another pace, and worlds, which are played where a change has not shown."""
    short = sorted((each for each in ways if each.cycle is None), key=_length)[:PACED]
    for pace in (SLOW, FAST):
        for way in short:
            yield Way(_paced(way.timeline, pace), way.of, pace=pace)
    for player in (a, b):
        for words, world in player.worlds():
            yield Way((), "AB", world=world, words=words)


def _paced(timeline: Timeline, pace: float) -> Timeline:
    """Return a timeline with so long between the changes, s."""
    made: Timeline = ()
    for k, (_, group) in enumerate(groupby(timeline, key=itemgetter(0))):
        made += tuple((round((k + 1) * pace, 6), change) for _, change in group)
    return made


def _length(way: Way) -> tuple[bool, float, float]:
    changes = total(each.moment.times for _, each in way.timeline)
    return way.world is not None, changes, way.timeline[-1][0] if way.timeline else 0.0


def _task_names(a: Structure, b: Structure) -> tuple[dict[str, str], dict[str, str]]:
    """Return a name for each task of two programs: its own if both have the same ones, and its number if not."""
    titles = [[each.title for each in one.tasks()] for one in (a, b)]
    own = [{title.lower() for title in some[1:]} for some in titles]
    first, second = (
        {
            title: "program" if k == 0 else title.lower() if own[0] == own[1] else f"task {k}"
            for k, title in enumerate(some)
        }
        for some in titles
    )
    return first, second


# --------------------------------------------------------------------------------------------------------- ways


def all_ways(a: Player, b: Player) -> list[Way]:
    """Return the ways of two programs: the likeliest cycle first, then those with few changes, then other cycles.

    Ways with the same changes before the last ones follow each other, since they go on from one start.
    """
    found: dict[Timeline, Way] = {}
    full: dict[object, Timeline] = {}
    for name, player in (("A", a), ("B", b)):
        for timeline, cycle in player.ways(full):
            timeline = tuple(sorted(timeline, key=itemgetter(0)))
            way = found.setdefault(timeline, Way(timeline, name, cycle))
            way.cycle = way.cycle or cycle
            way.of = way.of if name in way.of else way.of + name
    short = [way for way in found.values() if way.cycle is None]
    short.sort(key=lambda way: (len(way.timeline), str(way.timeline[:-1]), _length(way)))
    cycles = [way for way in found.values() if way.cycle is not None]
    return [*cycles[:1], *short, *cycles[1:]]


def until_full(one: Exploration, cycle: MachineCycle) -> Trial:
    """Return the trial of a cycle that is played some times, and until what the program counts to is full."""
    trial = one.turns(cycle, TIMES)
    times = max(MAX_TIMES if _goes_on(one.last, cycle) else TIMES, _times_to_full(trial))
    if times > TIMES:
        trial = one.turns(cycle, times)
    return trial


def _goes_on(run: Run, cycle: MachineCycle) -> bool:
    """True if an axis ends each turn of a cycle further on, so that it approaches something."""
    ends: dict[tuple[int, int], list[float]] = defaultdict(list)
    for each in run.machine.log.moves:
        if each.line in cycle.work and each.profile is not None and each.profile.duration < inf:
            ends[each.axis, each.line].append(each.profile.end)
    last = [each[-TIMES:] for each in ends.values() if len(each) >= TIMES]
    return any(b - a and isclose(b - a, c - b) for a, b, c in last)


def _times_to_full(trial: Trial) -> int:
    """Return how often a cycle of a trial must run until each number is reached that its comparisons count to."""
    most = TIMES
    for sides in trial.comparisons.values():
        left = [b - a for a, b in sides if isinstance(a, (int, float)) and isinstance(b, (int, float))]
        distances = [each for each, _ in groupby(left)]
        if len(distances) < 3 or len({round(y - x, 6) for x, y in pairwise(distances)}) > 1:
            continue
        step = distances[1] - distances[0]
        if distances[-1] * step >= 0.0:
            continue  # it is reached, or goes away from it
        turns = TIMES + ceil(abs(distances[-1] / step) * TIMES / (len(distances) - 1)) + 1
        work = sum(map(len, trial.statements.values())) * turns / TIMES
        if turns <= (FULL if work < CYCLE_WORK else MAX_TIMES):
            most = max(most, turns)
    return most


# --------------------------------------------------------------------------------------------------- comparison


class _Comparison:
    """The comparison of one way after the other."""

    def __init__(self, found: WaysCompared, a: Player, b: Player) -> None:
        self.found, self.a, self.b = found, a, b
        self._first: dict[object, FoundDifference] = {}
        self._behind: dict[object, FoundDifference] = {}
        self._later: dict[object, FoundLater] = {}
        self._texts = a.text, b.text
        self._cycles: set[frozenset[int]] = set()

    def take(self, way: Way) -> None:
        """Play a way in both programs, unless it is the same by its text, and take note of what differs."""
        last = way.timeline[-1][0] if way.timeline and not way.pace else 0.0
        side = 0 if "A" in way.of else 1
        first = self._played(way, last, side)
        if self._texts[side].is_untouched(first):
            self.found.untouched += 1
            note_untouched(self._texts, side, first)
            return
        second = self._played(way, last, 1 - side)
        a, b = (second, first) if side else (first, second)
        if way.world is not None:
            self._note(way, ((), ()), a, b, compared(a, b))
            return
        timelines, result = (way.timeline, way.timeline), compared(a, b)
        if last > 0.0 and (result.differences or result.later):
            timelines, a, b = self._followed(way) or (timelines, a, b)
            result = compared(a, b)
        usual = self._first.keys() | self._behind.keys()
        lacking = {each.key for each in result.differences if each.end is None and not (each.a and each.b)}
        if lacking - usual:
            # What one side lacks may only come later there.
            timelines, a, b = self._followed(way, PATIENCE) or (timelines, a, b)
            result = compared(a, b)
        self._note(way, timelines, a, b, result)

    def _played(self, way: Way, last: float, side: int) -> PlayedWay:
        player = (self.a, self.b)[side]
        if way.world is not None:
            return player.play_in(way.world)
        return player.play(way.timeline, last, LONG if way.pace == SLOW else HORIZON)

    def _note(
        self, way: Way, timelines: tuple[Timeline, Timeline], a: PlayedWay, b: PlayedWay, result: ComparedActs
    ) -> None:
        found = self.found
        note_played(self._texts, (a, b), result)
        alone = self._alone(way, timelines, a, b)
        if result.differences and alone:
            found.only[alone] += 1
        elif result.differences:
            found.differ += 1
        elif result.later:
            found.timed += 1
        else:
            found.equal += 1
        # What repeats in a way is one difference.
        shown: dict[object, ActDifference] = {}
        for each in result.differences:
            shown.setdefault(each.key, each)
        for k, each in enumerate(shown.values()):
            known, listed = (self._behind, found.behind) if k else (self._first, found.differences)
            one = known.get(each.key)
            if one is None:
                one = known[each.key] = FoundDifference(way, timelines, each, a, b, 0)
                listed.append(one)
            one.times += 1
            if _length(way) < _length(one.way):
                one.way, one.timelines, one.difference, one.a, one.b = way, timelines, each, a, b
        laters: dict[object, Later] = {}
        for later in () if result.differences else result.later:
            laters.setdefault((later.act.line, later.act.subject, later.lasts), later)
        for key, later in laters.items():
            slow = self._later.get(key)
            if slow is None:
                slow = self._later[key] = FoundLater(way, later)
                found.later.append(slow)
                continue
            slow.times += 1
            if _length(way) < _length(slow.way):
                slow.way, slow.later = way, later
        if way.cycle is not None and not result.differences and way.cycle.work not in self._cycles:
            self._cycles.add(way.cycle.work)
            found.cycles += _cycle_time(way, a, b, result)

    @property
    def is_settled(self) -> bool:
        """True if nothing is left to play: each change was carried out in all outcomes, and has shown."""
        return not any(each.uncompared or each.one_sided or each.hidden for each in self._texts)

    def conclude(self) -> None:
        """Name the lines that no way has reached, and those whose changes have not shown."""
        found, sides = self.found, zip("AB", self._texts, (self.a, self.b), strict=True)
        for side, text, player in sides:
            lines = player.exploration.without(text.begun)
            begun = set(text.lines(text.begun & text.forms.keys()))
            found.unreached[side] = [line for line in lines if line not in begun]
            found.partial[side] = [line for line in lines if line in begun]
            found.uncompared[side] = text.lines(text.uncompared)
            found.one_sided[side] = text.one_sided
            found.hidden[side] = text.hidden

    def _alone(self, way: Way, timelines: tuple[Timeline, Timeline], a: PlayedWay, b: PlayedWay) -> str:
        """Return "A" or "B" if only that program goes on after the last change of a way; "" if both do."""
        goes_on = [
            one.status != "waits" or any(each.begin >= timeline[-1][0] for each in one.ordered if timeline)
            for one, timeline in zip((a, b), timelines, strict=True)
        ]
        if way.of in ("A", "B") and goes_on == [way.of == "A", way.of == "B"]:
            return way.of
        return ""

    def _followed(
        self, way: Way, patience: float = HORIZON
    ) -> tuple[tuple[Timeline, Timeline], PlayedWay, PlayedWay] | None:
        """Play a way in both, each change as long after the rests of one as it came after those of the other.

        The changes come as they were found; in the program that has not found them, they follow. None if it has done
        something else before a change.
        """
        leader, follower = (self.a, self.b) if "A" in way.of else (self.b, self.a)
        lead = leader.play(way.timeline, 0.0, patience)
        parts = leader.text.parts_at(lead)
        made: Timeline = ()
        before, since, late = 0.0, 0.0, 0.0
        for time, group in groupby(way.timeline, key=itemgetter(0)):
            if time > parts:
                part = follower.play(made, since, patience)
                moved = _moment(time, before, lead, part, late)
                if moved is None:
                    return None
                late = moved - time
            before, since = time, max(time + late, since)
            made = (*made, *((round(since, 6), change) for _, change in group))
        follow = follower.play(made, 0.0, patience)
        if leader is self.a:
            return (way.timeline, made), lead, follow
        return (made, way.timeline), follow, lead


def _moment(time: float, since: float, lead: PlayedWay, follow: PlayedWay, late: float) -> float | None:
    """Return when a change comes in a way that follows another one, in which it came at a time.

    It comes in the middle of the same move, or when all tasks have come as far. The rests from a time on, that of the
    change before, are those of the way that follows. None if that has done something else before.
    """
    pairs: list[tuple[ComparedAct, ComparedAct]] = []
    for task, acts in lead.acts.items():
        mine = [each for each in acts if each.begin < time]
        others = follow.acts.get(task, ())
        if mine and len(others) >= len(mine) and others[len(mine) - 1].subject == mine[-1].subject:
            pairs.append((mine[-1], others[len(mine) - 1]))
        elif mine:
            return None
    moving = [(one, other) for one, other in pairs if one.end > time or one.is_cut]
    if moving:
        one, other = max(moving, key=lambda pair: pair[0].begin)
        return time + other.begin - one.begin
    return max((_behind(time, since, lead, follow, pair) for pair in pairs), default=time + late)


def _behind(
    time: float, since: float, lead: PlayedWay, follow: PlayedWay, pair: tuple[ComparedAct, ComparedAct]
) -> float:
    """Return when a change comes that came at a time: as long after the rest behind an act as in the lead."""
    one, other = pair
    stays = [stay for stay in lead.stays if max(one.end, since) - 1e-3 <= stay[0] <= time]
    others_stays = [stay for stay in follow.stays if stay[0] >= other.end - 1e-3 or stay[1] == inf]
    if not stays or not others_stays:
        return time + other.end - one.end
    stay = others_stays[min(len(stays), len(others_stays)) - 1]
    return max(stay[0], other.end) + time - max(stays[-1][0], one.end)


def _cycle_time(way: Way, a: PlayedWay, b: PlayedWay, result: ComparedActs) -> Iterator[CycleTime]:
    """Yield how long one turn of a cycle takes, if that differs by more than when the changes of the world came."""
    assert way.cycle is not None
    work = [pair for pair in result.pairs if pair[0].line in way.cycle.work]
    if not _is_slower(work, [*zip(a.changes, b.changes, strict=False)]):
        return
    turns: dict[tuple[int, str], list[tuple[float, float]]] = defaultdict(list)
    for one, other in work:
        if one.subject.startswith("axis"):
            turns[one.line, one.subject].append((one.begin, other.begin))
    often = max(turns.values(), key=len, default=[])
    if len(often) > 1:
        periods = sorted((x - w, y - v) for (w, v), (x, y) in pairwise(often))
        old, new = periods[len(periods) // 2]
        if abs(new - old) > TICK:
            yield CycleTime(way, old, new)


def _is_slower(
    pairs: Sequence[tuple[ComparedAct, ComparedAct]], changes: Sequence[tuple[float, float]]
) -> bool:
    """True if an act takes another time, or comes at another time behind the act and the change before it."""
    k, before = 0, (0.0, 0.0)
    for one, other in pairs:
        k = 0 if one.begin < before[0] else k  # the next task begins
        while k < len(changes) and changes[k][0] <= one.begin:
            k += 1
        gaps = [(other.begin - y) - (one.begin - x) for x, y in (before, *changes[max(k - 1, 0) : k])]
        if min(map(abs, gaps)) > TICK or abs((other.end - other.begin) - (one.end - one.begin)) > TICK:
            return True
        before = one.begin, other.begin
    return False
