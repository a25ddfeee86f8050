"""Known transitions between the states of a program, for `polled_ticks.py`.

A transition goes from a checkpoint to the next one. `Known` has all that are known, each under the ticks and the
ends of WAITs in its path.
"""

from __future__ import annotations

from math import ceil

from motionlang.controller.clock import INFINITY
from motionlang.lang.waits import ROUNDING

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from motionlang.lang.dependencies import Note

# A tick or the end of a WAIT: its time, the index of the task or `TICK`, and the beginning of the WAIT.
Due = tuple[float, int, float]

# In place of the index of a task: the tick.
TICK = -1
# Two times further apart than this, s, are two times for the scheduler.
APART = 2 * ROUNDING
# The end of a WAIT that is so close, s, is over for the scheduler.
ONE_TIME = 0.1 * ROUNDING
NO_DUE: Due = (INFINITY, TICK, 0.0)


class Transition:
    """The effects from one checkpoint to the next one.

    Statements are counted from the origin: the checkpoint, the first tick or end if all tasks waited for it, or the
    beginning of the last iterations of a task that polls. `length` is the number of them, and `state` the state then.
    `handler` is the rest of the record of the handler, None without a tick. `switches` are those of outputs, each with
    its statement. `waits` are the WAITs that tasks have begun: the index of the task, the statement, and the units
    from the origin to the end. `earliest` is the first statement of either, infinite without one. `open` are the
    indices of the WAITs in its path that are not over. `steps` is how far it advances the counters, () if it does
    not. `seconds` is how long each task has computed since the origin.
    `is_proved` is false until it may be repeated.
    """

    __slots__ = (
        "earliest", "handler", "is_proved", "length", "open", "seconds", "state", "steps", "switches", "waits",
    )  # fmt: skip

    def __init__(
        self,
        state: int,
        length: float,
        handler: tuple[object, ...] | None,
        switches: tuple[tuple[float, tuple[object, ...]], ...],
        waits: tuple[tuple[int, float, int], ...],
        open: frozenset[int],
        steps: tuple[float, ...],
        seconds: dict[str, float],
    ) -> None:
        self.state, self.length, self.handler, self.switches = state, length, handler, switches
        self.waits, self.open, self.steps, self.seconds = waits, open, steps, seconds
        offsets = [offset for offset, _ in switches[:1]] + [offset for _, offset, _ in waits]
        self.earliest = min(offsets, default=INFINITY)
        self.is_proved = False

    def equals(self, other: Transition) -> bool:
        """True if it has the same effects, in whatever time slices."""
        own = self.state, self.length, self.handler, self.switches, self.waits, self.steps
        return own == (
            other.state,
            other.length,
            other.handler,
            other.switches,
            other.waits,
            other.steps,
        )


class Node:
    """The transition after some ticks and ends.

    `next` has the nodes after one more of them, by its index and statement.
    """

    __slots__ = ("next", "transition")

    def __init__(self) -> None:
        self.transition: Transition | None = None
        self.next: dict[tuple[int, float], Node] = {}


class Checkpoint:
    """A state with its times.

    These are the base and count of the statements, and the next tick and ends in order. `number` is that of the
    next tick, `values` are those of the counters and `lengths` those of the streams.
    """

    __slots__ = ("base", "count", "dues", "lengths", "number", "state", "values")

    def __init__(
        self,
        state: int,
        base: float,
        count: float,
        dues: list[Due],
        number: int,
        values: tuple[float, ...],
        lengths: list[int] | None = None,
    ) -> None:
        self.state, self.base, self.count, self.dues = state, base, count, dues
        self.number, self.values, self.lengths = number, values, lengths or []


class Known:
    """The states that have been met, by number, and the transitions between them.

    `alive` has the objects whose identity is part of a state. By state, `are_idle` is true if all tasks wait in it,
    `polling` is the name of the task that polls in it if there is just one, and `periods` has the period of that
    task: its start after the checkpoint and its length, in statements. `waits` has the records of the WAITs in it, with
    other times, by the index of the task.
    """

    def __init__(self, counters: int) -> None:
        self.alive: dict[int, object] = {}
        # The dependencies of the tasks that have made them.
        self.read: set[Note] = set()
        self._counters = counters
        self._numbers: dict[object, int] = {}
        self.are_idle: list[bool] = []
        self.polling: list[str] = []
        self.periods: dict[int, tuple[float, float] | None] = {}
        self.waits: dict[int, dict[int, tuple[Any, ...]]] = {}
        self.forget_transitions()

    def __len__(self) -> int:
        return len(self.are_idle)

    def number(self, state: tuple[object, ...], polling: list[str]) -> int:
        """Return the number of a state in which some tasks poll."""
        found = self._numbers.get(state)
        if found is None:
            found = self._numbers[state] = len(self._numbers)
            self.are_idle.append(not polling)
            self.polling.append(polling[0] if len(polling) == 1 else "")
        return found

    def forget_transitions(self) -> None:
        """Drop all transitions; the states keep their numbers."""
        # The least and the greatest step of each counter in a transition.
        self.range = [0.0] * self._counters, [0.0] * self._counters
        # How far each tick advances the counters that the handler also sets, None before the first one.
        self.advance: list[float] | None = None
        self.trees: dict[int, Node] = {}
        # Of these, transitions from states in which all tasks wait for just one tick or end, by its index, and those
        # of states in which no task is in a WAIT, by the number of statements up to the tick.
        self.alone: dict[tuple[int, int], Transition] = {}
        self.gaps: dict[int, dict[float, Transition]] = {}

    def widen(self, steps: tuple[float, ...]) -> None:
        """Add the steps of the counters in a transition to `range`."""
        least, greatest = self.range
        self.range = list(map(min, least, steps)), list(map(max, greatest, steps))

    def node(self, state: int, path: list[tuple[int, float]]) -> Node:
        """Return the place of a transition with some ticks and ends in its path.

        Each has its index and its statement.
        """
        node = self.trees.setdefault(state, Node())
        for each in path:
            node = node.next.setdefault(each, Node())
        return node


def first_statement(due: Due, base: float, cost: float) -> float | None:
    """Return the first statement that comes after a tick or the end of a WAIT.

    None if rounding might decide. The scheduler regards a WAIT as over slightly early.
    """
    moment = due[0]
    if due[1] == TICK:
        count = float(ceil((moment - base) / cost))
        if base + count * cost < moment:
            return count + 1.0
        return count - 1.0 if base + (count - 1.0) * cost >= moment else count
    # A statement this much before the end comes after it.
    nearest = float(round((moment - base) / cost))
    distance = base + nearest * cost - moment
    if -ONE_TIME < distance < ONE_TIME:
        return nearest
    if -APART < distance < APART:
        return None
    return nearest if distance > 0.0 else nearest + 1.0
