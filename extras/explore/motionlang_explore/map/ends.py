"""What ends an alarm: it is played.

It begins in the world of the good cycle by what it comes by, and all inputs stay as they are then, but for buttons,
which are let go if it stays so; a host gives nothing more. At the rest behind
it, what has led there may be taken back. Then one channel after the other that is read at rest is changed, until the
outputs of the alarm are off, or the machine is where it comes without an alarm that has none. Those of these changes
are left out without which that happens as well. Without some of them the alarm comes again where other inputs go on to
follow what the machine does.
"""

from __future__ import annotations

import re
from collections import defaultdict, deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from math import inf
from typing import NamedTuple

from motionlang.comparison.texts import plain
from motionlang.kernel import Run
from motionlang.kernel.lang import WRITE, Statement
from motionlang_explore.exploration import (
    SECOND,
    TEXTS,
    Change,
    Channel,
    Exploration,
    PlayedTimeline,
    Rest,
    RestState,
    Timeline,
    Trial,
    Visit,
    entries,
    is_pushed,
    is_reset,
    made_at,
    number_in,
    without_memory,
)
from motionlang_explore.map.faults import Begin
from motionlang_explore.map.names import ReaderNames
from motionlang_explore.map.plays import LEFT, VALUES, Settings, given_in, inputs_until

# So many changes are tried behind each begin, and in all alarms no more is tried once they have done so much work.
MAX_TRIED, WORK = 20, 3 * SECOND
# The number of an alarm in a text.
_CODE = re.compile(r"\d")
# A machine is watched for so long behind an alarm, and each change, s.
PATIENCE = 12.0
# An alarm is over if it does not come again for so long, s.
AWHILE = 1.0
# The values with which an output is switched on.
ON = ("1", "_on", "_true")
# The changes of an end, in order; those of one step come together.
Step = tuple[Change, ...]
Steps = tuple[Step, ...]


class End(NamedTuple):
    """The changes that end an alarm, none if it ends by itself.

    It comes again without those that it `keeps`, or `comes_again` with all that was tried.
    """

    steps: Steps = ()
    keeps: Step = ()
    comes_again: bool = False


class _Reached(NamedTuple):
    """What some steps have led to in a world: the run, the levels of its inputs, and the rest in which it stays.

    The last step is made at `since`, s. `moving` is the same world with inputs that go on to follow what the machine
    does. The rest is None if there is none.
    """

    world: Settings
    moving: Settings
    timeline: Timeline
    since: float
    played: PlayedTimeline
    levels: Mapping[int, float]
    visit: Visit | None


