"""The baseline of a recording: a run of the program, or an older recording of the machine.

Both have the position of each axis at any time and a list of moves, so that one comparison serves both. A recording has
no commands: its moves are its strokes, its velocity is the slope of its positions, and its time 0 is its first row.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.commands.compare.alignment import ComparedMotion, Signal
from motionlang.commands.compare.strokes import strokes_of
from motionlang.commands.recording import QUANTITIES, Mapped, RecordedTable, Recording, read_recording
from motionlang.kernel import ProgramError, Run
from motionlang.kernel.report import moves as moves_of

Array = NDArray[np.float64]
Row = dict[str, Any]

# The quantity of which another one is the slope.
_SLOPE_OF = {"velocity": "position", "acceleration": "velocity", "jerk": "acceleration"}


class RecordedMotion:
    """The motion of an older recording, from 0 to `end`, s."""

    def __init__(self, recording: Recording) -> None:
        self.begin = float(recording.times[0])
        self.end = float(recording.times[-1]) - self.begin
        self._samples: dict[tuple[int, str], tuple[Array, Array]] = {
            (each.axis, each.quantity): (each.times - self.begin, each.values)
            for each in signals_of(recording)
        }
        self.axes = sorted({axis for axis, _ in self._samples})
        for axis in self.axes:
            for quantity, integral in _SLOPE_OF.items():
                times, values = self._samples.get((axis, integral), (np.zeros(1), np.zeros(1)))
                slope = (times[1:] + times[:-1]) / 2, np.diff(values) / np.diff(times)
                self._samples.setdefault((axis, quantity), slope if len(times) > 1 else (times, 0.0 * values))
            self._samples.setdefault((axis, "position"), (np.zeros(1), np.zeros(1)))

    def at(self, axis: int, quantity: str, times: Array) -> Array:
        """Return a quantity of an axis in user units at any `times`, in s."""
        return np.interp(times, *self._samples[axis, quantity])


class Baseline(NamedTuple):
    """A run, or a recording without one: its motion, its moves, and the counts of a user unit of each axis.

    `noun` is its name in a sentence, `length` how long its motion takes by itself, in s, None if a time limit ends it.
    """

    name: str
    noun: str
    motion: ComparedMotion
    counts: Mapping[int, float]
    moves: list[Row]
    length: float | None
    run: Run | None
    sentence: str


def baseline_of(made: Run | Recording) -> Baseline:
    """Return a run or a recording as that with which another recording is compared."""
    if isinstance(made, Run):
        counts = {axis: each.scale.counts for axis, each in made.controller.axes.items()}
        length = made.time if made.status in ("ended", "stopped") else None
        rows = list(moves_of(made))
        return Baseline(made.source.name, "the run", made.trace, counts, rows, length, made, "")
    motion = RecordedMotion(made)
    rows = _moves(made, motion)
    counts = dict.fromkeys(motion.axes, 1.0)
    return Baseline(made.name, made.name, motion, counts, rows, motion.end, None, made.sentence)


def _moves(recording: Recording, motion: RecordedMotion) -> list[Row]:
    """Return the strokes of the positions of a recording as rows of a report, in order of time."""
    strokes = [
        (each.begin, signal.axis, each)
        for signal in signals_of(recording)
        if signal.quantity == "position"
        for each in strokes_of(motion, signal._replace(times=signal.times - motion.begin))
    ]
    return [
        {
            "axis": axis,
            "command": "",
            "line": 0,
            "start_time": begin,
            "duration": each.duration,
            "distance": each.travel,
            "end": each.level + each.travel,
            "phases": [],
        }
        for begin, axis, each in sorted(strokes, key=lambda stroke: stroke[:2])
    ]


def signals_of(recording: Recording) -> list[Signal]:
    """Return the signals of a recording with their axes."""
    found = []
    for each in recording.signals.values():
        quantity, _, axis = each.target.partition(".")
        kind = "position" if quantity == "actual" else quantity
        found.append(Signal(int(axis), kind, each.column, each.times, each.scaled, recording.events))
    return found


def read_compared(
    table: RecordedTable, mapping: Sequence[Mapped], baseline: Baseline | None = None
) -> Recording:
    """Return a recording of motion, compared with a baseline or to be one; raise ProgramError if it has none."""

    def check(target: str) -> None:
        quantity, _, axis = target.partition(".")
        if quantity not in QUANTITIES:
            problem, hint = f"{quantity!r} is no quantity of an axis", f"one of {', '.join(QUANTITIES)}"
        elif not axis.isdecimal() or (baseline is not None and int(axis) not in baseline.counts):
            first = 0 if baseline is None else next(iter(baseline.counts))
            owner = "this controller" if baseline is None or baseline.run is not None else baseline.noun
            problem = f"{target!r} names no axis of {owner}"
            hint = f"{quantity}.{first} is that of the first axis"
        else:
            return
        raise ProgramError.of("recording", problem, hint=hint)

    length = None if baseline is None else baseline.length
    recording = read_recording(table, mapping, QUANTITIES, length=length, checked=check)
    if not recording.signals:
        raise ProgramError.of(
            "recording",
            f"the columns of {table.name} are not assigned",
            hint=f"--map position.0=NAME; its columns are {', '.join(table.columns)}",
        )
    return recording
