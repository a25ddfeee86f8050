"""What stops a machine between its moves: it is played in the world of its cycle.

In the first move of a cycle each input that is left on goes off, each that is left off comes on, and each key that the
program reads is pressed. What goes on as usual for a while and then begins no other move has been stopped there. Nobody
resets it, nor pushes its start button any more, if it goes on as usual without.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from difflib import SequenceMatcher
from functools import reduce
from math import inf
from typing import NamedTuple

from motionlang.kernel import Run
from motionlang.kernel.log import CONTINUED, LoggedMove
from motionlang_explore.exploration import (
    SECOND,
    Change,
    Exploration,
    Rest,
    Trial,
    entries,
    is_pushed,
    number_in,
)
from motionlang_explore.map.faults import changed, without_resets
from motionlang_explore.map.names import ReaderNames
from motionlang_explore.map.starts import LEFT

# So much longer than two cycles the machine is watched, s; once all together have done so much work, no more is played.
WATCHED, WORK = 3.0, 2 * SECOND
# What a move is not cut off by.
UNCUT = ("", CONTINUED)
# Times that differ by less are the same, s.
SHORT = 1e-6


class Stops(NamedTuple):
    """The changes that bring a machine to rest, those that cut off a move, and those that were not played to the end.

    They are made in the middle of the move of line `move`. A line is that of the last thing that was done as usual, a
    move, an output or a print, 0 at the end of the cycle.
    """

    lines: Sequence[tuple[Change, int]] = ()
    cuts: Sequence[Change] = ()
    left: Sequence[Change] = ()
    move: int = 0


def stops_of(exploration: Exploration, names: ReaderNames) -> Stops:
    """Return what stops a machine that makes good pieces between its moves; nothing is played of any other."""
    world = exploration.world
    cycle = world.run.cycle
    if cycle is None or exploration.fault_of(world.run) or len(cycle.times) < 2:
        return Stops()
    begin, end = cycle.times[1:3] if len(cycle.times) > 2 else cycle.times
    moves = (each for each in world.run.machine.log.moves if each.profile is not None)
    move = next((each for each in moves if begin <= each.start_time < end), None)
    if move is None:
        return Stops()
    played = _Played(exploration, move, end, cycle.period)
    settings, most = played.without_hands(names), exploration.work + WORK
    lines, cuts, left = list[tuple[Change, int]](), list[Change](), list[Change]()
    for change in _changes(exploration, world.settings):
        line, is_cut = played.line_behind(settings, change) if exploration.work <= most else (None, False)
        if is_cut:
            cuts.append(change)
        if line is None:
            left.append(change)
        elif line >= 0:
            lines.append((change, line))
    return Stops(lines, cuts, left, move.line)


class _Played:
    """A cycle of a world, up to `end`, with changes in the middle of one of its moves."""

    def __init__(self, exploration: Exploration, move: LoggedMove, end: float, period: float) -> None:
        self._exploration, self._move, self._run = exploration, move, exploration.world.run
        self._period = period
        duration = 0.0 if move.profile is None else move.profile.duration
        self._time = move.start_time + min(duration, period) / 2.0
        self._until = self._time + 2.0 * period + WATCHED
        log = self._run.machine.log
        begun = ((each.start_time, each.line) for each in log.moves if each.profile is not None)
        later = [(time, line) for time, line in begun if time > self._time]
        # What the machine does as usual: its moves in this cycle and the next one, and all that it does in this one.
        self._usual = [line for time, line in later if time < end + period]
        self._done = [line for time, line in _acts(exploration, self._run) if self._time < time < end]

    def without_hands(self, names: ReaderNames) -> Mapping[str, object]:
        """Return the settings in which nobody resets, nor pushes a start button any more, if the machine goes on so."""
        settings, _ = without_resets(self._exploration, names)
        given = dict.fromkeys(number_in("input", each) for each in entries(settings, "input"))
        pushed = [number for number in given if is_pushed(names[f"input {number}"])]
        offs = [Change("input", number, 0.0) for number in pushed]
        released = reduce(lambda made, off: changed(made, self._run, off, self._time), offs, settings)
        goes_on = pushed and self._behind(*self._exploration.play_in(released, self._until)) == -1
        return released if goes_on else settings

    def line_behind(self, settings: Mapping[str, object], change: Change) -> tuple[int | None, bool]:
        """Return the line behind which the machine stops by a change, and if the move is cut off.

        The line is 0 at the end of the cycle, -1 if the machine goes on, None if it was not played to the end.
        """
        played = self._exploration.play_in(_with(settings, change, self._time), self._until)
        is_cut = self._move.ended in UNCUT and any(
            each.line == self._move.line
            and each.ended not in UNCUT
            and abs(each.start_time - self._move.start_time) < SHORT
            for each in played.run.machine.log.moves
        )
        return self._behind(*played), is_cut

    def _behind(self, trial: Trial, run: Run, rests: Sequence[Rest]) -> int | None:
        if not (trial.is_stuck or trial.has_ended or trial.time >= self._until - SHORT):
            return None
        begun = [each.line for each in trial.moves if each.begin > self._time and each.profile is not None]
        stays = any(each.end == inf and each.begin < self._until - self._period for each in rests)
        is_usual = len(begun) < len(self._usual) and begun == self._usual[: len(begun)]
        if not (is_usual and (stays or trial.is_stuck or trial.has_ended)):
            return -1
        after = [line for time, line in _acts(self._exploration, run) if time > self._time]
        # A lamp may go off between what is done as usual.
        blocks = SequenceMatcher(None, self._done, after, autojunk=False).get_matching_blocks()
        last = max((each.a + each.size for each in blocks[:-1]), default=0)
        return 0 if last >= len(self._done) else [self._move.line, *self._done][last]


def _acts(exploration: Exploration, run: Run) -> list[tuple[float, int]]:
    """Return the times and lines of the moves, outputs and prints of a run, in order."""
    log = run.machine.log
    found = [(each.start_time, each.line) for each in log.moves]
    found += [(each.time, exploration.line(each.at)) for each in log.outputs if each.at >= 0]
    found += [(each.time, exploration.line(each.at)) for each in log.prints if each.at >= 0]
    return sorted(found)


def _changes(exploration: Exploration, settings: Mapping[str, object]) -> Iterator[Change]:
    """Yield the changes of the inputs that have one level in a world, and of the keys that it does not press."""
    given = entries(settings, "input")
    for number in exploration.inputs:
        own = [each for each in given if each["channel"] == number]
        if not own or (len(own) == 1 and own[0].keys() <= LEFT):
            is_on = bool(own) and bool(own[0].get("value", 1))
            yield Change("input", number, 0.0 if is_on else 1.0)
    known = {each.get("text") for each in entries(settings, "key")}
    causes = (one for node in exploration.nodes for each in node.transitions for one in each.causes)
    keys = (one for one in causes if one.table == "key" and not one.moment.line)
    yield from dict.fromkeys(one for one in keys if one.value not in known)


def _with(settings: Mapping[str, object], change: Change, time: float) -> dict[str, object]:
    made = (
        {"channel": change.number, "value": change.value}
        if change.table == "input"
        else {"text": change.value}
    )
    return {**settings, change.table: [*entries(settings, change.table), {**made, "at": time}]}
