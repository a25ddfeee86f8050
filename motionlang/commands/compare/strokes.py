"""The strokes of a recording, paired with those of the run.

A stroke is a motion in one direction, from rest or reversal to rest or reversal. Least squares compare two curves at
the same times. They answer well if the motion is the same, and badly if the machine moved at another speed, further, or
not at all. Strokes answer these cases: each has a travel, a start and a duration of its own.

* **Data.** Recording and run are sampled on the same grid and treated alike, so that smoothing shifts neither against
  the other. The slope is the difference of the means of two adjacent windows. Windows grow until the noise is small
  against the fastest slope. An axis is at rest where the slope is below a share of the fastest one.
* **Start and end.** Noise hides the first samples of a ramp. The times at which a small share of the travel and four
  times as much are reached are well known, in the run and in the recording; the shape of the run continues them to its
  exact start. This is exact if the recording has the same shape at another rate.
* **Pairs.** An alignment of the two sequences, in O(run × recording), with a cost for each missing and each extra
  stroke, for travel that differs, and for positions that begin elsewhere. It is done for several scales, of which the
  cheapest is chosen, and among equal ones that next to 1.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import isclose, log, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.commands.compare.alignment import ComparedMotion, Signal, fit, simulated

Array = NDArray[np.float64]
# A cost, and pairs of indices.
Pairing = tuple[float, list[tuple[int, int]]]

# Samples of the grid of both motions, and the largest product of their numbers of strokes; more are not paired.
MAX_SAMPLES, MAX_CELLS = 1 << 18, 40_000
# The smallest window of a slope in samples, and the smallest number of windows in a signal.
MIN_WINDOW, MIN_WINDOWS = 3, 16
# At rest the slope is below this share of the largest, and this many standard deviations of the noise. Windows grow
# until the noise is below another share.
REST_SHARE, NOISE, NOISE_SHARE = 2e-3, 8.0, 0.1
# A signal whose first slope is below this share of the largest begins at rest; so does its end.
EDGE_SHARE = 0.1
# The speed at the end of a run is that of its last so many seconds.
END = 1e-4
# A reversal without rest of less than this share of the larger stroke is its overshoot, and a stroke of less than
# another share of the largest one is none.
OVERSHOOT_SHARE, STROKE_SHARE = 0.2, 1e-3
# The second share of the travel that gives the start of a stroke is this many times the first one, which has a bound.
FURTHER, MAX_LEVEL = 4.0, 0.1
# An acceleration is constant if these shares of the top speed are reached at times on a line, but for this share.
RATE_SHARES, STRAIGHT = (0.2, 0.4, 0.8), 0.05
# Strokes shorter than this many samples have no start.
MIN_SAMPLES = 6
# Travel and times that differ by less than this share agree; so do times within so many windows.
SAME_SHARE, SAME_WINDOWS = 0.01, 2.0
# The RMS that a fit may leave of the same motion: so many standard deviations of the noise, or a share of the range.
RESIDUAL_NOISE, RESIDUAL_SHARE = 3.0, 5e-4
# Costs of an alignment: a stroke without a partner, a start that is entirely elsewhere, a first position that differs,
# and a reversed sign.
GAP, ELSEWHERE, SHIFTED, REVERSED = 1.0, 0.2, 0.1, 0.5
# The largest number of scales that are tried.
MAX_SCALES = 16


class Stroke(NamedTuple):
    """A motion in one direction: times (s), the level before it, the travel, and the top speed.

    `rates` are acceleration and deceleration, None if they are not constant. `shares` of the travel are reached at
    `times`; `known` are the smallest shares that can be seen at its start and its end.
    """

    begin: float
    end: float
    level: float
    travel: float
    speed: float
    rates: tuple[float | None, float | None]
    shares: NDArray[np.floating]
    times: NDArray[np.floating]
    known: tuple[float, float]

    @property
    def duration(self) -> float:
        """The seconds from start to end."""
        return self.end - self.begin

    def reached(self, share: float, *, at_end: bool) -> float:
        """Return the time at which a share of the travel is reached, or is left at the end."""
        return float(np.interp(1.0 - share if at_end else share, self.shares, self.times))


class Pair(NamedTuple):
    """The stroke of the run, and that of the recording in the times of the recording."""

    run: Stroke
    recorded: Stroke

    @property
    def lag(self) -> float:
        """The seconds from the start in the run to that in the recording."""
        return self.recorded.begin - self.run.begin

    def level(self, *, at_end: bool) -> float:
        """Return the share of the travel that gives the start or the end."""
        return min(MAX_LEVEL, max(self.run.known[at_end], self.recorded.known[at_end]))


class Matched(NamedTuple):
    """The strokes of a signal and of the run: `pairs`, `missing` from the recording, and `extra` in it; `later` ones.

    `scale` is the travel of the recording relative to that of the run. `resolution` is that of times, s.
    """

    scale: float
    pairs: list[Pair]
    missing: list[Stroke]
    extra: list[Stroke]
    later: list[Stroke]
    resolution: float

    @property
    def is_same(self) -> bool:
        """True if the recording has the strokes of the run, of the same travel, at the same times."""
        return not (
            self.missing
            or self.extra
            or any(self.has_other_travel(pair) or self.has_other_time(pair) for pair in self.pairs)
            or any(self.dwell_change(*each) for each in pairwise(self.pairs))
        )

    @property
    def offset(self) -> float:
        """The position of the recording where that of the run is 0."""
        first = self.pairs[0]
        return first.recorded.level - self.scale * first.run.level

    @property
    def is_shifted(self) -> bool:
        """True if the positions of the recording begin at another zero than those of the run."""
        return _is_shifted(self.pairs[0].run, self.pairs[0].recorded, self.scale)

    def is_same_at(self, delay: float) -> bool:
        """True if the strokes are the same, and a delay pairs them in the same way."""
        return self.is_same and abs(self.pairs[0].lag - delay) <= self.resolution

    def lag_of(self, begin: float, end: float) -> float | None:
        """Return the lag of the pair that begins between two times of the run; None if there is none."""
        return next(
            (each.lag for each in self.pairs if begin <= each.run.begin + self.resolution < end), None
        )

    def has_other_travel(self, pair: Pair) -> bool:
        """True if the travel of a pair differs, apart from the scale."""
        return abs(pair.recorded.travel / (self.scale * pair.run.travel) - 1.0) > SAME_SHARE

    def has_other_time(self, pair: Pair) -> bool:
        """True if the duration of a pair differs."""
        return abs(pair.recorded.duration - pair.run.duration) > self._tolerance(pair.run.duration)

    def dwell_change(self, before: Pair, after: Pair) -> float:
        """Return the change of the rest between two adjacent pairs, s; 0 within the tolerance."""
        if any(before.run.end <= each.begin < after.run.begin for each in self.missing) or any(
            before.recorded.end <= each.begin < after.recorded.begin for each in self.extra
        ):
            return 0.0
        rest = after.run.begin - before.run.end
        change = after.recorded.begin - before.recorded.end - rest
        return change if abs(change) > self._tolerance(after.run.begin - before.run.begin) else 0.0

    def _tolerance(self, seconds: float) -> float:
        return max(SAME_SHARE * seconds, self.resolution)


class SampledMotion(NamedTuple):
    """Positions on an even grid that begins at `start` (s), and the standard deviation of their noise."""

    start: float
    step: float
    positions: Array
    noise: float

    def slopes(self, window: int) -> Array:
        """Return differences of means of adjacent windows; number k is at sample `k + window`."""
        sums = np.concatenate(([0.0], np.cumsum(self.positions)))
        means = (sums[window:] - sums[:-window]) / window
        return np.asarray(means[window:] - means[:-window])

    def top_slope(self, window: int) -> float:
        """Return the largest slope, 0 if the motion is shorter than a window."""
        slopes = self.slopes(window) if len(self.positions) >= 2 * window else np.zeros(1)
        return float(np.abs(slopes).max())

    def padded(self, count: int) -> SampledMotion:
        """Return the motion with `count` samples of rest at each end where it is slow."""
        if len(self.positions) < 2:
            return self
        steps = np.abs(np.diff(self.positions))
        slow = [count if each <= EDGE_SHARE * steps.max() else 0 for each in (steps[0], steps[-1])]
        return self._replace(
            start=self.start - slow[0] * self.step, positions=np.pad(self.positions, slow, "edge")
        )


def is_explained(trace: ComparedMotion, signal: Signal, delay: float) -> bool:
    """True if a signal is that of the run at a delay, but for its noise, a scale and an offset."""
    if signal.quantity not in ("position", "velocity"):
        return True
    expected = simulated(trace, signal, signal.times - delay)
    scale, offset = fit(expected, signal.values)
    left = signal.values - scale * expected - offset
    allowed = max(RESIDUAL_NOISE * _noise(signal.values), RESIDUAL_SHARE * float(np.ptp(signal.values)))
    return float(np.sqrt(np.mean(left**2))) <= allowed


def strokes_of(trace: ComparedMotion, signal: Signal) -> list[Stroke]:
    """Return the strokes of a position, which is that of a motion, with their exact start and end."""
    step = max(float(np.median(np.diff(signal.times))), trace.end / MAX_SAMPLES)
    sampled = _recorded(signal, step)
    window = None if sampled is None else _window(sampled)
    if sampled is None or window is None:
        return []
    return [
        _exact(trace, signal.axis, each, step) for each in _strokes(sampled.padded(2 * window), window)[0]
    ]


def match(trace: ComparedMotion, signal: Signal) -> Matched | None:
    """Return the strokes of a signal paired with those of the run, or None if it has none that are complete."""
    step = float(np.median(np.diff(signal.times)))
    span = max(float(signal.times[-1] - signal.times[0]), trace.end)
    step = max(step, span / MAX_SAMPLES)
    recorded = _recorded(signal, step)
    if recorded is None:
        return None
    window = _window(recorded)
    if window is None:
        return None
    # At rest the last samples are those of the end. In motion there are none, so the move that is cut is no stroke.
    times = np.arange(int(trace.end / step) + (1 if _moves_at_end(trace, signal.axis, step) else 2)) * step
    positions = trace.at(signal.axis, "position", np.clip(times, 0.0, trace.end))
    # The same share of the slopes is noise, so that the same motion has the same strokes.
    noise = (
        recorded.noise
        * SampledMotion(0.0, step, positions, 0.0).top_slope(window)
        / recorded.top_slope(window)
    )
    run = SampledMotion(0.0, step, positions, noise)
    expected, _, _ = _strokes(run.padded(2 * window), window)
    measured, first, last = _strokes(recorded.padded(2 * window), window)
    if len(expected) * len(measured) > MAX_CELLS:
        return None
    found = _aligned(expected, measured, has_zero=signal.quantity == "position")
    if found is None:
        return None
    scale, indices = found
    paired = [set(each) for each in zip(*indices, strict=True)]
    pairs = []
    for i, j in indices:
        exact = _exact(trace, signal.axis, expected[i], step)
        pairs.append(Pair(exact, _timed(exact, measured[j])))
    resolution = SAME_WINDOWS * window * step
    first, last = (
        max(first, float(signal.times[0])) + resolution,
        min(last, float(signal.times[-1])) - resolution,
    )
    unpaired = (stroke for i, stroke in enumerate(expected) if i not in paired[0])
    missing = [
        _exact(trace, signal.axis, stroke, step)
        for stroke in unpaired
        if first < stroke.end + _shift(pairs, stroke) and stroke.begin + _shift(pairs, stroke) < last
    ]
    begin, end = pairs[0].lag, pairs[-1].recorded.end + trace.end - pairs[-1].run.end
    extra = [
        stroke._replace(begin=_onset(stroke))
        for j, stroke in enumerate(measured)
        if j not in paired[1] and begin <= stroke.begin and stroke.end <= end
    ]
    later = [
        stroke._replace(begin=_onset(stroke))
        for j, stroke in enumerate(measured)
        if j not in paired[1] and stroke.begin > end - resolution
    ]
    return Matched(scale, pairs, missing, extra, later, resolution)


def _moves_at_end(trace: ComparedMotion, axis: int, step: float) -> bool:
    times = np.arange(0.0, trace.end, step)
    speeds = np.abs(np.diff(trace.at(axis, "position", times))) / step
    last = trace.at(axis, "position", np.array([trace.end - END, trace.end]))
    return len(speeds) > 0 and abs(float(last[1] - last[0])) / END > EDGE_SHARE * float(speeds.max())


def _shift(pairs: Sequence[Pair], stroke: Stroke) -> float:
    """Return by how much later the recording is than the run where a stroke begins."""
    before = [pair for pair in pairs if pair.run.end <= stroke.begin]
    return before[-1].recorded.end - before[-1].run.end if before else pairs[0].lag


def _recorded(signal: Signal, step: float) -> SampledMotion | None:
    """Return the position of a signal on a grid, None if it has none."""
    if signal.events or len(signal.times) < MIN_WINDOWS * MIN_WINDOW:
        return None
    times = np.arange(signal.times[0], signal.times[-1] + 0.5 * step, step)
    values = np.interp(times, signal.times, signal.values)
    if signal.quantity == "velocity":
        first = values[: max(MIN_WINDOW, len(values) // 50)]
        if np.ptp(first) > 0.02 * np.ptp(values):
            return None
        values = values - np.median(first)
        values = np.concatenate(([0.0], np.cumsum(0.5 * step * (values[1:] + values[:-1]))))
        noise = _noise(values)
    elif signal.quantity == "position":
        noise = _noise(signal.values)
    else:
        return None
    return SampledMotion(float(signal.times[0]), step, values, noise)


def _noise(positions: Array) -> float:
    """Return the standard deviation of the noise and of the resolution.

    They follow from the median of second differences, and from the smallest difference.
    """
    steps = np.abs(np.diff(positions))
    resolution = float(steps.min(where=steps > 0.0, initial=float(steps.max(initial=0.0)))) / sqrt(12.0)
    return float(np.median(np.abs(np.diff(positions, 2)))) / (0.6745 * sqrt(6.0)) + resolution


def _window(motion: SampledMotion) -> int | None:
    """Return the smallest window whose noise is small against the slopes, None if there is none."""
    count, window = len(motion.positions), MIN_WINDOW
    while MIN_WINDOWS * window <= count:
        largest = float(np.abs(motion.slopes(window)).max())
        if NOISE * motion.noise * (2.0 / window) ** 0.5 <= NOISE_SHARE * largest:
            return window if largest > 0.0 else None
        window *= 2
    return None


def _strokes(motion: SampledMotion, window: int) -> tuple[list[Stroke], float, float]:
    """Return the complete strokes of a motion in times of the grid, and the times between which all are known."""
    start, end = motion.start, motion.start + (len(motion.positions) - 1) * motion.step
    if len(motion.positions) < 4 * window:
        return [], start, end
    slopes = motion.slopes(window)
    largest = float(np.abs(slopes).max())
    noise = NOISE * motion.noise * (2.0 / window) ** 0.5
    rest = max(REST_SHARE * largest, noise)
    signs = np.where(np.abs(slopes) > rest, np.sign(slopes), 0.0)
    changes = np.flatnonzero(np.diff(signs)) + 1
    bounds = [0, *changes.tolist(), len(signs)]
    spans = [(a + window, b - 1 + window) for a, b in pairwise(bounds) if signs[a] and b > a]
    if not spans:
        return [], start, end
    if spans[0][0] == window:
        start += spans[0][1] * motion.step
    if spans[-1][1] == len(slopes) + window - 1:
        end = motion.start + spans[-1][0] * motion.step
    smooth: Array = np.convolve(
        np.pad(motion.positions, window // 2, "edge"), np.full(window, 1.0 / window), "valid"
    )
    levels = _levels(
        motion.positions if window == MIN_WINDOW else smooth[: len(motion.positions)], spans, window
    )
    spans, levels = _without_overshoots(spans, levels, window)
    least = max(4.0 * rest, STROKE_SHARE * max(abs(b - a) for a, b in pairwise(levels)))
    made = []
    for (first, last), (level, after) in zip(spans, pairwise(levels), strict=True):
        inside = window < first and last < len(slopes) + window - 1 and last - first >= MIN_SAMPLES
        if not inside or abs(after - level) < least:
            continue
        low, high = max(0, first - window), min(len(smooth) - 1, last + window)
        share = np.maximum.accumulate((smooth[low : high + 1] - level) / (after - level))
        times = motion.start + (np.arange(low, high + 1) + (0.5 if window % 2 else 0.0) - 0.5) * motion.step
        least_share = 2.0 * noise / abs(after - level)
        seen = share[min(3 * window, len(share) - 1)], 1.0 - share[max(len(share) - 1 - 3 * window, 0)]
        known = max(float(seen[0]), least_share), max(float(seen[1]), least_share)
        sizes = np.abs(slopes[first - window : last + 1 - window])
        speed = float(np.median(sizes[sizes >= sizes.max() - noise])) / (window * motion.step)
        edges = motion.start + low * motion.step, motion.start + high * motion.step
        rates = _rate(sizes, window, motion.step), _rate(sizes[::-1], window, motion.step)
        travel = after - level
        made.append(Stroke(*edges, level, travel, speed, rates, share, times, known))
    return made, start, end


def _rate(sizes: Array, window: int, step: float) -> float | None:
    """Return the acceleration to the largest of some slopes, None if it is not constant."""
    top = int(np.argmax(sizes))
    reached = np.maximum.accumulate(sizes[: top + 1])
    times = np.interp(np.array(RATE_SHARES) * reached[-1], reached, np.arange(top + 1) * step)
    first, second, third = (float(each) for each in times)
    wanted = (RATE_SHARES[1] - RATE_SHARES[0]) / (RATE_SHARES[2] - RATE_SHARES[1])
    if third - second < 2.0 * step or not isclose(
        (second - first) / (third - second), wanted, rel_tol=STRAIGHT
    ):
        return None
    return (RATE_SHARES[2] - RATE_SHARES[0]) * float(reached[-1]) / (window * step) / (third - first)


def _levels(positions: Array, spans: Sequence[tuple[int, int]], window: int) -> list[float]:
    """Return the position at rest before, between and after the strokes; at a reversal, the extremum."""
    rests = [
        (0, spans[0][0]),
        *((a[1], b[0]) for a, b in pairwise(spans)),
        (spans[-1][1], len(positions) - 1),
    ]
    levels = []
    for number, (first, last) in enumerate(rests):
        low = first + window if number else first
        high = last - window if number < len(spans) else last
        if low <= high:
            levels.append(float(np.median(positions[low : high + 1])))
        else:
            values = positions[first : last + 1]
            a, b = spans[max(number - 1, 0)]
            rises = positions[b] >= positions[a] if number else positions[b] < positions[a]
            levels.append(float(values.max() if rises else values.min()))
    return levels


def _without_overshoots(
    spans: list[tuple[int, int]], levels: list[float], window: int
) -> tuple[list[tuple[int, int]], list[float]]:
    """Return strokes and levels with each small reversal made part of its neighbour."""
    made, kept = [spans[0]], levels[:2]
    for span, after in zip(spans[1:], levels[2:], strict=True):
        last, travel = kept[-1] - kept[-2], after - kept[-1]
        small, large = sorted((abs(last), abs(travel)))
        if last * travel < 0.0 and span[0] - made[-1][1] <= 2 * window and small < OVERSHOOT_SHARE * large:
            made[-1], kept[-1] = (made[-1][0], span[1]), after
        else:
            made.append(span)
            kept.append(after)
    return made, kept


def _exact(trace: ComparedMotion, axis: int, stroke: Stroke, step: float) -> Stroke:
    """Return a stroke of the run with its exact start and end."""
    sign = 1.0 if stroke.travel > 0.0 else -1.0
    begin = _edge(trace, axis, sign, stroke.reached(stroke.known[0], at_end=False), stroke.begin - step)
    end = _edge(trace, axis, sign, stroke.reached(stroke.known[1], at_end=True), stroke.end + step)
    return stroke._replace(begin=begin, end=end)


def _edge(trace: ComparedMotion, axis: int, sign: float, moving: float, resting: float) -> float:
    """Return the time between `moving` and `resting` from which the velocity is not of that sign."""
    moving, resting = (float(np.clip(each, 0.0, trace.end)) for each in (moving, resting))
    for _ in range(40):
        half = 0.5 * (moving + resting)
        if sign * float(trace.at(axis, "velocity", np.array([half]))[0]) > 0.0:
            moving = half
        else:
            resting = half
    return resting


def _onset(stroke: Stroke) -> float:
    """Return the start of a stroke without a partner, if it begins with a constant acceleration."""
    share = min(MAX_LEVEL, stroke.known[0])
    near, far = (stroke.reached(each, at_end=False) for each in (share, FURTHER * share))
    return near - (far - near) / (sqrt(FURTHER) - 1.0)


def _timed(run: Stroke, recorded: Stroke) -> Stroke:
    """Return a stroke of the recording with the start and the end that the shape of the run gives it."""
    edges = []
    for at_end, edge in ((False, run.begin), (True, run.end)):
        near = Pair(run, recorded).level(at_end=at_end)
        expected, measured = (
            [each.reached(share, at_end=at_end) for share in (near, FURTHER * near)]
            for each in (run, recorded)
        )
        spread = expected[1] - expected[0]
        stretch = (measured[1] - measured[0]) / spread if spread else 1.0
        edges.append(measured[0] + stretch * (edge - expected[0]))
    return recorded._replace(begin=edges[0], end=edges[1])


# ------------------------------------------------------------------------------------------ pairs


def _is_shifted(run: Stroke, recorded: Stroke, scale: float) -> bool:
    return abs(recorded.level - scale * run.level) > SAME_SHARE * abs(recorded.travel)


def _aligned(
    run: Sequence[Stroke], recorded: Sequence[Stroke], *, has_zero: bool
) -> tuple[float, list[tuple[int, int]]] | None:
    """Return the scale of the recording and the pairs of indices, None if there is no pair.

    `has_zero` is true if levels of the recording are positions, which it may have in common with the run.
    """
    ratios = [1.0, *(m.travel / r.travel for m in recorded[:4] for r in run[:4])]
    scales = list({f"{each:.4g}": each for each in ratios}.values())[:MAX_SCALES]
    found = [(*_pairing(run, recorded, scale, has_zero), scale) for scale in scales]
    found = [each for each in found if each[1]]
    if not found:
        return None

    def rank(each: tuple[float, list[tuple[int, int]], float]) -> tuple[float, float]:
        cost, pairs, scale = each
        unlikely = abs(log(abs(scale)))
        cost += REVERSED if scale < 0.0 else 0.0
        if len(pairs) == 1 < len(run):  # nothing confirms the scale: the axis may have jammed on its way
            cost += min(unlikely, GAP)
        return round(cost, 3), unlikely

    _, pairs, scale = min(found, key=rank)
    return scale, pairs


def _pairing(run: Sequence[Stroke], recorded: Sequence[Stroke], scale: float, has_zero: bool) -> Pairing:
    """Return the cost of the cheapest pairing at a scale, and its pairs of indices."""
    above: list[Pairing] = [(GAP * j, []) for j in range(len(recorded) + 1)]
    for i, expected in enumerate(run):
        row: list[Pairing] = [(GAP * (i + 1), [])]
        for j, measured in enumerate(recorded):
            choices = [(above[j + 1][0] + GAP, above[j + 1][1]), (row[j][0] + GAP, row[j][1])]
            ratio = measured.travel / (scale * expected.travel)
            if ratio > 0.0:
                cost, pairs = above[j]
                cost += abs(log(ratio))
                if pairs:
                    before, other = run[pairs[-1][0]], recorded[pairs[-1][1]]
                    later, wanted = measured.begin - other.begin, expected.begin - before.begin
                    cost += ELSEWHERE * abs(later - wanted) / max(later, wanted)
                elif has_zero and _is_shifted(expected, measured, scale):
                    cost += SHIFTED
                choices.append((cost, [*pairs, (i, j)]))  # last: of equal pairings, the earliest
            row.append(min(choices, key=lambda each: each[0]))
        above = row
    return above[-1]
