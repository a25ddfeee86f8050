"""The kinds of waits that both languages have.

A task that must wait returns a `Wait`. The scheduler calls `ready` to test if it is over, and `due` to find
when it may be over next if nothing else happens.

- `Delay` waits for a time. Its end is known (`ends`), so neither function is called.
- `Condition` waits for a condition of the program. It is checked at events and at the times that its
  dependencies give (`change_times.py`).
- `Wait` itself is built from two functions, as in `wait_idle`.

The waits of individual statements and commands are defined with them: WAIT and PAUSE of Mint in
`kernel/mint/runtime/waits.py`, WA, WS, WT and WP of MCCL in `kernel/mccl/keywords/flow_waits.py`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY, Clock
from motionlang.kernel.controller.operations import Controller

if TYPE_CHECKING:
    from motionlang.kernel.lang.change_times import Dependencies, Note
    from motionlang.kernel.lang.machine.machine import Machine

# Times that differ by less than this are equal, so that rounding does not decide the order.
ROUNDING = 1e-9
# The profiler's period: how often a condition is checked if its readings cannot be solved.
TICK = 1e-3
# How long after a solved time a condition is checked: `POS > 50` is false at the exact time of 50.
_AFTER = (0.0, 1e-12, 1e-10, 1e-8)


class Wait:
    """The wait of a task.

    `since`   the time at which the task began to wait
    `ready()` true if the task may continue, checked after every event
    `due()`   the earliest time at which `ready` may become true if nothing else happens (infinite if never)
    `why`     a description, for the report of a wait that never ends
    `cause`   the kind of thing that ends it, one of `record.records.CAUSES`, and `what` its numbers
    `ends`    the time at which it certainly ends, if there is one; the two functions are then not called
    """

    __slots__ = ("cause", "due", "ends", "ready", "since", "what", "why")

    # True if no variable or memory of the program can end it.
    ignores_data = False
    # Returns when axes will be at rest, negative once they are, if only that ends it: nothing is tested meanwhile.
    end_of_moves: Callable[[], float] | None = None

    def __init__(
        self,
        since: float,
        ready: Callable[[], bool],
        due: Callable[[], float],
        why: str,
        cause: str = "condition",
        what: tuple[int, ...] = (),
    ) -> None:
        self.since, self.ready, self.due, self.why = since, ready, due, why
        self.cause, self.what = cause, what
        self.ends: float | None = None


class Delay(Wait):
    """A wait for a time; its description is made on demand, as a program has millions."""

    __slots__ = ("_clock",)

    cause = "time"
    what = ()
    ends: float
    ignores_data = True

    def __init__(self, clock: Clock, since: float, time: float) -> None:
        self.since, self._clock, self.ends = since, clock, time

    def ready(self) -> bool:
        return self._clock.now >= self.ends - ROUNDING

    def due(self) -> float:
        return self.ends

    @property
    def why(self) -> str:  # type: ignore[override]
        return f"for {self.ends - self.since:.10g} s"


class Idle(Wait):
    """A wait until all axes are idle with no released move buffered; a follower is idle when its master is."""

    __slots__ = ()

    def __init__(self, controller: Controller, since: float, axes: tuple[int, ...]) -> None:
        super().__init__(
            since,
            lambda: all(map(controller.is_at_standstill, axes)),
            lambda: max(map(controller.standstill_time, axes), default=since),
            until_idle(axes),
            "axis",
            axes,
        )


class Standstill(Idle):
    """A wait until axes are idle that need not be tested meanwhile.

    `end_of_moves` returns when they will be at rest, negative once they are.
    """

    __slots__ = ("end_of_moves",)

    def __init__(self, controller: Controller, since: float, axes: tuple[int, ...]) -> None:
        super().__init__(controller, since, axes)
        self.end_of_moves = controller.end_of_moves(axes)


class Condition(Wait):
    """A wait for a condition: checked at solved times, events, or ticks if unsolvable."""

    __slots__ = ("_checked", "_dependencies", "_holds", "_notes", "_solved", "_test", "ignores_data")

    cause = "condition"
    what = ()
    ends = None

    def __init__(
        self,
        dependencies: Dependencies,
        test: Callable[[], object],
        since: float,
        why: str,
        ignores_data: bool = False,
    ) -> None:
        self.ignores_data = ignores_data
        self._dependencies, self._test, self.since, self.why = dependencies, test, since, why
        self._notes: list[Note] = []
        # When the dependencies were recorded, after how many events, and the last time that `due` returned.
        self._checked, self._solved = (-1.0, -1), -1.0
        self._holds = False

    def ready(self) -> bool:
        """Return True if the condition holds now or immediately after."""
        clock = self._dependencies.clock
        now = clock.now
        self._checked = now, clock.fired
        delays = _AFTER if now == self._solved else _AFTER[:1]
        try:
            self._holds = any(self._evaluate(now + after * max(1.0, now)) for after in delays)
        finally:
            clock.now = now
        return self._holds

    def due(self) -> float:
        """Return the next time at which the condition may change by itself."""
        clock = self._dependencies.clock
        now = clock.now
        if self._checked != (now, clock.fired):
            self.ready()  # other tasks have run since
        if self._holds and now == self._solved:
            return now  # another solution would hide that the condition holds immediately after
        # After the time that was just checked.
        begin = now + 1e-7 * max(1.0, now) if now == self._solved else now
        moments = [self._dependencies.until(begin, [each]) for each in set(self._notes)]
        moment = min((each if each > begin else next_tick(now) for each in moments), default=INFINITY)
        self._solved = moment if moment > now else now + TICK
        return self._solved

    def _evaluate(self, moment: float) -> bool:
        """Evaluate the condition at a time, and store its dependencies."""
        dependencies = self._dependencies
        notes: list[Note] = []
        before, dependencies.notes = dependencies.notes, notes
        dependencies.clock.now = moment
        try:
            return bool(self._test())
        finally:
            self._notes = notes if dependencies.notes is notes else [(dependencies.at_once, ())]
            dependencies.notes = before


def wait_until(machine: Controller | Machine, since: float, time: float) -> Wait:
    """Return a wait for a time."""
    return Delay(machine.clock, since, time)


def wait_idle(controller: Controller, since: float, axes: Iterable[int]) -> Wait:
    """Return a wait until all of `axes` are idle."""
    return Idle(controller, since, tuple(axes))


def until_idle(axes: tuple[int, ...]) -> str:
    """Return the description of a wait until axes are idle."""
    return f"for axis {', '.join(map(str, axes))} to be idle"


def next_tick(now: float) -> float:
    """Return the first tick of the profiler after a time."""
    return (int(now / TICK + 1e-6) + 1) * TICK
