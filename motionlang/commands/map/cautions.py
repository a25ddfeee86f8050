"""What to know before a program is changed: what stops a motion, outputs on in one, and waits without a time-out.

Stops are those that the exploration has seen: a move was cut off when an input changed in the middle of it, and is
otherwise not. Outputs are those of the run in the likeliest world. A wait has no time-out if nothing came by itself
while it lasted.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from math import inf

from motionlang.commands.map.names import ReaderNames
from motionlang.exploration import Change, Exploration, Transition
from motionlang.kernel import Run
from motionlang.kernel.lang import Structure
from motionlang.kernel.tools import ranges

# An output that is on for less than this in a motion only follows or precedes it, s.
SHORT = 1e-3


@dataclass(eq=False, slots=True)
class CautionRow:
    """Something to know: its kind, the channel or the wait, and what it does, with lines in words."""

    kind: str
    what: str
    why: str


def cautions(exploration: Exploration, structure: Structure, names: ReaderNames) -> list[CautionRow]:
    """Return what to know before a change."""
    rows = [CautionRow("stops", what, why) for what, why in _stops(exploration, structure, names)]
    rows += [
        CautionRow("on in motion", names[f"output {channel}"], f"is on in moves of {_lines(at)}")
        for channel, at in sorted(_on_in_motion(exploration.world.run, exploration.beside).items())
    ]
    waits = {
        structure.line(at)
        for node in exploration.nodes
        if node.state is not None and all(each.causes for each in node.transitions)
        for place in node.state
        for at in place.statements
        if at in node.reads
    }
    return [*rows, CautionRow("waits", "waits", f"of {_lines(waits)} have no time-out")] if waits else rows


def _stops(exploration: Exploration, structure: Structure, names: ReaderNames) -> Iterator[tuple[str, str]]:
    """Yield the changes that cut off moves or start a handler, each with the lines of these moves and the handler."""
    units = {
        f"{each.channel} {each.number}": unit.title for unit in structure.units for each in unit.triggers
    }
    transitions = [each for node in exploration.nodes for each in node.transitions]
    usual = {line for each in transitions if not _in_move(each) for line in _cut_off(each)}
    found: dict[Change, set[int]] = defaultdict(set)
    for each in transitions:
        for one in _in_move(each):
            cut = set(_cut_off(each)) - usual
            if cut:
                found[Change(one.table, one.number, one.value)] |= cut
    for one, cut in sorted(found.items(), key=lambda pair: (pair[0].table, pair[0].number, pair[0].value)):
        unit = units.get(one.subject)
        yield names.change(one), f"cuts off moves of {_lines(cut)}{f' by {unit}' if unit else ''}"


def _in_move(transition: Transition) -> Iterable[Change]:
    """Return the changes of a transition that come in the middle of a move."""
    return [each for each in transition.causes if each.moment.line]


def _cut_off(transition: Transition) -> Iterator[int]:
    return (line for line, ended in transition.does.moves if ended)


def _on_in_motion(run: Run, beside: Iterable[int]) -> dict[int, set[int]]:
    """Return the lines of the moves in which each output is on that the work switches."""
    log, aside = run.machine.log, set(beside)
    moves = [
        (each.start_time, each.start_time + each.profile.duration, each.line)
        for each in log.moves
        if each.profile is not None and each.profile.duration < inf
    ]
    switched: dict[int, list[tuple[float, bool]]] = defaultdict(list)
    for each in log.outputs:
        if each.at not in aside:
            switched[each.channel].append((each.time, bool(each.value)))
    found: dict[int, set[int]] = {}
    for channel, changes in switched.items():
        spans = [
            (begin, end)
            for (begin, level), (end, _) in zip(changes, [*changes[1:], (run.time, False)], strict=True)
            if level
        ]
        at = {
            line for on, off in spans for begin, end, line in moves if min(off, end) - max(on, begin) > SHORT
        }
        if at:
            found[channel] = at
    return found


def _lines(lines: Collection[int]) -> str:
    return f"line{'s' if len(lines) > 1 else ''} {ranges(lines)}"
