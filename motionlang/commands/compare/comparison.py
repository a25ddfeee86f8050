"""Comparison of a recording with a run: residuals, lag and overshoot.

The figures are given in total, and for each move and phase.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import zip_longest
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.commands.compare.alignment import (
    ComparedMotion,
    Signal,
    find_delay,
    find_delay_near,
    fit,
    lag,
    simulated,
)
from motionlang.commands.compare.baseline import Baseline, Row, signals_of
from motionlang.commands.compare.differences import (
    later_remarks,
    scale_remarks,
    stroke_remarks,
    unrecorded_remarks,
)
from motionlang.commands.compare.drift import clock_text, drift
from motionlang.commands.compare.strokes import SAME_SHARE, Matched, is_explained, match
from motionlang.commands.recording import Recording
from motionlang.kernel import Diagnostic, ProgramError

Array = NDArray[np.float64]

# Seconds after an end in which a motor overshoots, and the share of the variance that least squares may leave in a
# signal whose scale they give.
AFTER, UNEXPLAINED = 0.5, 1e-3


class Comparison(NamedTuple):
    """The result: `delay` of the recording in seconds, and rows `signals` and `moves`.

    The rows are those of the report.
    """

    baseline: Baseline
    recording: Recording
    delay: float
    found: list[Signal]
    signals: list[Row]
    moves: list[Row]
    remarks: list[Diagnostic]

    @property
    def is_within(self) -> bool | None:
        """True if everything is within tolerance; None if no tolerance was given."""
        verdicts = [row["within"] for row in self.moves + self.signals if row["within"] is not None]
        return all(verdicts) if verdicts else None


def compare(
    baseline: Baseline,
    recording: Recording,
    *,
    tolerances: Mapping[str, float] | None = None,
    delay: float | None = None,
) -> Comparison:
    """Compare a recording with a run, or with another recording.

    `tolerances` has the largest allowed residual, in user units, by "position.0" or "position". If `delay`
    (s) is None it is computed from the data. Raises ProgramError if there is nothing to compare.
    """
    found, remarks, trace = signals_of(recording), list(recording.remarks), baseline.motion
    if baseline.run is None:  # both count from their first row
        first_row = float(recording.times[0])
        found = [each._replace(times=each.times - first_row) for each in found]
    matches = [match(trace, signal) for signal in found]
    rate = drift(found, matches)
    if rate is not None:
        begin = float(recording.times[0])
        found = [each._replace(times=begin + (each.times - begin) / rate) for each in found]
        matches = [match(trace, signal) for signal in found]
        hint = "set the clock of the logger, or measure with another one"
        remarks.append(Diagnostic("recording", clock_text(rate), severity="warning", hint=hint))
    known = _matches_with_zero(found, matches)
    first = min((each.pairs[0] for each in known), key=lambda pair: pair.run.begin, default=None)
    fitted = find_delay(trace, found) if delay is None else delay
    if fitted is not None and _is_explained(trace, found, matches, fitted, given=delay is not None):
        # The fit may be that of another repetition of the motion than the pairs.
        matches = [each if each is not None and each.is_same_at(fitted) else None for each in matches]
    elif delay is None and first is not None and not all(each.is_same_at(first.lag) for each in known):
        fitted = first.lag
    elif delay is None and first is not None and not all(each.is_same_at(fitted or 0.0) for each in known):
        fitted = find_delay_near(trace, found, first.lag)
    if fitted is None:
        raise ProgramError.of(
            "recording",
            f"cannot align in time: nothing moves in {baseline.noun} or in {recording.name}",
            hint="give the delay of the recording with --delay S",
        )
    delay = fitted
    compared = _Compared(trace, delay, tolerances or {})
    rows = baseline.moves
    signals = []
    strokes: dict[int, Matched] = {}
    moves = []
    for signal, matched in sorted(
        zip(found, matches, strict=True), key=lambda each: each[0].quantity != "position"
    ):
        if matched is not None and signal.axis not in strokes:
            strokes[signal.axis] = matched
            own = [row for row in rows if row["axis"] == signal.axis]
            remarks += stroke_remarks(signal.name, matched, delay, own, baseline.noun)
            remarks += later_remarks(signal.name, matched, delay, baseline.noun)
    axes = set()
    for signal, matched in zip(found, matches, strict=True):
        own_strokes = strokes.get(signal.axis)
        row = compared.signal(signal, matched, own_strokes)
        signals.append(row)
        compared_moves = list(compared.moves(signal, rows, own_strokes))
        moves += compared_moves
        if signal.axis not in axes and row["points"]:
            axes.add(signal.axis)
            begin, end = float(signal.times[0]) - delay, float(signal.times[-1]) - delay
            remarks += unrecorded_remarks(signal.name, compared_moves, begin, end, baseline.noun)
        remarks += scale_remarks(row, signal.quantity, matched, baseline.counts[signal.axis], baseline.noun)
    return Comparison(baseline, recording, delay, found, signals, moves, remarks)


def _matches_with_zero(found: Sequence[Signal], matches: Sequence[Matched | None]) -> list[Matched]:
    """Return the matches of positions, which show where motion happened, or else all."""
    known = [(signal, each) for signal, each in zip(found, matches, strict=True) if each is not None]
    return [each for signal, each in known if signal.quantity == "position"] or [each for _, each in known]


def _is_explained(
    trace: ComparedMotion,
    found: Sequence[Signal],
    matches: Sequence[Matched | None],
    delay: float,
    *,
    given: bool,
) -> bool:
    """True if the run at a delay explains all signals.

    A delay that was not given must not need another zero of the positions where the pairs of strokes need none.
    """
    for signal, matched in zip(found, matches, strict=True):
        if not is_explained(trace, signal, delay):
            return False
        if not given and signal.quantity == "position" and matched is not None and not matched.is_shifted:
            _, offset = fit(simulated(trace, signal, signal.times - delay), signal.values)
            if abs(offset) > SAME_SHARE * float(np.ptp(signal.values)):
                return False
    return True


# ------------------------------------------------------------------------------------------ figures


class _Compared:
    """One recording against one run, at one delay."""

    def __init__(self, trace: ComparedMotion, delay: float, tolerances: Mapping[str, float]) -> None:
        self._trace, self._delay, self._tolerances = trace, delay, tolerances

    def signal(self, signal: Signal, matched: Matched | None, strokes: Matched | None) -> Row:
        """Return the figures of a signal over its whole length, whose axis has these strokes."""
        times, values, residual = self._within(signal, 0.0, self._trace.end)
        expected = values - residual
        start = None if strokes is None else strokes.pairs[0].recorded.begin
        scale, offset = self._fit(signal, matched, start, expected, values)
        row = {"signal": signal.name, "column": signal.column, "points": len(times)}
        row |= {"scale": scale, "offset": offset, "moves": bool(len(times) and np.ptp(expected) > 0.0)}
        row |= {"lag": self._lag(signal, strokes, 0.0, self._trace.end)}
        return row | self._figures(signal, times, residual)

    def _fit(
        self, signal: Signal, matched: Matched | None, start: float | None, expected: Array, values: Array
    ) -> tuple[float | None, float | None]:
        """Return scale and offset: of the travel and at rest, or by least squares; None if they do not fit."""
        if not len(values):
            return 1.0, 0.0
        scale, offset = fit(expected, values)
        left = values - scale * expected - offset
        if matched is not None:
            scale = matched.scale
        elif float(left @ left) > UNEXPLAINED * float(np.var(values)) * len(values):
            return None, None
        if matched is not None and signal.quantity == "position":
            return scale, matched.offset
        before = np.zeros(0) if start is None else signal.values[signal.times < start]
        return scale, float(np.median(before)) if len(before) else offset

    def moves(self, signal: Signal, rows: Sequence[Row], strokes: Matched | None) -> Iterator[Row]:
        """Yield a row per move of the signal's axis, with one per phase.

        If the strokes of the axis differ, a move is as late as the recorded stroke that is paired with its own.
        """
        own = [row for row in rows if row["axis"] == signal.axis]
        for row, following in zip_longest(own, own[1:]):
            begin, end = row["start_time"], row["start_time"] + row["duration"]
            times, _, residual = self._within(signal, begin, end)
            made: Row = {"signal": signal.name, "axis": signal.axis, "command": row["command"]}
            made |= {"line": row["line"], "start_time": begin, "duration": row["duration"]}
            made |= self._figures(signal, times, residual)
            if strokes is None or strokes.is_same:
                made["lag"] = self._lag(signal, strokes, begin, end)
            else:
                behind = strokes.lag_of(begin, end)
                made["lag"] = None if behind is None else behind - self._delay
            if signal.quantity == "position":
                until = min(following["start_time"] if following else self._trace.end, end + AFTER)
                made["overshoot"] = self._overshoot(signal, row, end, max(end, until))
            made["phases"] = []
            for phase in row["phases"]:
                inside, _, left = self._within(signal, begin, begin + phase["duration"])
                made["phases"].append({"name": phase["name"]} | self._figures(signal, inside, left))
                begin += phase["duration"]
            yield made

    def _lag(self, signal: Signal, strokes: Matched | None, begin: float, end: float) -> float | None:
        """Return the lag of a signal in an interval, s; None if the strokes of its axis have no lag in common."""
        if strokes is not None and not strokes.is_same:
            return None
        if strokes is not None and signal.quantity == "position":
            signal = signal._replace(values=(signal.values - strokes.offset) / strokes.scale)
        return lag(self._trace, signal, self._delay, begin, end)

    def _within(self, signal: Signal, begin: float, end: float) -> tuple[Array, Array, Array]:
        """Return run times, measured values and residuals of a signal in an interval."""
        times = signal.times - self._delay
        first, last = np.searchsorted(times, (begin, end), "left")
        last = int(np.searchsorted(times, end, "right"))
        times, values = times[first:last], signal.values[first:last]
        return times, values, values - simulated(self._trace, signal, times)

    def _figures(self, signal: Signal, times: Array, residual: Array) -> Row:
        """Return the largest residual with sign and time, the RMS, and the verdict.

        The verdict is true if the largest residual is within the tolerance of the signal.
        """
        tolerance = self._tolerances.get(signal.name, self._tolerances.get(signal.quantity))
        if not len(times):
            return {"peak": None, "peak_time": None, "rms": None, "within": None}
        worst = int(np.argmax(np.abs(residual)))
        peak = float(residual[worst])
        return {
            "peak": peak,
            "peak_time": float(times[worst]),
            "rms": float(np.sqrt(np.mean(residual**2))),
            "within": None if tolerance is None else abs(peak) <= tolerance,
        }

    def _overshoot(self, signal: Signal, row: Row, end: float, until: float) -> float | None:
        """Return the overshoot after a move, user units; 0 if there is none."""
        _, values, _ = self._within(signal, end, until)
        if not len(values) or not row["distance"]:
            return None
        beyond = (values - row["end"]) * (1.0 if row["distance"] > 0.0 else -1.0)
        return max(0.0, float(beyond.max()))
