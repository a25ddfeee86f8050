"""Loops that only poll, as the program runs: many turns at once where all are the same.

A turn that did nothing and left every variable as it was will be repeated until something happens: the next event, or
the moment at which a compared reading (POS, TIME …) passes its level. So many whole turns as fit before it are paid
for at once. While other tasks can run that ends with the task's time slice. Where none can, and none could for as
long as the task has polled, it goes on to the moment at which the first of them may go on.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.runtime.environment import Environment
    from motionlang.mint.runtime.task import MintTask

INFINITY = float("inf")
# How far from a whole number of statements a turn may seem to have been, by rounding.
_ROUNDING = 1e-3


class Skipper:
    """What tasks poll, and since when."""

    def __init__(self, environment: Environment) -> None:
        self._environment = environment
        self._clock, self._machine = environment.clock, environment.machine
        # The task that polled last, from when to when without a break.
        self._task: MintTask | None = None
        self._first, self._last = 0.0, -1.0

    def skip(
        self,
        t: float,
        since: float,
        horizon: float,
        watches: tuple[tuple[object, ...], ...],
        state: tuple[object, ...],
        others: int,
        waited: float = 0.0,
        asks: bool = True,
    ) -> float:
        """A loop polls, its last turn from `since` to `t`: the end of the last turn that can be no different.

        `state` is what every turn leaves behind, after the count of what the program did; `others`: how often other
        tasks ran within the turn, which then is no more than remembered; `waited` are the milliseconds that the turn
        waited; `asks`: whether the loop looks at anything.
        """
        environment, task = self._environment, self._environment.task
        level = self._level(t, since, watches) if watches or task.sampled else INFINITY
        task.look, task.looked, task.level = (environment.acts, state[1:], asks), t, level
        if others:
            return t
        if since != self._last or task is not self._task:
            self._task, self._first = task, since
        horizon = min(self._horizon(t, horizon), level)
        if horizon == INFINITY:
            raise Refusal("never", "the loop looks for something that can no longer happen", "")
        if asks:
            self._note_vain(horizon, level)
        environment.task = task  # what others wait for may have been looked at with their eyes
        cost = self._cost(t - since, waited / 1000.0)
        self._last = task.looked = t + max(0, int((horizon - t) / cost)) * cost if cost else t
        return self._last

    def _level(self, t: float, since: float, watches: tuple[tuple[object, ...], ...]) -> float:
        """When what was looked at since a moment changes by itself."""
        from motionlang.mint.runtime.waits import next_change

        if self._environment.task.sampled:
            self._environment.task.sampled = False
            watches = (*watches, ("moving",))
        level = next_change(self._environment, since, watches)
        if level <= t:
            self._environment.acts += (
                1  # the turn was not in everything that it looked at like the one before
            )
        return level

    def _horizon(self, t: float, horizon: float) -> float:
        """The end of the time slice, or what lies beyond it where nobody else can run."""
        scheduler = self._machine.scheduler
        assert scheduler is not None
        if t >= horizon or self._first > scheduler.began:
            return horizon
        self._clock.now = t
        return max(horizon, scheduler.reach())

    def _note_vain(self, horizon: float, level: float) -> None:
        """Note since when the task looks for what nothing will bring about."""
        scheduler = self._machine.scheduler
        assert scheduler is not None
        if horizon >= scheduler.until and level == scheduler.next_change() == INFINITY:
            task = self._task
            assert task is not None
            task.in_vain = self._first if task.in_vain is None else task.in_vain

    def rest(
        self,
        t: float,
        since: float,
        horizon: float,
        watches: tuple[()],
        state: tuple[object, ...],
        others: int,
    ) -> float:
        """The same for a loop that looks at nothing."""
        return self.skip(t, since, horizon, watches, state, others, asks=False)

    def _cost(self, seconds: float, waited: float) -> float:
        """What a turn takes, in whole statements and milliseconds, so that no rounding adds up over millions of turns.

        0 where it was anything else.
        """
        instruction = self._machine.instruction_time
        statements = (seconds - waited) / instruction
        whole = round(statements)
        return whole * instruction + waited if abs(statements - whole) < _ROUNDING else 0.0
