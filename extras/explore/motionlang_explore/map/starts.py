"""What starts the cycle of a machine: its world is played without each of its channels in turn.

What the cycle does not come without, or not without trouble, or without which it does not print what it prints, is
needed. A person or a host starts it by what is needed and given on purpose: a key, an answer, a number of a host, an
input with the name of what is pushed, or of a switch with which the machine runs. If there are but answers among it,
the inputs that come when they are asked for start it as well; if there is nothing, those that follow an output, such as
a part that comes again.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from motionlang.kernel import Run
from motionlang_explore.exploration import (
    SECOND,
    TABLES,
    Change,
    Entry,
    Exploration,
    entries,
    is_pushed,
    is_reset,
    is_run,
    made_by,
)
from motionlang_explore.map.names import ReaderNames, spaced
from motionlang_explore.map.plays import LEFT

# So much longer than the first cycle the machine is watched, s, and a share; after so much work no more is played.
WATCHED, LONGER, WORK = 1.0, 1.2, SECOND
# A first cycle that takes a smaller share of the time of the later ones is not whole.
WHOLE = 0.8
# With a smaller share of its moves a cycle does not come.
MIN_MOVES = 0.5
# Nobody gives these by chance.
GIVEN = ("key", "answer", "comms", "netdata", "modbus.register")
# What follows something has one of these keys.
FOLLOWS = {"output", "axis"}


class Starts(NamedTuple):
    """What starts the cycle, what it needs as well, what follows an output or an axis, and what else was on.

    Of what is `left` it was not played whether the cycle needs it.
    """

    by: Sequence[Change]
    held: Sequence[Change]
    following: Sequence[Change]
    others: Sequence[Change]
    left: Sequence[Change]


def starts_of(exploration: Exploration, names: ReaderNames) -> Starts | None:
    """Return what starts the cycle of the world, or its whole run; None if no axis moves there but for a homing.

    None also if nothing that was played starts it, and not all was played.
    """
    run = exploration.world.run
    cycle, homes = run.cycle, run.dialect.table().homes
    until = run.time if cycle is None else min(LONGER * _whole(cycle.times, cycle.period) + WATCHED, run.time)
    moved = [each for each in run.machine.log.moves if not homes(each.command) and each.start_time < until]
    lines = {each.line for each in moved if cycle is None or each.line in cycle.lines}
    if not lines:
        return None

    channels = _channels(exploration.world.settings)
    needed = _needed(exploration, channels, names, lines, until)
    starting, asked, held = list[Change](), list[Change](), list[Change]()
    behind, following, others = list[Change](), list[Change](), list[Change]()
    for change, own in channels:
        is_input, is_left = change.table == "input", len(own) == 1 and own[0].keys() <= LEFT
        is_needed = needed.get(change, False)
        if is_needed and _is_given(change, names):
            starting.append(change)
        elif any(each.keys() & FOLLOWS for each in own):
            (behind if is_needed and is_input else following).append(change)
        elif is_needed:
            (asked if is_input and not is_left else held).append(change)
        elif change in needed and is_input and is_left and change.value:
            others.append(change)
    left = [change for change, _ in channels if change not in needed and change not in following]
    if all(each.table == "answer" for each in starting):
        starting, asked = starting + asked, []
    if not starting and left:
        return None
    if not starting:
        starting, behind = behind, []
    return Starts(starting, asked + held, behind + following, others, left)


def _needed(
    exploration: Exploration,
    channels: Sequence[tuple[Change, list[Entry]]],
    names: ReaderNames,
    lines: Collection[int],
    until: float,
) -> dict[Change, bool]:
    """Return whether the moves of some lines need each channel that was played, those that a person gives first.

    Nobody holds a reset that the moves do not need.
    """
    settings, most = exploration.world.settings, exploration.work + WORK
    usual = exploration.run(settings, until)
    is_good, enough = not exploration.fault_of(usual), MIN_MOVES * _moves(usual, lines)
    cycle = exploration.world.run.cycle
    said = _said(exploration, usual).intersection(() if cycle is None else cycle.lines)
    needed: dict[Change, bool] = {}
    resets = {change for change, _ in channels if change.table == "input" and is_reset(names[change.subject])}
    for change, own in sorted(
        channels, key=lambda each: not (each[0] in resets or _is_given(each[0], names))
    ):
        if exploration.work >= most:
            break
        without = {
            **settings,
            change.table: [each for each in entries(settings, change.table) if each not in own],
        }
        played = exploration.run(without, until)
        is_silent = not said <= _said(exploration, played)
        needed[change] = _moves(played, lines) < enough or (
            is_good and (is_silent or bool(exploration.fault_of(played)))
        )
        if change in resets and not needed[change]:
            settings = without
    return needed


def _moves(run: Run, lines: Collection[int]) -> int:
    return sum(each.line in lines for each in run.machine.log.moves)


def _said(exploration: Exploration, run: Run) -> set[int]:
    """Return the lines that print something in a run."""
    return {exploration.line(each.at) for each in run.machine.log.prints if each.at >= 0}


def _is_given(change: Change, names: ReaderNames) -> bool:
    """True for what a person or a host gives on purpose."""
    name = spaced(names[change.subject])
    return change.table in GIVEN or (change.table == "input" and (is_pushed(name) or is_run(name)))


def _whole(times: Sequence[float], period: float) -> float:
    """Return when the first cycle ends that is not shorter than the later ones, as where a machine fills."""
    ends = (end for begin, end in pairwise(times) if end - begin > WHOLE * period)
    return next(ends, times[1])


def _channels(settings: Mapping[str, object]) -> list[tuple[Change, list[Entry]]]:
    """Return the entries of each channel of a world, with the first change; of a key and a host those of each value."""
    found = defaultdict[object, list[tuple[Change, Entry]]](list)
    for table in TABLES:
        for entry in entries(settings, table):
            _, change = made_by(table, entry)
            if table == "input" and entry.keys() & FOLLOWS:
                change = change._replace(value=1.0)
            value = change.value if table in GIVEN and table != "answer" else change.prompt
            found[table, change.number, value].append((change, entry))
    return [(own[0][0], [entry for _, entry in own]) for own in found.values()]
