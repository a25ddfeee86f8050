"""Cautions before a program is changed: what starts the cycle, what cuts off moves, alarms, outputs, endless waits.

An input cuts off a move if the exploration has seen it: the input changed in the middle of the move. Outputs are those
of the run in the likeliest world. A wait has no time-out if nothing came by itself while it lasted.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from math import inf

from motionlang.commands.map.names import ReaderNames
from motionlang.exploration import Change, Exploration, is_wrong
from motionlang.kernel import Run
from motionlang.kernel.lang import Structure
from motionlang.kernel.tools import ranges

# An output that is on for less than this in a motion only follows or precedes it, s.
SHORT = 1e-3
# So many alarms are shown, and so many causes of one and of its reset.
MAX_ALARMS, MAX_CAUSES = 8, 2

Changes = tuple[Change, ...]


@dataclass(eq=False, slots=True)
class CautionRow:
    """A caution: its kind, the channel or "waits", and what it does, with its lines in words."""

    kind: str
    what: str
    why: str


def cautions(exploration: Exploration, structure: Structure, names: ReaderNames) -> list[CautionRow]:
    """Return the cautions of a machine."""
    rows = list(_start(exploration, names))
    rows += [CautionRow("stops", what, why) for what, why in _stops(exploration, structure, names)]
    rows += _alarms(exploration, names)
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


def _start(exploration: Exploration, names: ReaderNames) -> Iterator[CautionRow]:
    """Yield the last changes before the first move of the cycle."""
    causes: Collection[Change] = ()
    for each in exploration.world.cycle.transitions * 2:
        causes = each.causes or causes
        if causes and each.does.moves:
            what = " and ".join(map(names.of, causes))
            yield CautionRow("starts", what, f"start{'s' if len(causes) == 1 else ''} the cycle")
            return


def _alarms(exploration: Exploration, names: ReaderNames) -> Iterator[CautionRow]:
    """Yield what says that something is wrong, with the fewest changes that bring it, and what goes on from there."""
    nodes = {node.state: node for node in exploration.nodes}
    found: dict[str, tuple[list[float], list[Changes], list[Changes]]] = {}
    for each in (each for node in exploration.nodes for each in node.transitions):
        last = {act.subject: act.words for act in each.acts if act.subject in names.alarms}
        signs = [names[subject] for subject, words in last.items() if words == "on"]
        signs += (act.words for act in each.acts if not act.subject and is_wrong(act.words))
        if signs:
            after, causes, resets = found.setdefault(" and ".join(dict.fromkeys(signs)), ([], [], []))
            after += [each.seconds] * each.is_by_itself
            causes += [each.causes] * (not each.is_by_itself)
            ways = (
                nodes[each.target].transitions if each.target in nodes and each.target != each.source else ()
            )
            resets += (way.causes for way in ways if not way.is_by_itself)
    for what, (after, causes, resets) in list(found.items())[:MAX_ALARMS]:
        times = [f"after {min(after):.3g} s"] if after else []
        by = " or ".join([*times, *(f"by {each}" for each in _fewest(causes, names))])
        back = " or ".join(_fewest(resets, names))
        yield CautionRow("alarm", what, f"comes {by}{f', and ends by {back}' if back else ''}")


def _fewest(changes: Iterable[Changes], names: ReaderNames) -> list[str]:
    """Return some changes in words, but for those with others of them and more."""
    found: list[Changes] = []
    for each in sorted(changes, key=len):
        if not any(set(other) <= set(each) for other in found):
            found.append(each)
    return [" and ".join(map(names.of, each)) for each in found[:MAX_CAUSES]]


def _stops(exploration: Exploration, structure: Structure, names: ReaderNames) -> Iterator[tuple[str, str]]:
    """Yield the changes that cut off moves, each with the lines of these moves and the handler that it starts."""
    units = {
        f"{each.channel} {each.number}": unit.title for unit in structure.units for each in unit.triggers
    }
    cut_off = exploration.cut_off()
    channels: dict[str, list[Change]] = defaultdict(list)
    for one in sorted(cut_off, key=lambda each: (each.table, each.number, each.value)):
        channels[one.subject].append(one)
    for subject, (first, *others) in channels.items():
        cuts = [f"cuts off moves of {_lines(cut_off[first])}"]
        cuts += [
            f"{names.of(one).removeprefix(names[subject]).strip()} those of {_lines(cut_off[one])}"
            for one in others
        ]
        yield names.of(first), f"{', '.join(cuts)}{f' by {units[subject]}' if subject in units else ''}"


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
