"""Runs commands one after another on one machine, and survives their errors."""

from __future__ import annotations

from collections.abc import Callable
from traceback import walk_tb

from motionlang.kernel import (
    ONE_SHIFT,
    Diagnostic,
    Dialect,
    Machine,
    ProgramError,
    Rejected,
    Scheduler,
    Source,
    Stuck,
    Task,
    Wait,
)
from motionlang.kernel.lang import explain, wait_idle, wait_until, what_ends, what_frees
from motionlang.kernel.tools import StackSpace, missing
from motionlang.repl.status import moving

# Machine time after which a busy command is polled again for Ctrl-C.
SLICE = 0.25
# Machine time after eight hours in which `.run 28800` still ends.
REST = 1e-3
NOWHERE = Source("input", "")


class CommandInterrupted(Exception):
    """The user pressed Ctrl-C while a command was running."""


class Runner:
    """Executes the commands of a session on its machine.

    `tell(diagnostics, source)` reports errors. `poll(time)` is called between two steps of a command, when
    every axis is consistent, with the machine time of the next step. It raises `CommandInterrupted` to end the command.
    """

    def __init__(
        self,
        dialect: Dialect,
        machine: Machine,
        report: Callable[[list[Diagnostic], Source], None],
        poll: Callable[[float], None],
    ) -> None:
        self.dialect, self.machine = dialect, machine
        self._report, self._poll = report, poll
        # One scheduler for the whole session: background tasks and event handlers continue during every
        # command.
        idle = _Passing(wait_until(machine, 0.0, 0.0))
        self._scheduler = machine.scheduler = Scheduler(machine.controller, idle, poll)
        self._scheduler.gives_up = True
        self.interactive = dialect.interactive(machine)

    def execute(self, source: Source) -> bool:
        """Run a source until its task has ended; return False after an error.

        Motion continues.
        """
        try:
            task = self.interactive.task(source)
        except ProgramError as error:
            self._report(error.diagnostics, source)
            return False
        except Exception as error:
            self._explain(error, None, source)
            return False
        return self._run(task, source)

    def pass_time(self, seconds: float) -> bool:
        """Let machine time pass; return False if an error occurred."""
        controller = self.machine.controller
        now = controller.clock.now
        return self._run(_Passing(wait_until(controller, now, now + seconds)), NOWHERE)

    def settle(self) -> bool:
        """Let time pass until all motion has ended.

        Returns False if it never ends or an error occurs.
        """
        controller = self.machine.controller
        return self._run(_Passing(wait_idle(controller, controller.clock.now, moving(self.machine))), NOWHERE)

    def _run(self, task: Task, source: Source) -> bool:
        scheduler, clock = self._scheduler, self.machine.controller.clock
        self._let_run(task)
        end = clock.now + ONE_SHIFT + REST

        def run() -> bool:
            while not scheduler.run_program(min(clock.now + SLICE, end)):
                if clock.now >= end:
                    raise Rejected("limit", "the command has been running for eight hours of machine time")
                self._poll(clock.now)
            return True

        return self._guard(source, run)

    def _let_run(self, task: Task) -> None:
        """Replace the previous command's task by a new one."""
        scheduler = self._scheduler
        before = scheduler.parent
        scheduler.tasks = [task, *(each for each in scheduler.tasks if each is not before and not each.done)]
        scheduler.interrupts = [each for each in scheduler.interrupts if not each.done]
        scheduler.current = task
        self.machine.controller.forget_text()

    def _guard(self, source: Source, work: Callable[[], bool]) -> bool:
        """Call `work`; report any error and keep the machine running."""
        try:
            try:
                with StackSpace():
                    return work()
            finally:  # diagnostics of the machine that did not end the command
                complaints, self.machine.diagnostics = self.machine.diagnostics, []
                if complaints:
                    self._report(complaints, source)
        except (CommandInterrupted, KeyboardInterrupt) as error:
            at = self._scheduler.parent.at_error(error)
            self._report_at(source, at, "interrupted", "the command was interrupted from the keyboard")
        except Stuck as stuck:
            message = f"the command waits {stuck.wait.why}, which can never happen"
            program = self.dialect.program(source) if source.text.strip() else None
            if program is not None and program.errors:  # it has names of earlier lines
                program = None
            blocked = self.dialect, program, self.machine, stuck.task, stuck.wait
            hint = (
                what_ends(*blocked, at_prompt=True) or what_frees(*blocked) or "start what changes it first"
            )
            self._report_at(source, self._scheduler.parent.at, "never", message, hint)
        except Exception as error:
            self._drop_if_broken(error)
            self._explain(error, self._scheduler.current, source)
        return False

    def _report_at(self, source: Source, at: int, code: str, message: str, hint: str = "") -> None:
        """Report an error at the current position of the command."""
        diagnostic = Diagnostic(code, message, hint=hint)
        if source is not NOWHERE:
            diagnostic.line, diagnostic.column, diagnostic.length = self.dialect.locate(source, at)
        self._report([diagnostic], source)

    def _drop_if_broken(self, error: Exception) -> None:
        """Remove the current task if the error occurred in it, because it cannot continue.

        The task is the command or a background task.
        """
        task = self._scheduler.current
        frames = (frame for frame, _ in walk_tb(error.__traceback__))
        if any(frame.f_code.co_name == "resume" and frame.f_locals.get("self") is task for frame in frames):
            task.done = True  # the command stays the scheduler's parent until the next one takes its place
            if task is not self._scheduler.parent:
                self._scheduler.end(task)

    def _explain(self, error: Exception, task: Task | None, source: Source) -> None:
        """Report an error; internal errors are raised again."""
        foreground = source is not NOWHERE and task is self._scheduler.parent
        diagnostic = explain(self.dialect, source, task if foreground else None, error)
        if diagnostic is None:
            lacking = missing(error, "this line")
            if lacking is None:
                raise error
            diagnostic = Diagnostic("extra", lacking.message, hint=lacking.hint)
        self._report([diagnostic], source)


class _Passing(Task):
    """A task that only waits."""

    __slots__ = ("_wait",)

    def __init__(self, wait: Wait) -> None:
        super().__init__("prompt")
        self._wait: Wait | None = wait

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        wait, self._wait = self._wait, None
        self.done = wait is None
        return now, wait
