"""The hook that a debug build calls before statements, and its state at a stop.

A debug build counts its statements. Before each of them it compares the number with a limit, and its source offset with
a set, and calls the hook if either asks for it. While the program waits there are no statements, so the clock of a
debug build also reports each time to which it advances. The hook may block the run, or end it with an exception; it
never changes the time of a statement. Both languages share one vocabulary: a stop is in a task, at a source offset, and
has frames with variables.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.record import record

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from types import CellType
    from typing import Any, Protocol

    from motionlang.lang.task import Task

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
    Stop = Callable[[Task, float, int], None]


class Hook:
    """The hook of one run, and the number of the last statement.

    `stop` is called before each statement whose number is at least `limit`, and before those at the source
    offsets in `offsets`. `cells` has these three, so that generated code reads them as fast as its own variables.
    `advancing` is called with each time to which the clock is about to advance.
    `tally` is for an interpreter, which compares only once: the number, and the limit, or 0 while there are offsets.
    """

    def __init__(
        self,
        stop: Stop,
        limit: float = INFINITY,
        advancing: Callable[[float], None] = lambda time: None,
    ) -> None:
        self.stop, self.advancing = stop, advancing
        # The variables of the program, once it has started.
        self.inspection: Inspection | None = None
        self.cells: tuple[CellType, CellType, CellType] = (_cell(0), _cell(limit), _cell(None))
        self.tally: list[float] = [0, limit]

    @property
    def count(self) -> int:
        """The number of statements begun so far."""
        return self.cells[0].cell_contents + int(self.tally[0])  # type: ignore[no-any-return]

    @property
    def limit(self) -> float:
        """The number of the first statement before which `stop` is called."""
        return self.cells[1].cell_contents  # type: ignore[no-any-return]

    @limit.setter
    def limit(self, number: float) -> None:
        self.cells[1].cell_contents = number
        self.tally[1] = number if self.offsets is None else 0

    @property
    def offsets(self) -> frozenset[int] | None:
        """The source offsets before which `stop` is called; None if there are none."""
        return self.cells[2].cell_contents  # type: ignore[no-any-return]

    @offsets.setter
    def offsets(self, offsets: frozenset[int] | None) -> None:
        self.cells[2].cell_contents = offsets or None
        self.tally[1] = 0 if offsets else self.limit

    def begins(self, task: Task, time: float, offset: int) -> None:
        """Count a statement, and stop before it if that is due; compiled code does so by itself."""
        tally = self.tally
        tally[0] += 1
        if tally[0] < tally[1]:
            return
        if self.count >= self.limit or (self.offsets is not None and offset in self.offsets):
            self.stop(task, time, offset)


def _cell(value: object) -> Any:
    return (lambda: value).__closure__[0]  # type: ignore[index]


@record
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


@record
class Frame:
    """A call at a stop.

    It has the name of the sub, the source offset in it, and its own variables.
    """

    name: str
    offset: int
    variables: Sequence[Variable]
