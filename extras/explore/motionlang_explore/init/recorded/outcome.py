"""A run against a recording: power-up in the recording, its clock, and the cycle.

Marks are what both show: an output that is switched, an axis that starts or stops. The marks of both are matched in
their order. Power-up in the recording is where most of the first marks agree, the clock the ratio of the times between
marks in which the run waits for no input. Between two marks of the cycle the times are compared, and a difference has
the wait of the run that lies there.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Collection, Iterator, Sequence
from difflib import SequenceMatcher
from itertools import pairwise
from math import inf, sqrt
from statistics import fmean, median
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.commands.compare.drift import CLOCK, MAX_CLOCK
from motionlang.kernel import Run
from motionlang.kernel.tools import count_of
from motionlang_explore.identification.positions import Series
from motionlang_explore.init.recorded.recording import MeasuredRecording, machine_positions

# Marks that are tried as those of power-up, and marks of the run that are compared with each.
FIRST, COMPARED = 4, 60
# Times of the same mark differ by so many rows and this, s, at most.
NEAR_ROWS, NEAR = 2.0, 0.01
# Pulses of fewer rows may be in none, or only one of two may be.
PULSE_ROWS = 1.5
# What happens so soon after power-up, s, may be before the first row.
SOON = 0.05
# A clock differs by more than so many rows for each stretch over the time that is compared.
CLOCK_ROWS = 1.5
# A program that polls an input answers within this time, s.
ANSWER = 0.03
# The marks of a program are in a recording if this share of the recorded ones is matched, in so many at least.
SAME_PROGRAM, ENOUGH = 0.5, 4
# A run is compared for this much longer than the recording.
LONGER = 1.2
# Marks in the same row can be in another order, so far apart.
SWAPPED = 3
# Times of a cycle differ by more than this, s, or by more than so many rows.
DIFFERS, DIFFERS_ROWS = 2e-3, 1.0

# A cycle that takes so many times as long is two, or was interrupted.
LONG = 1.5

Label = tuple[str, int, int]


class OutcomeMark(NamedTuple):
    """Something that a recording and a run both show: the level of an output, or the direction of an axis."""

    time: float
    label: Label

    def __str__(self) -> str:
        kind, number, level = self.label
        if kind == "output":
            return f"output {number} {'on' if level else 'off'}"
        return f"axis {number} {'starts' if level else 'stops'}"


def recorded_marks(recording: MeasuredRecording) -> list[OutcomeMark]:
    """Return the marks of a recording, in its own time."""
    found: list[OutcomeMark] = []
    for number, channel in recording.outputs.items():
        levels = [(each.time, each.level) for each in channel.changes]
        found += _switched(number, levels, recording)
    for axis, path in recording.positions.items():
        found += _strokes(axis, path, path)
    return sorted(found)


def run_marks(run: Run, recording: MeasuredRecording) -> list[OutcomeMark]:
    """Return the marks of a run that the recording can have, sampled like it."""
    found: list[OutcomeMark] = []
    levels: dict[int, list[tuple[float, int]]] = {number: [] for number in recording.outputs}
    for each in run.machine.log.outputs:
        level, known = int(bool(each.value)), levels.get(each.channel)
        if known is not None and level != (known[-1][1] if known else 0):
            known.append((each.time, level))
    for number, changes in levels.items():
        found += _switched(number, changes, recording)
    for axis, path in recording.positions.items():
        if axis in run.trace.axes:
            found += _strokes(axis, run_path(run, axis, recording), path)
    return sorted(found)


def _switched(
    number: int, changes: Sequence[tuple[float, int]], recording: MeasuredRecording
) -> list[OutcomeMark]:
    """Return the marks of an output without pulses so short that the rows may miss them."""
    found: list[OutcomeMark] = []
    for time, level in changes:
        if found and time - found[-1].time < PULSE_ROWS * recording.step:
            found.pop()
        else:
            found.append(OutcomeMark(time, ("output", number, level)))
    return found


def run_path(run: Run, axis: int, recording: MeasuredRecording) -> Series:
    """Return the positions of an axis in a run, sampled as those of a recording, with a rest before and after it."""
    trace, path = run.trace, recording.positions[axis]
    rest = 2.0 * path.window * recording.step
    times = np.arange(-rest, min(trace.end + rest, LONGER * recording.end), recording.step)
    inside = np.clip(times, 0.0, trace.end)
    return machine_positions(Series("", times, trace.at(axis, "position", inside)))


def _strokes(axis: int, path: Series, recorded: Series) -> Iterator[OutcomeMark]:
    """Yield where an axis starts and stops, by the slopes that show motion in its recording."""
    window = recorded.window
    if len(path.times) < 2 * window + 3 or not float(np.ptp(recorded.values)) > 0.0:
        return
    speeds = path.slopes(window)
    moves = np.abs(speeds) > recorded.least_speed(window)
    edges = np.flatnonzero(moves[1:] != moves[:-1]).tolist()
    edges = _without_short(edges, moves, window, is_moving=False)  # a slow part of a move
    edges = _without_short(edges, moves, window, is_moving=True)  # noise
    for k in edges:
        direction = int(np.sign(speeds[k + 1])) if moves[k + 1] else 0
        yield OutcomeMark(float(path.times[k] + path.times[k + 1]) / 2, ("axis", axis, direction))


def _without_short(edges: list[int], moves: NDArray[np.bool_], window: int, *, is_moving: bool) -> list[int]:
    """Return edges without those of moves, or rests, of so few rows."""
    found: list[int] = []
    for k in edges:
        if found and k - found[-1] <= window and moves[found[-1] + 1] == is_moving:
            found.pop()
        else:
            found.append(k)
    return found


def power_up(run: Run, recording: MeasuredRecording, before: float) -> float | None:
    """Return the time of the recording at which the run begins, s; None if no mark agrees.

    Marks count up to `before`, and up to the first wait for an input.
    """
    waits = [
        each.until for each in run.machine.log.waits if each.cause == "input" and each.until > each.since
    ]
    before = min([before, *waits])
    mine = [each for each in run_marks(run, recording) if each.time <= before][:COMPARED]
    theirs = recorded_marks(recording)
    times: dict[Label, list[float]] = defaultdict(list)
    for each in theirs:
        times[each.label].append(each.time)
    before_begin = {*_at_begin(recording)}

    def has(mark: OutcomeMark, offset: float) -> bool:
        """True if the recording has a mark of the run, or it was before the first row."""
        time = mark.time + offset
        is_before = abs(time - recording.begin) <= SOON and mark.label in before_begin
        return is_before or abs(_nearest(times[mark.label], time) - time) <= near(recording)

    offsets = [recording.begin] if before_begin else []
    for label in dict.fromkeys(each.label for each in mine[:FIRST]):
        first = next(each for each in mine if each.label == label)
        offsets += [time - first.time for time in times[label][:FIRST]]
    ranks = [
        (len([each for each in mine if has(each, offset)]), -abs(offset - recording.begin), offset)
        for offset in offsets
    ]
    count, _, offset = max(ranks, default=(0, 0.0, 0.0))
    if not count:
        return None
    lags = (_nearest(times[each.label], each.time + offset) - each.time for each in mine)
    close = [each for each in lags if abs(each - offset) <= near(recording)]
    return fmean(close) if close else offset


def near(recording: MeasuredRecording) -> float:
    """Return by how much the times of a mark may differ, s."""
    return NEAR_ROWS * recording.step + NEAR


def _nearest(times: Sequence[float], time: float) -> float:
    at = bisect_left(times, time)
    return min(times[max(at - 1, 0) : at + 1], key=lambda each: abs(each - time), default=inf)


def _at_begin(recording: MeasuredRecording) -> Iterator[Label]:
    """Yield the marks that were before the first row of a recording: outputs that are on, axes that move."""
    for number, channel in sorted(recording.outputs.items()):
        if channel.first:
            yield "output", number, 1
    for axis, path in sorted(recording.positions.items()):
        window = path.window
        speed = path.slopes(window)[0]
        if abs(speed) > path.least_speed(window):
            yield "axis", axis, int(np.sign(speed))


def running(run: Run, recording: MeasuredRecording) -> str:
    """Return what a machine does at the begin of its recording, and not so soon after power-up; "" if it is nothing."""
    soon = {each.label for each in run_marks(run, recording) if each.time <= SOON + recording.step}
    for label in _at_begin(recording):
        if label not in soon:
            kind, number, _ = label
            return f"output {number} is on" if kind == "output" else f"axis {number} moves"
    return ""


class MatchedMarks(NamedTuple):
    """Marks of a run with those of the recording, as positions in both lists."""

    mine: list[OutcomeMark]
    theirs: list[OutcomeMark]
    pairs: list[tuple[int, int]]

    @property
    def is_other_program(self) -> bool:
        """True if the run does something else than the recording, not less of it."""
        known = {each.label for each in self.mine}
        unknown = [each for each in self.theirs if each.label not in known]
        is_else = len(self.mine) >= SAME_PROGRAM * len(self.theirs)
        is_unknown = len(unknown) >= SAME_PROGRAM * len(self.theirs)
        return len(self.pairs) < SAME_PROGRAM * len(self.theirs) and (is_else or is_unknown)


def matched(
    run: Run, recording: MeasuredRecording, kinds: Sequence[str] = ("output", "axis")
) -> MatchedMarks:
    """Match the marks of a run with those of a recording, in order.

    Outputs of the tasks beside the work, such as a lamp that blinks, have no place in that order.
    """
    beside = _beside(run)
    theirs = [each for each in recorded_marks(recording) if _counts(each, kinds, beside)]
    mine = [each for each in run_marks(run, recording) if _counts(each, kinds, beside)]
    # What happens at power-up may be in no row. If it comes later in the recording, this begins before power-up.
    since, until = recording.begin + near(recording), LONGER * recording.end
    early = {*_at_begin(recording), *(each.label for each in theirs if each.time <= since)}
    later = {each.label for each in theirs} - early
    mine = [each for each in mine if each.time > since or each.label in later]
    theirs = [each for each in theirs if each.time > since]
    mine, theirs = (
        _grouped([each for each in marks if each.time <= until], recording) for marks in (mine, theirs)
    )
    pairs: list[tuple[int, int]] = []
    for voice in dict.fromkeys(map(_voice, theirs)):
        at, by = ([k for k, each in enumerate(marks) if _voice(each) == voice] for marks in (mine, theirs))
        matcher = SequenceMatcher(
            None, [mine[k].label for k in at], [theirs[k].label for k in by], autojunk=False
        )
        for block in matcher.get_matching_blocks():
            pairs += zip(at[block.a : block.a + block.size], by[block.b : block.b + block.size], strict=True)
    return MatchedMarks(mine, theirs, sorted(pairs, key=lambda pair: pair[1]))


def _voice(mark: OutcomeMark) -> tuple[str, int]:
    """Return what a mark is in order with: all outputs, or the same axis; an axis may stop a little later."""
    kind, number, _ = mark.label
    return (kind, number) if kind == "axis" else (kind, -1)


def _counts(mark: OutcomeMark, kinds: Sequence[str], beside: Collection[int]) -> bool:
    kind, number, _ = mark.label
    return kind in kinds and not (kind == "output" and number in beside)


def _beside(run: Run) -> set[int]:
    """Return the outputs that only tasks switch which move no axis."""
    program = run.program or run.dialect.program(run.source)
    owners = program.structure.owners()
    moving = {each.line for each in run.machine.log.moves}
    # A run that waits for ever has no moves, and its lamp blinks all the same.
    moving |= {each.line for each in program.structure.statements.values() if each.moves}
    working = {owners.get(line, "") for line in moving}
    by: dict[int, set[str]] = defaultdict(set)
    for switched in run.machine.log.outputs:
        if switched.at >= 0:
            by[switched.channel].add(owners.get(run.source.location(switched.at)[0], ""))
    return {channel for channel, tasks in by.items() if working and not tasks & working}


def _grouped(marks: Sequence[OutcomeMark], recording: MeasuredRecording) -> list[OutcomeMark]:
    """Return marks with those that may be in the same row in the order of their labels, not of their times."""
    groups: list[list[OutcomeMark]] = []
    for each in marks:
        if groups and each.time - groups[-1][-1].time <= near(recording):
            groups[-1].append(each)
        else:
            groups.append([each])
    return [each for group in groups for each in sorted(group, key=lambda mark: mark.label)]


def clock_of(run: Run, recording: MeasuredRecording) -> float | None:
    """Return how many seconds the recording counts for one of the run; None if that is not certain.

    Only times between marks that follow each other count, and none in which the run waits for an input, or a condition
    that may read one. An output that is switched right after an input changes may be the answer of a program that polls
    it.
    """
    outputs = matched(run, recording, ("output",))
    changes = sorted(each.time for channel in recording.inputs.values() for each in channel.changes)
    waits = [
        (each.since, each.until)
        for each in run.machine.log.waits
        if each.cause in ("input", "condition") and each.until > each.since
    ]
    ratios: list[tuple[float, float]] = []
    stretches = 1
    for (a, b), (c, d) in pairwise(outputs.pairs):
        begin, end = outputs.mine[a].time, outputs.mine[c].time
        since, until = outputs.theirs[b].time, outputs.theirs[d].time
        is_answer = bisect_left(changes, until - ANSWER - recording.step) < bisect_left(changes, until)
        if c > a + 1 or is_answer or any(each[0] < end and each[1] > begin for each in waits):
            stretches += 1
        else:
            ratios.append((end - begin, until - since))
    ratios = [(mine, theirs) for mine, theirs in ratios if mine > 10.0 * recording.step]
    if len(ratios) < ENOUGH:
        return None
    usual = median(theirs / mine for mine, theirs in ratios)
    good = [
        (mine, theirs) for mine, theirs in ratios if abs(theirs - usual * mine) <= 2.0 * recording.step + 1e-3
    ]
    if len(good) < SAME_PROGRAM * len(ratios):
        return None
    mine, theirs = (float(np.sum(np.array(each))) for each in zip(*good, strict=True))
    found = theirs / mine
    error = CLOCK_ROWS * recording.step * sqrt(stretches) / mine
    return found if max(CLOCK, error) < abs(found - 1.0) < MAX_CLOCK else None


# ------------------------------------------------------------------------------------------ the cycle


def cycle_text(run: Run, recording: MeasuredRecording) -> str | None:
    """Return the cycle of the recording against that of the run, with the largest difference; None if none is known."""
    cycle = run.cycle
    if cycle is None:
        return None
    for kind in ("output", "axis"):
        found = matched(run, recording, (kind,))
        last = max((found.mine[a].time for a, _ in found.pairs), default=0.0)
        labels = _regular(found.mine, [each for each in pairwise(cycle.times) if each[1] <= last])
        pairs: dict[Label, list[tuple[float, float]]] = defaultdict(list)
        for a, b in found.pairs:
            pairs[found.mine[a].label].append((found.mine[a].time, found.theirs[b].time))
        for label in sorted(labels, key=lambda each: labels[each]):
            own = [each for each in pairs[label] if cycle.times[0] <= each[0]]
            periods = [
                (b[1] - a[1], b[0] - a[0]) for a, b in pairwise(own) if abs(b[0] - a[0]) < LONG * cycle.period
            ]
            if periods:
                theirs, mine = (_middle(each) for each in zip(*periods, strict=True))
                text = f"cycle {theirs:.4g} s recorded, {mine:.4g} s run ({count_of(len(periods), 'cycle')})"
                differences = _differences(run, recording, labels, pairs)
                return f"{text}: {differences}" if differences else text
    return None


def _middle(values: Sequence[float]) -> float:
    """Return the mean of values without the quarter at each end."""
    ordered = sorted(values)
    cut = len(ordered) // 4
    return fmean(ordered[cut : len(ordered) - cut])


def _regular(marks: Sequence[OutcomeMark], spans: Sequence[tuple[float, float]]) -> dict[Label, float]:
    """Return the labels that occur once in each cycle, with the usual time after its begin."""
    found: dict[Label, float] = {}
    for label in dict.fromkeys(each.label for each in marks):
        times = [each.time for each in marks if each.label == label]
        inside = [[t - begin for t in times if begin <= t < end] for begin, end in spans]
        if inside and all(len(each) == 1 for each in inside):
            found[label] = median(each[0] for each in inside)
    return found


def _differences(
    run: Run,
    recording: MeasuredRecording,
    labels: dict[Label, float],
    pairs: dict[Label, list[tuple[float, float]]],
) -> str:
    """Return the largest difference of a time between two marks of the cycle, with what the run waits for there."""
    ordered = sorted(labels, key=lambda each: labels[each])
    worst: tuple[float, str] = (0.0, "")
    least = max(DIFFERS, DIFFERS_ROWS * recording.step)
    for before, after in pairwise(ordered):
        theirs, mine, spans = [], [], []
        ends = [each[0] for each in pairs[after]]
        for a in pairs[before]:
            k = bisect_left(ends, a[0])
            if k < len(ends) and ends[k] - a[0] <= labels[after] - labels[before] + 0.5:
                theirs.append(pairs[after][k][1] - a[1])
                mine.append(ends[k] - a[0])
                spans.append((a[0], ends[k]))
        if not theirs:
            continue
        change = median(theirs) - median(mine)
        if abs(change) > max(least, abs(worst[0])):
            worst = change, _where(run, spans[0], OutcomeMark(0.0, before), OutcomeMark(0.0, after), change)
    return worst[1]


def _where(
    run: Run, span: tuple[float, float], before: OutcomeMark, after: OutcomeMark, change: float
) -> str:
    milliseconds = float(f"{abs(change) * 1000.0:.3g}")
    size = f"{milliseconds:.10g} ms {'longer' if change > 0.0 else 'shorter'}"
    waits = [
        (min(each.until, span[1]) - max(each.since, span[0]), each)
        for each in run.machine.log.waits
        if each.since < span[1] and each.until > span[0] and each.cause == "input"
    ]
    if waits:
        _, wait = max(waits, key=lambda each: each[0])
        line = run.source.location(wait.at)[0]
        return f"line {line} waits {size} (input {', '.join(map(str, wait.what))})"
    return f"{size} from {before} to {after}"
