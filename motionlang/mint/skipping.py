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
    from motionlang.mint.environment import Environment
    from motionlang.mint.task import MintTask

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
        level = INFINITY
        if watches:
            from motionlang.mint.watching import next_change

            level = next_change(environment, since, watches)
            if level <= t:
                environment.acts += 1  # the turn was not like the one before in everything that it looked at
        task.look, task.looked, task.level = (environment.acts, state[1:], asks), t, level
        if others:
            return t
        if since != self._last or task is not self._task:
            self._task, self._first = task, since
        scheduler = self._machine.scheduler
        assert scheduler is not None
        if t < horizon and self._first <= scheduler.began:
            self._clock.now = t
            horizon = max(horizon, scheduler.reach())
            environment.task = task  # what the others wait for was looked at with their eyes
        horizon = min(horizon, level)
        if horizon == INFINITY:
            raise Refusal("never", "the loop looks for something that can no longer happen", "")
        if horizon >= scheduler.until and asks and level == scheduler.next_change() == INFINITY:
            environment.task = task
            task.in_vain = self._first if task.in_vain is None else task.in_vain
        cost = self._cost(t - since, waited / 1000.0)
        self._last = t + max(0, int((horizon - t) / cost)) * cost if cost else t
        task.looked = self._last
        return self._last

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
