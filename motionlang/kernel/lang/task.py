"""A task: code that runs until the horizon, or until it must wait; the scheduler's view of `step_task.py`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.log.records import Waited

if TYPE_CHECKING:
    from motionlang.kernel.lang.waits import Wait

# A loop of fewer statements leaves no record; it counts for the code around it.
MIN_STATEMENTS = 100.0


class Task:
    """`resume(now, horizon)` runs from `now`; it returns the time reached and a wait.

    `None` for the wait means that the horizon was reached, or, with `done` set, that the task has ended.
    Source positions ("at") are offsets, which the dialect's `locate` converts to line and column.
    """

    __slots__ = ("done", "max_slice", "name", "priority", "wait")

    def __init__(self, name: str) -> None:
        self.name = name
        self.priority = 0  # of the tasks that can run, one of the highest priority runs
        self.max_slice = INFINITY  # the longest that it may run, s, while others can
        self.done = False
        self.wait: Wait | None = None

    @property
    def polls_in_vain(self) -> bool:
        """True if it polls, and only another task or an event can change what it reads."""
        return False

    @property
    def is_endless(self) -> bool:
        """True if it polls so, and its iterations change no variable."""
        return False

    def conditions_out(self) -> Callable[[], list[bool]]:
        """Return the function that tests the conditions that lead out of its loop."""
        return list

    @property
    def polled(self) -> str:
        """What it polls, as text; "" if that is not known."""
        return ""

    @property
    def at(self) -> int:
        """The source position of the task."""
        return 0

    @property
    def stack(self) -> tuple[int, ...]:
        """The source position of the task after those of its callers, outermost first."""
        return (self.at,)

    @property
    def callers(self) -> tuple[int, ...]:
        """The source positions of the calls that led to the task's position, outermost first."""
        return ()

    @property
    def loops(self) -> Sequence[tuple[int, float, tuple[int, ...]]]:
        """The loops that the task is in, outermost first.

        Each has its source position, its start in s, and the positions of the calls that led there.
        """
        return ()

    def waited(self, wait: Wait, until: float) -> Waited:
        """Return the record of a completed wait."""
        *callers, at = self.stack
        why = "" if wait.cause == "time" else wait.why
        return Waited(self.name, at, wait.since, until, wait.cause, wait.what, why, tuple(callers))

    @property
    def running(self) -> bool:
        """True if a statement of the task is being executed now."""
        return False

    @property
    def reached(self) -> tuple[int, float]:
        """The source position and the time, s, that it has reached, as far as another thread sees them."""
        return self.at, 0.0

    def at_error(self, error: BaseException) -> int:
        """Return the source position at which `error`, raised by `resume`, occurred."""
        return self.at

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        """Run until `horizon`, s, a wait or the end; return the time and the wait, if any."""
        raise NotImplementedError
