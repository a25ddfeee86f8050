"""Error table of a leadscrew: the actual nut position at equal steps of the motor.

The inverse, from nut to motor, is here too.
"""

from __future__ import annotations

from bisect import bisect_right
from itertools import pairwise


class Leadscrew:
    """Actual positions of the nut at motor positions `start`, `start + step`, …

    Between them the nut position is linear.
    """

    def __init__(self, start: float, step: float, actual: list[float]) -> None:
        if not step > 0.0:
            raise ValueError("the increment of a precision table must be above zero")
        if len(actual) < 2 or any(not a < b for a, b in pairwise(actual)):
            raise ValueError("a precision table needs two positions or more, each above the one before")
        self.start, self.step, self.actual = start, step, actual

    def motor(self, nut: float) -> float:
        """Return the motor position, in the same unit, that puts the nut at `nut`."""
        k = self._segment(nut)
        if k is None:
            last = len(self.actual) - 1 if nut > self.actual[0] else 0
            return nut + self.start + last * self.step - self.actual[last]
        below, above = self.actual[k], self.actual[k + 1]
        return self.start + (k + (nut - below) / (above - below)) * self.step

    def slope(self, nut: float) -> float:
        """Return the ratio of motor speed to nut speed at `nut`."""
        k = self._segment(nut)
        return 1.0 if k is None else self.step / (self.actual[k + 1] - self.actual[k])

    def _segment(self, nut: float) -> int | None:
        k = bisect_right(self.actual, nut) - 1
        return k if 0 <= k < len(self.actual) - 1 else None
