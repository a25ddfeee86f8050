"""Cautions before a program is changed: what starts the cycle, what cuts off moves, alarms, endless waits.

An input cuts off a move if the exploration has seen it: the input changed in the middle of the move. A wait has no
time-out if nothing came by itself while it lasted.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from motionlang.kernel.lang import Statement, Structure
from motionlang.kernel.tools import ranges
from motionlang_explore.exploration import Change, Exploration
from motionlang_explore.map.alarms import Alarm, alarms_of, in_row
from motionlang_explore.map.ends import Ends, Steps
from motionlang_explore.map.faults import SAID
from motionlang_explore.map.guards import Guards
from motionlang_explore.map.names import ReaderNames
from motionlang_explore.map.starts import starts_of
from motionlang_explore.map.stops import Stops

# In the form of a statement: a variable, one that counts the time, and the time.
_NAME, _CLOCK, _TIME = re.compile(r"~(\w+)"), re.compile(r"~(\w+) TypeName ~time"), re.compile(r"\bTIME\b")


@dataclass(eq=False, slots=True)
class CautionRow:
    """A caution: its kind, the channel or "waits", and what it does, with its lines in words."""

    kind: str
    what: str
    why: str


def cautions(exploration: Exploration, structure: Structure, names: ReaderNames) -> list[CautionRow]:
    """Return the cautions of a machine."""
    guards = Guards(structure)
    rows = list(_start(exploration, names))
    alarms, stops, left = alarms_of(exploration, structure, names, guards)
    has_moves = exploration.axes or exploration.world.run.machine.log.moves
    if stops.places or (exploration.channels and has_moves):
        rows += _stops(exploration, structure, names, stops)
    rows += _alarms(exploration, structure, names, alarms)
    if left:
        what = ", ".join(_rows(left, names))
        rows.append(
            CautionRow(
                "alarm", "whether the machine stops, or anything else comes,", f"by {what} was not played"
            )
        )
    forms = (each.form for each in structure.statements.values())
    clocks = {each for form in forms for each in _CLOCK.findall(form)}
    rests = (node for node in exploration.nodes if all(each.causes for each in node.transitions))
    rested = {at for node in rests for place in node.state or () for at in place.statements}
    waits = {
        structure.line(at)
        for at in rested | stops.waits
        if guards.waits(at) and not _has_clock(structure.statements[at], clocks)
    }
    return [*rows, CautionRow("waits", "waits", f"of {_lines(waits)} have no time-out")] if waits else rows


def _has_clock(statement: Statement, clocks: Collection[str]) -> bool:
    """True if a statement reads the time, or a variable that counts it."""
    return bool(_TIME.search(statement.form)) or not set(clocks).isdisjoint(_NAME.findall(statement.form))


def _start(exploration: Exploration, names: ReaderNames) -> Iterator[CautionRow]:
    """Yield what starts the cycle, with what else it needs and was played with."""
    starts = starts_of(exploration, names)
    if starts is None:
        return
    what = " and ".join(map(names.of, starts.by)) or "power-up"
    why = f" with {_listed(starts.held, names)}" if starts.held else ""
    following = ", ".join(names[each.subject] for each in starts.following)
    played = [f"with {following} behind an output or an axis"] if following else []
    played += [f"with {_listed(starts.others, names)}"] if starts.others else []
    why += f"; played {' and '.join(played)}" if played else ""
    left = ", ".join(names[each.subject] for each in starts.left)
    why += f"; whether it needs {left} was not played" if left else ""
    yield CautionRow("starts", what, f"start{'' if len(starts.by) > 1 else 's'} the cycle{why}")


def _listed(changes: Iterable[Change], names: ReaderNames) -> str:
    """Return changes in words, the names of the inputs that come on first."""
    on = [names[each.subject] for each in changes if each.table == "input" and each.value]
    return ", ".join(
        [f"{', '.join(on)} on"] * bool(on)
        + [names.of(each) for each in changes if not (each.table == "input" and each.value)]
    )


def _alarms(
    exploration: Exploration, structure: Structure, names: ReaderNames, alarms: Sequence[Alarm]
) -> Iterator[CautionRow]:
    """Yield what says that something is wrong or is said only where the cycle is left, why, and what ends it."""
    statements = structure.statements
    ends = Ends(
        exploration,
        [statements[sign.at] for each in alarms if each.is_trouble for sign in (*each.signs, *each.lamps)],
        names,
    )
    for each in sorted(alarms, key=lambda one: not one.is_trouble):
        what, back = each.what(names), ""
        if each.is_trouble and each.ends:
            said = [sign.what for sign in each.signs if sign.kind == SAID]
            end = ends.of(
                [statements[sign.at] for sign in (*each.signs, *each.lamps)], each.why, said, each.begins
            )
            it = "" if " or " not in each.why else "as it was played, it "
            if end is None and not each.is_rare:
                back = "; what ends it was not played"
            elif end is not None and end.steps:
                again = ", and comes again if nothing else changes" if end.comes_again else ""
                again += f", and comes again without {_joined((end.keeps,), names)}" if end.keeps else ""
                back = f"; {it}ends by {_joined(end.steps, names)}{again}"
        is_said = not each.is_trouble and all(sign.kind == SAID for sign in each.signs)
        verb = ("are printed", "is printed") if is_said else ("come", "comes")
        why = f"{verb[len(what) < 2]} {each.why}{' (not played)' if each.is_unplayed else ''}"
        yield CautionRow("alarm" if each.is_trouble else "said", " and ".join(what), why + back)


def _joined(steps: Steps, names: ReaderNames) -> str:
    return ", then ".join(" and ".join(map(names.of, step)) for step in steps)


def _stops(
    exploration: Exploration, structure: Structure, names: ReaderNames, stops: Stops
) -> Iterator[CautionRow]:
    """Yield what cuts off moves, with their lines and the handler, and what stops the machine between its moves."""
    cut_off = exploration.cut_off()
    for change, lines in stops.cuts.items():
        cut_off.setdefault(change, set()).update(lines)
    yield from _cuts(cut_off, structure, names)
    ways = (each for node in exploration.nodes for each in node.transitions)
    if not cut_off and not any(ended for each in ways for _, ended in each.does.moves):
        yield CautionRow("stops", "nothing that was played", "cuts off a move to a target")
    found: dict[str, list[Change]] = defaultdict(list)
    for change, place in stops.places:
        if change not in cut_off:
            found[place].append(change)
    for place, changes in found.items():
        what = " or ".join(_rows(changes, names))
        yield CautionRow("stops", what, f"in the move of line {stops.move} stops the machine {place}")


def _rows(changes: Iterable[Change], names: ReaderNames) -> list[str]:
    """Return changes in words, those of one channel together."""
    ordered = sorted(changes, key=lambda each: each.channel)
    return [in_row(list(own), names) for _, own in groupby(ordered, key=lambda each: each.channel)]


def _cuts(
    cut_off: Mapping[Change, Collection[int]], structure: Structure, names: ReaderNames
) -> Iterator[CautionRow]:
    units = {
        f"{each.channel} {each.number}": unit.title for unit in structure.units for each in unit.triggers
    }
    channels: dict[str, list[Change]] = defaultdict(list)
    for one in sorted(cut_off, key=lambda each: (each.table, each.number, each.value)):
        channels[one.subject].append(one)
    found: dict[str, list[str]] = defaultdict(list)
    for subject, (first, *others) in channels.items():
        cuts = [f"cuts off moves of {_lines(cut_off[first])}"]
        cuts += [
            f"{names.of(one).removeprefix(names[subject]).strip()} those of {_lines(cut_off[one])}"
            for one in others
        ]
        found[", ".join(cuts) + (f" by {units[subject]}" if subject in units else "")].append(names.of(first))
    yield from (CautionRow("stops", " or ".join(changes), cuts) for cuts, changes in found.items())


def _lines(lines: Collection[int]) -> str:
    return f"line{'s' if len(lines) > 1 else ''} {ranges(lines)}"
