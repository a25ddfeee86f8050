"""What starts the cycle of a machine: its world is played without each of its channels in turn.

What the cycle does not come without, or not without trouble, is needed. A person or a host starts it by what is needed
and given on purpose: a key, an answer, a number of a host, an input with the name of what is pushed. If there are but
answers among it, the inputs that come when they are asked for start it as well; if there is nothing, those that follow
an output, such as a part that comes again.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from motionlang_explore.exploration import (
    SECOND,
    TABLES,
    Change,
    Entry,
    Exploration,
    entries,
    is_pushed,
    made_by,
)
from motionlang_explore.map.names import ReaderNames

# So much longer than the first cycle the machine is watched, s, and a share; after so much work no more is played.
WATCHED, LONGER, WORK = 1.0, 1.2, SECOND
# With a smaller share of its moves a cycle does not come.
MIN_MOVES = 0.5
# Nobody gives these by chance.
GIVEN = ("key", "answer", "comms", "netdata", "modbus.register")
# What is left on has no other keys than these, and what follows something has one of those.
LEFT, FOLLOWS = {"channel", "at", "value"}, {"output", "axis"}


class Starts(NamedTuple):
    """What starts the cycle, what it needs as well, what follows an output or an axis, and what else was on."""

    by: Sequence[Change]
    held: Sequence[Change]
    following: Sequence[Change]
    others: Sequence[Change]


def starts_of(exploration: Exploration, names: ReaderNames) -> Starts | None:
    """Return what starts the cycle of the world, or its whole run; None if no axis moves there but for a homing.

    None also if nothing that was played starts it, and not all was played.
    """
    run, most = exploration.world.run, exploration.work + WORK
    cycle, homes = run.cycle, run.dialect.table().homes
    until = run.time if cycle is None else min(LONGER * cycle.times[1] + WATCHED, run.time)
    moved = [each for each in run.machine.log.moves if not homes(each.command) and each.start_time < until]
    lines = {each.line for each in moved if cycle is None or each.line in cycle.lines}
    enough = MIN_MOVES * sum(each.line in lines for each in moved)
    if not lines:
        return None

    settings, is_good = exploration.world.settings, not exploration.fault_of(run)
    starting, asked, held = list[Change](), list[Change](), list[Change]()
    behind, following, others = list[Change](), list[Change](), list[Change]()
    for change, own in _channels(settings):
        table = change.table
        is_needed = False
        if exploration.work < most:
            rest = [each for each in entries(settings, table) if each not in own]
            played = exploration.run({**settings, table: rest}, until)
            is_needed = sum(each.line in lines for each in played.machine.log.moves) < enough or (
                is_good and bool(exploration.fault_of(played))
            )
        is_left = len(own) == 1 and own[0].keys() <= LEFT
        if is_needed and (table in GIVEN or (table == "input" and is_pushed(names[change.subject]))):
            starting.append(change)
        elif any(each.keys() & FOLLOWS for each in own):
            (behind if is_needed and table == "input" else following).append(change)
        elif is_needed:
            (asked if table == "input" and not is_left else held).append(change)
        elif table == "input" and is_left and change.value:
            others.append(change)
    if all(each.table == "answer" for each in starting):
        starting, asked = starting + asked, []
    if not starting and exploration.work >= most:
        return None
    if not starting:
        starting, behind = behind, []
    return Starts(starting, asked + held, behind + following, others)


def _channels(settings: Mapping[str, object]) -> list[tuple[Change, list[Entry]]]:
    """Return the entries of each channel of a world, with the first change; of a key and a host those of each value."""
    found = defaultdict[object, list[tuple[Change, Entry]]](list)
    for table in TABLES:
        for entry in entries(settings, table):
            _, change = made_by(table, entry)
            if entry.keys() & FOLLOWS:
                change = change._replace(value=1.0)
            value = change.value if table in GIVEN and table != "answer" else change.prompt
            found[table, change.number, value].append((change, entry))
    return [(own[0][0], [entry for _, entry in own]) for own in found.values()]
