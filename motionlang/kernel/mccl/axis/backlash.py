"""Backlash compensation: the motor leads the load by BD in either direction."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy

from motionlang.kernel.controller.motion.takeup import Takeup
from motionlang.kernel.controller.operations import Controller


class Backlash:
    """The backlash of one axis, which BN sets to its middle.

    Positions of the controller are those of the load.
    """

    def __init__(self, controller: Controller, number: int, half: float) -> None:
        self._clock = controller.clock
        self._takeup = Takeup(controller.axes[number], self._clock.now)
        self._takeup.size, self._takeup.taken = 2.0 * half, half

    def shift(self) -> float:
        """Return how far the motor leads the load, counts; negative if it lags."""
        return self._takeup.advance(self._clock.now, True) - 0.5 * self._takeup.size

    def copied(self) -> Backlash:
        """Return a copy as of now, which BD and BF do not change."""
        self.shift()
        made = copy(self)
        made._takeup = copy(self._takeup)
        return made

    def shifts(self, times: Sequence[float]) -> list[float]:
        """Return how far the motor leads the load at rising times since the copy was made."""
        takeup = copy(self._takeup)
        return [takeup.advance(time, True) - 0.5 * takeup.size for time in times]

    def resize(self, half: float) -> None:
        """Apply BD while compensation is on; the motor moves only when the axis next does."""
        taken = self.shift() + half
        self._takeup.size, self._takeup.taken = 2.0 * half, taken
