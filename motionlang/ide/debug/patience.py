"""How long a command of the debugger waits for a statement.

The next statement may begin after eight hours of events, or never. Work is counted in advances of the clock, so that
the same command gives up at the same time in every run.
"""

from __future__ import annotations

from motionlang.ide.debug.replay import PAUSE, Replay
from motionlang.kernel import INFINITY

# The advances of the clock that a command always waits; it waits longer if the run up to there took more.
ADVANCES = 16384


class Patience:
    """A number of advances of the clock after `time`.

    It is as many as the run had made up to then, and at least `ADVANCES`.
    An instance is what `Replay.go` calls to give up: shortly after the end, for a statement of another task.
    """

    def __init__(self, replay: Replay, time: float) -> None:
        self._replay = replay
        self._last = INFINITY
        # The last time to which the clock has advanced.
        self._time = self.reached = time

    @property
    def is_over(self) -> bool:
        return self._replay.advances > self._last

    def renew(self) -> None:
        """Wait as long again, since the program makes progress."""
        self._last = self._replay.advances + max(ADVANCES, self._replay.advances)

    def __call__(self, time: float) -> bool:
        self.reached = time
        if self._last == INFINITY and time >= self._time:
            self.renew()
        return self._replay.advances > self._last + PAUSE
