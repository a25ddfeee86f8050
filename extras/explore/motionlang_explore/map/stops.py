"""What stops a machine between its moves: it is played in the world of its cycle.

In the first move of a cycle each input that is left on goes off, each that is left off comes on, and each key that the
program reads is pressed. What goes on as usual for a while and then begins no other move has been stopped there. A
machine that goes on as usual when its start button is released is played so.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import reduce
from math import inf
from typing import NamedTuple

from motionlang.kernel import Run
from motionlang_explore.exploration import SECOND, Change, Exploration, entries, is_pushed
from motionlang_explore.map.names import ReaderNames
from motionlang_explore.map.starts import LEFT

# So much longer than two cycles the machine is watched, s; once all together have done so much work, no more is played.
WATCHED, WORK = 3.0, 2 * SECOND
# Times that differ by less are the same, s.
SHORT = 1e-6


class Stops(NamedTuple):
    """The changes that bring a machine to rest, and those that were not played to the end.

    They are made in the middle of a move. A line is that of the last thing that was done as usual, a move, an output or
    a print, 0 at the end of the cycle.
    """

    lines: Sequence[tuple[Change, int]] = ()
    left: Sequence[Change] = ()
    move: int = 0


def stops_of(exploration: Exploration, names: ReaderNames) -> Stops:
    """Return what stops a machine that makes good pieces between its moves; nothing is played of any other."""
    world, most = exploration.world, exploration.work + WORK
    found = world.run.cycle
    if found is None or exploration.fault_of(world.run) or len(found.times) < 3:
        return Stops()
    begin, end = found.times[1:3]
    log = world.run.machine.log
    moves = [
        (each.start_time, each.profile.duration, each.line)
        for each in log.moves
        if each.profile is not None and begin <= each.start_time < end
    ]
    if not moves:
        return Stops()
    first, seconds, move = moves[0]
    time, lines = first + min(seconds, end - begin) / 2.0, [line for *_, line in moves]
    until, usual = time + 2.0 * found.period + WATCHED, [*lines[1:], *lines]
    done = [line for at, line in _acts(exploration, world.run) if time < at < end]

    def line_behind(settings: Mapping[str, object]) -> int | None:
        """Return the line behind which the machine stops, 0 at the end of its cycle, -1 if it goes on."""
        trial, run, rests = exploration.play_in(settings, until)
        if not (trial.is_stuck or trial.has_ended or trial.time >= until - SHORT):
            return None
        begun = [each.line for each in trial.moves if each.begin > time and each.profile is not None]
        stays = any(each.end == inf and each.begin < until - found.period for each in rests)
        is_usual = len(begun) < len(usual) and begun == usual[: len(begun)]
        if not (is_usual and (stays or trial.is_stuck or trial.has_ended)):
            return -1
        after = [line for at, line in _acts(exploration, run) if at > time]
        same = next(
            (k for k, pair in enumerate(zip(done, after, strict=False)) if len({*pair}) > 1), len(after)
        )
        return 0 if same >= len(done) else [move, *done[:same]][-1]

    settings = world.settings
    pushed = [
        one for one in _changes(exploration, settings) if not one.value and is_pushed(names[one.subject])
    ]
    released = reduce(lambda made, one: _with(made, one, time), pushed, settings)
    if pushed and line_behind(released) == -1:
        settings = released
    stops, left = list[tuple[Change, int]](), list[Change]()
    for change in _changes(exploration, world.settings):
        line = line_behind(_with(settings, change, time)) if exploration.work <= most else None
        if line is None:
            left.append(change)
        elif line >= 0:
            stops.append((change, line))
    return Stops(stops, left, move)


def _acts(exploration: Exploration, run: Run) -> list[tuple[float, int]]:
    """Return the times and lines of the moves, outputs and prints of a run, in order."""
    log = run.machine.log
    found = [(each.start_time, each.line) for each in log.moves]
    found += [(each.time, exploration.line(each.at)) for each in log.outputs if each.at >= 0]
    found += [(each.time, exploration.line(each.at)) for each in log.prints if each.at >= 0]
    return sorted(found)


def _changes(exploration: Exploration, settings: Mapping[str, object]) -> Iterator[Change]:
    """Yield the changes of the inputs that have one level in a world, and of the keys that the program reads."""
    given = entries(settings, "input")
    for number in exploration.channels:
        own = [each for each in given if each["channel"] == number]
        if not own or (len(own) == 1 and own[0].keys() <= LEFT):
            is_on = bool(own) and bool(own[0].get("value", 1))
            yield Change("input", number, 0.0 if is_on else 1.0)
    causes = (one for node in exploration.nodes for each in node.transitions for one in each.causes)
    yield from dict.fromkeys(one for one in causes if one.table == "key" and not one.moment.line)


def _with(settings: Mapping[str, object], change: Change, time: float) -> dict[str, object]:
    made = (
        {"channel": change.number, "value": change.value}
        if change.table == "input"
        else {"text": change.value}
    )
    return {**settings, change.table: [*entries(settings, change.table), {**made, "at": time}]}
