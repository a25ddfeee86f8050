"""Inputs by the position of an axis, in the middle of moves or while it jogs, and what answers when it is asked."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from math import inf

from motionlang.kernel import Axis
from motionlang_explore.exploration.changes import Change, Moment, entries, tables_of
from motionlang_explore.exploration.states import DELAY
from motionlang_explore.exploration.trials import Trial, TrialMotion
from motionlang_explore.identification import Entry, place

# So many marks are on the way of an axis that goes on and on, and positions are the same within this, uu.
MARKS, SAME = 300, 0.01
Axes = Mapping[int, Axis]


def along(trial: Trial, axes: Axes) -> dict[int, Entry]:
    """Return the entries by the position of an axis for inputs that come in the middle of moves, or while one jogs.

    A change that was found in a move may come at another time of the played run, when the axis is at rest.
    """
    changes: dict[int, list[tuple[float, Moment]]] = defaultdict(list)
    for time, each in trial.timeline:
        if each.table == "input" and each.value:
            changes[each.number].append((time, each.moment))
    found: dict[int, Entry] = {}
    for number, moments in changes.items():
        passing = [(move, *each) for each in moments if (move := _passing(trial, axes, *each)) is not None]
        if not passing:
            continue
        move, time, (_, _, _, times, every) = passing[0]
        a = axes[move.axis]
        begins = [place(a, each.begin) for each, _, _ in passing if each.line == move.line]
        end = place(a, time + every / 2 if every else (time + min(move.end, time + 1.0)) / 2)
        between = [round(each, 2) for each in sorted((place(a, time), end))]
        entry: Entry = {"channel": number, "axis": move.axis, "between": between}
        if between[0] == between[1] and not every:  # it has cut the move off
            edge = "above" if place(a, time) > place(a, move.begin) else "below"
            entry = {"channel": number, "axis": move.axis, edge: between[0]}
        elif move.end == inf:  # a jog: as far as it goes
            entry |= {"every": round(abs(place(a, time + every) - place(a, time)), 2), "times": MARKS}
        elif max(begins) - min(begins) > SAME:
            entry |= {"every": round((begins[1] - begins[0]) / times, 2), "times": MARKS}
        elif times > 1:
            entry |= {"every": round((place(a, move.end) - begins[0]) / times, 2), "times": times}
        every_uu: float = entry.get("every", between[1] - between[0] + SAME)  # type: ignore[assignment]
        if every_uu > between[1] - between[0]:  # a mark ends before the next one
            found[number] = entry
    return found


def beyond(trial: Trial, axes: Axes) -> dict[int, Entry]:
    """Return the entries by the position of an axis for inputs that come on while it jogs: beyond it, or at steps."""
    moves = [
        (time, each, _jogging(trial, axes, time)) for time, each in trial.timeline if each.table == "input"
    ]
    found: dict[int, Entry] = {}
    for number in sorted({each.number for _, each, move in moves if each.value and move is not None}):
        on = [(time, move) for time, each, move in moves if each.number == number and each.value]
        off = [
            time for time, each, _ in moves if each.number == number and not each.value and time > on[0][0]
        ]
        (time, move), *others = on
        if move is None or not off:
            continue
        a = axes[move.axis]
        first, middle = place(a, time), (place(a, time) + place(a, off[0])) / 2
        step = round(abs(place(a, others[0][0]) - first), 2) if others else 0.0
        entry: Entry = {"channel": number, "axis": move.axis}
        if step > abs(middle - first):
            between = [round(each, 2) for each in sorted((first, middle))]
            found[number] = {**entry, "between": between, "every": step, "times": MARKS}
        else:
            found[number] = {**entry, "above" if first > place(a, move.begin) else "below": round(first, 2)}
    return found


def _jogging(trial: Trial, axes: Axes, time: float) -> TrialMotion | None:
    """Return the motion without an end of its own in which a time lies."""
    begun = [each for each in trial.moves if each.begin <= time and each.end == inf]
    return begun[-1] if begun and axes[begun[-1].axis].velocity(time) else None


def _passing(trial: Trial, axes: Axes, time: float, moment: Moment) -> TrialMotion | None:
    """Return the move in whose middle an input comes: that of a line, or a jog in which it comes again and again."""
    for each in reversed(trial.moves):
        is_jog = moment.every and not moment.line and axes[each.axis].velocity(time)
        if each.begin <= time < each.end and (is_jog if each.end == inf else moment.line == each.line):
            return each
    return None


def answers(trial: Trial) -> dict[str, list[Entry]]:
    """Return the entries by which levels, numbers and keys that a trial changes come when they are asked for."""
    firsts: dict[tuple[object, ...], Change] = {}
    for _, each in trial.timeline:
        if each.table not in ("input", "answer") and (each.value or each.table != "analogue"):
            firsts.setdefault((*each.channel, each.value) if each.table == "key" else each.channel, each)
    found: dict[str, list[Entry]] = defaultdict(list)
    for each in firsts.values():
        entry = {**entries(tables_of(((0.0, each),)), each.table)[0], "asked": DELAY}
        del entry["at"]
        found[each.table].append(entry)
    return dict(found)
