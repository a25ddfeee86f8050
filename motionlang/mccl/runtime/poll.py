"""Loops that only look: they are left until something can change, and land where they would have been.

A jump back that finds the accumulator as it was at the last one, with nothing done in between but reading, will find
the same again until an event. The task then waits for the last whole pass before that event instead of running them.
So it is where the accumulator moves on, too, if a pass begins by reading it and does no more than compare it.
"""

from __future__ import annotations

from motionlang.lang.attention import Attention
from motionlang.lang.task import CLOSE, INFINITY, Wait
from motionlang.mccl.axis.variables import crossing_time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.attention import Note
    from motionlang.mccl.runtime.task import CommandTask

    # The place and what was done by then, the accumulator, the count of commands, the next event.
    Before = tuple[tuple[object, ...], float | int, int, float]

# What compares the whole accumulator with a number, and what does nothing to it.
_COMPARES = frozenset(("if_below", "if_equal", "if_greater", "if_unequal"))
_JUMPS = frozenset(("jump", "jump_by", "repeat", "nothing"))


class Poll:
    """Watches one task's loops. `effects` counts what was done; `attention` has the notes of what was read."""

    __slots__ = ("_before", "_task", "attention", "effects")

    def __init__(self, task: CommandTask) -> None:
        self._task = task
        self.effects = 0
        self.attention = Attention(task.board.controller.clock)
        self._before: Before = (), 0, 0, 0.0

    def again(self) -> Wait | None:
        """Called at each jump back: a wait, if nothing can come of another pass."""
        task, attention, clock = self._task, self.attention, self.attention.clock
        place = task.line, task.pc, self.effects, len(task.calls), task.board.turns
        notes, attention.notes = attention.notes, []
        (before, accumulator, count, event), now = self._before, clock.now
        self._before = place, task.registers[0], task.count, clock.next_time()
        length = task.count - count
        if before != place or now >= event or length <= 0 or notes is None:
            return None  # where an event or another task came between, what was read before it is old
        until = attention.until(now, notes) if accumulator == task.registers[0] else 0.0
        if until <= now:
            until = attention.until(now - length * task.cost - CLOSE, self._levels())
        return self._wait(length, min(until, clock.next_time(), task.board.next_wake(task)))

    def _levels(self) -> list[Note]:
        """What a pass that begins with a reading compares it with; what may change at once where it does more."""
        task = self._task
        assert task.line is not None
        reading, *others = task.line.commands[task.pc : task.here + 1]
        verbs = [each.row.verb if each.row is not None else "" for each in others]
        if reading.row is None or not reading.row.solved or not _JUMPS.union(_COMPARES).issuperset(verbs):
            return [(self.attention.at_once, ())]
        compared = [task.value(each) for each, verb in zip(others, verbs, strict=True) if verb in _COMPARES]
        where = task.board, task.axis(reading), task.whole(reading)
        # A fraction is cut off: what is compared with 5 may change at 4 and 6, too.
        return [(crossing_time, (*where, level + k)) for level in compared for k in (-1, 0, 1)]

    def _wait(self, length: int, event: float) -> Wait | None:
        """The wait for the last whole pass, of so many commands, before an event."""
        task, board, clock = self._task, self._task.board, self.attention.clock
        now, disturbances = clock.now, board.disturbances
        if event == INFINITY:
            why = "in a loop that only looks at what does not change"
            return Wait(now, lambda: board.disturbances != disturbances, lambda: INFINITY, why)
        passes = int((event - now) / (length * task.cost)) - 1
        base, count = task.base, task.count + passes * length
        due = base + count * task.cost
        if passes <= 0 or due >= event:
            return None

        def land(time: float) -> None:
            # Woken early, by something nobody could foresee, the loop starts afresh where it is.
            if time == due:
                task.base, task.count = base, count
            place, accumulator, _, event = self._before
            self._before = place, accumulator, task.count, event

        task.then = land
        return Wait(
            now,
            lambda: clock.now >= due or board.disturbances != disturbances,
            lambda: due,
            "in a loop that only looks",
        )
