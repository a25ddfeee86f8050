"""The pace of a run: its machine time is held to real time."""

from __future__ import annotations

from math import inf
from time import monotonic

# Real time by which a run may lag before the lag is lost, s.
MAX_LAG = 0.25


class PlayPace:
    """Machine time as real time has it, at a speed.

    If the computer is too slow for the machine, the run is late and does not catch up.
    """

    def __init__(self, speed: float) -> None:
        self.speed = speed
        self.is_late = False
        # The real time at which machine time was 0 at the present speed; -inf until `left` is asked.
        self._zero = -inf

    def restart(self) -> None:
        """Count from the next machine time on."""
        self._zero, self.is_late = -inf, False

    def set_speed(self, speed: float) -> None:
        self.restart()
        self.speed = speed

    @property
    def machine_time(self) -> float:
        """The machine time that real time has come to, s."""
        return (monotonic() - self._zero) * self.speed

    def left(self, now: float) -> float:
        """Return the real time until a machine time, s."""
        real = monotonic()
        if self._zero == -inf:
            self._zero = real - now / self.speed
        left = self._zero + now / self.speed - real
        if left < -MAX_LAG:
            self._zero -= left
            self.is_late = True
        elif left > 0.0:
            self.is_late = False
        return left
