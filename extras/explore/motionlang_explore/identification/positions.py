"""The regions of an axis in which an input is active."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, pairwise
from math import fsum, inf
from statistics import fmean
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.tools import count_of
from motionlang_explore.identification import (
    MISSED,
    PLACES,
    SEEN,
    Digital,
    Entry,
    MeasuredFigure,
    MeasuredRule,
    Observation,
    figure_of,
)

Array = NDArray[np.float64]

# An input follows a position if this share of its changes is in the middle of a move.
IN_MOVES = 0.9
# Regions of an axis at most in which an input is active, each one mark or several at equal distances.
MAX_REGIONS = 20
# The rows may have missed some marks between the first and the last, but not most.
MAX_LEFT_OUT = 2
# An axis moves above this share of its largest speed. The slope of its position has this share of noise at most, given
# by so many standard deviations; rows of a rough slope, and of the widest one.
MOVING, NOISE, ROUGH, MAX_WINDOW = 0.02, 6.0, 5, 100
# A motion of less than this share of the range is none.
LEAST = 1e-5
# The median of a second difference of noise, in standard deviations.
SECOND = 1.65


class Series(NamedTuple):
    """Sampled values of a column; those of a run are exact."""

    column: str
    times: Array
    values: Array
    is_exact: bool = False

    @property
    def _deviation(self) -> float:
        """The standard deviation of the noise."""
        return 0.0 if self.is_exact else float(np.median(np.abs(np.diff(self.values, 2)))) / SECOND

    def noise(self, times: float) -> float:
        """Return so many standard deviations of the noise, or a small share of the range."""
        return max(times * self._deviation, LEAST * float(np.ptp(self.values)))

    @property
    def window(self) -> int:
        """The number of rows to each side over which a slope shows motion above the noise."""
        if len(self.values) < 2 * ROUGH:
            return 1
        fastest = float(np.abs(self.values[ROUGH:] - self.values[:-ROUGH]).max()) / ROUGH
        most = np.ceil(NOISE * self.noise(1.0) / (MOVING * fastest)) if fastest else 1
        return int(np.clip(most, 1, MAX_WINDOW))

    def slopes(self, window: int) -> Array:
        """Return the speed of an axis at each row, between the rows so many before and after it."""
        rows = np.arange(len(self.times))
        before, after = np.maximum(rows - window, 0), np.minimum(rows + window, len(rows) - 1)
        found: Array = (self.values[after] - self.values[before]) / (self.times[after] - self.times[before])
        return found

    def least_speed(self, window: int) -> float:
        """Return the speed above which an axis moves, which no noise reaches over so many rows to each side."""
        seconds_apart = 2.0 * window * float(np.median(np.diff(self.times)))
        fastest = float(np.abs(self.slopes(window)).max())
        return max(MOVING * fastest, NOISE * self._deviation / seconds_apart)

    def rules(self, number: int, axis: int, channel: Digital, seen: Observation) -> Iterator[MeasuredRule]:
        """Yield the rules by which an input follows the position of an axis."""
        if len(channel.changes) < SEEN or not float(np.ptp(self.values)) > 0.0:
            return
        times = np.array([each.time for each in channel.changes])
        window = self.window
        speeds = self.slopes(window)
        at = np.interp(times, self.times, self.values)
        speed = np.interp(times, self.times, speeds)
        moves = np.abs(speed) > self.least_speed(window)
        if moves.mean() < IN_MOVES:
            return
        pairs = [
            (float(x), float(v), each.level)
            for x, v, each, is_moving in zip(at, speed, channel.changes, moves, strict=True)
            if is_moving and not seen.has_gap(each.time - each.within, each.time + each.within)
        ]
        fastest, usual = float(np.abs(speed).max()), float(np.median(np.abs(speed[moves])))
        tolerance = max(3.0 * seen.step, seen.reaction) * fastest + 1e-6
        for active in (1, 0):
            lows = [x for x, v, level in pairs if (level == active) == (v > 0.0)]
            highs = [x for x, v, level in pairs if (level == active) != (v > 0.0)]
            for regions in _regions(lows, highs, tolerance, seen.step * usual):
                missed = _passed(regions, active, channel, self, seen)
                keys = [each.keys for each in regions] if active else _complement(regions)
                if missed is not None and len(missed) <= MISSED * len(pairs) / 2 and keys:
                    entries = tuple({"channel": number, "axis": axis, **each} for each in keys)
                    seconds = max(each.spread for each in regions) / usual
                    texts = tuple(each.text for each in regions)
                    yield MeasuredRule(f"axis {axis}", entries, texts, len(pairs), seconds, 1, missed=missed)


class _Region(NamedTuple):
    """A region of an axis in which an input is active: the keys of its entry, and the comment on it.

    `edges` are its pairs of bounds, and `spread` is that of the measured positions, all in user units.
    """

    keys: Entry
    edges: tuple[tuple[float, float], ...]
    spread: float
    text: str


_Mark = tuple[MeasuredFigure, MeasuredFigure]


def _regions(
    lows: list[float], highs: list[float], tolerance: float, within: float
) -> Iterator[list[_Region]]:
    """Yield where an input may be active that changes at these ends: beyond one, or in marks.

    Marks are at equal distances from the first to the last one, of which the rows may have missed some, or those that
    were seen.
    """
    firsts, lasts = (
        [figure_of(each, within, "uu") for each in _groups(ends, tolerance)] for ends in (lows, highs)
    )
    if len(firsts) + len(lasts) == 1:
        (edge,) = firsts or lasts
        side = (edge.value, inf) if firsts else (-inf, edge.value)
        yield [_Region({"above" if firsts else "below": edge.value}, (side,), edge.spread, str(edge))]
    marks = [*zip(firsts, lasts, strict=False)]
    ends = [each.value for each in chain.from_iterable(marks)]
    if not marks or len(firsts) != len(lasts) or ends != sorted(ends):
        return
    steps = [b[0].value - a[0].value for a, b in pairwise(marks)]
    counts = [round((low.value - firsts[0].value) / min(steps)) if steps else 0 for low, _ in marks]
    if _line(marks, counts)[2] <= tolerance and counts[-1] < MAX_LEFT_OUT * len(marks):
        yield [_marks(marks, counts)]
    found: list[_Region] = []
    while marks:
        count = min(len(marks), 2)
        while count < len(marks) and _line(marks[: count + 1], range(count + 1))[2] <= tolerance:
            count += 1
        found.append(_marks(marks[:count], range(count)))
        marks = marks[count:]
    if 1 < len(found) <= MAX_REGIONS:
        yield found


def _complement(regions: Sequence[_Region]) -> list[Entry]:
    """Return the keys of where an input is on that is off in a region; none for several regions."""
    if len(regions) > 1 or len(regions[0].edges) > 1:
        return []
    ((low, high),) = regions[0].edges
    return [{key: end} for key, end in (("below", low), ("above", high)) if abs(end) < inf]


def _groups(values: Iterable[float], tolerance: float) -> list[list[float]]:
    """Return values in groups, so that the values of one are as close as the tolerance."""
    found: list[list[float]] = []
    for each in sorted(values):
        if found and each - found[-1][0] <= tolerance:
            found[-1].append(each)
        else:
            found.append([each])
    return found


def _line(marks: Sequence[_Mark], counts: Sequence[int]) -> tuple[float, float, float]:
    """Return the distance between marks, the position of the first one, and by how much one differs from that."""
    lows = np.array([low.value for low, _ in marks])
    every, first = np.polyfit(np.array(counts), lows, 1) if len(marks) > 1 else (0.0, lows[0])
    return float(every), float(first), float(np.abs(first + every * np.array(counts) - lows).max())


def _marks(marks: Sequence[_Mark], counts: Sequence[int]) -> _Region:
    (first, last), number = marks[0], counts[-1] + 1
    spread = max(each.spread for each in chain.from_iterable(marks))
    if number == 1:
        one = ((first.value, last.value),)
        return _Region({"between": [first.value, last.value]}, one, spread, f"{first.interval}, and {last}")
    every, at, deviation = _line(marks, counts)
    width = fmean(high.value - low.value for low, high in marks)
    between = [round(at, PLACES), round(at + width, PLACES)]
    keys: Entry = {"between": between, "every": round(every, PLACES), "times": number}
    within = max(10.0**-PLACES, deviation, first.within)
    changes = count_of(int(fsum(each.times for each in chain.from_iterable(marks))), "change")
    text = f"{at:.{PLACES}f} uu ± {within:.{PLACES}f}, every {every:.{PLACES}f} uu ({changes})"
    edges = tuple((at + k * every, at + k * every + width) for k in range(number))
    return _Region(keys, edges, spread, text)


def _passed(
    regions: Sequence[_Region], active: int, channel: Digital, path: Series, seen: Observation
) -> tuple[float, ...] | None:
    """Return when an axis was in a region without an effect; None if the input was active elsewhere."""
    inside = np.zeros(len(path.values), dtype=bool)
    for low, high in chain.from_iterable(each.edges for each in regions):
        inside |= (path.values >= low) & (path.values <= high)
    levels = np.array([channel.first, *(each.level for each in channel.changes)])
    rows = np.searchsorted([each.time for each in channel.changes], path.times, "right")
    actual = levels[rows] == active
    edges = np.flatnonzero(np.diff(np.concatenate(([False], actual != inside, [False])).astype(np.int8)))
    missed: list[float] = []
    for first, past in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        begin, end = float(path.times[first]), float(path.times[past - 1])
        if end - begin > seen.tolerance(0.0) and not seen.has_gap(begin, end):
            if actual[first]:
                return None
            missed.append(begin)
    return tuple(missed)
