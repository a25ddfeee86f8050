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
a host that come again follow an output, or come when asked.

A rule holds if each task does what it did in the played run, in the same order: moves, outputs, and prints but for
their figures; or if it moves so and says less of what is wrong. A move that is over at once is another one than a move
with a way. A task that moves no axis may come further or less far. No other handler runs but one of a timer.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import product
from math import fsum, inf
from typing import NamedTuple

from motionlang.comparison.texts import without_figures
from motionlang.kernel import Run
from motionlang.kernel.log import Printed, Switched
from motionlang_explore.exploration.along import along, answers, beyond
from motionlang_explore.exploration.changes import AT_REST, Change, entries, is_about, number_in, tables_of
from motionlang_explore.exploration.cycles import MachineCycle
from motionlang_explore.exploration.likely import ASKED, ON, SOON
from motionlang_explore.exploration.playing import COMPARED, TIMES, count, faults, played, quality
from motionlang_explore.exploration.recorder import HANDLERS
from motionlang_explore.exploration.search import Explorer
from motionlang_explore.exploration.states import DELAY, Visit
from motionlang_explore.exploration.trials import (
    Trial,
    is_short_move,
)
from motionlang_explore.exploration.words import wrong
from motionlang_explore.identification import Entry, Observation, channels, rules_of

