"""How machine time passes while hosts are served: with the wall clock, or only while a host waits for an answer.

The server calls `before()` when hosts are about to be heard, `work()` when they have been, and sleeps for `timeout()`.
Each lets the board run for a bounded while, so that a program that never waits cannot keep hosts from being heard.
"""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Callable

    from motionlang.mccl.hosts.console import Console

INFINITY = float("inf")
# Machine seconds between two looks at the hosts while the board is busy, and while it has more to do than it can.
SLICE, SHORTEST = 2e-3, 2e-5
# Machine seconds by which an answer may come early: a command takes machine time, its host would wait for the wall.
LEAD = 2e-3
# Wall seconds that the board may take to catch up with the wall before hosts are heard again, and that it may be late.
BUDGET, LATEST = 5e-3, 0.25
# Wall seconds between two looks at a board that is busy all the time.
TICK = 1e-3
# Wall seconds that the board may take in lock step before hosts are heard again.
TURN = 0.2e-3
# Machine seconds that a line takes at least in lock step: what it takes a real host to ask and to be answered.
STEP = 1e-3


class Pace(Protocol):
    """What the server needs to know of time. `by_line` says whether a host's lines are heard one at a time.

    In every turn of the server: `before` hosts are heard, `entered` for each line of theirs, then `work`; `timeout` is
    the wall seconds for which only a host could make something happen, None where that is for ever.
    """

    by_line: bool

    def before(self) -> None: ...
    def entered(self) -> None: ...
    def work(self) -> None: ...
    def timeout(self) -> float | None: ...


class RealTime:
    """Machine time is the wall's, `factor` machine seconds a second.

    A board that has more to do than this computer can compute falls behind; `late` counts the wall seconds lost.
    """

    by_line = False

    def __init__(
        self, console: Console, factor: float = 1.0, wall: Callable[[], float] = time.monotonic
    ) -> None:
        self.late = 0.0
        self._console, self._factor, self._wall = console, factor, wall
        self._slice = SLICE
        self._began = wall() - console.now / factor

    @property
    def due(self) -> float:
        """Machine time as it should be now."""
        return (self._wall() - self._began) * self._factor

    def before(self) -> None:
        """Catch up with the wall."""
        console, enough, due = self._console, self._wall() + BUDGET, self.due
        while console.now < due:
            self._bounded(console.run, due)
            if self._wall() >= enough:
                self._fall_behind()
                return

    def entered(self) -> None:
        """A line has come in; it takes the time that its commands take."""

    def work(self) -> None:
        """Answer what takes no longer than the blink of an eye."""
        self._bounded(self._console.settle, self.due + LEAD * self._factor)

    def timeout(self) -> float | None:
        """Wall seconds in which nothing will happen."""
        next_time = self._console.next_time()
        if next_time == INFINITY:
            return None
        if next_time == 0.0:
            return TICK
        return max(0.0, next_time / self._factor + self._began - self._wall())

    def _bounded(self, go: Callable[[float], object], until: float) -> None:
        """Let a slice of machine time pass; the more tasks never wait, the shorter it is."""
        console, began = self._console, self._wall()
        go(min(until, max(console.next_time(), console.now) + self._slice))
        took = self._wall() - began
        if took > BUDGET:
            self._slice = max(SHORTEST, 0.25 * self._slice)
        elif took < 0.25 * BUDGET:
            self._slice = min(SLICE, 2.0 * self._slice)

    def _fall_behind(self) -> None:
        lag = (self.due - self._console.now) / self._factor
        if lag > LATEST:
            self._began += lag
            self.late += lag


class LockStep:
    """Time stands still unless a host waits for an answer; a line takes `step` seconds, or as long as it waits.

    The same lines in the same order are answered the same, however fast this computer is and however long hosts think.
    """

    by_line = True

    def __init__(self, console: Console, step: float = STEP) -> None:
        self._console, self._step = console, step
        self._owed = 0.0
        self._stuck = False

    def before(self) -> None:
        """What hosts send is heard before time passes."""

    def entered(self) -> None:
        """A line is about to come in: the time of the last one is over."""
        if self._owed > self._console.now:
            self._console.run(self._owed)
        self._owed = self._console.now + self._step

    def work(self) -> None:
        """Let time pass while a host waits."""
        console, enough = self._console, time.monotonic() + TURN
        self._stuck = False
        while console.working and not self._stuck and time.monotonic() < enough:
            now = console.now
            limit = max(min(console.next_time(), 1e300), now) + SLICE
            self._stuck = not console.settle(limit) and console.now < limit

    def timeout(self) -> float | None:
        """None when only a host can make something happen."""
        return None if self._stuck or not self._console.working else 0.0
