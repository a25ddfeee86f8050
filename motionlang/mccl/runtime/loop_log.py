"""Log of the times of a task's loops.

A jump back and the commands from its target up to it form a loop. A loop that begins with the first command
of a line or macro starts with that line, any other at its first jump back. It ends at the first command after
its last jump, or when its line ends. The innermost loop is last. The only cost per command is one comparison.
"""

from __future__ import annotations

from motionlang.lang.task import MIN_STATEMENTS

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mccl.resolve.line import Line
    from motionlang.mccl.runtime.task import CommandTask

# No command of a line has such a number.
NEVER = 1 << 30


class _Open:
    """A running loop: the commands from `target` to `here` of a line."""

    __slots__ = ("callers", "depth", "here", "line", "since", "target")

    def __init__(self, line: Line, target: int, depth: int, since: float, callers: tuple[int, ...]) -> None:
        self.line, self.target, self.here, self.depth = line, target, target, depth
        self.since, self.callers = since, callers


class LoopLog:
    """The loops of one task.

    `target` and `end` are the indexes of the first and the last command of the innermost loop, valid only
    while its line is being executed. A jump back from `end` to `target` is the next iteration.
    """

    __slots__ = ("_task", "end", "entered", "running", "target")

    def __init__(self, task: CommandTask) -> None:
        self._task = task
        self.running: list[_Open] = []
        self.end = self.target = NEVER
        # The time at which the current line began.
        self.entered = 0.0

    def back(self, line: Line, target: int, here: int) -> None:
        """Record a jump back from command `here` of a line to command `target`."""
        around, depth = self.running, len(self._task.calls)
        while around:
            last = around[-1]
            if last.depth == depth and last.line is line:
                if last.target == target:
                    last.here = max(last.here, here)
                    self.find_end()
                    return
                if last.target < target:
                    break
            elif last.depth < depth:
                break
            self._close()
        task = self._task
        now = task.base + task.count * task.cost
        around.append(_Open(line, target, depth, now if target else self.entered, task.stack[:-1]))
        around[-1].here = here
        self.find_end()

    def passed(self) -> None:
        """Close the loops that do not contain the next command."""
        task, around = self._task, self.running
        while around and around[-1].depth == len(task.calls):
            last = around[-1]
            if last.line is task.line and task.pc <= last.here:
                break
            self._close()
        self.find_end()

    def left(self) -> None:
        """Close the loops of a line that has ended or been abandoned."""
        while self.running and self.running[-1].depth >= len(self._task.calls):
            self._close()
        self.find_end()

    def open(self) -> list[tuple[int, float, tuple[int, ...]]]:
        """Return the loops that the task is in, outermost first.

        The form is that of `Task.loops`.
        """
        return [(each.line.offsets[each.here], each.since, each.callers) for each in self.running]

    def find_end(self) -> None:
        """Find the last command of the innermost loop.

        There is none while the task is in a macro that the loop calls.
        """
        last = self.running[-1] if self.running else None
        task = self._task
        inside = last is not None and last.line is task.line and last.depth == len(task.calls)
        self.end, self.target = (last.here, last.target) if last is not None and inside else (NEVER, NEVER)

    def _close(self) -> None:
        task, loop = self._task, self.running.pop()
        until = task.base + task.count * task.cost
        if until - loop.since > MIN_STATEMENTS * task.cost:
            at = loop.line.offsets[loop.here]
            task.board.machine.log.loops.add((task.name, at, loop.since, until, loop.callers))