class Ends:
    """The ends of the alarms of an explored program; `signs` are the statements of all of them."""

    def __init__(self, exploration: Exploration, signs: Collection[Statement], names: ReaderNames) -> None:
        self._exploration, self._names = exploration, names
        self._most = exploration.work + WORK
        self._nodes = {node.state: node for node in exploration.nodes}
        # The levels, numbers and keys that lead on somewhere, by channel.
        self._values: dict[Channel, dict[Change, None]] = defaultdict(dict)
        for each in (one for node in exploration.nodes for way in node.transitions for one in way.causes):
            self._values[each.channel][each] = None
        # The inputs that come more than once in the world.
        own = entries(exploration.world.settings, "input")
        self._given = {number_in("input", each) for each in own if not each.keys() <= LEFT}
        # The ends that were found: a lamp has that of its text.
        self._known: dict[End, None] = {}
        alarms = {each.at for each in signs}
        self._good = {*exploration.world.cycle.states, *self._without(alarms)} - {None}

    def _without(self, alarms: Collection[int]) -> set[RestState | None]:
        """Return the states to which the machine comes without any of some statements."""
        found: dict[RestState | None, None] = {None: None}
        queue = deque(found)
        while queue:
            node = self._nodes.get(queue.popleft())
            for each in node.transitions if node is not None else ():
                if each.target is not None and each.target not in found and each.begun.isdisjoint(alarms):
                    found[each.target] = None
                    queue.append(each.target)
        return set(found)

    def of(
        self, signs: Collection[Statement], why: str, said: Collection[str], begins: Sequence[Begin]
    ) -> End | None:
        """Return what ends the alarm of some statements.

        It begins as it was played, where one of the texts is `said`. Of changes that can stand for each other those are
        left that the reason `why` it comes names.
        None if nothing that was played has ended it. What ends one alarm is tried last with the next one.
        """
        alarm = _Alarm(
            self._exploration,
            signs,
            {each for each in said if _CODE.search(each) and "..." not in each},
            self._good,
        )
        known = tuple(self._known)
        if self._is_out_of_work and not known:
            return None
        begun = self._begun(begins, alarm)
        if begun is None:
            return None
        start, undone = begun
        alarm.shows(start.played, self._names)
        start = self._released(start, alarm)
        if start.played.trial.has_ended or alarm.goes_on(start.played):
            return End()
        alarm.begins(start.played)
        if alarm.is_over(start.played, has_come=False):
            return End()
        if start.visit is None:  # nothing can be tried where the machine does not rest
            return None
        for begin in dict.fromkeys((undone, ())):
            found = None if self._is_out_of_work else self._found(start, (begin,) if begin else (), alarm)
            if found is not None:
                end = self._end(start, found, alarm, why)
                self._known[end] = None
                return end
        return next((each for each in known if alarm.is_over(self._after(start, each.steps).played)), None)

    def _begun(self, begins: Sequence[Begin], alarm: _Alarm) -> tuple[_Reached, Step] | None:
        """Return what an alarm begins with in the first way in which it comes, and what takes that back.

        Nobody holds a reset, unless the alarm does not come so.
        """
        for each in begins:
            until = self._exploration.run(each.settings, each.came)
            changed = {one.channel for one in until.machine.log.inputs}
            # All inputs stay as they were when it came.
            settings = {
                **each.settings,
                **_given_until(until, each.settings),
                "input": inputs_until(until, inf),
            }
            held = self._resets(changed - ({each.change.number} if each.change is not None else set()))
            for timeline in dict.fromkeys((made_at(each.time, held), ())):
                patience = each.came - each.time + PATIENCE
                start = self._play(settings, each.settings, timeline, each.time, patience)
                if alarm.has_come(start.played):
                    return start, self._taken_back(each.change)
        return None

    def _taken_back(self, change: Change | None) -> Step:
        """Return what takes a change of the world back."""
        if change is None or change.table in TEXTS:
            return ()
        if change.table == "input":
            return (change._replace(value=1.0 - float(change.value)),)
        given = entries(self._exploration.world.settings, change.table)
        values = [each.get("value", 0.0) for each in given if number_in(change.table, each) == change.number]
        return tuple(change._replace(value=value) for value in values[-1:] if isinstance(value, (int, float)))

    def _released(self, start: _Reached, alarm: _Alarm) -> _Reached:
        """Return what an alarm begins with while nobody holds a button, or as it is if it does not stay so."""
        on = [number for number, level in start.levels.items() if level]
        pushed = (
            number for number in on if is_pushed(self._names[f"input {number}"]) and number in self._given
        )
        held = (*self._resets(on), *(Change("input", number, 0.0) for number in pushed))
        later = self._changed(start, held)
        return start if alarm.is_over(later.played) else later

    def _resets(self, numbers: Iterable[int]) -> Step:
        """Return the changes that release those of some inputs that reset."""
        return tuple(
            Change("input", each, 0.0) for each in sorted(numbers) if is_reset(self._names[f"input {each}"])
        )

    def _found(self, start: _Reached, begin: Steps, alarm: _Alarm) -> Steps | None:
        """Return the fewest steps behind some that end an alarm; None if none of those that were tried do."""
        here = self._after(start, begin)
        if begin and alarm.is_over(here.played):
            return begin
        tried, known, queue = 0, set[object](), deque([(begin, here)])
        while queue:
            steps, here = queue.popleft()
            for step in sorted(dict.fromkeys(self._steps(here)), key=len):
                tried += 1
                reached = self._changed(here, step)
                if alarm.is_over(reached.played):
                    return (*steps, step)
                if self._is_out_of_work:
                    return None
                place = reached.visit and (reached.played.rests[-1].state, *reached.levels.items())
                if tried < MAX_TRIED and place is not None and place not in known:
                    known.add(place)
                    queue.append(((*steps, step), reached))
        return None

    @property
    def _is_out_of_work(self) -> bool:
        return self._exploration.work >= self._most

    def _play(
        self, world: Settings, moving: Settings, timeline: Timeline, since: float, patience: float = PATIENCE
    ) -> _Reached:
        played = self._exploration.play(timeline, since, patience, world)
        levels = {each.channel: float(each.value) for each in played.run.machine.log.inputs}
        last = played.rests[-1] if played.rests else None
        visit = None
        if last is not None and last.end == inf:
            visit = Visit(timeline, max(last.begin, since), last.end, question=last.question)
        return _Reached(world, moving, timeline, since, played, levels, visit)

    def _after(self, here: _Reached, steps: Steps) -> _Reached:
        for step in steps:
            here = self._changed(here, step)
        return here

    def _changed(self, here: _Reached, step: Step) -> _Reached:
        if here.visit is None or not step:
            return here
        timeline = here.visit.changed(step)
        return self._play(here.world, here.moving, timeline, here.visit.change_time)

    def _steps(self, here: _Reached) -> Iterator[Step]:
        """Yield what may be changed at a rest: what has led on there, and what it reads."""
        if here.visit is None:
            return
        rest = here.played.rests[-1]
        node = self._nodes.get(rest.state)
        for each in node.transitions if node is not None else ():
            if each.causes and not any(one.moment.line for one in each.causes):
                yield each.causes
        read = dict.fromkeys(channel for channels in rest.reads.values() for channel in channels)
        for channel in read:
            if channel[0] == "input":
                yield (Change(*channel, 1.0 - here.levels.get(channel[1], 0.0)),)
            else:
                yield from ((each,) for each in self._values.get(channel, ()))

    def _end(self, start: _Reached, steps: Steps, alarm: _Alarm, why: str) -> End:
        """Return an end without the changes that it does not need, and those without which the alarm comes again."""

        def is_over(less: Steps) -> bool:
            return alarm.is_over(self._after(start, less).played)

        def lasts(less: Steps) -> bool:
            reached = self._after(start, less)
            return alarm.is_over(reached.played) and not self._comes_again(reached, alarm)

        needed = self._needed(steps, is_over, why)
        if lasts(needed):
            return End(needed)
        if not lasts(steps):
            return End(needed, comes_again=True)
        lasting = self._needed(steps, lasts, why)
        given = {one for step in needed for one in step}
        keeps = tuple(one for step in lasting for one in step if one not in given)
        return End(needed, keeps) if keeps else End(lasting)

    def _needed(self, steps: Steps, holds: Callable[[Steps], bool], why: str) -> Steps:
        """Return steps without the changes without which something holds as well."""
        changes = [(k, change) for k, step in enumerate(steps) for change in step]
        for k, change in sorted(changes, key=lambda each: self._names[each[1].subject] in why):
            less = (*steps[:k], tuple(one for one in steps[k] if one != change), *steps[k + 1 :])
            if any(less) and holds(less):
                steps = less
        return tuple(filter(None, steps))

    def _comes_again(self, reached: _Reached, alarm: _Alarm) -> bool:
        """True if an alarm comes again where other inputs go on to follow what the machine does."""
        played = self._exploration.play(reached.timeline, reached.since, PATIENCE, reached.moving)
        return alarm.comes_again(played)


