"""How machine time passes while hosts are served: real time or lock step.

In lock step, time passes only while a host waits for an answer. The server calls `before()` before it reads
from hosts and `work()` afterwards, and sleeps for `timeout()`. Each call lets the board run for a bounded
time, so that a program that never waits cannot block the hosts.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, Protocol

from motionlang.hosts.serve.wall import WallClock
from motionlang.kernel import INFINITY

if TYPE_CHECKING:
    from motionlang.hosts.console import HostConsole

# Machine seconds between two polls of the hosts while the board is busy, and while it is overloaded.
SLICE, MIN_SLICE = 2e-3, 2e-5
# Seconds of real time by which an answer may be early: a command takes machine time, and its host would wait in
# real time.
LEAD = 2e-3
# Seconds of real time that the board may take to catch up before hosts are read again, and that it may be
# late.
BUDGET, LATEST = 5e-3, 0.25
# Seconds of real time between two polls of a board that is always busy.
TICK = 1e-3
# Seconds of real time that the board may take in lock step before hosts are read again.
TIME_SLICE = 0.2e-3
# Least machine seconds of a line in lock step: the time that a real host takes to ask and to be answered.
STEP = 1e-3


class ServerPace(Protocol):
    """The control of time in a server; `by_line` is True if lines are read one by one.

    In every iteration the server calls `before`, then `entered` for each line from a host, then `work`. `timeout`
    is the real time, in seconds, during which nothing happens unless a host sends something; None means unlimited.
    """

    by_line: bool

    def before(self) -> None: ...
    def entered(self) -> None: ...
    def work(self) -> None: ...
    def timeout(self) -> float | None: ...


class RealTime:
    """Machine time follows real time: `factor` machine seconds per second.

    A board with more work than this computer can do falls behind; `late` is the real time lost, in seconds.
    """

    by_line = False

    def __init__(
        self, console: HostConsole[Any], factor: float = 1.0, wall: Callable[[], float] = time.monotonic
    ) -> None:
        self.late = 0.0
        self._console = console
        self._slice = SLICE
        self._clock = WallClock(wall, factor, console.now)

    @property
    def due(self) -> float:
        """The machine time that corresponds to the current real time."""
        return self._clock.due

    def before(self) -> None:
        """Let the board catch up with real time."""
        console, enough, until = self._console, self._clock.wall() + BUDGET, self.due
        while console.now < until:
            self._bounded(console.run, until)
            if self._clock.wall() >= enough:
                self._fall_behind()
                return

    def entered(self) -> None:
        """Do nothing: a line takes the time of its commands."""

    def work(self) -> None:
        """Answer commands that end less than `LEAD` after the machine time due."""
        self._bounded(self._console.settle, self.due + LEAD * self._clock.factor)

    def timeout(self) -> float | None:
        """Return the real time until the next event, s; None if there is none."""
        next_time = self._console.next_time()
        if next_time == INFINITY:
            return None
        if next_time == 0.0:
            return TICK
        return max(0.0, self._clock.left(next_time))

    def _bounded(self, go: Callable[[float], object], until: float) -> None:
        """Run one slice of machine time, which is shorter while tasks are busy."""
        console, began = self._console, self._clock.wall()
        go(min(until, max(console.next_time(), console.now) + self._slice))
        took = self._clock.wall() - began
        if took > BUDGET:
            self._slice = max(MIN_SLICE, 0.25 * self._slice)
        elif took < 0.25 * BUDGET:
            self._slice = min(SLICE, 2.0 * self._slice)

    def _fall_behind(self) -> None:
        lag = -self._clock.left(self._console.now)
        if lag > LATEST:
            self._clock.began += lag
            self.late += lag


class LockStep:
    """Time passes only while a host waits for an answer.

    A line takes `step` seconds, until `busy_until`, or as long as it waits. The same lines in the same order get the
    same answers, regardless of the speed of this computer and of the time between the lines. With `at_once` the time
    passes before the answer is sent, so that a program running in the meantime can react; without it, before the
    next line.
    """

    by_line = True

    def __init__(self, console: HostConsole[Any], step: float = STEP, at_once: bool = False) -> None:
        self._console, self._step, self._at_once = console, step, at_once
        self.busy_until = 0.0
        self._stuck = False

    def before(self) -> None:
        """Do nothing: lines from hosts are read before time passes."""

    def entered(self) -> None:
        """End the time of the previous line before a new line is processed."""
        if self._at_once:
            self.busy_until = max(self.busy_until, self._console.now) + self._step
            return
        if self.busy_until > self._console.now:
            self._console.run(self.busy_until)
        self.busy_until = self._console.now + self._step

    def work(self) -> None:
        """Let time pass while a host waits."""
        console, enough = self._console, time.monotonic() + TIME_SLICE
        self._stuck = False
        while console.working and not self._stuck and time.monotonic() < enough:
            now = console.now
            limit = max(min(console.next_time(), 1e300), now) + SLICE
            self._stuck = not console.settle(limit) and console.now < limit
        if self._at_once and self.busy_until > console.now and (self._stuck or not console.working):
            console.run(self.busy_until)

    def timeout(self) -> float | None:
        """Return None if nothing happens until a host sends something, else 0."""
        return None if self._stuck or not self._console.working else 0.0
