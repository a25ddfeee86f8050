"""Samples of a motor, and the searches in them."""

from __future__ import annotations

from math import ceil, inf

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel.servo.demand import Demanded
from motionlang.kernel.servo.step import COLUMNS

Array = NDArray[np.float64]

# Seconds: a profile that ends this much later counts as ended.
_AT_ONCE = 1e-9
# Counts within which a motor is at a position.
_ON = 1e-6
# A motor is at rest when its following error has been this small, counts, for so many seconds.
REST_ERROR, REST_TIME = 1.0, 0.02


def rests_as_seen(track: Demanded) -> bool:
    """True if the last profile is the rest assumed at the end of the one before."""
    if len(track.profiles) < 2:
        return False
    before, after = track.profiles[-2:]
    return (
        after.shape == "hold"
        and after.duration == inf
        and before.end_velocity == 0.0
        and before.end == after.start
        and track.starts[-1] - track.starts[-2] >= before.duration - _AT_ONCE
        and before.pieced
    )


class SampleBlock:
    """Consecutive samples from number `first` on, with a row for each of `step.COLUMNS`.

    `encoder` is the measured position in the motor's own coordinates, counts; velocity is in counts/s, error in
    counts, output in volts, current in A.
    """

    __slots__ = ("first", "rows")

    def __init__(self, first: int, rows: Array) -> None:
        self.first, self.rows = first, rows

    def __len__(self) -> int:
        return int(self.rows.shape[1])

    @property
    def end(self) -> int:
        """The number of the first sample after the block."""
        return self.first + len(self)

    @property
    def encoder(self) -> Array:
        """Measured positions."""
        return self._row("measured")

    @property
    def velocity(self) -> Array:
        """Velocities."""
        return self._row("velocity")

    @property
    def error(self) -> Array:
        """Following errors."""
        return self._row("demand") - self._row("measured")

    @property
    def output(self) -> Array:
        """Outputs of the controller."""
        return self._row("output")

    @property
    def current(self) -> Array:
        return self._row("current")

    def _row(self, column: str) -> Array:
        row: Array = self.rows[COLUMNS.index(column)]
        return row

    def keep(self, first: int, until: int) -> None:
        """Keep only the samples from `first` to `until` (exclusive)."""
        self.rows = self.rows[:, max(first - self.first, 0) : until - self.first]
        self.first = max(first, self.first)

    def extend(self, made: Array) -> None:
        """Append further samples."""
        self.rows = np.concatenate((self.rows, made), axis=1)


class SettlingWindow:
    """The window in which a motor must be for `hold` seconds to count as settled.

    It is a following error of at most `error` counts and a speed of at most `speed` counts/s; with
    `at_target` the distance to the target replaces the following error. `since` is the sample from which the motor
    has been inside. If the window is `announced`, waits are checked when the motor has settled.
    """

    __slots__ = ("announced", "at_target", "error", "hold", "since", "speed")

    def __init__(
        self,
        error: float = inf,
        speed: float = inf,
        hold: float = 0.0,
        at_target: bool = False,
        announced: bool = True,
    ) -> None:
        self.error, self.speed, self.hold, self.at_target = error, speed, hold, at_target
        self.announced = announced
        self.since = inf

    def same(self, other: SettlingWindow | None) -> bool:
        """True if another window has the same bounds."""
        names = ("error", "speed", "hold", "at_target")
        return other is not None and all(getattr(self, name) == getattr(other, name) for name in names)

    def inside(self, samples: SampleBlock, target: float) -> NDArray[np.bool_]:
        """Return a mask of the samples inside; `target` is in motor coordinates."""
        off = target - samples.encoder if self.at_target else samples.error
        made = np.abs(off) <= self.error
        if self.speed < inf:
            made &= np.abs(samples.velocity) <= self.speed
        return made

    def pass_by(self, samples: SampleBlock, target: float, until: int) -> None:
        """Update `since` with the samples before number `until`."""
        inside = self.inside(samples, target)[: until - samples.first]
        outside = np.flatnonzero(~inside)
        if len(outside) == len(inside) or (len(outside) and outside[-1] == len(inside) - 1):
            self.since = inf
        elif len(outside):
            self.since = float(samples.first + int(outside[-1]) + 1)
        elif self.since == inf:
            self.since = float(samples.first)

    def settled(self, samples: SampleBlock, target: float, now: int, rate: float) -> float:
        """Return the first sample from `now` on at which the motor is settled, or inf.

        If the samples end inside the window, return the sample at which `hold` will be over.
        """
        for onset, end in self.onsets(samples, target, rate):
            if max(onset, now) < end or end == samples.end:
                return float(max(onset, now))
        return inf

    def onsets(self, samples: SampleBlock, target: float, rate: float) -> list[tuple[int, int]]:
        """Return, for each stay inside, the sample when settled and the first one outside."""
        found = []
        for begin, end in _runs(self.inside(samples, target)):
            known = begin == 0 and self.since < inf
            first = self.since if known else float(samples.first + begin)
            found.append((ceil(first + self.hold * rate - 1e-6), samples.first + end))
        return found


def _runs(inside: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the start and end of each run of samples inside."""
    padded = np.concatenate(([False], inside, [False]))
    edges = np.flatnonzero(padded[1:] != padded[:-1])
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def crossing(position: Array, level: float) -> int | None:
    """Return the first later sample that has reached `level`, or None.

    If the first sample is at the level, return the first one that has left it.
    """
    margin = _ON + 1e-12 * abs(level)
    off = position - level
    if abs(off[0]) <= margin:
        found = np.flatnonzero(np.abs(off) > margin)
    elif off[0] > 0.0:
        found = np.flatnonzero(off <= margin)
    else:
        found = np.flatnonzero(off >= -margin)
    return int(found[0]) if len(found) else None


def next_side(position: Array, level: float, side: int) -> tuple[int | None, int]:
    """Return the first later sample at which the motor changes sides of `level`.

    The new side is also returned. `side` is the present one, 0 if it is not known yet. Reaching the level counts as
    passing it.
    """
    margin = _ON + 1e-12 * abs(level)
    off = position - level
    start = 1
    if side and abs(off[0]) <= margin:  # it is at the level: moving back is no change
        away = np.flatnonzero(np.abs(off) > margin)
        if not len(away):
            return None, side
        start = int(away[0])
        if (off[start] > 0.0) != (side > 0):
            return start, -side
    if side == 0:
        found = np.flatnonzero(np.abs(off[1:]) > margin)
        return (int(found[0]) + 1, 1 if off[int(found[0]) + 1] > 0.0 else -1) if len(found) else (None, 0)
    found = np.flatnonzero(off[start:] * side <= margin)
    return (int(found[0]) + start, -side) if len(found) else (None, side)


def next_other_side(values: Array, level: float) -> int | None:
    """Return the first sample that is not clearly on the initial side of a level."""
    off = values - level
    side = np.where(np.abs(off) <= _ON + 1e-9 * abs(level), 0.0, np.sign(off))
    found = np.flatnonzero((side[1:] != side[0]) | (side[1:] == 0.0))
    return int(found[0]) + 1 if len(found) else None
