"""Axes of a recording against those of a run: the switches of a homing, the scale, and speeds that were not reached.

A homing turns behind its switch by what the axis needs to stop. The run needs the same, so the switch of the recording
lies as far from the guessed one as the one turn lies from the other. The same holds for an index mark.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from math import floor
from statistics import median
from typing import NamedTuple

import numpy as np

from motionlang.commands.compare.differences import usual_factor
from motionlang.commands.init.recorded.outcome import OutcomeMark, matched, run_path
from motionlang.commands.init.recorded.recording import MeasuredRecording, Series, noise_of
from motionlang.kernel import Run

# An axis rests if it does not move for so long, s; it moves by at least so many standard deviations of the noise.
REST, AT_REST = 0.08, 6.0
# Decimal places of a switch.
PLACES = 2
# A scale or a speed differs by more than this share.
SCALE, SPEED = 0.01, 0.03
# So many slow strokes are no accident.
MIN_STROKES = 3
# The top speed of a stroke is reached in the fastest part of its rows, from this percentage on.
TOP = 90
# The rows at both ends of a stroke that its figures leave out.
EDGE = 2


def switches(
    run: Run, recording: MeasuredRecording, guessed: Mapping[int, Mapping[str, object]]
) -> tuple[dict[str, object], dict[str, str]]:
    """Return the settings of the guessed switches as measured, each with a comment."""
    found: dict[str, object] = {}
    comments: dict[str, str] = {}
    for axis, keys in guessed.items():
        path = recording.positions.get(axis)
        if path is None or recording.begin > 0.0:
            continue
        least = noise_of(path, AT_REST)
        theirs, mine = _turns(path, least), _turns(run_path(run, axis, recording), least)
        if not theirs or not mine:
            continue
        measured = dict(keys)
        if "home_switch" in keys:
            low, high = (float(each) for each in keys["home_switch"])  # type: ignore[attr-defined]
            moved = theirs[0] - mine[0]
            measured["home_switch"] = [round(low + moved, PLACES), round(high + moved, PLACES)]
        if "index_every" in keys:
            turn = 1 if "home_switch" in keys else 0
            if min(len(theirs), len(mine)) > turn:
                mark = _mark(mine, turn, float(str(keys["index_every"]))) + theirs[turn] - mine[turn]
                measured["index_every"] = round(abs(mark), PLACES)
        for key, value in measured.items():
            found[f"axis.{axis}.{key}"] = value
            comments[f"axis.{axis}.{key}"] = f"measured: the homing turns at {theirs[0]:.4g} uu"
        found[f"axis.{axis}.guess"] = True
    return found, comments


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
    """A stroke of the run and of the recording: begin, travel and top speed of both."""

    begin: float
    mine: tuple[float, float]
    theirs: tuple[float, float]


def axis_remarks(run: Run, recording: MeasuredRecording) -> Iterator[str]:
    """Yield the axes whose scale or speed in the recording is not that of the run."""
    for axis, path in sorted(recording.positions.items()):
        strokes = [*_strokes(run, axis, path, recording)]
        if not strokes:
            continue
        travel = median(each.theirs[0] / each.mine[0] for each in strokes)
        speed = median(each.theirs[1] / each.mine[1] for each in strokes)
        name = usual_factor(speed, run.controller.axes[axis].scale.counts, "position")
        if abs(speed - 1.0) > SPEED and (name or abs(travel - speed) < SPEED * speed):
            yield (
                f"axis {axis}: {path.column} moves {speed:.4g} times as far as the run{name and f' ({name})'}: "
                f"if its unit differs, give --map position.{axis}={path.column}*{1.0 / speed:.6g}"
            )
            continue
        same = [each for each in strokes if abs(each.theirs[0] / each.mine[0] - 1.0) < SCALE]
        slow = [each for each in same if each.theirs[1] < (1.0 - SPEED) * each.mine[1]]
        # A few strokes may seem slow because a row is missing at their top.
        if len(slow) >= MIN_STROKES and len(slow) > len(same) / 2:
            worst = min(slow, key=lambda each: each.theirs[1] / each.mine[1])
            begun = [each for each in run.machine.log.moves if each.axis == axis]
            lines = [each.line for each in begun if each.start_time <= worst.begin + recording.step]
            line = f", line {lines[-1]}" if lines else ""
            yield (
                f"axis {axis}{line}: {worst.theirs[1]:.4g} uu/s recorded, {worst.mine[1]:.4g} uu/s run: "
                "the drive does not reach its speed"
            )


def _strokes(run: Run, axis: int, path: Series, recording: MeasuredRecording) -> Iterator[_Stroke]:
    """Yield the strokes of an axis that a run and a recording both have, and that end where the next mark is."""
    found = matched(run, recording, ("axis",))
    ends = {("axis", axis, level) for level in (0, 1)}
    pairs = [(found.mine[a], found.theirs[b]) for a, b in found.pairs if found.mine[a].label in ends]
    mine = run_path(run, axis, recording)
    least = SCALE * float(np.ptp(mine.values))
    for (begin, their_begin), (end, their_end) in pairwise(pairs):
        if begin.label[2] and not end.label[2]:
            own = _figures(mine, begin, end)
            theirs = _figures(path, their_begin, their_end)
            if own is not None and theirs is not None and abs(own[0]) > least:
                yield _Stroke(begin.time, own, theirs)


def _figures(path: Series, begin: OutcomeMark, end: OutcomeMark) -> tuple[float, float] | None:
    """Return the travel of a stroke and its top speed; None if it has too few rows."""
    first, last = np.searchsorted(path.times, [begin.time, end.time])
    times = path.times[max(first - EDGE, 0) : last + EDGE]
    values = path.values[max(first - EDGE, 0) : last + EDGE]
    if len(times) < 4 * EDGE:
        return None
    width = max(len(times) // 8, 1)
    speeds = np.abs(values[width:] - values[:-width]) / (times[width:] - times[:-width])
    return float(values[-1] - values[0]), float(np.percentile(speeds, TOP))
