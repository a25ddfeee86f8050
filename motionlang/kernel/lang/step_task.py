"""A task that runs steps; one class for both languages.

Its state is `pc`, `calls` and `values` (see `steps.py`), with the list of steps that `pc` is an index of. A language
adds in a subclass what the operations of its keywords look for in a task.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.change_times import Note
from motionlang.kernel.lang.debugging import Hook
from motionlang.kernel.lang.loop_log import LoopLog
from motionlang.kernel.lang.loops import Loops, LoopState
from motionlang.kernel.lang.run_errors import NotSimulated
from motionlang.kernel.lang.steps import (
    BACK,
    BEGIN,
    BRANCH,
    CALL,
    COMMAND,
    DO,
    END,
    ENTER,
    GO,
    JUMP,
    NOTE,
    NOW,
    RETURN,
    TRY,
    TURN,
    WAIT,
    Steps,
    Values,
)
from motionlang.kernel.lang.task import Task
from motionlang.kernel.lang.waits import Wait

# Statements between two returns to the scheduler, so that a busy program can be paced and interrupted.
SLICE = 20_000


class Caller(NamedTuple):
    """The place of a caller: its steps, the index of the next one, and its values."""

    steps: Steps
    pc: int
    values: Values


class StepTask(Task):
    """Runs steps until something else may happen, a wait, or the end.

    `at_statement` is the offset of the statement that has begun last.
    """

    # The errors of statements after which the program goes on.
    recovers: tuple[type[Exception], ...] = ()
    max_depth = 1000

    def __init__(self, name: str, steps: Steps, values: Values, loops: Loops) -> None:
        super().__init__(name)
        self.steps, self.pc, self.values = steps, 0, values
        self.calls: list[Caller] = []
        # True if the time of the statement at `pc` has been paid, and it has not begun.
        self.is_paid = False
        self.at_statement = -1
        # The result of the call that has ended last.
        self.result: Any = None
        self.loops_of_all = loops
        self.machine, self.time = loops.machine, loops.time
        self.clock = self.machine.clock
        self.loop_log = LoopLog(self)
        self.hook: Hook | None = None
        # What it has read since its last checked jump back, while that is recorded.
        self.notes: list[Note] | None = None
        # The jumps back that are not checked, the length of that back-off, and the checks in a row without a skip.
        self.unchecked = self.back_off = self.failures = 0
        # Its last loop: steps, first and last one; and how often that has become another.
        self.last_loop = steps, 0, -1
        self.strayed = 0
        # The states at its jumps back, by their places, since the last action.
        self.met: dict[object, LoopState] = {}
        self.met_after = -1, -1
        # Its own state at the last checked jump back, what it had read by then, and when that was.
        self.last_own: object = None
        self.since: tuple[list[Note] | None, int, float] = None, 0, 0.0
        # Since when all its iterations are equal if nothing else acts, and after which actions.
        self.futile_since: float | None = None
        self.futile_after: object = None
        # The variables of all tasks at its last checked jump back, and those with which an iteration changed nothing.
        self.seen_shared: list[Any] | None = None
        self.endless_with: list[Any] | None = None

    # -------------------------------------------------------------------------------------------- for the log

    @property
    def now(self) -> float:
        """The time of its present statement, s."""
        return self.time.at(self.time.count)

    @property
    def at(self) -> int:
        return max(self.at_statement, 0)

    @property
    def reached(self) -> tuple[int, float]:
        steps, pc = self.steps, self.pc
        at = steps[pc].at if pc < len(steps) else -1  # a call or a return changes one before the other
        return (at if at >= 0 else self.at), self.now

    @property
    def stack(self) -> tuple[int, ...]:
        return (*self.callers, self.at)

    @property
    def callers(self) -> tuple[int, ...]:
        calls = self.calls
        return tuple([at for steps, pc, _ in calls if (at := steps[pc - 1].at) >= 0]) if calls else ()

    @property
    def loops(self) -> Sequence[tuple[int, float, tuple[int, ...]]]:
        return self.loop_log.open()

    @property
    def polls_in_vain(self) -> bool:
        return self.futile_since is not None and self.futile_after == self.loops_of_all.world.acted()

    @property
    def is_endless(self) -> bool:
        return self.polls_in_vain and self.endless_with == self.loops_of_all.world.shared

    def condition(self) -> Callable[[], object] | None:
        """Return the condition that its present step tests, None if that is not one."""
        steps, pc, values = self.steps, self.pc, self.values
        _, do, _, _, _ = step = steps[pc] if pc < len(steps) else steps[-1]
        return partial(do, values) if step.kind in (BRANCH, BACK) and do is not None else None

    def conditions_out(self) -> Callable[[], list[bool]]:
        steps, first, last = self.last_loop
        loop = list(
            zip(range(first, last + 1), steps[first : last + 1], steps.uses[first : last + 1], strict=True)
        )
        # A test may read a copy of a value, such as that of a key in `k = INKEY`. What takes the answer of a wait or a
        # call is none, and neither is what uses that.
        copies, taken = [], frozenset[int]()
        for pc, step, uses in loop:
            if step.kind == DO and step.do is not None and uses is not None and uses.sets:
                before = steps[pc - 1]
                is_result = before.kind == WAIT or (before.kind == CALL and before.at == step.at)
                if is_result or uses.reads & taken:
                    taken |= uses.sets
                else:
                    copies.append(step.do)
        tests = [
            step.do
            for pc, step, _ in loop
            if step.do is not None
            and ((step.kind == BRANCH and step.to > last) or (step.kind == BACK and pc == last))
        ]

        def tested() -> list[bool]:
            values, shared = list(self.values), self.loops_of_all.world.shared
            before = list(shared)
            results: list[object] = []
            for do in (*copies, *tests):
                try:
                    results.append(do(values))
                except (Rejected, NotSimulated, ArithmeticError):  # the program may not come there
                    results.append(False)
            shared[:] = before
            return [bool(each) for each in results[len(copies) :]]

        return tested

    # ------------------------------------------------------------------------------------------ for languages

    @property
    def own(self) -> Values:
        """The variables of the running call that may count."""
        return self.values

    def context(self) -> object:
        """Return a copy of what decides how the task goes on, except its own variables."""
        raise NotImplementedError

    def others_ready(self) -> bool:
        """True if another task goes before the next statement."""
        return False

    def gate(self) -> Wait | None:
        """Return the wait before a statement that has been paid, if any."""
        return None

    def failed(self, error: BaseException, pc: int, t: float) -> None:
        """Record that a step has failed at a statement; raise the error again if the program cannot go on."""
        if not isinstance(error, self.recovers):
            raise error

    def recover(self, error: BaseException) -> bool:
        """Set the state in which the program goes on after an error, one of `recovers`; True if it gives way first."""
        raise error

    def too_deep(self) -> Exception:
        """Return the error of a call that is nested too deeply."""
        return RecursionError()

    # ------------------------------------------------------------------------------------------------ running

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        """Run from `now` until `horizon`, a wait or the end; return the time and the wait."""
        loops = self.loops_of_all
        loops.run(self)
        try:
            t, wait = self._run(self.time.go_on(now, horizon), horizon)
        finally:
            loops.give_way(self)
        return self.time.leave(t), wait

    def _run(self, t: float, horizon: float) -> tuple[float, Wait | None]:
        """Run from statement `t`; by `horizon`, or the next event, something else may happen."""
        time, clock, calls, loop_log = self.time, self.clock, self.calls, self.loop_log
        left, has_run, hook = SLICE, False, self.hook
        cost_of_statement = time.cost
        time.count = t
        while not self.done:
            steps, pc, values = self.steps, self.pc, self.values
            try:
                while True:
                    kind, do, to, at, cost = steps[pc]
                    if kind == DO:
                        do(values)  # type: ignore[misc]
                        t += cost
                        pc += 1
                    elif kind == NOW:
                        self.pc = pc = pc + 1
                        self.at_statement = at
                        time.count = t
                        now = time.base + t * cost_of_statement
                        if now >= horizon or now >= clock.horizon:
                            return t, None
                        clock.now = now
                        if not left:
                            return t, None
                    elif kind == BRANCH:
                        pc = pc + 1 if do(values) else to  # type: ignore[misc]
                        t += cost
                    elif kind == COMMAND:
                        self.pc = pc
                        if self.is_paid:
                            self.is_paid = False
                        else:
                            if not left or (has_run and self.others_ready()):
                                return t, None
                            left -= 1
                            time.count = t = t + 1.0
                            now = time.at(t)
                            if now >= horizon or now >= clock.horizon:
                                self.is_paid = True
                                return t, None
                            clock.now = now
                        has_run = True
                        if (wait := self.gate()) is not None:
                            self.is_paid = True
                            return t, wait
                        if pc > loop_log.end:
                            loop_log.passed()
                        if hook is not None and hook.begins(self, clock.now, at) and self._is_alone:
                            left = 0
                        self.at_statement = at
                        self.pc = pc = pc + 1
                        if do is not None:
                            do(values)
                    elif kind in (WAIT, TRY):
                        self.pc = pc
                        if at >= 0:
                            self.at_statement = at
                        time.count = t
                        wait = do(values)  # type: ignore[misc]
                        if wait is None or kind == WAIT:
                            self.pc = pc = pc + 1
                            t += cost
                        if wait is not None:
                            if not self._passes(wait):
                                return t, wait
                            t, horizon = self._after_wait(wait, t)
                    elif kind in (BACK, GO):
                        here = pc
                        pc = to if do is None else do(values) if kind == GO else to if do(values) else pc + 1
                        self.pc = pc
                        t += cost
                        if do is None:
                            time.count = t
                            now = time.base + t * cost_of_statement
                            if now >= horizon or now >= clock.horizon:
                                self.at_statement = at
                                return t, None
                        if pc <= here:
                            began, base = t, time.base
                            t, wait = self.loops_of_all.back(self, here, t)
                            if wait is not None:
                                return t, wait
                            if t != began or time.base != base:
                                horizon = self._horizon(t)
                        elif loop_log.running:
                            loop_log.passed()
                    elif kind == JUMP:
                        pc = to
                        t += cost
                    elif kind == CALL:
                        if len(calls) > self.max_depth:
                            raise self.too_deep()
                        time.count = t
                        called = do(values)  # type: ignore[misc]
                        calls.append(Caller(steps, pc + 1, values))
                        self.steps, self.values = steps, values = called
                        self.pc = pc = max(to, 0)
                        loop_log.enter()
                    elif kind == ENTER:
                        here, before = pc, steps
                        steps, values = do(values)  # type: ignore[misc]
                        if steps is not before:
                            loop_log.leave()
                        self.steps, self.pc, self.values, pc = steps, 0, values, 0
                        if steps is not before:
                            loop_log.enter()
                        t, wait = self.loops_of_all.back(self, here, t, steps is before)
                        if wait is not None:
                            return t, wait
                    elif kind == RETURN:
                        self.pc = pc
                        if has_run and self.others_ready():
                            return t, None
                        time.count = t
                        self.result = None if do is None else do(values)
                        if loop_log.running:
                            loop_log.leave()
                        if not calls:
                            self.done = True
                            return t, None
                        self.steps, self.pc, self.values = steps, pc, values = calls.pop()
                        if loop_log.running:
                            loop_log.enter()
                    elif kind == NOTE:
                        self.pc = pc = pc + 1
                        time.count = t
                        do(values)  # type: ignore[misc]
                    elif kind == TURN:
                        horizon = -INFINITY
                        t += cost
                        pc += 1
                    elif kind == BEGIN:
                        self.pc = pc
                        self.at_statement = at
                        time.count = t
                        assert hook is not None
                        if hook.begins(self, time.at(t), at) and self._is_alone:
                            left = 0
                        pc += 1
                    else:
                        assert kind == END
                        self.pc = pc
                        time.count = t
                        self.done = True
                        if do is not None:
                            do(values)
                        if loop_log.running:
                            loop_log.close()
                        return t, None
                    if self.done:
                        if loop_log.running:
                            loop_log.close()
                        return t, None
            except BaseException as error:
                # It has run ahead of the clock, at most to the next event.
                clock.now = max(clock.now, min(time.at(t), horizon, clock.horizon))
                self.failed(error, pc, t)
                gives_way = self.recover(error)
                if self.machine.observer is not None:
                    self.machine.observer.failed(self)
                t = time.count
                if gives_way or self.others_ready():
                    break
        return t, None

    @property
    def _is_alone(self) -> bool:
        """True if it is the only task, so that another round of the scheduler changes nothing."""
        scheduler = self.machine.scheduler
        return scheduler is not None and len(scheduler.tasks) == 1

    def _horizon(self, t: float) -> float:
        """Return until when the task may run on after it has skipped iterations."""
        scheduler = self.machine.scheduler
        assert scheduler is not None
        self.clock.now = self.time.at(t)
        self.time.until = horizon = scheduler.horizon(self)
        return horizon

    def _passes(self, wait: Wait) -> bool:
        """Let a wait pass within the statement if nothing else happens meanwhile; False if the task must give way."""
        scheduler = self.machine.scheduler
        if scheduler is None:
            return False
        if wait.end_of_moves is not None:
            return bool(scheduler.comes_to_rest(wait.since, wait.end_of_moves))
        return bool(scheduler.passes(wait))

    def _after_wait(self, wait: Wait, t: float) -> tuple[float, float]:
        """Log a wait that has passed; return the statement after it, and the new horizon."""
        time, clock, scheduler = self.time, self.clock, self.machine.scheduler
        assert scheduler is not None
        # First: an interrupt meanwhile reads the time from the statement and its base, which change below.
        scheduler.waited(self.waited(wait, clock.now))
        if clock.now != time.at(t):
            t = time.start(clock.now)
        time.leave(t)
        return t, min(clock.horizon, scheduler.until)
