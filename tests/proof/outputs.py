"""Checks of the outputs of a run: report and trace agree with the tracks."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import zip_longest
from math import isfinite

from motionlang.kernel import Axis
from motionlang.kernel.log import LoggedMove
from motionlang.kernel.tracks import Samples
from tests.proof.checker import ROUNDED, SLACK, Proof, RunRecords, position
from tests.proof.segments import spans

# Rows of the trace that are compared with the tracks.
ROWS = 40


def check_report(proof: Proof, run: RunRecords, rows: Iterable[Mapping[str, object]]) -> None:
    """Check each move of a report against the track: ends, duration and peak speed."""
    moves = (move for move in run.moves if move.profile is not None)
    reported, logged, before = 0, 0, len(proof.violations)
    for row, move in zip_longest(rows, moves):
        reported, logged = reported + (row is not None), logged + (move is not None)
        if row is not None and move is not None:
            _check_row(proof, run, row, move)
    if reported != logged:
        del proof.violations[before:]
        proof.breaks(0, f"the report has {reported} moves, the log {logged}")


def _check_row(proof: Proof, run: RunRecords, row: Mapping[str, object], move: LoggedMove) -> None:
    a, profile = run.axes[move.axis], move.profile
    assert profile is not None
    start, end, duration, peak = (float(row[name]) for name in ("start", "end", "duration", "peak_speed"))  # type: ignore[arg-type]
    where = f"axis {move.axis} from {move.start_time:.6f} s"
    if row["axis"] != move.axis or row["line"] != move.line or row["start_time"] != move.start_time:
        proof.breaks(move.line, f"{where}: the report has it at {row['start_time']} s, line {row['line']}")
        return
    if move.start_time + duration > run.until + 1e-12 * (1.0 + run.until):
        proof.breaks(
            move.line,
            f"{where}: the report has it end at {move.start_time + duration:g} s, the run at {run.until:g} s",
        )
        return
    if move.overlaid or move.offset or not isfinite(profile.start):
        return
    points = [(move.start_time, start)]
    finish = move.start_time + duration
    if isfinite(end) and finish <= run.until:
        points.append((finish, end))
    for time, reported in points:
        counts = reported * move.scale + move.zero
        done = run.logged(a, move, time, time == finish and duration > 0.0)
        if abs(counts - done) > SLACK * max(1.0, abs(done)) + 8e-16 * (1.0 + time) * _speed(a, time):
            proof.breaks(
                move.line,
                f"{where}: the report has it at {counts:g} at {time:.6f} s, the track at {done:g}",
            )
    _check_peak(proof, run, a, peak * abs(move.scale), (move.start_time, finish), move.line)


def _check_peak(
    proof: Proof, run: RunRecords, a: Axis, reported: float, time: tuple[float, float], line: int
) -> None:
    """Check the reported peak speed of a move against the speeds on its track."""
    begin, finish = time[0], min(time[1], run.until)
    k, seen, exact = max(a.index_at(begin), 0), 0.0, True
    late = finish - ROUNDED * (1.0 + finish)  # an end is the sum of a beginning and a time
    while k < len(a.starts) and a.starts[k] < late:
        profile, first = a.profiles[k], max(begin - a.starts[k], 0.0)
        last = min(finish, a.starts[k + 1] if k + 1 < len(a.starts) else finish) - a.starts[k]
        if run.expected_motion.of[a.index][k].kind == "rest":
            return
        if profile.pieced:
            seen = max([seen, *(span.peak(1) for span in spans(profile, first, last - first))])
        elif last > first:  # another profile may replace it at once
            exact = False
            # At its ends the velocity of a master may step.
            inside = 4.0 * ROUNDED * (1.0 + finish)
            first, last = min(first + inside, last), max(last - inside, first)
            steps = [first + (last - first) * n / 16.0 for n in range(17)]
            seen = max([seen, *(abs(profile.velocity(step)) for step in steps)])
        k += 1
    slack = 1e-9 + SLACK * seen
    if reported < seen - slack or (exact and finish == time[1] and reported > seen + slack):
        proof.breaks(
            line,
            f"axis {a.index} from {begin:.6f} s: the report has a peak of {reported:g}, the track {seen:g}",
        )


def check_trace(proof: Proof, run: RunRecords, samples: Samples) -> None:
    """Check position and velocity of every row of a trace against the track."""
    for column, values in zip(samples.columns, samples.data, strict=True):
        if column.axis is None or column.quantity != "position":
            continue
        a = run.axes[column.axis]
        for time, value in zip(samples.time.tolist(), values.tolist(), strict=True):
            size, zero = a.scale_at(time)
            counts = value * size + zero
            # The time of a row is rounded: a profile that begins then may have begun.
            late = time + 4e-15 * (1.0 + time)
            expected = position(a, late), position(a, time, ending=True)
            slack = SLACK * max(1.0, *map(abs, expected)) + 8e-16 * (1.0 + time) * _speed(a, time)
            if min(abs(counts - counts_then) for counts_then in expected) > slack:
                proof.breaks(
                    0,
                    f"axis {a.index} at {time:.6f} s: the trace has it at {counts:g}, the track at {expected[0]:g}",
                )
                break


def _speed(a: Axis, time: float) -> float:
    i = a.index_at(time)
    return abs(a.profiles[i].velocity(time - a.starts[i]))
