"""Skipping of polling loops: iterations that would repeat the last one.

A jump back starts an iteration. If the accumulator equals its value at the last jump back, and the commands
in between only read, the result stays the same until an event. This also holds if the accumulator changes,
provided that an iteration sets it before using it, and only tests it after reading a value that changes by
itself: the iterations then repeat until the result of one of these tests changes (`loop_tests.py`). Execution
resumes after the last whole iteration before the event.

An iteration that waits for a time (WA) is skipped, too. Its times are sums that round, so they are added up
one by one.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.lang.dependencies import CLOSE, Dependencies
from motionlang.lang.waits import Wait
from motionlang.mccl.axis.variables import changes_by_event, crossing_time, read_until
from motionlang.mccl.resolve.command import NUMBER
from motionlang.mccl.runtime.loop_tests import BIT_TESTS, COMPARES, tests_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from motionlang.lang.dependencies import Note
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.resolve.line import Line
    from motionlang.mccl.runtime.loop_tests import Tests
    from motionlang.mccl.runtime.task import CommandTask

_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz "
# The largest number of iterations without a check; with it a checked loop costs little more than an unchecked
# one.
MAX_BACK_OFF = 1024
# An iteration with more waits for a time is not skipped.
MAX_WAITS = 100
# The tests of so many loops of a task are cached.
MAX_LOOPS = 100


class Poll:
    """Watches one task's loops; `dependencies` records the values that they read.

    `hopeless` is the time since which all iterations were equal, if only another task or an event can change
    that.
    """

    def __init__(self, task: CommandTask) -> None:
        self._task = task
        self.dependencies = Dependencies(task.board.controller.clock)
        # The position with the effects by then, the accumulator, the base and the count of commands, and the
        # next event. The last item shows whether another task has run since.
        self._before: tuple[tuple[object, ...], float | int, float, int, float, int] = (
            (None, None),
            0,
            0.0,
            0,
            0.0,
            -1,
        )
        # The waits for a time since the last jump back: the count of commands from the base, and seconds.
        self._waits: list[tuple[int, float]] = []
        self.hopeless: float | None = None
        # The effects of tasks and events up to the last hopeless iteration, and the commands of that
        # iteration.
        self._done: tuple[int, int, tuple[Command, ...]] = 0, 0, ()
        # True if an output was switched to its present level in the last iteration, and the count of that.
        self._writes, self._rewrites = False, 0
        # The registers that its loops count, if there is an accelerator for them.
        make = task.board.machine.accelerators.registers
        self._registers = None if make is None else make(task)
        # The tests of loops, by line, first and last command.
        self._tests: dict[tuple[int, int, int], tuple[Line, Tests | None]] = {}
        # Back-off: iterations that still run unchecked, and those after the next failed check.
        self._alone = self._left = 0

    def again(self) -> Wait | None:
        """Skip the iterations that would repeat; called at each jump back.

        Returns a wait if they would repeat for ever.
        """
        task = self._task
        if self._alone:
            there = self._before[0]
            if there[0] is task.line and there[1] == task.pc:
                self._alone -= 1
                return None
        dependencies, clock, board = self.dependencies, self.dependencies.clock, task.board
        (before, accumulator, base, count, event, ran), accumulated = self._before, task.registers[0]
        wait, now = None, clock.now
        position = task.line, task.pc, board.effects, len(task.calls)
        waits, self._waits = self._waits, []
        goes_on = ran == board.slices and after(base, waits, task.cost) == task.base
        counters: Any = ()
        if self._registers is not None:
            same = before[:2] == position[:2] and before[3:] == position[3:] and not waits
            counters = self._registers.advanced(board.effects - before[2] if same else -1)  # type: ignore[operator]
            if counters:
                before = position
                if self._registers.leaves_accumulator(counters):
                    accumulator = accumulated
        repeats = goes_on and before == position and (task.count == count if waits else task.count > count)
        self._writes, self._rewrites = board.rewrites != self._rewrites, board.rewrites
        notes, dependencies.notes = dependencies.notes, []
        if before[:2] != position[:2] or now >= event or notes is None:
            self._alone = 0  # after an event, earlier reads are out of date
        elif not goes_on:
            self._alone = 0
            is_constant = before == position and accumulator == accumulated and not counters
            if is_constant and dependencies.until(now, notes) == INFINITY:
                self._give_up()
        else:
            until = now
            if repeats:
                until = dependencies.until(now, notes) if accumulator == accumulated else now
                if until == INFINITY and not counters:
                    self._give_up()
                elif until < clock.next_time():
                    began = base + count * task.cost
                    until = max(until, dependencies.until(began - CLOSE, self._tested(notes, now)))
            if until > now:
                self._left, wait = 0, self._skip(until, task.count - count, waits, counters)
                if counters:
                    position, accumulated = (*position[:2], board.effects, *position[3:]), task.registers[0]
            else:
                self._alone, self._left = self._left, min(2 * self._left or 1, MAX_BACK_OFF)
                dependencies.notes = None if self._alone else []
        self._before = position, accumulated, task.base, task.count, clock.next_time(), board.slices
        if len(board.tasks) > 1 and board.is_shared(task):
            board.jumped(task)
        return wait

    def wait(self, seconds: float) -> None:
        """Record a wait for `seconds` that begins now."""
        self._task.board.waited += 1
        if len(self._waits) >= MAX_WAITS:
            self._waits.clear()
        self._waits.append((self._task.count, seconds))

    def is_hopeless(self) -> bool:
        """True if only a task or an event can change the loop, and neither has acted.

        This refers to the last iteration.
        """
        done = self._task.board.effects, self.dependencies.clock.fired
        return self.hopeless is not None and done == self._done[:2]

    def watched(self) -> list[str]:
        """Return the inputs of a hopeless loop: channels, and other commands that read."""
        found: dict[str, None] = {}
        macros, bodies = dict(self._task.board.macros), [self._done[2]]
        for commands in bodies:  # the list grows meanwhile
            for command in commands:
                if command.verb == "call_macro" and command.value in macros:
                    bodies.append(macros.pop(command.value).commands)  # type: ignore[arg-type]
                elif command.polls == "input":
                    found[f"channel {command.text.lstrip(_LETTERS)}"] = None
                elif command.polls:
                    found[command.text] = None
        return list(found)

    def _give_up(self) -> None:
        """Mark the loop as hopeless, unless it switches outputs.

        The iteration that ends here has no effect and, as far as this task knows, repeats for ever.
        """
        if self._writes:
            return
        task = self._task
        assert task.line is not None
        if not self.is_hopeless():
            self.hopeless = self.dependencies.clock.now
        commands = task.line.commands[task.pc : max(task.here, task.pc) + 1]
        self._done = task.board.effects, self.dependencies.clock.fired, tuple(commands)

    def _skip(self, until: float, length: int, waits: list[tuple[int, float]], counters: Any) -> Wait | None:
        """Skip equal iterations, of `length` commands or with `waits`, until a time.

        They are equal except for `counters`, which advance.
        """
        task, clock = self._task, self.dependencies.clock
        board, now, slices = task.board, clock.now, task.board.slices
        scheduler = board.machine.scheduler
        assert scheduler is not None
        until = min(until, clock.next_time(), board.next_wake(task))
        if until == INFINITY and (self._writes or waits or counters):
            until = scheduler.until
            if until == INFINITY or ((waits or counters) and len(board.tasks) > 1):
                return None  # the run may end before, if all tasks are hopeless
        if until == INFINITY:
            why = "in a loop that polls only values that never change"
            return Wait(now, lambda: board.slices != slices, lambda: INFINITY, why)
        until = min(until, max(task.horizon, scheduler.reach()))
        if waits:
            self._skip_waits(until, waits)
            return None
        iterations = max(0, int((until - now) / (length * task.cost)) - 1)
        if counters:
            assert self._registers is not None
            iterations = int(min(iterations, self._registers.most(counters)))
            self._registers.count(counters, iterations)
        task.count += length * iterations
        return None

    def _skip_waits(self, until: float, waits: list[tuple[int, float]]) -> None:
        """Skip all but the last of the iterations that wait, up to the time `until`."""
        task = self._task
        rest = task.count * task.cost
        first = before = last = base = task.base
        if len(waits) == 1:  # as in `after`
            ((count, seconds),) = waits
            busy = count * task.cost
            while base + rest < until:
                before, last, base = last, base, base + busy + seconds
        else:
            while base + rest < until:
                before, last, base = last, base, after(base, waits, task.cost)
        task.base = before
        if before > first:
            period = after(0.0, waits, task.cost)
            # The iteration that repeats began a period ago; half a command more is for rounding.
            began = first + rest - period - 0.5 * task.cost
            task.board.machine.log.repeat_waits(task.name, began, period, round((before - first) / period))

    def _tested(self, notes: list[Note], now: float) -> list[Note]:
        """Replace dependencies on values by dependencies on the results of tests.

        `notes` are the dependencies that the iteration recorded, and `now` is the time at its end. If a value
        that has changed by then is used for more than tests, the loop may change at once.
        """
        task = self._task
        assert task.line is not None
        key = id(task.line), task.pc, task.here
        known = self._tests.get(key)
        if known is None:
            if len(self._tests) >= MAX_LOOPS:
                self._tests.clear()
            governs: int = task.board.assumptions.get("mccl.skipped", 2)  # type: ignore[assignment]
            known = task.line, tests_of(task.line.commands[task.pc : task.here + 1], governs)
            self._tests[key] = known
        tests = known[1]
        if tests is None:
            return [(self.dependencies.at_once, ())]
        found: list[Note] = []
        for note in notes:
            if note[0] is read_until:
                found += self._changes(note, tests.get(note[1][1] - task.pc), now)
            else:
                found.append(note)
        return found

    def _changes(self, note: Note, tests: tuple[Command, ...] | None, now: float) -> list[Note]:
        """Return the dependencies of the tests of a value that was read.

        If `tests` is None, they are those of the value.
        """
        until, _, axis, address = note[1]
        task = self._task
        bits = [
            int(each.value)
            for each in tests or ()
            if each.kind == NUMBER and each.row is not None and each.row.verb in BIT_TESTS
        ]
        if tests is not None and len(bits) == len(tests) and changes_by_event(task.board, address, bits):
            return []
        if until > now:
            return [note]
        if tests is None or any(each.row is None or each.row.verb not in COMPARES for each in tests):
            return [(self.dependencies.at_once, ())]
        # A fraction is cut off, so a comparison with 5 may change at 4 and 6, too.
        return [
            (crossing_time, (task.board, axis, address, task.value(each) + j))
            for each in tests
            for j in (-1, 0, 1)
        ]


def after(base: float, waits: list[tuple[int, float]], cost: float) -> float:
    """Return the base of a task's command times after some waits."""
    for count, seconds in waits:
        base = base + count * cost + seconds
    return base
