"""The rows of a recording in the order of their times.

Loggers write the newest row first, swap neighbours that came over a network, repeat rows, begin at 0 again when they
are restarted, and count whole seconds. All of it shows in the times alone: a row that is a little late is sorted, and
one that is late by many rows, or comes after a long pause, begins another stretch. The longest stretch is read.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.commands.recording.table import warning
from motionlang.kernel import Diagnostic
from motionlang.kernel.tools import count_of, listed

Array = NDArray[np.float64]
Rows = NDArray[np.int64]

# A row is sorted if it is late by less than so many usual steps.
FAR = 16.0
# So many times as long as all rows take together, and longer than this, s, is a pause between two recordings.
PAUSE, MIN_PAUSE = 10.0, 60.0
# More stretches than this, of fewer rows than this each, are rows in no order.
MAX_STRETCHES, MIN_STRETCH = 8, 16
# The newest row comes first if this share of the steps goes backwards.
BACKWARDS = 0.9
# A clock is coarse if so many rows have the same time, or two that differ.
COARSE = 3


class OrderedRows(NamedTuple):
    """The rows that are used, in order, and their increasing times."""

    rows: Rows
    times: Array
    remarks: list[Diagnostic]


def ordered(times: Array, lines: Rows, is_same: Callable[[int, int], bool]) -> OrderedRows:
    """Return the rows of a recording in order of time; `is_same` is true if two rows have the same cells."""
    remarks: list[Diagnostic] = []
    rows = np.flatnonzero(np.isfinite(times))
    rows = _oldest_first(rows, times, lines, remarks)
    rows = _in_line(rows, times, lines, remarks)
    rows = _sorted(_stretch(rows, times, lines, remarks), times, lines, remarks)
    return _apart(rows, times[rows], lines, is_same, remarks)


def _oldest_first(rows: Rows, times: Array, lines: Rows, remarks: list[Diagnostic]) -> Rows:
    steps = np.diff(times[rows])
    back = steps < 0.0
    if back.sum() >= 2 and back.sum() > BACKWARDS * np.count_nonzero(steps):
        remarks.append(warning("the newest row comes first: read from the last line", int(lines[rows[0]])))
        return rows[::-1]
    return rows


def _in_line(rows: Rows, times: Array, lines: Rows, remarks: list[Diagnostic]) -> Rows:
    """Return rows without those whose time is far from that of both neighbours, which are close to each other."""
    if len(rows) < 3:
        return rows
    found = times[rows]
    far = FAR * _usual(found)
    before, here, after = found[:-2], found[1:-1], found[2:]
    off = (np.abs(after - before) <= far / 2) & (np.abs(here - before) > far) & (np.abs(here - after) > far)
    wrong = np.append(np.append(False, off), False)
    if wrong.any():
        first = int(lines[rows[np.flatnonzero(wrong)[0]]])
        remarks.append(
            warning(f"{count_of(int(wrong.sum()), 'row')} with a time that is out of line, left out", first)
        )
    return np.asarray(rows[~wrong])


def _usual(times: Array) -> float:
    steps = np.abs(np.diff(times))
    return float(np.median(steps[steps > 0.0])) if (steps > 0.0).any() else 0.0


def _sorted(rows: Rows, times: Array, lines: Rows, remarks: list[Diagnostic]) -> Rows:
    late = np.flatnonzero(np.diff(times[rows]) < 0.0)
    if not len(late):
        return rows
    line = int(lines[rows[late[0] + 1]])
    remarks.append(warning(f"{count_of(len(late), 'row')} out of order, sorted by time", line))
    return rows[np.argsort(times[rows], kind="stable")]


def _stretch(rows: Rows, times: Array, lines: Rows, remarks: list[Diagnostic]) -> Rows:
    """Return the longest stretch in which time goes on."""
    stretches, reason = _stretches(times[rows])
    if len(stretches) > MAX_STRETCHES and len(rows) < MIN_STRETCH * len(stretches):
        rows = _sorted(rows, times, lines, remarks)
        stretches, reason = _stretches(times[rows])
    if len(stretches) == 1:
        return rows
    first, last = max(stretches, key=lambda edge: edge[1] - edge[0])
    remarks.append(
        warning(
            f"{reason}: {len(stretches)} stretches, of {_listed([b - a for a, b in stretches])} rows",
            int(lines[rows[stretches[1][0]]]),
            f"only the longest is read, lines {_range(lines[rows[first:last]])}; cut the file to read another one",
        )
    )
    return rows[first:last]


def _stretches(times: Array) -> tuple[list[tuple[int, int]], str]:
    """Return the stretches of rows in which time goes on, and why the first one ends."""
    usual = _usual(times)
    pause = max(MIN_PAUSE, PAUSE * usual * len(times))
    edges, latest, reason = [0], -np.inf, ""
    for k, time in enumerate(times.tolist()):
        is_again, is_paused = time < latest - FAR * usual, k > 0 and time > latest + pause
        if is_again or is_paused:
            edges.append(k)
            reason = reason or ("time starts again" if is_again else f"no rows for {time - latest:.3g} s")
            latest = time
        latest = max(latest, time)
    return list(pairwise([*edges, len(times)])), reason


def _listed(counts: Sequence[int]) -> str:
    """Return counts as text, the first of many."""
    return f"{listed(counts[:MAX_STRETCHES])}{' …' if len(counts) > MAX_STRETCHES else ''}"


def _range(lines: Sequence[int] | Rows) -> str:
    return f"{min(lines)} to {max(lines)}"


def _apart(
    rows: Rows, times: Array, lines: Rows, is_same: Callable[[int, int], bool], remarks: list[Diagnostic]
) -> OrderedRows:
    """Return rows with different times: doubled ones are left out, those of a coarse clock are spread."""
    if len(rows) < 2:
        return OrderedRows(rows, times, remarks)
    starts = np.flatnonzero(np.append(True, np.diff(times) > 0.0))
    counts = np.diff(np.append(starts, len(rows)))
    shared = len(rows) - len(starts)
    if not shared:
        return OrderedRows(rows, times, remarks)
    repeats = np.setdiff1d(np.arange(len(rows)), starts)
    doubled = [int(k) for k in repeats if is_same(int(rows[k - 1]), int(rows[k]))]
    usual = float(np.median(counts))
    first = int(lines[rows[repeats[0]]])
    if usual >= COARSE or (usual >= 2.0 and len(doubled) < shared):
        if len(starts) < 2:
            return OrderedRows(rows[:1], times[:1], remarks)
        tick = float(np.median(np.diff(times[starts])))
        name = "whole seconds" if tick == 1.0 else f"steps of {tick:.6g} s"
        remarks.append(
            warning(
                f"the clock has {name}: {shared} of {count_of(len(rows), 'row')} share their time with another one",
                first,
                "they are spread evenly: times are known to a row, not better; record a finer clock",
            )
        )
        return OrderedRows(rows, _spread(times, starts, counts, tick), remarks)
    others = shared - len(doubled)
    if doubled:
        line = int(lines[rows[doubled[0]]])
        remarks.append(warning(f"{count_of(len(doubled), 'row')} doubled, left out", line))
    if others:
        text = f"{count_of(others, 'row')} at the time of the row before: the last one counts"
        remarks.append(warning(text, first))
    last = np.append(np.diff(times) > 0.0, True)
    return OrderedRows(rows[last], times[last], remarks)


def _spread(times: Array, starts: Rows, counts: Rows, tick: float) -> Array:
    """Return times with the rows of each tick of the clock spread evenly up to the next one."""
    made = times.copy()
    usual = tick / float(np.median(counts[1:-1] if len(counts) > 2 else counts))
    for k, (start, count) in enumerate(zip(starts.tolist(), counts.tolist(), strict=True)):
        step = usual if k in (0, len(starts) - 1) else min(tick, times[starts[k + 1]] - times[start]) / count
        step = min(step, tick / count)
        # The first tick may have begun before the first row.
        offset = tick - step * count if k == 0 and times[starts[1]] - times[0] <= tick else 0.0
        made[start : start + count] += offset + step * np.arange(count)
    return made
