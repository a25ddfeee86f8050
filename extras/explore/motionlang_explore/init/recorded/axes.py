"""Axes of a recording against those of a run: the switches of a homing, the scale, and speeds that were not reached.

A homing turns behind its switch by what the axis needs to stop. The run needs the same, so the switch of the recording
lies as far from the guessed one as the one turn lies from the other. The same holds for an index mark.

A scale is that of the moves that end where their line sends the axis. What an input ends may end elsewhere in the run,
so it has only the ratio of the speeds. Strokes that take longer between two positions show a wrong clock, or a slow
drive; those that come later after an output, a lag.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from math import floor, isfinite
from statistics import median
from typing import NamedTuple

import numpy as np

from motionlang.commands.compare.differences import usual_factor
from motionlang.commands.compare.drift import MIN_PASSED, MIN_ROWS, PASSED, clock_rate
from motionlang.kernel import Run
from motionlang.kernel.log import LoggedMove
from motionlang.kernel.tools import numbered
from motionlang_explore.identification.positions import Series
from motionlang_explore.init.recorded.outcome import (
    OutcomeMark,
    matched,
    near,
    recorded_marks,
    run_marks,
    run_path,
)
from motionlang_explore.init.recorded.recording import MeasuredRecording

# An axis rests if it does not move for so long, s; it moves by at least so many standard deviations of the noise.
REST, AT_REST = 0.08, 6.0
# How an axis begins, in starts and stops: what follows may wait.
BEGIN_MARKS = 2
# Decimal places of a switch.
PLACES = 2
# A scale or a speed differs by more than this share.
SCALE, SPEED = 0.01, 0.03
# So many slow strokes are no accident.
MIN_STROKES = 3
# The top speed of a stroke is reached in the fastest part of its rows, from this percentage on.
TOP = 90
# A lag is at least so long, s.
MIN_LAG = 0.002
# The rows at both ends of a stroke that its figures leave out.
EDGE = 2


def switches(
    run: Run,
    recording: MeasuredRecording,
    guessed: Mapping[int, Mapping[str, object]],
    play: Callable[[Mapping[str, object]], Run],
) -> tuple[dict[str, object], dict[str, str]]:
    """Return the settings of the guessed switches as measured, each with a comment.

    `play` runs the program with such settings. A guess stays if the axis does not begin in the run as it does in the
    recording, not even with what was measured: the recording has no homing then.
    """
    found: dict[str, object] = {}
    comments: dict[str, str] = {}
    for axis, keys in guessed.items():
        path = recording.positions.get(axis)
        if path is None or recording.is_late:
            continue
        least = path.noise(AT_REST)
        theirs, measured, result = _turns(path, least), dict(keys), run
        if not _begins_alike(axis, run, recording, theirs, least):
            measured = _moved(keys, theirs, _turns(run_path(run, axis, recording), least))
            result = play({f"axis.{axis}.{key}": value for key, value in measured.items()})
        if not _begins_alike(axis, result, recording, theirs, least):
            continue
        for key, value in measured.items():
            found[f"axis.{axis}.{key}"] = value
            comments[f"axis.{axis}.{key}"] = f"measured: the homing turns at {theirs[0]:.4g} uu ± {least:.2g}"
        found[f"axis.{axis}.guess"] = True
    return found, comments


def _begins_alike(
    axis: int, run: Run, recording: MeasuredRecording, theirs: list[float], least: float
) -> bool:
    """True if an axis turns first at the same positions in a run and in the recording, and takes as long there."""
    mine = _turns(run_path(run, axis, recording), least)
    if not theirs or len(theirs) > len(mine):
        return False
    if any(abs(a - b) > least + 10.0**-PLACES for a, b in zip(theirs, mine, strict=False)):
        return False
    own, recorded = (
        [each for each in marks if each.label[:2] == ("axis", axis)][:BEGIN_MARKS]
        for marks in (run_marks(run, recording), recorded_marks(recording))
    )
    if recorded and not recorded[0].label[2]:  # it moves in the first row
        recorded = [OutcomeMark(0.0, own[0].label), *recorded][:BEGIN_MARKS] if own else []
    return (
        bool(own)
        and [each.label for each in own] == [each.label for each in recorded]
        and all(
            abs(b.time - recorded[0].time - (a.time - own[0].time))
            <= 2.0 * near(recording) + SCALE * (a.time - own[0].time)
            for a, b in zip(own, recorded, strict=True)
        )
    )


def _moved(keys: Mapping[str, object], theirs: list[float], mine: list[float]) -> dict[str, object]:
    """Return guessed switches moved by as much as the recorded turns lie from those of the run."""
    measured = dict(keys)
    if "home_switch" in keys and theirs and mine:
        low, high = (float(each) for each in keys["home_switch"])  # type: ignore[attr-defined]
        by = theirs[0] - mine[0]
        measured["home_switch"] = [round(low + by, PLACES), round(high + by, PLACES)]
    turn = 1 if "home_switch" in keys else 0
    if "index_every" in keys and min(len(theirs), len(mine)) > turn:
        mark = _mark(mine, turn, float(str(keys["index_every"]))) + theirs[turn] - mine[turn]
        if round(abs(mark), PLACES):  # else the axis turned where it began, and passed no mark
            measured["index_every"] = round(abs(mark), PLACES)
    return measured


def _mark(turns: list[float], turn: int, every: float) -> float:
    """Return the index mark that an axis passed before a turn."""
    before = turns[turn - 1] if turn else 0.0
    if turns[turn] > before:
        return every * floor(turns[turn] / every)
    return -every * floor(-turns[turn] / every)


def _turns(path: Series, least: float) -> list[float]:
    """Return the first two positions at which an axis turns or comes to rest; it moves if it moves by `least`."""
    found: list[float] = []
    rest = extreme = progress = float(path.values[0])
    direction, since = 0.0, 0.0
    for time, value in zip(path.times.tolist(), path.values.tolist(), strict=True):
        if not direction:
            if abs(value - rest) > least:
                direction, extreme, progress, since = float(np.sign(value - rest)), value, value, time
            continue
        extreme = max(extreme, value, key=lambda each: each * direction)
        if direction * (value - progress) > least:
            progress, since = value, time
        elif direction * (extreme - value) > least:
            found.append(extreme)
            direction, extreme, progress, since = -direction, value, value, time
        elif time - since > REST:
            inside = (path.times > time - REST / 2) & (path.times <= time)
            rest = float(np.median(path.values[inside]))
            found.append(rest)
            direction = 0.0
        if len(found) == 2:
            break
    return found


class _Stroke(NamedTuple):
    """A stroke of the run and of the recording: its line, travel and top speed of both, and their rows.

    It is planned if the run ends where its line sends the axis, not at a switch or an input.
    """

    line: int
    is_planned: bool
    mine: tuple[float, float]
    theirs: tuple[float, float]
    rows: tuple[Series, Series]

    @property
    def scale(self) -> float:
        """The travel of the recording as a share of that of the run."""
        return self.theirs[0] / self.mine[0]


def axis_remarks(run: Run, recording: MeasuredRecording) -> Iterator[str]:
    """Yield the axes whose scale or speed in the recording is not that of the run."""
    for axis, path in sorted(recording.positions.items()):
        strokes = [*_strokes(run, axis, path, recording)]
        # An input that follows a position ends others elsewhere.
        strokes = [each for each in strokes if each.is_planned] or strokes
        if not strokes:
            continue
        travel = median(each.scale for each in strokes)
        speed = median(each.theirs[1] / each.mine[1] for each in strokes)
        scale = travel if strokes[0].is_planned else speed
        name = usual_factor(scale, run.controller.axes[axis].scale.counts, "position")
        if abs(scale - 1.0) > SPEED and (name or abs(travel - speed) < SPEED * speed):
            yield (
                f"axis {axis}, {numbered('line', {each.line for each in strokes})}: "
                f"{path.column} moves {scale:.4g} times as far as the run{name and f' ({name})'}: "
                f"if its unit differs, give --map position.{axis}={path.column}*{1.0 / scale:.6g}"
            )
            continue
        same = [each for each in strokes if abs(each.scale - 1.0) < SCALE]
        lags = _lags(run, recording, same)
        if len(lags) >= MIN_PASSED and (lag := median(lags)) > max(MIN_LAG, recording.step / 2):
            spread = median(abs(each - lag) for each in lags)
            if spread < lag / 2:
                yield (
                    f"axis {axis}: the position is {1000.0 * lag:.2g} ms behind the run ({len(lags)} strokes), "
                    "as of a drive with this time constant"
                )
        slow = [each for each in same if each.theirs[1] < (1.0 - SPEED) * each.mine[1]]
        # A few strokes may seem slow because a row is missing at their top.
        if len(slow) >= MIN_STROKES and len(slow) > len(same) / 2:
            worst = min(slow, key=lambda each: each.theirs[1] / each.mine[1])
            yield (
                f"axis {axis}, line {worst.line}: {worst.theirs[1]:.4g} uu/s recorded, {worst.mine[1]:.4g} uu/s run: "
                "the drive does not reach its speed"
            )


def _lags(run: Run, recording: MeasuredRecording, strokes: Sequence[_Stroke]) -> list[float]:
    """Return how much later the middle of each stroke comes after the output before it than in the run, s.

    No input may be waited for in between.
    """
    found = matched(run, recording, ("output",))
    outputs = [(found.mine[a].time, found.theirs[b].time) for a, b in found.pairs]
    waits = [each for each in run.machine.log.waits if each.cause == "input" and each.until > each.since]
    lags: list[float] = []
    for each in strokes:
        mine, theirs = (_passed(rows, each.mine[0] / 2) for rows in each.rows)
        at = bisect_left(outputs, (mine, 0.0)) - 1
        if at >= 0 and not any(wait.since < mine and wait.until > outputs[at][0] for wait in waits):
            lags.append(theirs - outputs[at][1] - (mine - outputs[at][0]))
    return lags


def stroke_clock(run: Run, recording: MeasuredRecording) -> float | None:
    """Return how many seconds the recording counts for one of the run, by strokes; None if that is not certain.

    An input may end the wait before a stroke, or the stroke, but nothing changes the time between two positions within
    it. These are passed between two rows, so strokes show a clock that outputs, which have rows, do not.
    """
    times: list[tuple[float, float]] = []
    for axis, path in sorted(recording.positions.items()):
        strokes = [*_strokes(run, axis, path, recording)]
        usual = median(each.scale for each in strokes) if strokes else 1.0
        unit = 1.0 if abs(usual - 1.0) < SCALE else usual
        for each in strokes:
            if abs(each.scale - usual) < SCALE * abs(usual):
                mine, theirs = each.rows
                passed = _passing(mine, each.mine[0]), _passing(theirs, unit * each.mine[0])
                times += [passed] if min(passed) > MIN_ROWS * recording.step else []
    return clock_rate(times)


def _passing(rows: Series, travel: float) -> float:
    """Return the time that a stroke takes for most of a travel, s."""
    first, last = (_passed(rows, share * travel) for share in PASSED)
    return last - first


def _passed(rows: Series, travel: float) -> float:
    """Return the time at which a stroke has a travel behind it, s."""
    way = np.maximum.accumulate((rows.values - rows.values[0]) * np.sign(travel))
    return float(np.interp(abs(travel), way, rows.times))


def _strokes(run: Run, axis: int, path: Series, recording: MeasuredRecording) -> Iterator[_Stroke]:
    """Yield the strokes of an axis that a run and a recording both have, and that end where the next mark is."""
    found = matched(run, recording, ("axis",))
    pairs = [(found.mine[a], found.theirs[b]) for a, b in found.pairs if found.mine[a].label[1] == axis]
    mine = run_path(run, axis, recording)
    least = SCALE * float(np.ptp(mine.values))
    moves = [each for each in run.machine.log.moves if each.axis == axis]
    for (begin, their_begin), (end, their_end) in pairwise(pairs):
        if begin.label[2] and not end.label[2]:
            rows = _rows(mine, begin, end), _rows(path, their_begin, their_end)
            if min(len(each.times) for each in rows) >= 4 * EDGE:
                own, theirs = map(_figures, rows)
                begun = [each for each in moves if each.start_time <= begin.time + near(recording)]
                if abs(own[0]) > least and begun:
                    stroke = _Stroke(begun[-1].line, _is_planned(begun[-1], own[0]), own, theirs, rows)
                    yield stroke if stroke.is_planned else _with_speed(stroke, begun[-1])


def _with_speed(stroke: _Stroke, move: LoggedMove) -> _Stroke:
    """Return a stroke that ends elsewhere in the run with the speed of its move, which the run may not reach."""
    if abs(stroke.scale - 1.0) < SPEED or not move.commanded_speed:
        return stroke
    return stroke._replace(mine=(stroke.mine[0], move.size_to_user(move.commanded_speed)))


def _is_planned(move: LoggedMove, travel: float) -> bool:
    """True if an axis has travelled as far as a move sends it."""
    if move.profile is None or move.ended or not isfinite(move.profile.end):
        return False
    distance = move.to_user(move.profile.end) - move.to_user(move.profile.start)
    return abs(distance - travel) < SCALE * abs(travel)


def _rows(path: Series, begin: OutcomeMark, end: OutcomeMark) -> Series:
    first, last = np.searchsorted(path.times, [begin.time, end.time])
    inside = slice(max(first - EDGE, 0), last + EDGE)
    return path._replace(times=path.times[inside], values=path.values[inside])


def _figures(rows: Series) -> tuple[float, float]:
    """Return the travel of a stroke and its top speed."""
    times, values = rows.times, rows.values
    width = max(len(times) // 8, 1)
    speeds = np.abs(values[width:] - values[:-width]) / (times[width:] - times[:-width])
    return float(values[-1] - values[0]), float(np.percentile(speeds, TOP))
