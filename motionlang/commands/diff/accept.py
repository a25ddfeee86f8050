"""The individual changes between two reports, and a report with some of them.

A change is one that a person can accept or reject: the moves of one line that have changed equally, moves
that were inserted or removed together, a printed line, an event, an error, a field. Consequences of changes
are not changes: moves, events and the end of the run shift with the accepted changes before them.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from math import inf
from typing import Any

from motionlang.commands.diff.reports import Difference, LineChange, Move, Pair, Report, end_of
from motionlang.commands.diff.timeline import NEAR, Timeline

# A begin or end of a move in its run: its time, its shift in the merged run, and whether that has this move.
Shift = tuple[float, float, bool]
Shifts = tuple[list[Shift], list[Shift]]


@dataclass(eq=False, slots=True)
class AcceptedChange:
    """One change: its `kind`, and its number in `Difference`."""

    kind: str
    what: Any

    @property
    def key(self) -> tuple[str, object]:
        """The key that identifies the change within a difference."""
        return self.kind, id(self.what) if isinstance(self.what, LineChange) else self.what


def changes(found: Difference) -> list[AcceptedChange]:
    """Return all changes in the order of their report; empty if there is none."""
    made = [AcceptedChange("status", "")] if found.status is not None else []
    by_time = sorted(found.lines, key=lambda each: (-abs(each.duration + each.wait), each.new, each.axis))
    made += [AcceptedChange("line", each) for each in by_time]
    made += [AcceptedChange("moves", number) for number in dict.fromkeys(found.hunks.values())]
    made += [AcceptedChange("end", "")] if found.tail else []
    for kind, pairs in (("print", found.prints), ("event", found.events), ("error", found.errors)):
        made += [AcceptedChange(kind, n) for n in range(len(pairs))]
    return made + [AcceptedChange("field", name) for name in found.fields]


def merged(
    old: Report, new: Report, found: Difference, accepted: Collection[AcceptedChange]
) -> dict[str, Any]:
    """Return the old report with the accepted changes applied."""
    keys = {change.key for change in accepted}
    line = Timeline()
    moves, shifts = _moves(old, new, found, keys, line)
    made = dict(old)
    made["moves"] = moves
    _, made["time"] = line.pair(end_of(old), end_of(new), None, _ends_like_new(found, keys))
    if ("status", "") in keys:
        made["status"] = new.get("status")
    made["output"] = list(
        _chosen(old.get("output", []), new.get("output", []), found.printed, _numbers(keys, "print"))
    )
    made["diagnostics"] = list(
        _chosen(
            old.get("diagnostics", []), new.get("diagnostics", []), found.reported, _numbers(keys, "error")
        )
    )
    if "events" in old or "events" in new:
        made["events"] = list(_events(old, new, found, _numbers(keys, "event"), shifts))
    for name in found.fields:
        if ("field", name) in keys:
            made.pop(name, None)
            if name in new:
                made[name] = new[name]
    return {name: made[name] for name in dict.fromkeys((*new, *old)) if name in made}


def _ends_like_new(found: Difference, keys: set[tuple[str, object]]) -> bool:
    """True if the merged run goes on after its last motion as long as the new run.

    If both runs take the same time, their ends are no change: then it does if all changes of motion are accepted.
    """
    if found.tail:
        return ("end", "") in keys
    return all(each.key in keys for each in changes(found) if each.kind in ("line", "moves"))


def _moves(
    old: Report, new: Report, found: Difference, keys: set[tuple[str, object]], line: Timeline
) -> tuple[list[Move], Shifts]:
    """Return the moves of the merged report, and the time shifts of both sides."""
    was, is_ = old.get("moves", []), new.get("moves", [])
    made: list[Move] = []
    shifts: Shifts = ([], [])
    for i, j, change in found.pairs:
        if i is not None and j is not None:
            accepted = change is not None and ("line", id(change)) in keys
            row = is_[j] if accepted else was[i]
            _, begin = line.pair(was[i], is_[j], row, accepted)
            sides = ((0, was[i], not accepted), (1, is_[j], accepted or change is None))
        else:
            side, row = (0, was[i]) if i is not None else (1, is_[j])
            in_merged = (("moves", found.hunks[i, j]) in keys) is (side == 1)
            begin = line.alone(row, side, in_merged)
            if not in_merged:
                continue
            sides = ((side, row, True),)  # type: ignore[assignment]
        made.append({**row, "start_time": begin})
        over = begin + (row["duration"] or 0.0)
        for side, each, is_taken in sides:
            end = each["start_time"] + (each["duration"] or 0.0)
            shifts[side].append((each["start_time"], begin - each["start_time"], is_taken))
            shifts[side].append((end, over - end, is_taken))
    for each in shifts:
        each.sort()
    return made, shifts


def _events(
    old: Report, new: Report, found: Difference, accepted: set[object], shifts: Shifts
) -> Iterator[Move]:
    """Yield the events of the merged report; equal ones come with their motion."""
    olds, news = old.get("events", []), new.get("events", [])
    for i, j, number in found.happened:
        was, is_ = None if i is None else olds[i], None if j is None else news[j]
        takes_new, stays = number in accepted, False
        if number is None and was is not None and is_ is not None:
            takes_new = _last(shifts[1], is_["time"])[1]
            stays = abs(is_["time"] - was["time"]) < NEAR  # such as an event of a timer
        row = is_ if takes_new else was
        if row is not None:
            shift = 0.0 if stays else _last(shifts[takes_new], row["time"])[0]
            yield {**row, "time": row["time"] + shift}


def _last(shifts: list[Shift], time: float) -> tuple[float, bool]:
    """Return the shift of the last begin or end up to a time, and whether it is taken."""
    index = bisect_right(shifts, (time + NEAR, inf, True))
    return shifts[index - 1][1:] if index else (0.0, True)


def _numbers(keys: set[tuple[str, object]], kind: str) -> set[object]:
    return {what for each, what in keys if each == kind}


def _chosen(old: list[Any], new: list[Any], pairs: list[Pair], accepted: set[object]) -> Iterator[Any]:
    """Yield the entries of the merged list in order; equal entries count as new."""
    for i, j, number in pairs:
        take = number is None or number in accepted
        if take and j is not None:
            yield new[j]
        elif not take and i is not None:
            yield old[i]
