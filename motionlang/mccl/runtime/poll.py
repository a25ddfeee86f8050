"""Loops that only look: passes that would be as the last one was are skipped.

A jump back that finds the accumulator as it was at the last one, with nothing done in between but reading, will find
the same again until an event. So it is where the accumulator moves on, too, if a pass begins by reading it and does no
more than compare it. The command that follows is then that of the last whole pass before that.
"""

from __future__ import annotations

from motionlang.lang.attention import Attention
from motionlang.lang.task import CLOSE, INFINITY, Wait
from motionlang.mccl.axis.variables import crossing_time

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.lang.attention import Note
    from motionlang.mccl.runtime.task import CommandTask

# What compares the whole accumulator with a number, and what does nothing to it.
_COMPARES = frozenset(("if_below", "if_equal", "if_greater", "if_unequal"))
_JUMPS = frozenset(("jump", "jump_by", "repeat", "nothing"))


# So many passes go by unlooked at; what is looked at costs not much more than what is not.
MOST_ALONE = 1024


class Poll:
    """Watches one task's loops. `effects` counts what was done; `attention` has the notes of what was read."""

    __slots__ = ("_alone", "_before", "_left", "_task", "attention", "effects")

    def __init__(self, task: CommandTask) -> None:
        self._task = task
        self.effects = 0
        self.attention = Attention(task.board.controller.clock)
        # The place and what was done by then, the accumulator, the count of commands, the next event.
        self._before: tuple[tuple[object, ...], float | int, int, float] = (None, None), 0, 0, 0.0
        # For how many passes nobody looks at what goes on there, and for how many when next that is in vain.
        self._alone = self._left = 0

    def again(self) -> Wait | None:
        """Called at each jump back: go on to the last pass that can be no different; a wait if it is so for ever."""
        task = self._task
        if self._alone:
            there = self._before[0]
            if there[0] is task.line and there[1] == task.pc:
                self._alone -= 1
                return None
        attention, clock = self.attention, self.attention.clock
        (before, accumulator, count, event), held = self._before, task.registers[0]
        wait, now, length = None, clock.now, task.count - count
        place = task.line, task.pc, task.board.turns, self.effects, len(task.calls)
        notes, attention.notes = attention.notes, []
        if before[:3] != place[:3] or now >= event or notes is None:
            self._alone = 0  # where an event or another task came between, what was read before it is old
        else:
            until = now
            if before == place and length > 0:
                until = attention.until(now, notes) if accumulator == held else now
                if until <= now:
                    until = attention.until(now - length * task.cost - CLOSE, self._levels())
            if until > now:
                self._left, wait = 0, self._skip(until, length)
            else:
                self._alone, self._left = self._left, min(2 * self._left or 1, MOST_ALONE)
                attention.notes = None if self._alone else []
        self._before = place, held, task.count, clock.next_time()
        return wait

    def _skip(self, until: float, length: int) -> Wait | None:
        """Go on over passes of so many commands that are alike until a moment."""
        task, clock = self._task, self.attention.clock
        board, now, turns = task.board, clock.now, task.board.turns
        scheduler = board.machine.scheduler
        assert scheduler is not None
        until = min(until, clock.next_time(), board.next_wake(task))
        if until == INFINITY:
            why = "in a loop that only looks at what does not change"
            return Wait(now, lambda: board.turns != turns, lambda: INFINITY, why)
        until = min(until, max(task.horizon, scheduler.reach()))
        task.count += length * max(0, int((until - now) / (length * task.cost)) - 1)
        return None

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
