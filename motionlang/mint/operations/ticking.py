"""Readings that change while nothing happens, and whose moments nobody can solve: each one asks for another look.

Who waits for such a reading is woken by every event. So a reading makes one at the moment at which it may have changed;
when nobody reads it any more there are none.
"""

from __future__ import annotations

from motionlang.controller.sensor import next_tick

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.environment import Environment


class Ticks:
    """The next moment that is worth a look."""

    def __init__(self, environment: Environment) -> None:
        self._environment, self._clock = environment, environment.clock
        self._due = -1.0

    def at(self, time: float) -> None:
        """Have everybody look at `time`, unless they will earlier; a loop that polls until then is not skipped."""
        self._environment.acts += 1
        if not self._clock.now < self._due <= time:
            self._due = time
            self._clock.at(time, _look)

    def soon(self) -> None:
        """Have everybody look at the next tick of the profiler."""
        self.at(next_tick(self._clock.now))


def _look() -> None:
    """An event whose only purpose is that everybody looks around."""
