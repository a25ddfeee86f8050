"""Tasks that poll and wait side by side: when all of them stand as they once stood, what follows is what followed then.

How a task goes on that has done nothing for a whole turn is told by what the turn left behind, by how long it has run
since, and by how long it still waits. So the machine as a whole comes back, after a while, to where it was, and will
again and again until something happens: an event, a level that is passed, the end of a wait that is not like others.
"""

from __future__ import annotations

from motionlang.lang.task import INFINITY, Delay

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.controller.controller import Controller
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.statement_time import StatementTime
    from motionlang.lang.task import Task

# What ends later than this, in seconds, is no part of a period but its limit.
FAR = 0.03
# So many states are remembered; where none has come back by then, none is looked for until something happens.
MOST = 20_000
# What leads no further than this, in seconds, is passed state by state, so that a longer period is found; until one has
# been, or there are so many states without one.
SHORT, ENOUGH = 0.3, 3000
# Times are compared in nanoseconds.
_UNITS = 1e9


class Recurrence:
    """The states that the tasks have been in since something happened, each with its time."""

    def __init__(self, machine: Controller | Machine) -> None:
        self._clock = machine.clock
        self._statements: StatementTime | None = getattr(machine, "statements", None)
        self._key, self._short = (-1, -1), SHORT
        self._seen: dict[tuple[object, ...], tuple[float, float, float]] = {}

    def forget(self) -> None:
        """A task has done something."""
        self._key = (-1, -1)

    def leap(
        self, tasks: Sequence[Task], turn: int, until: float, pace: Callable[[float], None] | None
    ) -> None:
        """After a slice: go on over as many whole periods as fit before anything can change, if they are known."""
        clock = self._clock
        now = clock.now
        acts, state = _state(tasks, now)
        if acts is None or len(self._seen) > MOST:
            return
        key = (clock.fired, acts)
        if key != self._key:
            self._key, self._seen, self._short = key, {}, SHORT
        signature = (turn, *state)
        statements = self._statements
        here = (now, 0.0, 0.0) if statements is None else (now, statements.base, statements.count)
        before = self._seen.setdefault(signature, here)
        if before[0] == now:
            return
        limit = min(_limit(tasks, now), clock.next_time())
        if limit == INFINITY:
            _note_vain(tasks, now)
        period = now - before[0]
        count = int((min(limit, until) - now) / period)
        if count * period > self._short or (count > 0 and len(self._seen) > ENOUGH):
            self._short = 0.0
            time = now + count * period
            if statements is not None and statements.reached == now:
                statements.repeat(before[1], before[2], count)
                time = statements.reached
            self._go_on(tasks, time, pace)

    def _go_on(self, tasks: Sequence[Task], time: float, pace: Callable[[float], None] | None) -> None:
        clock = self._clock
        if pace is not None:
            pace(time)
        for task in tasks:
            if _is_near(task, clock.now):
                task.wait.shift(time - clock.now)  # type: ignore[union-attr]
        clock.leaps += 1
        clock.now = time


def _state(tasks: Sequence[Task], now: float) -> tuple[int | None, list[object]]:
    """How much had been done when the tasks last looked, and how they stand; None where they act."""
    acts: int | None = None
    found: list[object] = []
    for task in tasks:
        wait, look = task.wait, task.look
        if wait is not None and not _is_near(task, now):
            found.append(wait.due())  # no part of a period: the same for as long as this very wait lasts
            continue
        if look is None or (acts is not None and look[0] != acts):
            return None, []
        acts = look[0]
        left = 0.0 if wait is None else wait.due() - now
        found += (look[1], round(task.into * _UNITS), round(left * _UNITS))
    return acts, found


def _limit(tasks: Sequence[Task], now: float) -> float:
    """Until when they go on like this: no level is passed, and nobody's wait ends that is no part of it."""
    limit = INFINITY
    for task in tasks:
        wait = task.wait
        if wait is None or _is_near(task, now):
            limit = min(limit, task.level)
        elif wait.ready():
            return now
        else:
            due = wait.due()
            limit = min(limit, due - FAR if wait.__class__ is Delay and task.look is not None else due)
    return limit


def _is_near(task: Task, now: float) -> bool:
    """Whether a task waits for a moment that is part of a period."""
    wait = task.wait
    return wait.__class__ is Delay and task.look is not None and wait.due() - now <= FAR


def _note_vain(tasks: Sequence[Task], now: float) -> None:
    for task in tasks:
        if task.in_vain is None and task.look is not None and task.look[2]:
            task.in_vain = now
