"""Machine time that follows real time."""

from __future__ import annotations

from collections.abc import Callable


class WallClock:
    """`factor` machine seconds per second of `wall`; the machine time is `now` at first."""

    def __init__(self, wall: Callable[[], float], factor: float, now: float = 0.0) -> None:
        self.wall, self.factor = wall, factor
        self.began = wall() - now / factor

    @property
    def due(self) -> float:
        """The machine time that corresponds to the current real time."""
        return (self.wall() - self.began) * self.factor

    def left(self, time: float) -> float:
        """Return the seconds of real time until a machine time."""
        return time / self.factor + self.began - self.wall()
