"""A leadscrew's error table: where the nut really is at equal steps of the motor, and the way back from there."""

from __future__ import annotations

from bisect import bisect_right
from itertools import pairwise


class Leadscrew:
    """Positions `actual` of the nut where it should be at `start`, `start + step`, …; linear between."""

    def __init__(self, start: float, step: float, actual: list[float]) -> None:
        if not step > 0.0:
            raise ValueError("the increment of a precision table must be above zero")
        if len(actual) < 2 or any(not a < b for a, b in pairwise(actual)):
            raise ValueError("a precision table needs two positions or more, each above the one before")
        self.start, self.step, self.actual = start, step, actual

    def motor(self, nut: float) -> float:
        """Where the motor must be, in the same unit, for the nut to be at `nut`."""
        k = self._segment(nut)
        if k is None:
            last = len(self.actual) - 1 if nut > self.actual[0] else 0
            return nut + self.start + last * self.step - self.actual[last]
        below, above = self.actual[k], self.actual[k + 1]
        return self.start + (k + (nut - below) / (above - below)) * self.step

    def slope(self, nut: float) -> float:
        """How much faster than the nut the motor goes there."""
        k = self._segment(nut)
        return 1.0 if k is None else self.step / (self.actual[k + 1] - self.actual[k])

    def _segment(self, nut: float) -> int | None:
        k = bisect_right(self.actual, nut) - 1
        return k if 0 <= k < len(self.actual) - 1 else None
