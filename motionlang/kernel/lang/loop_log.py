"""Log of the times of a task's loops.

A jump back and the steps from its target up to it form a loop. A loop that says so (`begin`) begins then, one from the
first step of its list with that list, any other at its first jump back. It ends at the first statement after its last
jump, or when its list ends. The innermost loop is last. The only cost per statement is one comparison.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.kernel.lang.steps import Steps
from motionlang.kernel.lang.task import MIN_STATEMENTS
from motionlang.kernel.log.records import Looped

if TYPE_CHECKING:
    from motionlang.kernel.lang.step_task import StepTask

# No step has such a number.
NEVER = 1 << 30


@dataclass(slots=True)
class _Open:
    """A running loop: the steps from `target` to `last`, in a call at this depth."""

    steps: Steps
    target: int
    last: int
    depth: int
    since: float
    # The statement with which it begins, and the time from which statements were counted.
    begun: tuple[float, float]
    callers: tuple[int, ...]
    # The offset of its statement, -1 for that of the last step.
    at: int = -1

    @property
    def offset(self) -> int:
        """The offset of its statement."""
        return self.at if self.at >= 0 else self.steps[self.last].at


class LoopLog:
    """The loops that a task is in.

    `end` and `target` are the last and the first step of the innermost loop, valid only while its list of steps is
    being executed. A jump back from `end` to `target` is the next iteration. `entered` is when that list began.
    """

    def __init__(self, task: StepTask) -> None:
        self._task = task
        self.running: list[_Open] = []
        self.end = self.target = NEVER
        self.entered = 0.0

    def enter(self) -> None:
        """Record that a list of steps begins."""
        self.entered = self._task.now
        if self.running:
            self._find_end()

    def begin(self, at: int, first: int, last: int) -> None:
        """Record that the loop of a statement begins, with the steps from `first` to `last`."""
        task = self._task
        self.running.append(self._opened(first, last, task.now, at))
        self.end, self.target = last, first

    def begin_once(self, at: int, first: int, last: int) -> None:
        """Like `begin`, unless the loop is running already."""
        depth, steps = len(self._task.calls), self._task.steps
        for loop in reversed(self.running):
            if loop.depth < depth:
                break
            if loop.steps is steps and loop.target == first:
                return
        self.begin(at, first, last)

    def called(self, count: float, base: float, at: int, caller: int) -> None:
        """Log a sub that has computed since a statement, like a loop; its waits would be logged by themselves."""
        task, time = self._task, self._task.time
        if base is time.base and time.count - count > MIN_STATEMENTS:
            since = base + count * time.cost
            task.machine.log.loops.add(Looped(task.name, at, since, task.now, (*task.stack[:-1], caller)))

    def back(self, last: int, target: int) -> None:
        """Record a jump back from step `last` to step `target`."""
        task, around = self._task, self.running
        depth, steps = len(task.calls), task.steps
        while around:
            inner = around[-1]
            if inner.depth == depth and inner.steps is steps:
                if inner.target == target:
                    inner.last = max(inner.last, last)
                    self._find_end()
                    return
                if inner.target < target:
                    break
            elif inner.depth < depth:
                break
            self._close()
        since = task.now if target else self.entered
        around.append(self._opened(target, last, since))
        self._find_end()

    def _opened(self, first: int, last: int, since: float, at: int = -1) -> _Open:
        task = self._task
        begun = task.time.count, task.time.base
        return _Open(task.steps, first, last, len(task.calls), since, begun, task.stack[:-1], at)

    def passed(self) -> None:
        """Close the loops that do not contain the next step."""
        task, around = self._task, self.running
        while around and around[-1].depth == len(task.calls):
            inner = around[-1]
            if inner.steps is task.steps and inner.target <= task.pc <= inner.last:
                break
            self._close()
        self._find_end()

    def leave(self) -> None:
        """Close the loops of a list of steps that has ended or been abandoned."""
        while self.running and self.running[-1].depth >= len(self._task.calls):
            self._close()
        self._find_end()

    def close(self) -> None:
        """Close all loops, as the task ends."""
        while self.running:
            self._close()

    def open(self) -> list[tuple[int, float, tuple[int, ...]]]:
        """Return the loops that the task is in, outermost first, in the form of `Task.loops`."""
        return [(each.offset, each.since, each.callers) for each in self.running]

    def _find_end(self) -> None:
        """Find the last step of the innermost loop; there is none while the task is in a call that the loop makes."""
        inner, task = self.running[-1] if self.running else None, self._task
        if inner is not None and inner.steps is task.steps and inner.depth == len(task.calls):
            self.end, self.target = inner.last, inner.target
        else:
            self.end = self.target = NEVER

    def _close(self) -> None:
        task, loop = self._task, self.running.pop()
        count, base = loop.begun
        if loop.at >= 0 and base is task.time.base and task.time.count - count <= MIN_STATEMENTS:
            return  # a difference of times would round
        if task.now - loop.since > MIN_STATEMENTS * task.time.cost:
            task.machine.log.loops.add(Looped(task.name, loop.offset, loop.since, task.now, loop.callers))
