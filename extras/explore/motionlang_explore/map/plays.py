"""The good cycle with one thing in its world otherwise: it is played.

Each input of the world goes on or off for good in the middle of a cycle, or is so from the start; each level and number
of a host takes the values on both sides of those at which comparisons turn; each key that the program reads is pressed.
Nobody resets anything, nor pushes a button any more, if the machine works as well without.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Collection, Iterator, Mapping, Sequence, Set
from functools import reduce
from itertools import pairwise
from math import inf
from typing import NamedTuple

from motionlang.kernel import Run
from motionlang.kernel.log import LoggedMove, Switched
from motionlang_explore.exploration import (
    LENGTH,
    SECOND,
    TABLES,
    Change,
    Channel,
    Entry,
    Exploration,
    entries,
    is_pushed,
    is_reset,
    keys_of,
    levels,
    made_by,
    number_in,
)
from motionlang_explore.map.names import ReaderNames

# The machine is watched for so many cycles and s behind a change, where it moves no more so much longer, s; after so
# much work no more is played.
CYCLES, WATCHED, LONGER, WORK = 3, 12.0, 48.0, 4 * SECOND
# What is played once more a cycle later has so much more.
LATER = SECOND
# What is left on has no other keys than these.
LEFT = {"channel", "element", "server", "register", "at", "value"}
KEYED = {"text"}
# What has values: levels, numbers of a host and keys. An answer is given when it is asked for.
VALUES = tuple(table for table in TABLES if table not in ("input", "answer"))

Settings = Mapping[str, object]


class Play(NamedTuple):
    """A change in the world of the cycle, the settings with it, and when it is made, s, 0.0 from the start.

    Its channel `is_left` if nothing else changes it.
    """

    change: Change
    settings: Settings
    since: float
    is_left: bool


class Watched(NamedTuple):
    """A run, and the tasks in which each line has been carried out, "" for a handler."""

    run: Run
    tasks: Mapping[int, Set[str]]


class Plays:
    """The plays of the good cycle of an exploration, each with one change.

    A change is made at `since`, s, in the middle of the first `move` of a cycle, or at its begin if that has none; the
    cycle is over at `end`.
    `settings` are those of the world, without what resets if it works so: `nobody_resets` anything then. `left` are the
    changes that were not played.
    """

    def __init__(self, exploration: Exploration, names: ReaderNames) -> None:
        self._exploration = exploration
        self.left = list[Change]()
        world = self._world = exploration.world.run
        self.period, cycles = (LENGTH, 1) if world.cycle is None else (world.cycle.period, CYCLES)
        self.move, self.since = _middle(exploration)
        times = () if world.cycle is None else world.cycle.times
        self.end = next((each for each in times if each > self.since), inf)
        self._watched = cycles * self.period + WATCHED
        self._most = exploration.work + WORK
        self.settings, self.nobody_resets = self._without_resets(names)
        self._released = self._without_hands(names)

    def usual(self) -> Watched:
        """Return the run without any change, for at least as long as the plays are watched."""
        until = self.since + self.period + self._watched
        return Watched(*self._exploration.watch(self.settings, max(until, self._world.time)))

    def all(self) -> Iterator[tuple[Play, Watched]]:
        """Yield each play with its run: the changes in the middle of a cycle, then those from the start."""
        was_played = dict[Change, bool]()
        for play in self._plays(self.since):
            goes_on = self._exploration.work <= self._most
            was_played[play.change] = was_played.get(play.change, False) or goes_on
            if goes_on:
                yield play, self._run(play.settings, self.since)
        self.left = [change for change, is_known in was_played.items() if not is_known]

    def later(self, changes: Collection[Change]) -> Iterator[tuple[Play, Run]]:
        """Yield the plays with some changes one cycle later, with their runs."""
        since = self.since + self.period
        for play in self._plays(since) if self._world.cycle is not None else ():
            if play.since and play.change in changes and self._exploration.work <= self._most + LATER:
                yield play, self._run(play.settings, since).run

    def _run(self, settings: Settings, since: float) -> Watched:
        """Run the machine with a change; where it begins no move any more it is watched longer."""
        until = since + self._watched

        def goes_on(run: Run) -> bool:
            return any(each.start_time > until - WATCHED for each in run.machine.log.moves)

        return Watched(*self._exploration.watch(settings, until, until + LONGER, stands=goes_on))

    def _without_resets(self, names: ReaderNames) -> tuple[Settings, bool]:
        """Return the settings of the world without the inputs that reset if it works as well, and if it does."""
        settings, exploration = self._exploration.world.settings, self._exploration
        inputs = entries(settings, "input")
        left = [each for each in inputs if not is_reset(names[f"input {number_in('input', each)}"])]
        without = {**settings, "input": left}
        works = len(left) == len(inputs) or not exploration.fault_of(
            exploration.run(without, self._world.time)
        )
        return (without if works else settings), works

    def _without_hands(self, names: ReaderNames) -> Settings:
        """Return the settings in which nobody pushes a button behind a change any more, if the machine goes on so."""
        given = dict.fromkeys(number_in("input", each) for each in entries(self.settings, "input"))
        pushed = [number for number in given if is_pushed(names[f"input {number}"])]
        if not pushed:
            return self.settings
        offs = [Change("input", number, 0.0) for number in pushed]
        released = reduce(lambda made, off: self._changed(made, off, self.since), offs, self.settings)
        return released if self._goes_on(released, self.since) else self.settings

    def _goes_on(self, settings: Settings, since: float) -> bool:
        """True if the machine begins its usual moves behind a time, s, in this cycle and the next one."""
        until = self.end + since - self.since + self.period
        usual, begun = (
            sum(since < each.start_time < until for each in run.machine.log.moves)
            for run in (self._world, self._run(settings, since).run)
        )
        return begun >= usual

    def _plays(self, since: float) -> Iterator[Play]:
        """Yield the plays with the changes at a time, then with those from the start."""
        always, released, until = list[Play](), self._released, dict[Channel, list[Entry] | None]()
        for change in self._inputs():
            own = _own(self.settings, change)
            is_left = not own or (len(own) == 1 and own[0].keys() <= LEFT)
            yield Play(change, self._changed(released, change, since), since, is_left)
            if is_left or not change.value:
                always.append(self._always(change, is_left))
        for change in self._values():
            own, is_key = _own(self.settings, change), change.table == "key"
            is_left = is_key or (len(own) < 2 and all(each.keys() <= LEFT for each in own))
            if not is_left and change.channel not in until:
                until[change.channel] = self._until(change, own, since)
            past = None if is_left else until[change.channel]
            own, is_left = (own, is_left) if past is None else (past, True)
            made = {"text" if is_key else "value": change.value, "at": since}
            yield Play(change, _given(released, change, [*own, made]), since, is_left)
            if not is_key and change.value not in {each.get("value") for each in own}:
                always.append(self._always(change, is_left))
        yield from always

    def _always(self, change: Change, is_left: bool) -> Play:
        return Play(change, _given(self.settings, change, [{"at": 0.0, "value": change.value}]), 0.0, is_left)

    def _inputs(self) -> Iterator[Change]:
        """Yield the levels of each input that it does not have all the time."""
        for number in self._exploration.inputs:
            own = _own(self.settings, Change("input", number, 0.0))
            is_left = len(own) == 1 and own[0].keys() <= LEFT
            others = [0.0 if own[0].get("value", 1) else 1.0] if is_left else [0.0, 1.0] if own else [1.0]
            yield from (Change("input", number, level) for level in others)

    def _values(self) -> list[Change]:
        """Return the values at which the comparisons of the program turn, on both sides, and the keys of no world."""
        exploration, world = self._exploration, self._exploration.world
        ways = (each for node in exploration.nodes for each in node.transitions)
        tried = dict[tuple[Channel, frozenset[int]], Change]()
        for way, one in ((each, one) for each in ways for one in each.causes):
            if one.table in VALUES and not one.moment.line:
                # Values with which the same statements begin are one.
                tried.setdefault((one.channel, way.begun), Change(one.table, one.number, one.value))
        compared = levels(exploration.play_in(world.settings, world.run.time).trial, VALUES)
        known = {each.get("text") for each in entries(world.settings, "key")}
        return list(dict.fromkeys(one for one in (*tried.values(), *compared) if one.value not in known))

    def _until(self, change: Change, own: Sequence[Entry], since: float) -> list[Entry] | None:
        """Return the entries of a number of a host until a time, s; None if the machine needs those behind it.

        `own` are those of its channel.
        """
        given = given_in(self._world, change.table, own)
        past = [each for time, each in given if time < since]
        needs_none = len(past) == len(given) or self._goes_on(_given(self._released, change, past), since)
        return past if given and needs_none else None

    def _changed(self, settings: Settings, change: Change, since: float) -> Settings:
        """Return settings in which an input is as in the world until a time, s, and then as a change says.

        What answers does so from then on: without one of two hands the other one would have come at another time.
        """
        was, later = inputs_until(self._world, since), inputs_until(self._world, inf)
        for each in (each for each in entries(settings, "input") if "asked" in each):
            number = number_in("input", each)
            own = [one for one in was if one["channel"] == number]
            # A button that is held is let go as in the world.
            held = [one for one in later if one["channel"] == number][len(own) :][
                : bool(own and "for" in each)
            ]
            held = held if own and own[-1]["value"] else []
            rule = {**each, "at": held[0]["at"] if held else since}
            settings = _given(settings, change._replace(number=number), [*own, *held, rule])
        own = [one for one in was if one["channel"] == change.number]
        return _given(settings, change, [*own, {"at": since, "value": change.value}])


def given_in(run: Run, table: str, own: Sequence[Entry]) -> list[tuple[float, Entry]]:
    """Return what entries of a host or a key have given in a run, and when, s; none for what comes by other rules."""
    asked = [each for each in run.machine.log.events if each.kind == "asked"]
    found = list[tuple[float, Entry]]()
    for each in own:
        time, made = made_by(table, each)
        if each.keys() <= {*LEFT, *KEYED}:
            found.append((time, each))
        elif each.keys() <= {*LEFT, *KEYED, "asked"}:
            kept = {key: one for key, one in each.items() if key != "asked"}
            found += [(one.time, {**kept, "at": one.time}) for one in asked if one.text == str(made)]
        else:
            return []
    return found


def inputs_until(run: Run, time: float) -> list[Entry]:
    """Return the entries of the inputs that have changed in a run before a time, s."""
    past = (each for each in run.machine.log.inputs if each.time < time)
    return [{"channel": each.channel, "at": each.time, "value": each.value} for each in past]


def acts(exploration: Exploration, run: Run) -> list[tuple[float, int]]:
    """Return the times and lines of the moves, outputs and prints of a run, in order, but for the ends of pulses."""
    log = run.machine.log
    found = [(each.start_time, each.line) for each in log.moves]
    found += [(each.time, exploration.line(each.at)) for each in switched(exploration, run)]
    found += [(each.time, exploration.line(each.at)) for each in log.prints if each.at >= 0]
    return sorted(found)


def switched(exploration: Exploration, run: Run) -> Iterator[Switched]:
    """Yield what the program has switched in a run, but for the ends of pulses."""
    statements = exploration.program.structure.statements
    pulses = {at for at, each in statements.items() if any(use.unit == "ms" for use in each.channels)}
    for each in run.machine.log.outputs:
        if each.at >= 0 and (each.value or each.at not in pulses):
            yield each


def _middle(exploration: Exploration) -> tuple[LoggedMove | None, float]:
    """Return the first move of the first whole cycle and its middle, or no move and the begin of the cycle."""
    run = exploration.world.run
    begin, end = 0.0, run.time
    if run.cycle is not None:
        begin, end = _whole(run.cycle.times, run.cycle.lines, acts(exploration, run))
    moves = (each for each in run.machine.log.moves if begin <= each.start_time < end)
    for each in moves:
        if each.profile is not None:
            return each, each.start_time + min(each.profile.duration, end - begin) / 2.0
    return None, begin


def _whole(
    times: Sequence[float], lines: Collection[int], done: Sequence[tuple[float, int]]
) -> tuple[float, float]:
    """Return begin and end of the first cycle with all usual lines, but for the first one; of the second if none has.

    A row of stations fills up before. `done` are the times and lines of all that the machine does.
    """
    spans = list(pairwise(times))
    later = spans[1:] or spans
    for begin, end in later:
        own = done[bisect_left(done, (begin,)) : bisect_left(done, (end,))]
        if {line for _, line in own}.issuperset(lines):
            return begin, end
    return later[0]


def _own(settings: Settings, change: Change) -> list[Entry]:
    """Return the entries of the channel of a change."""
    return [
        each for each in entries(settings, change.table) if number_in(change.table, each) == change.number
    ]


def _given(settings: Settings, change: Change, rules: Sequence[Mapping[str, object]]) -> Settings:
    """Return settings in which the channel of a change has other entries."""
    table = change.table
    others = [each for each in entries(settings, table) if number_in(table, each) != change.number]
    return {**settings, table: [*others, *({**keys_of(*change.channel), **each} for each in rules)]}
