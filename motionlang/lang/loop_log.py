"""Log of the times of a task's loops.

A jump back and the steps from its target up to it form a loop. A loop from the first step of its list begins
with it, any other at its first jump back. It ends at the first statement after its last jump, or when its list
ends. The innermost loop is last. The only cost per statement is one comparison.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.lang.task import MIN_STATEMENTS

if TYPE_CHECKING:
    from motionlang.lang.step_task import StepTask
    from motionlang.lang.steps import Steps

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
    callers: tuple[int, ...]


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
        around.append(_Open(steps, target, last, depth, since, task.stack[:-1]))
        self._find_end()

    def passed(self) -> None:
        """Close the loops that do not contain the next step."""
        task, around = self._task, self.running
        while around and around[-1].depth == len(task.calls):
            inner = around[-1]
            if inner.steps is task.steps and task.pc <= inner.last:
                break
            self._close()
        self._find_end()

    def leave(self) -> None:
        """Close the loops of a list of steps that has ended or been abandoned."""
        while self.running and self.running[-1].depth >= len(self._task.calls):
            self._close()
        self._find_end()

    def open(self) -> list[tuple[int, float, tuple[int, ...]]]:
        """Return the loops that the task is in, outermost first, in the form of `Task.loops`."""
        return [(each.steps[each.last].at, each.since, each.callers) for each in self.running]

    def _find_end(self) -> None:
        """Find the last step of the innermost loop; there is none while the task is in a call that the loop makes."""
        inner, task = self.running[-1] if self.running else None, self._task
        if inner is not None and inner.steps is task.steps and inner.depth == len(task.calls):
            self.end, self.target = inner.last, inner.target
        else:
            self.end = self.target = NEVER

    def _close(self) -> None:
        task, loop = self._task, self.running.pop()
        if task.now - loop.since > MIN_STATEMENTS * task.time.cost:
            at = loop.steps[loop.last].at
            task.machine.log.loops.add((task.name, at, loop.since, task.now, loop.callers))
