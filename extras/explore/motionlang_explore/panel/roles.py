"""Roles of the inputs of a program by its exploration: switches, buttons, and inputs that would stop a move."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from typing import NamedTuple

from motionlang.kernel import Source, dialect_for
from motionlang_explore.exploration import explore, without_world


class Roles(NamedTuple):
    """The kind of each input, "switch" or "button", and the inputs that each line that moves an axis must not meet."""

    kinds: Mapping[int, str]
    stops: Mapping[int, list[int]]


NO_ROLES = Roles({}, {})


def roles_of(source: Source, settings: Mapping[str, object]) -> Roles:
    """Explore a program: an input that is on all through its cycle is a switch, one that comes on in it a button."""
    world = without_world(settings)
    found = explore(dialect_for(source, None).program(source, world, is_debug=True), world)
    cycle = found.world.cycle
    changed = [each for one in cycle.transitions for each in one.causes if each.table == "input"]
    read = {
        number
        for channels in found.turns(cycle, 1).readings.values()
        for (table, number), spans in channels.items()
        if table == "input" and spans[-1].last > cycle.visit.change_time
    }
    kinds = {number: "switch" for number, level in cycle.visit.levels.items() if level and number in read}
    kinds |= {each.number: "button" for each in changed if each.value or kinds.get(each.number)}
    stops: dict[int, set[int]] = defaultdict(set)
    for change, lines in found.cut_off().items():
        for line in lines:
            stops[line].add(change.number)
    return Roles(kinds, {line: sorted(numbers) for line, numbers in stops.items()})
