"""Skipping of polling loops: iterations that would repeat the last one.

A jump back starts an iteration. If the accumulator equals its value at the last jump back, and the commands
in between only read, the result stays the same until an event. This also holds if the accumulator changes,
provided that an iteration sets it before using it, and only tests it after reading a value that changes by
itself: the iterations then repeat until the result of one of these tests changes (`loop_tests.py`). Execution
resumes after the last whole iteration that ends at least a command before that.

An iteration that waits for a time (WA) is skipped, too. Its times are sums that round, so they are added up
one by one.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.lang.dependencies import CLOSE, Dependencies
from motionlang.lang.waits import Wait
from motionlang.mccl.axis.variables import changes_by_event, crossing_time, read_until
from motionlang.mccl.runtime.loop_tests import levels, readings_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from motionlang.lang.dependencies import Note
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.resolve.line import Line
    from motionlang.mccl.runtime.loop_tests import Reading
    from motionlang.mccl.runtime.task import CommandTask

_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz "
# The largest number of iterations without a check; with it a checked loop costs little more than an unchecked
# one.
MAX_BACK_OFF = 1024
# So many checks may fail before the back-off: a value changes in one iteration, and the next one switches an output.
FREE_FAILURES = 2
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
        # The values that loops read, by line, first and last command.
        self._readings: dict[tuple[int, int, int], tuple[Line, dict[int, Reading | None] | None]] = {}
        # Back-off: iterations that still run unchecked, and failed checks since the last skip.
        self._alone = self._failures = 0

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
        wait, now, next_event, cost = None, clock.now, clock.next_time(), task.cost
        callers = [pc for _, pc, _ in task.calls] if task.calls else []
        position = task.line, task.pc, board.effects, callers
        waits = self._waits
        goes_on = ran == board.slices and (after(base, waits, cost) if waits else base) == task.base
        if waits:
            self._waits = []
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
                if accumulator == accumulated:
                    until = dependencies.until(now, notes)
                    if until == INFINITY and not counters:
                        self._give_up()
                if until < next_event:
                    until = max(until, self._tested_until(notes, now, base + count * cost - CLOSE))
            if until > now:
                self._failures, wait = 0, self._skip(until, task.count - count, waits, counters)
                if counters:
                    position, accumulated = (*position[:2], board.effects, *position[3:]), task.registers[0]
            else:
                self._failures += 1
                later = self._failures - FREE_FAILURES - 1
                self._alone = min(1 << min(later, 30), MAX_BACK_OFF) if later >= 0 else 0
                dependencies.notes = None if self._alone else []
        self._before = position, accumulated, task.base, task.count, next_event, board.slices
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
        until = min(until, clock.next_time())
        if len(board.tasks) > 1:
            until = min(until, board.next_wake(task))
        if until == INFINITY and (self._writes or waits or counters):
            until = scheduler.until
            if until == INFINITY or ((waits or counters) and len(board.tasks) > 1):
                return None  # the run may end before, if all tasks are hopeless
        if until == INFINITY:
            why = "for its loop to end"
            return Wait(now, lambda: board.slices != slices, lambda: INFINITY, why)
        until = min(until, max(task.horizon, scheduler.reach()))
        if waits:
            self._skip_waits(until, waits)
            return None
        iterations = max(0, int((until - task.cost - now) / (length * task.cost)))
        if counters:
            assert self._registers is not None
            iterations = int(min(iterations, self._registers.most(counters)))
            self._registers.count(counters, iterations)
        task.count += length * iterations
        return None

    def _skip_waits(self, until: float, waits: list[tuple[int, float]]) -> None:
        """Skip the iterations that wait, up to the time `until`."""
        task = self._task
        # The time of the last command of an iteration, after its waits.
        rest = (task.count + 1) * task.cost
        first = last = base = task.base
        if len(waits) == 1:  # as in `after`
            ((count, seconds),) = waits
            busy = count * task.cost
            while base + rest < until:
                last, base = base, base + busy + seconds
        else:
            while base + rest < until:
                last, base = base, after(base, waits, task.cost)
        task.base = last
        if last > first:
            period = after(0.0, waits, task.cost)
            # The iteration that repeats began a period ago; half a command more is for rounding.
            began = first + task.count * task.cost - period - 0.5 * task.cost
            task.board.machine.log.repeat_waits(task.name, began, period, round((last - first) / period))

    def _tested_until(self, notes: list[Note], now: float, since: float) -> float:
        """Return until when the tests of an iteration give the same results as at `since`.

        `notes` are the dependencies that the iteration recorded, and `now` is the time at its end. If a value
        that has changed by then is used for more than tests, the loop may change at once.
        """
        task, clock = self._task, self.dependencies.clock
        assert task.line is not None
        key = id(task.line), task.pc, task.here
        known = self._readings.get(key)
        if known is None:
            if len(self._readings) >= MAX_LOOPS:
                self._readings.clear()
            governs: int = task.board.assumptions.get("mccl.skipped", 2)  # type: ignore[assignment]
            known = task.line, readings_of(task.line.commands[task.pc : task.here + 1], governs)
            self._readings[key] = known
        readings, first, found = known[1], task.pc, INFINITY
        if readings is None:
            return since
        clock.now = since
        try:
            for until, about in notes:
                if until is read_until:
                    moment = self._changed(about, readings.get(about[1] - first), now)
                else:
                    moment = until(*about)
                if moment < found:
                    found = moment
        finally:
            clock.now = now
        return found

    def _changed(self, about: tuple[Any, ...], reading: Reading | None, now: float) -> float:
        """Return when a test of a value that was read may change.

        `about` is what its dependency is about. If `reading` is None, the value is used for more than tests.
        """
        until: float
        until, _, axis, address = about
        task, board = self._task, self._task.board
        bits = None if reading is None else reading.bits
        if bits is not None and changes_by_event(board, address, bits):
            return INFINITY
        if until > now:
            return until
        if reading is None or reading.levels is None:
            return self.dependencies.clock.now
        wanted = reading.levels
        if reading.by_register:
            more = [levels(each, task.value(each), reading.verb) for each in reading.by_register]
            wanted = wanted + tuple([level for found in more for level in found])
        return min([crossing_time(board, axis, address, level) for level in wanted], default=INFINITY)


def after(base: float, waits: list[tuple[int, float]], cost: float) -> float:
    """Return the base of a task's command times after some waits."""
    for count, seconds in waits:
        base = base + count * cost + seconds
    return base