# A cycle repeats if each of its lines does so often.
ENOUGH = 3
# Each input is described so often, since its rule may depend on those of the others.
PASSES = 2
# A world is tried for so long, s.
WHOLE = 300.0
# So many cycles are played until one repeats.
PLAYED = 6
# A number or a key is there for so long, s; a comparison includes what comes so soon after its end.
MOMENT = 0.02
# Rules for one world take at most so much of the work of an exploration.
DESCRIBED = 0.25
# A world is compared for this much longer than the played run.
LONGER = 1.5
# An input comes and goes in so long, s.
EVERY = 2.0
PULSES: Entry = {"at": EVERY / 2, "for": EVERY / 2, "every": EVERY}
# The tables of the numbers of a host and the keys, which may come again.
WRITES = ("comms", "netdata", "modbus.register", "key")


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

    Without a cycle it is the world in which the program comes furthest.
    """
    best: tuple[tuple[bool, bool, int], MachineCycle, Trial] | None = None
    wanted = True, True, min(times, ENOUGH)
    most = explorer.most()
    for cycle in likeliest[:PLAYED]:
        if explorer.trials.work > most:
            break
        trial = _best_played(explorer, cycle, times)
        found = quality(cycle, trial)
        known = best[1] if best is not None and best[0][0] else cycle
        # Another cycle may move nothing, or say more of what is wrong.
        is_worse = (bool(known.work) and not cycle.work) or wrong(cycle.said) > wrong(known.said)
        if best is None or (found > best[0] and cycle.repeats and not is_worse):
            best = found, cycle, trial
        if found >= wanted or (found[2] >= wanted[2] and faults(cycle, trial) * ENOUGH <= found[2]):
            break
    if best is None:
        furthest = nowhere(explorer)
        best = (False, True, 0), furthest, explorer.play(furthest.visit.timeline, 0.0)
    _, cycle, trial = best
    if cycle.repeats and explorer.axes and not count(cycle, trial):
        settings = tables_of(trial.timeline)
        return FoundWorld(cycle, settings, explorer.trials.run_in(settings, trial.time)[0], 0)
    trial = _with_more_on(explorer, cycle, trial)
    return _Description(explorer, count(cycle, trial), cycle, trial).world()


def _best_played(explorer: Explorer, cycle: MachineCycle, times: int) -> Trial:
    """Play a cycle; if it does not repeat so, with all inputs as they were when it was found."""
    trial = played(explorer, cycle, times=times)
    enough = min(times, ENOUGH)
    if count(cycle, trial) >= enough or not (cycle.repeats and (cycle.work or cycle.said)):
        return trial
    as_found = played(explorer, cycle, times=times, as_found=True)
    return max(trial, as_found, key=lambda each: count(cycle, each))


def nowhere(explorer: Explorer) -> MachineCycle:
    """Return the path to the state that took most changes, for a program without a cycle."""
    visits = [node.first for node in explorer.nodes.values()]
    furthest = max(visits, key=lambda visit: len(visit.timeline), default=Visit((), 0.0))
    none = frozenset[int]()
    return MachineCycle((), furthest, (), none, none, none, 0.0)


def _with_more_on(explorer: Explorer, cycle: MachineCycle, trial: Trial) -> Trial:
    """Play a cycle with the inputs on from the start that only come on once, if it runs as often and as well then.

    What they would have ended, such as an alarm, does not happen at all then.
    """
    changes = [(time, each) for time, each in trial.timeline if each.table == "input"]
    often = Counter(each.number for _, each in changes)
    later = tuple(
        each._replace(moment=AT_REST)
        for time, each in changes
        if often[each.number] == 1 and each.value and time > 0.0 and each.number not in explorer.triggers
    )
    if cycle.repeats and later:
        other = played(explorer, cycle, later)
        now, before = (wrong(one.text for one in each.prints) for each in (other, trial))
        if now <= before and count(cycle, other) >= min(count(cycle, trial), COMPARED):
            return other
    return trial


# -------------------------------------------------------------------------------------------------- explaining


class _Description:
    """Settings in which each task does what it did in a played run, described by simpler rules pass by pass."""

    def __init__(self, explorer: Explorer, count: int, cycle: MachineCycle, trial: Trial) -> None:
        self._explorer, self._count, self._cycle, self._trial = explorer, count, cycle, trial
        # Rules are tried by so much work.
        self._most = explorer.most(DESCRIBED)
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
        self._until = LONGER * end + EVERY * most
        self._axes = explorer.trials.run_in(tables_of(trial.timeline), trial.time)[0].controller.axes
        self._along, self._beyond = along(trial, self._axes), beyond(trial, self._axes)
        self._outputs = channels((each.channel, each.time, each.value) for each in trial.outputs)
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
            self._describe_inputs()
        self._describe_as_pulses()
        self._describe_levels()
        self._describe_writes()
        self._describe_others()
        self._take(self._released())
        settings = dict(self._settings)
        inputs = settings.pop("input", [])
        settings |= {"input": inputs} if inputs else {}
        result = self._explorer.trials.run_in(settings, self._until)[0]
        return FoundWorld(self._cycle, settings, result, self._count)

    def _describe_inputs(self) -> None:
        """Let each input follow the simplest rule."""
        for number, changes in sorted(self._flips.items(), key=lambda each: (len(each[1]), each[0])):
            first: Entry = {"channel": number, "at": round(changes[0][0], 1)}
            self._take(self._with(each, number) for each in self._rules(first, changes))

    def _describe_levels(self) -> None:
        """Let each analogue input have one of its levels all the time."""
        given = entries(self._settings, "analogue")
        for number in dict.fromkeys(number_in("analogue", each) for each in given):
            own = [each for each in given if number_in("analogue", each) == number]
            others = [each for each in entries(self._settings, "analogue") if each not in own]
            levels = dict.fromkeys(each.get("value") for each in own) if len(own) > 1 else ()
            steady = ({"channel": number, "value": each, "at": 0.0} for each in levels)
            self._take({**self._settings, "analogue": [*others, each]} for each in steady)

    def _describe_writes(self) -> None:
        """Let each number of a host and each key that comes again follow the simplest rule."""
        for change, times in self._writes.items():
            rest = [each for each in entries(self._settings, change.table) if not is_about(change, each)]
            (first,) = entries(tables_of(((times[0], change),)), change.table)
            pulses = [each for time in times for each in ((time, 1.0), (time + MOMENT, 0.0))]
            tried = self._rules(first, pulses, is_pulse=True) if len(times) > 1 else ()
            self._take({**self._settings, change.table: [*rest, *each]} for each in tried)

    def _describe_others(self) -> None:
        """Let other inputs be on where that makes no difference, or answer if the program waits for both levels."""
        others = set(self._explorer.channels) - self._flips.keys() - self._explorer.triggers
        leads: dict[int, set[object]] = defaultdict(set)
        for node in self._explorer.nodes.values():
            for each in node.transitions:
                (channel, value), *more = [(one.channel, one.value) for one in each.causes] or [
                    (("", 0), 0.0)
                ]
                if channel[0] == "input" and not more and node.channels == [channel]:
                    leads[channel[1]].add(value)
        for number in sorted(others) if self._cycle.repeats else ():
            for rule in (ASKED, ON) if len(leads[number]) > 1 else (ON,):
                settings = self._with([{"channel": number, **rule}], number)
                if self._explorer.trials.work < self._most and self._does_no_more(settings):
                    self._settings = settings
                    break

    def _with(self, made: Sequence[Entry], *numbers: int) -> Settings:
        """Return the settings with other entries for some inputs."""
        left = [each for each in entries(self._settings, "input") if each["channel"] not in numbers]
        return {**self._settings, "input": sorted((*left, *made), key=lambda each: number_in("input", each))}

    def _take(self, tried: Iterable[Settings]) -> None:
        for each in tried:
            if each == self._settings or (self._explorer.trials.work < self._most and self._holds(each)):
                self._settings = each
                return

    def _holds(self, settings: Settings) -> bool:
        """True if each task does what it did in the played run."""
        return self._is_kept(*self._run(settings))

    def _does_no_more(self, settings: Settings) -> bool:
        """True if the same holds, and other tasks do nothing."""
        result, begun, found = self._run(settings)
        others = any(own and not self._wanted.get(task) for task, own in found.items())
        return not others and self._is_kept(result, begun, found)

    def _is_kept(self, result: Run, begun: set[int], found: Acts) -> bool:
        """True if a run with these statements and acts does what the played run did."""
        if self._trial.status == "ended" and result.status != "ended":
            return False
        return begun & self._explorer.handlers <= self._handled and _is_as_good(self._wanted, found)

    def _run(self, settings: Settings) -> tuple[Run, set[int], Acts]:
        """Return a run in a world, the statements that begin, and what it does."""
        result, tasks, _ = self._explorer.trials.run_in(settings, self._until)
        log = result.machine.log
        moves = ((each.start_time, each.axis, each.line, is_short_move(each)) for each in log.moves)
        return result, {*tasks}, self._acts(moves, log.outputs, log.prints)

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
        others = answers(self._trial) if self._count > 1 else {}
        tried = [asked, {**asked, **self._beyond}]
        self._take({**self._with([*each.values()], *each), **others} for each in tried)

    def _describe_as_pulses(self) -> None:
        """Let all inputs without a rule come and go: the times of one fit those of the others."""
        often = Counter(number_in("input", each) for each in entries(self._settings, "input") if "at" in each)
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
        """Return the keys by which changes follow an output, at any delay.

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

        def order(each: Entry) -> tuple[float, int, bool]:
            output: int = each["output"]  # type: ignore[assignment]
            leads = [time - self._outputs[output].last(time + DELAY).time for time, _ in changes]
            return fsum(leads), output, "value" in each

        return sorted(found, key=order)

    def _released(self) -> Iterator[Settings]:
        """Yield rules with which the run does not end in a wait for an input that is always on to be off.

        It follows the output that was switched last.
        """
        result = self._explorer.trials.run_in(self._settings, self._until)[0]
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
            if self._explorer.trials.run_in(tried, self._until)[0].status != "fault":
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
