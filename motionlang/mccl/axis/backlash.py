"""Compensation of backlash: the motor goes BD ahead of the load, whichever way the axis goes."""

from __future__ import annotations

from motionlang.controller.motion.takeup import Takeup

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.controller import Controller


class Backlash:
    """The play of one axis from the moment of BN, in the middle of it; positions of the controller are the load's."""

    def __init__(self, controller: Controller, number: int, half: float) -> None:
        self._clock = controller.clock
        self._takeup = Takeup(controller.axes[number], self._clock.now)
        self._takeup.size, self._takeup.taken = 2.0 * half, half

    def shift(self) -> float:
        """How far the motor is ahead of the load, counts; negative behind it."""
        return self._takeup.advance(self._clock.now, True) - 0.5 * self._takeup.size

    def resize(self, half: float) -> None:
        """BD while it is on: the motor stays where it is until the axis moves."""
        taken = self.shift() + half
        self._takeup.size, self._takeup.taken = 2.0 * half, taken
