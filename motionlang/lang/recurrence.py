"""Tasks that poll and wait side by side: when all of them stand as they once stood, what follows is what followed then.

How a task goes on that has done nothing for a whole turn is told by what the turn left behind, by how long it has run
since, and by how long it still waits. So the machine as a whole comes back, after a while, to where it was, and will
again and again until something happens: an event, a level that is passed, the end of a wait that is not like others.
"""

from __future__ import annotations

from motionlang.controller.faults import Refusal
from motionlang.lang.statement_time import UNITS, StatementTime, units
from motionlang.lang.task import CLOSE, INFINITY, WATCH, Delay

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.controller.controller import Controller
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.task import Task, Wait

    # When a state was met: the time, the statement time's base and count, until when what was read holds.
    Met = tuple[float, float, float, float]

# Waits that are so many times as long as the shortest one are also taken as what ends a short period.
LONGER = 4.0
# So many states are remembered; where none has come back by then, none is looked for until something happens.
MOST = 20_000
# Times are compared in nanoseconds.
_NANOSECONDS = 1e9


class Recurrence:
    """The states that the tasks have been in since something happened, each with its time."""

    def __init__(self, machine: Controller | Machine, pace: Callable[[float], None] | None) -> None:
        self._clock, self._pace = machine.clock, pace
        self._statements: StatementTime = getattr(machine, "statements", None) or StatementTime(0.0)
        self._key: tuple[int, set[int]] = (-1, set())
        self._met: dict[tuple[object, ...], Met] = {}

    def leap(self, tasks: Sequence[Task], turn: int, until: float) -> None:
        """After a turn: go on over as many whole periods as fit before anything can change, if they are known."""
        acts = {task.look[0] for task in tasks if task.look is not None}
        unknown = any(task.wait is None and task.look is None for task in tasks)
        if len(acts) > 1 or unknown or self._statements.reached != self._clock.now:
            return  # one has done something, or runs and nobody knows what it does
        if self._key != (self._clock.fired, acts):
            self._key, self._met = (self._clock.fired, acts), {}
        if len(self._met) > MOST:
            return
        lengths = [task.wait.length for task in tasks if task.look and isinstance(task.wait, Delay)]
        longest, shortest = max(lengths, default=0.0), min(lengths, default=0.0)
        for most in sorted({longest, min(longest, LONGER * shortest)}, reverse=True):
            inner = [task for task in tasks if task.look and _lasts(task.wait) <= most]
            others = [task.wait for task in tasks if task.wait is not None and task not in inner]
            if self._skips(inner, others, (turn, most), until):
                return

    def _skips(
        self, tasks: list[Task], others: list[Wait], signature: tuple[object, ...], until: float
    ) -> bool:
        """Whether the clock went on over whole periods of some `tasks`, which stand as they once did; `others` wait."""
        clock, statements = self._clock, self._statements
        now = clock.now
        for task in tasks:
            left = 0.0 if task.wait is None else task.wait.due() - now
            signature += (task.look[1], round(task.into * _NANOSECONDS), round(left * _NANOSECONDS))  # type: ignore[index]
        dues = [wait.due() for wait in others]
        level = min([task.level for task in tasks], default=INFINITY)
        signature += tuple(dues)
        before = self._met.get(signature)
        if before is None or before[3] <= now:  # what passes a level sees another world from then on
            self._met[signature] = now, statements.base, statements.count, level
            return False
        if any(wait.ready() for wait in others):
            return False
        limit = min(level, clock.next_time(), *dues)
        if limit == INFINITY:
            for task in tasks:
                if task.in_vain is None and task.look and task.look[2] and _lasts(task.wait) <= WATCH:
                    task.in_vain = now
        if limit == until == INFINITY:
            raise Refusal("never", "the loops look for something that can no longer happen", "")
        count = int((min(limit, until) - CLOSE - now) / (now - before[0]))
        if count <= 0:
            return False
        statements.repeat(before[1], before[2], count)
        time = statements.reached
        if self._pace is not None:
            self._pace(time)
        for task in tasks:
            if isinstance(task.wait, Delay):
                task.wait.move(units(task.wait.due() + (time - now)) / UNITS)
        clock.leaps += 1
        clock.now = time
        return True


def _lasts(wait: Wait | None) -> float:
    """How long a wait takes; infinite where it is not known."""
    if wait is None:
        return 0.0
    return wait.length if isinstance(wait, Delay) else INFINITY
