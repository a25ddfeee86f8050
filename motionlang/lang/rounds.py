"""Tasks that poll side by side: the period in which they come back to where they were.

Each task runs for its time slice and stops at the next place where it can. Where it goes on from depends on nothing
but where it stopped, so that a task that polls soon stops in the same few places again and again, and all of them
together do. Two periods, alike in the state, the length and the end of every slice, will be followed by more of them
until something happens.
"""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.controller.controller import Controller
    from motionlang.lang.machine import Machine
    from motionlang.lang.task import Task

# The rounds of a period, at most: each task has few places to stop at.
LONGEST = 12
_EQUAL = 1e-9


class Rounds:
    """The slices of late in which nobody did anything."""

    def __init__(self, machine: Controller | Machine) -> None:
        self._clock = machine.clock
        self._instruction: float = getattr(machine, "instruction_time", 0.0)
        self._fired = 0
        self._slices: list[tuple[object, ...]] = []
        self._seconds: list[float] = []
        self._levels: list[float] = []

    def forget(self) -> None:
        """Something has happened."""
        if self._slices:
            self._slices, self._seconds, self._levels = [], [], []

    def period(self, task: Task, began: float, granted: float, running: int) -> tuple[float, float] | None:
        """After a slice of `task`, one of so many that run: the length of the period in seconds, where there is one.

        With it comes the moment up to which all of them will do the same again.
        """
        if self._fired != self._clock.fired:
            self._fired = self._clock.fired
            self.forget()
        seconds = self._clock.now - began
        # How far into a turn it stopped says where, as every turn is the same.
        into = self._clock.now - task.looked
        self._slices.append((task, task.look, *(round(each / _EQUAL) for each in (granted, seconds, into))))
        self._seconds.append(seconds)
        self._levels.append(task.level)
        for rounds in range(1, LONGEST + 1):
            count = rounds * running
            if len(self._slices) < 2 * count:
                return None
            if self._slices[-count:] == self._slices[-2 * count : -count]:
                break
        else:
            if len(self._slices) > 4 * LONGEST * running:
                self.forget()
            return None
        length, level = sum(self._seconds[-count:]), min(self._levels[-count:])
        self.forget()
        if self._instruction:
            length = round(length / self._instruction) * self._instruction
        return length, level