def _given_until(until: Run, settings: Settings) -> dict[str, object]:
    """Return what a host and keys have given in a run, which gives no more."""
    return {
        table: [entry for _, entry in given_in(until, table, own)]
        for table in VALUES
        if (own := entries(settings, table)) and table != "analogue"
    }


class _Alarm:
    """The statements and the outputs of an alarm, and the good states."""

    def __init__(
        self,
        exploration: Exploration,
        signs: Collection[Statement],
        texts: Collection[str],
        good: Collection[RestState | None],
    ) -> None:
        written = {each.at: [use for use in each.channels if use.access == WRITE] for each in signs}
        # What writes a number for a host writes what is right, too.
        self.at = {at for at, uses in written.items() if all(use.channel == "output" for use in uses)}
        # What writes a value that it works out begins all the time.
        self._said = {at for at in self.at if all(use.value.lower() in ON for use in written[at])}
        outputs = (use.number for at in self.at for use in written[at])
        self._outputs = {int(number) for number in outputs if number.isdecimal()}
        self._cycle, self._good, self._texts = exploration.world.cycle, good, set(texts)
        self._places = set(map(without_memory, good))

    def is_said(self, said: Iterable[str]) -> bool:
        """True if one of its texts is said, or it has none that does not count."""
        return not self._texts or not self._texts.isdisjoint(
            " ".join(plain(each).strip("'\"").split()) for each in said
        )

    def has_come(self, played: PlayedTimeline) -> bool:
        """True if one of its statements has begun, but for what writes a value that it works out, with its text."""
        since = played.trial.since
        begun = any(
            one.at in (self._said or self.at) for some in played.trial.statements.values() for one in some
        )
        return begun and self.is_said(each.text for each in played.trial.prints if each.time >= since)

    def shows(self, played: PlayedTimeline, names: ReaderNames) -> None:
        """Take the outputs of alarms that are on behind what is only said, as what shows it."""
        if not self._outputs:
            switched = {
                each.channel
                for each in played.run.machine.log.outputs
                if each.value and each.time >= played.trial.since and f"output {each.channel}" in names.alarms
            }
            self._outputs = {each for each in switched if self._is_on(played.run, inf, each)}

    def goes_on(self, played: PlayedTimeline) -> bool:
        """True if the machine goes on behind what is only said, or rests where it comes without it as well."""
        begun = (one for some in played.trial.statements.values() for one in some if one.at in self.at)
        said = max((each.time for each in begun), default=0.0)
        last = played.rests[-1:]
        goes_on = any(each.begin < said or without_memory(each.state) in self._places for each in last)
        later = [each for each in played.rests if each.end > said]
        return not self._outputs and (goes_on or len(later) > 1)

    def begins(self, played: PlayedTimeline) -> None:
        """Take note of the rest behind the alarm: at its place only what the program remembers tells a good state."""
        self._places -= {without_memory(each.state) for each in played.rests[-1:]}

    def is_over(self, played: PlayedTimeline, *, has_come: bool = True) -> bool:
        """True if the alarm is over for a while behind the last change: its outputs are off, or the machine is back.

        It is back in a good state, or on its way there. Unless the alarm `has_come` before, it has to come first.
        """
        return next(self._over(played, has_come), None) is not None

    def comes_again(self, played: PlayedTimeline) -> bool:
        """True if the alarm says again what it says, or shows it, behind the last change, or is not over."""
        time = next(self._over(played, has_come=True), None)
        prints = [each for each in played.trial.prints if each.at in self.at]
        said = [each.time for each in prints if self.is_said([each.text])] if prints else self._lit(played)
        return time is None or any(one > time for one in said)

    def _lit(self, played: PlayedTimeline) -> list[float]:
        """Return when the outputs of the alarm come on behind the last change, or else its statements begin."""
        trial, run, _ = played
        if not self._outputs:
            return [one.time for some in trial.statements.values() for one in some if one.at in self._said]
        lit = (each for each in run.machine.log.outputs if each.channel in self._outputs and each.value)
        return [each.time for each in lit if each.time > trial.since]

    def _over(self, played: PlayedTimeline, has_come: bool) -> Iterator[float]:
        """Yield the times from which on the alarm is over for a while."""
        trial, run, rests = played
        said = self._lit(played)
        if self._outputs:
            changes = (each for each in run.machine.log.outputs if each.channel in self._outputs)
            back = [trial.since, *(each.time for each in changes if not each.value)]
        else:
            back = list(self._back(trial, rests))
        since = trial.since if has_come else max((trial.since, *said))
        for time in back:
            if (
                time >= since
                and not any(time <= one < time + AWHILE for one in said)
                and not self._is_on(run, time, *self._outputs)
                and (time + AWHILE <= trial.time or trial.is_stuck or trial.has_ended)
            ):
                yield time

    def _back(self, trial: Trial, rests: Sequence[Rest]) -> Iterator[float]:
        """Yield the times at which the machine is in a good state, or begins a move of its cycle that leads there."""
        good = [each.state in self._good or without_memory(each.state) in self._places for each in rests]
        yield from (each.begin for each, is_good in zip(rests, good, strict=True) if is_good)
        for move in (each for each in trial.moves if each.line in self._cycle.work):
            comes = (is_good for each, is_good in zip(rests, good, strict=True) if each.begin >= move.begin)
            if next(comes, True):
                yield move.begin

    def _is_on(self, run: Run, time: float, *outputs: int) -> bool:
        """True if one of some outputs is on at a time."""
        levels = {each.channel: each.value for each in run.machine.log.outputs if each.time <= time}
        return any(levels.get(each) for each in outputs)
