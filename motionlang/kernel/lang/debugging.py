"""The hook that a debug build calls before statements, and its state at a stop.

A debug build counts its statements. Before each of them it compares the number with a limit, and its source offset with
a set, and calls the hook if either asks for it. While the program waits there are no statements, so the clock of a
debug build also reports each time to which it advances. The hook may block the run, or end it with an exception; it
never changes the time of a statement. Both languages share one vocabulary: a stop is in a task, at a source offset, and
has frames with variables.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

from motionlang.kernel.controller.clock import INFINITY

if TYPE_CHECKING:
    from motionlang.kernel.lang.step_task import StepTask
    from motionlang.kernel.lang.steps import Steps
    from motionlang.kernel.lang.task import Task


class Inspection(Protocol):
    """The variables of a debug build."""

    def module(self) -> list[Variable]:
        """Return the variables of the whole program."""

    def frames(self, task: Task, offset: int | None) -> list[Frame]:
        """Return the calls of a task, the innermost first.

        `offset` is the source offset of a task that is stopped in the hook; None for one that waits.
        """

    def unlisted(self, task: Task | None, name: str) -> Variable | None:
        """Return a variable by name that `module` omits; None if there is none.

        The task is None at the end of the run.
        """

    def depth(self, task: Task) -> int:
        """Return the number of calls that the running task is in."""


# Called with the task, the time of the statement, s, and its source offset.
Stop = Callable[["Task", float, int], None]


class Hook:
    """The hook of one run, and the number of the last statement.

    `stop` is called before each statement whose number is at least `limit`, and before those at the source
    offsets in `offsets`. `advancing` is called with each time to which the clock is about to advance. `between` is
    called between two rounds of the scheduler and when time is up, since the whole state of the run is in its objects
    then. A task that is alone seldom makes a round; from statement `round_at` on it makes one after each statement.
    """

    def __init__(
        self,
        stop: Stop,
        limit: float = INFINITY,
        advancing: Callable[[float], None] = lambda time: None,
        between: Callable[[], None] = lambda: None,
    ) -> None:
        self.stop, self.advancing, self.between = stop, advancing, between
        # The number of statements begun so far.
        self.count = 0
        self.limit, self.round_at = limit, INFINITY
        self.offsets: frozenset[int] | None = None
        # The variables of the program, once it has started.
        self.inspection: Inspection | None = None

    def begins(self, task: Task, time: float, offset: int) -> bool:
        """Count a statement, and stop before it if that is due; True if a round of the scheduler is to follow it."""
        self.count += 1
        if self.count >= self.limit or (self.offsets is not None and offset in self.offsets):
            self.stop(task, time, offset)
        return self.count >= self.round_at

    def compared(self, left: object, right: object) -> None:
        """Take note of both sides of a comparison of the statement that has begun last."""

    def tested(self, number: object) -> None:
        """Take note of a number whose truth decides in the statement that has begun last."""


class Observer(Protocol):
    """An observer of the steps that a run takes.

    It may replace the functions of steps before they run, by others that do the same and count. Iterations that are
    skipped call none of them, so they are reported.
    """

    @property
    def seen(self) -> Any:
        """Its counts so far, in the form that `skipped` takes."""

    def written(self, steps: Steps) -> None:
        """Take note of steps that have been written and not run."""

    def skipped(self, first: Any, end: Any, times: int) -> None:
        """Count what was counted between two moments, `first` and `end`, so many more times."""

    def failed(self, task: StepTask) -> None:
        """Take note that a statement of a task has failed, and that the task is now where it goes on."""


@dataclass(eq=False, slots=True)
class Variable:
    """A variable at a stop.

    `value` is a number, a text or a list of variables. `set` assigns a new value and raises ValueError if the
    language does not allow it; `set` is None if the variable cannot be set. `type` is its type in the
    language.
    """

    name: str
    type: str
    value: object
    set: Callable[[object], None] | None = None


@dataclass(eq=False, slots=True)
class Frame:
    """A call at a stop.

    It has the name of the sub, the source offset in it, and its own variables.
    """

    name: str
    offset: int
    variables: Sequence[Variable]
