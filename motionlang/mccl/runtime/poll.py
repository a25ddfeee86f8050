"""Loops that only look: they are left until something can change, and land where they would have been.

A jump back that finds the accumulator as it was at the last one, with nothing done in between but reading, will find
the same again until an event. The task then waits for the last whole pass before that event instead of running them.
So it is where the accumulator moves on, too, if a pass begins by reading it and does no more than compare it.
"""

from __future__ import annotations

from motionlang.lang.attention import Attention
from motionlang.lang.task import CLOSE, Wait
from motionlang.mccl.axis.variables import crossing_time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.line import Line
    from motionlang.mccl.runtime.task import CommandTask

INFINITY = float("inf")
# What compares the whole accumulator with a number, and what does nothing to it.
_COMPARES = frozenset(("if_below", "if_equal", "if_greater", "if_unequal"))
_JUMPS = frozenset(("jump", "jump_by", "repeat", "nothing"))


class Poll:
    """Watches one task's loops. `effects` counts what was done; `attention` has the notes of what was read."""

    __slots__ = (
        "_accumulator",
        "_count",
        "_depth",
        "_done",
        "_event",
        "_line",
        "_pc",
        "_task",
        "_turn",
        "attention",
        "effects",
    )

    def __init__(self, task: CommandTask) -> None:
        self._task = task
        self.effects = 0
        self.attention = Attention(task.board.controller.clock)
        self._line: Line | None = None
        self._pc = self._count = self._done = self._depth = 0
        self._accumulator: float | int = 0
        self._turn = 0
        self._event = 0.0

    def again(self) -> Wait | None:
        """Called at each jump back: a wait, if nothing can come of another pass."""
        task = self._task
        same = (
            self._line is task.line
            and self._pc == task.pc
            and self._done == self.effects
            and self._depth == len(task.calls)
            and self._undisturbed()
        )
        steady = self._accumulator == task.registers[0]
        attention, length = self.attention, task.count - self._count
        notes, attention.notes = attention.notes, []
        self._line, self._pc, self._done = task.line, task.pc, self.effects
        self._accumulator, self._count = task.registers[0], task.count
        self._depth = len(task.calls)
        self._turn, self._event = task.board.turns, task.board.controller.clock.next_time()
        if not same or length <= 0 or notes is None:
            return None
        until = attention.until(attention.clock.now, notes) if steady else 0.0
        if until <= attention.clock.now:
            until = self._passing(task, length)
        return self._until_the_next_event(length, until)

    def _passing(self, task: CommandTask, length: int) -> float:
        """When what a pass reads first passes a number that it is compared with; 0 where it does more than that."""
        assert task.line is not None
        reading, *others = task.line.commands[task.pc : task.here + 1]
        if reading.row is None or not reading.row.solved:
            return 0.0
        verbs = [each.row.verb if each.row is not None else "" for each in others]
        if not _JUMPS.union(_COMPARES).issuperset(verbs):
            return 0.0
        axis, address, clock = task.axis(reading), task.whole(reading), self.attention.clock
        now, clock.now = clock.now, clock.now - length * task.cost - CLOSE
        try:  # a fraction is cut off: what is compared with 5 may change at 4 and 6, too
            levels = [
                task.value(each) + k
                for each, verb in zip(others, verbs, strict=True)
                if verb in _COMPARES
                for k in (-1, 0, 1)
            ]
            return min([crossing_time(task.board, axis, address, level) for level in levels], default=0.0)
        finally:
            clock.now = now

    def _undisturbed(self) -> bool:
        """Whether neither an event nor another task came between: after it, what was read before it is old."""
        board = self._task.board
        return self._turn == board.turns and board.controller.clock.now < self._event

    def _until_the_next_event(self, length: int, until: float) -> Wait | None:
        task = self._task
        board = task.board
        clock = board.controller.clock
        now = clock.now
        event = min(until, clock.next_time(), board.next_wake(task))
        before = board.disturbances
        if event == INFINITY:
            why = "in a loop that only looks at what does not change"
            return Wait(now, lambda: board.disturbances != before, lambda: INFINITY, why)
        passes = int((event - now) / (length * task.cost)) - 1
        if passes <= 0:
            return None
        base, count = task.base, task.count + passes * length
        due = base + count * task.cost
        if due >= event:
            return None

        def land(time: float) -> None:
            # Woken early, by something nobody could foresee, the loop starts afresh where it is.
            if time == due:
                task.base, task.count = base, count
            self._count = task.count

        task.then = land
        return Wait(
            now,
            lambda: clock.now >= due or board.disturbances != before,
            lambda: due,
            "in a loop that only looks",
        )
