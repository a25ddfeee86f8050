"""A task of a Mint program: a generator with default axes, TIME and suspension."""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Rejected
from motionlang.lang.task import MIN_STATEMENTS, GeneratorTask
from motionlang.lang.waits import Wait
from motionlang.mint.runtime.loop_log import open_loops

TYPE_CHECKING = False
if TYPE_CHECKING:
    from types import FrameType
    from typing import Any

    from motionlang.lang.dependencies import Note
    from motionlang.lang.waits import Delay
    from motionlang.mint.runtime.environment import Environment, Make
    from motionlang.mint.runtime.loop_log import Open
    from motionlang.mint.runtime.operations import PutOff
    from motionlang.mint.runtime.waits import Waits


class TaskEnd(Exception):
    """Raised to end the running task."""

    def __init__(self, time: float) -> None:
        super().__init__()
        self.time = time


# The name of the parent task. No other task has it, because names of tasks are stored in lower case.
PARENT = "ParentTask"


class MintTask(GeneratorTask):
    """A task of a Mint program; `timer` holds the start time of its TIME."""

    __slots__ = (
        "_acts",
        "_count",
        "_put_off",
        "axes",
        "delay",
        "environment",
        "frame",
        "futile",
        "notes",
        "suspended",
        "suspended_wait",
        "timer",
    )

    def __init__(self, name: str, make: Make, environment: Environment) -> None:
        file = make.__code__.co_filename
        super().__init__(name, make, file, environment.files[file])  # type: ignore[arg-type]
        self.environment = environment
        # Its innermost code when no sub is called.
        self.frame: FrameType | None = None
        # The wait of its WAIT statements; one at a time is active.
        self.delay: Delay | None = None
        self.timer = [environment.clock.now]
        self.axes: tuple[int, ...] = (0,)
        # Its recent readings that change by themselves, while dependencies are recorded.
        self.notes: list[Note] | None = None
        # The number of actions at its last check, if only another action could change what it polls.
        self.futile: int | None = None
        self.suspended = False
        self.suspended_wait: Wait | None = None
        # The operation that it put off when it gave way, carried out when it resumes.
        self._put_off: PutOff | None = None
        self._acts = False  # True while that operation is carried out
        self._count = environment.time_cells[0]
        self.set_time_slice()

    @property
    def polls_in_vain(self) -> bool:
        """True if it polls, and only another task or an event can change what it reads."""
        environment = self.environment
        return environment.acts == self.futile and environment.fired == environment.clock.fired

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        """Resume like any task, and detect whether others ran in the meantime."""
        environment, generator = self.environment, self._generator
        environment.task = self
        clock, dependencies, statements = environment.clock, environment.dependencies, environment.statements
        if environment.fired != clock.fired:  # as in `noticed`
            environment.fired = clock.fired
            environment.acts += 1
            self.poll_check = None
        if environment.ran is not self or environment.leaps != clock.leaps:
            environment.resumed += 1
            environment.leaps = clock.leaps
        acts = environment.acts
        environment.acts_before = acts - environment.switches
        notes = self.notes
        dependencies.notes = [] if notes is None and dependencies.read is not None else notes
        self.busy = 0.0
        reached = statements.go_on(now, horizon)
        environment.set_time(reached)
        out: Any
        try:
            if self._put_off is not None:
                out = self._carry_out(*reached)
            elif generator is not None:
                out = generator.send(reached)
            else:
                self._generator = generator = self._make()  # type: ignore[call-arg]
                self.frame = generator.gi_frame  # type: ignore[attr-defined]
                out = next(generator)
        except StopIteration:
            self.done = True
            time, wait = statements.leave(self._count.cell_contents), None
        except TaskEnd as end:
            self.done = True
            for at, since, callers in self.loops_of(end, "lr")[::-1]:
                environment.machine.log.loops.add((self.name, at, since, end.time, callers))
            return end.time, None
        except Rejected as rejected:
            from motionlang.mint.runtime.errors import with_number

            with_number(rejected)
            raise
        else:
            kind = out.__class__
            if out is None:
                count, put_off = self._count.cell_contents, environment.put_off
                if put_off is None:
                    time, wait = statements.leave(count), None
                else:
                    self._put_off, environment.put_off = put_off, None
                    _, _, full = put_off
                    wait = None if full is None else environment.space_wait(count, full)
                    time = statements.leave(count)
            elif kind is float:
                time, wait = statements.leave(out), None
            elif kind is tuple:
                count, busy = out
                time, wait, self.busy = statements.leave(count), None, busy * statements.cost
            else:
                time, wait = out.since, out
        self.notes = dependencies.notes
        environment.ran = self
        if environment.acts != acts:  # it has acted, unless that was before its last check
            self.poll_check = None
        if self.suspended:
            self.suspended_wait, wait = wait, self.never()
        return time, wait

    def _carry_out(self, count: float, horizon: float) -> object:
        """Carry out the operation that was put off, then continue.

        A failure is raised at its statement. If a move still finds no space, it is put off again.
        """
        environment, generator = self.environment, self._generator
        assert self._put_off is not None
        assert generator is not None
        (operation, arguments, _), self._put_off = self._put_off, None
        if horizon <= count:  # everything due now has had its chance
            environment.set_time((count, count + 0.5))
        self._acts = True
        try:
            if operation(0.0, *arguments):
                return None
        except Exception as error:
            return generator.throw(error)
        finally:
            self._acts = False
        return generator.send((count, environment.time_cells[1].cell_contents))

    @property
    def shared(self) -> Environment:
        return self.environment

    def state(self, alive: dict[int, object], since: float = -INFINITY) -> bytes | None:
        """Return the state that decides its future, as `Task.state`."""
        from motionlang.mint.runtime.task_state import of_task

        base, cost = self.environment.statements.base, self.environment.statements.cost
        count = self.environment.statements.count

        def is_old(began: tuple[float, float]) -> bool:
            is_logged = began[1] != base or count - began[0] > MIN_STATEMENTS
            return is_logged and began[1] + began[0] * cost <= since

        return of_task(self._generator, self._put_off, alive, is_old)

    @property
    def running(self) -> bool:
        return self._acts or super().running

    @property
    def loops(self) -> list[Open]:
        frames, inner = [], self._generator
        while (frame := getattr(inner, "gi_frame", None)) is not None:
            frames.append((frame, frame.f_lineno))
            inner = getattr(inner, "gi_yieldfrom", None)
        return open_loops(frames, self._file, self._offsets, self.environment.statements)

    def loops_of(self, error: Exception, kinds: str = "l") -> list[Open]:
        """Return the loops in the frames that an exception came through, outermost first.

        For `kinds` see `open_loops`.
        """
        frames, traceback = [], error.__traceback__
        while traceback is not None:
            frames.append((traceback.tb_frame, traceback.tb_lineno))
            traceback = traceback.tb_next
        return open_loops(frames, self._file, self._offsets, self.environment.statements, kinds)

    def set_time_slice(self) -> None:
        """Apply TASKQUANTUM, reduced by half a statement.

        The reduction keeps rounding from deciding whether the last statement still fits.
        """
        environment = self.environment
        quantum = environment.quanta.get(self.name)
        if quantum is not None:
            self.max_slice = (quantum - 0.5) * environment.machine.instruction_time

    def noticed(self, environment: Waits) -> None:
        """Record that events have fired, so anything the program polled may have changed."""
        environment.fired = environment.clock.fired
        environment.acts += 1
        self.poll_check = None

    def take(self, semaphore: list[MintTask | None], wanted: int) -> bool:
        """Take or release a semaphore; return False while another task holds it."""
        holder = semaphore[0]
        if holder is not None and holder.done:
            holder = None  # a semaphore is released when its task ends
        if not wanted:
            semaphore[0] = None if holder is self else holder
            return True
        if holder is not None and holder is not self:
            return False
        semaphore[0] = self
        return True

    def time_at_error(self, error: BaseException) -> float:
        reached = super().time_at_error(error)
        return self.environment.statements.at(reached) if reached else 0.0

    def never(self) -> Wait:
        """Return the endless wait of a suspended task."""
        now = self.environment.clock.now
        return Wait(now, lambda: not self.suspended, lambda: INFINITY, f"for TASKRESUME({self.name})", "task")


def until_free(since: float, semaphore: list[MintTask | None]) -> Wait:
    """Return the wait until no task holds a semaphore."""
    return Wait(
        since,
        lambda: (holder := semaphore[0]) is None or holder.done,
        lambda: INFINITY,
        "for a semaphore",
        "task",
    )


MintTask.resumes = MintTask.resume.__code__
