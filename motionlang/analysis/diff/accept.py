"""The individual changes between two reports, and a report with some of them.

A change is one that a person can accept or reject: the moves of one line that have changed equally, moves
that were inserted or removed together, a printed line, an event, an error, a field. Consequences of changes
are not changes: moves, events and the end of the run shift with the accepted changes before them.
"""

from __future__ import annotations

from bisect import bisect_right
from math import inf
from typing import Any

from motionlang.analysis.diff.reports import Difference, LineChange, end_of
from motionlang.analysis.diff.timeline import Timeline
from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection, Iterator

    from motionlang.analysis.diff.reports import Move, Pair, Report


@record
class Change:
    """One change: its `kind`, and its number in `Difference`."""

    kind: str
    what: Any

    @property
    def key(self) -> tuple[str, object]:
        """The key that identifies the change within a difference."""
        return self.kind, id(self.what) if isinstance(self.what, LineChange) else self.what


def changes(found: Difference) -> list[Change]:
    """Return all changes in the order of their report; empty if there is none."""
    made = [Change("status", "")] if found.status is not None else []
    by_time = sorted(found.lines, key=lambda each: (-abs(each.duration + each.wait), each.new, each.axis))
    made += [Change("line", each) for each in by_time]
    made += [Change("moves", number) for number in dict.fromkeys(found.hunks.values())]
    made += [Change("end", "")] if found.tail else []
    for kind, pairs in (("print", found.prints), ("event", found.events), ("error", found.errors)):
        made += [Change(kind, n) for n in range(len(pairs))]
    return made + [Change("field", name) for name in found.fields]


def merged(old: Report, new: Report, found: Difference, accepted: Collection[Change]) -> dict[str, Any]:
    """Return the old report with the accepted changes applied."""
    keys = {change.key for change in accepted}
    line = Timeline()
    moves, shifts = _moves(old, new, found, keys, line)
    made = dict(old)
    made["moves"] = moves
    _, made["time"] = line.pair(end_of(old), end_of(new), None, ("end", "") in keys)
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
        olds, news = shifts
        rows = [
            {**row, "time": row["time"] + _shift(olds if side == 0 else news, row["time"])}
            for side, row in _sided(
                old.get("events", []), new.get("events", []), found.happened, _numbers(keys, "event")
            )
        ]
        made["events"] = rows
    for name in found.fields:
        if ("field", name) in keys:
            made.pop(name, None)
            if name in new:
                made[name] = new[name]
    return {name: made[name] for name in dict.fromkeys((*new, *old)) if name in made}


def _moves(
    old: Report, new: Report, found: Difference, keys: set[tuple[str, object]], line: Timeline
) -> tuple[list[Move], tuple[list[tuple[float, float]], list[tuple[float, float]]]]:
    """Return the moves of the merged report, and the time shifts of both sides.

    The shifts have, for old and new, the shift of each begin and end by its time.
    """
    was, is_ = old.get("moves", []), new.get("moves", [])
    made: list[Move] = []
    shifts: tuple[list[tuple[float, float]], list[tuple[float, float]]] = ([], [])
    for i, j, change in found.pairs:
        if i is not None and j is not None:
            accepted = change is not None and ("line", id(change)) in keys
            row = is_[j] if accepted else was[i]
            _, begin = line.pair(was[i], is_[j], row, accepted)
            sides = ((0, was[i]), (1, is_[j]))
        else:
            side, row = (0, was[i]) if i is not None else (1, is_[j])
            in_merged = (("moves", found.hunks[i, j]) in keys) is (side == 1)
            begin = line.alone(row, side, in_merged)
            if not in_merged:
                continue
            sides = ((side, row),)  # type: ignore[assignment]
        made.append({**row, "start_time": begin})
        over = begin + (row["duration"] or 0.0)
        for side, each in sides:
            shifts[side].append((each["start_time"], begin - each["start_time"]))
            end = each["start_time"] + (each["duration"] or 0.0)
            shifts[side].append((end, over - end))
    for each in shifts:
        each.sort()
    return made, shifts


def _shift(shifts: list[tuple[float, float]], time: float) -> float:
    """Return the shift at a time, which is that of the last begin or end before."""
    index = bisect_right(shifts, (time + 1e-9, inf))
    return shifts[index - 1][1] if index else 0.0


def _numbers(keys: set[tuple[str, object]], kind: str) -> set[object]:
    return {what for each, what in keys if each == kind}


def _chosen(old: list[Any], new: list[Any], pairs: list[Pair], accepted: set[object]) -> Iterator[Any]:
    for _, row in _sided(old, new, pairs, accepted):
        yield row


def _sided(
    old: list[Any], new: list[Any], pairs: list[Pair], accepted: set[object]
) -> Iterator[tuple[int, Any]]:
    """Yield the entries of the merged list in order, with 1 for new ones, 0 for old.

    Equal entries count as new.
    """
    for i, j, number in pairs:
        take = number is None or number in accepted
        if take and j is not None:
            yield 1, new[j]
        elif not take and i is not None:
            yield 0, old[i]
