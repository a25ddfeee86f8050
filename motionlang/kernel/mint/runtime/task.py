"""A task of a Mint program: steps with default axes, TIME and suspension."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.loops import Loops
from motionlang.kernel.lang.step_task import StepTask
from motionlang.kernel.lang.steps import CALL, RETURN
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import walk
from motionlang.kernel.mint.syntax.unparse import shown

if TYPE_CHECKING:
    from motionlang.kernel.mint.runtime.environment import Environment
    from motionlang.kernel.mint.steps.program import FunctionSteps

# Nested calls of subs, functions and Gosubs, in one task or handler: a language's own maximum, so that a recursion ends
# at the same call and the same time in any environment.
MAX_DEPTH = 1000
# A note names so many readings of a loop.
MAX_NAMED = 3
# The name of the parent task. No other task has it, because names of tasks are stored in lower case.
PARENT = "ParentTask"


class MintTask(StepTask):
    """A task of a Mint program; `timer` holds the start time of its TIME."""

    max_depth = MAX_DEPTH - 1

    def __init__(self, name: str, unit: FunctionSteps, environment: Environment) -> None:
        values = environment.places.new_values(unit.function)
        loops: Loops = environment.loops
        super().__init__(name, unit.steps, values, loops)
        self.pc, self.environment, self.unit = unit.entry, environment, unit
        self.at_statement = unit.steps[unit.entry].at
        self.hook = environment.machine.hook
        self.timer = [environment.clock.now]
        self.axes: tuple[int, ...] = (0,)
        self.suspended = False
        self.suspended_wait: Wait | None = None
        self.priority = environment.priorities.get(name, 0)
        self._is_running = False
        if environment.is_guarded:
            from motionlang.kernel.mint.runtime.errors import TROUBLE

            self.recovers = TROUBLE
        self.set_time_slice()

    @property
    def at(self) -> int:
        """The position of its statement; of the call of a sub that was typed in an earlier line at a prompt."""
        origin = self.unit.steps.origin
        if self.steps.origin is origin:
            return max(self.at_statement, 0)
        calls = (call for call in reversed(self.calls) if call.steps.origin is origin)
        return next((call.steps[call.pc - 1].at for call in calls), 0)

    @property
    def polled(self) -> str:
        """The first few readings in its loop, joined by "and"."""
        steps, _, last = self.last_loop
        node = steps.loops.get(last)
        return "" if node is None else readings(node)

    def context(self) -> object:
        callers = tuple([(id(call.steps), call.pc, *map(_known, call.values)) for call in self.calls])
        return self.axes, self.suspended, callers

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        """Run until `horizon`, as the task of the environment."""
        self.environment.task = self
        self._is_running = True
        try:
            time, wait = super().resume(now, horizon)
        finally:
            self._is_running = False
        if self.suspended:
            self.suspended_wait, wait = wait, self.never()
        return time, wait

    @property
    def running(self) -> bool:
        return self._is_running

    def _passes(self, wait: Wait) -> bool:
        # Errors that occur meanwhile belong to no waiting statement.
        return not self.environment.has_errors and super()._passes(wait)

    def failed(self, error: BaseException, pc: int, t: float) -> None:
        """Record the failure of a statement; raise it again if the program does not handle it."""
        self.at_statement = self.steps[pc].at if pc < len(self.steps) else self.at_statement
        self.pc, self.time.count = pc, t
        if isinstance(error, self.recovers) and pc in self.steps.behind:
            return
        if isinstance(error, Rejected):
            from motionlang.kernel.mint.runtime.errors import with_number

            with_number(error)
        raise error

    def recover(self, error: BaseException) -> bool:
        """Go on after the statement that has failed; ONERROR runs before that."""
        environment = self.environment
        line_of = environment.line_of
        self.pc = self.steps.behind[self.pc]
        environment.failed(error, 0 if line_of is None else line_of(self.at_statement))
        return True

    def too_deep(self) -> Rejected:
        """Return the error of calls that are nested too deeply."""
        words = f"calls are nested more than {MAX_DEPTH} deep"
        label = self._left_gosub()
        if label:
            return Rejected(
                "recursion", f"{words}: a Goto left GOSUB {label} without Return", "end it with Return"
            )
        return Rejected("recursion", words, "a sub, a function or a Gosub calls itself endlessly")

    def _left_gosub(self) -> str:
        """Return the label of the innermost Gosub that a Goto left, "" if each call is within the one around it."""
        for outer, inner in zip(reversed(self.calls[:-1]), reversed(self.calls[1:]), strict=True):
            steps, begin = outer.steps, outer.steps[outer.pc - 1].to
            if inner.steps is not steps or begin not in steps.labels:
                continue
            called = {step.to for step in steps if step.kind == CALL and step.to in steps.labels}
            end = min((at for at in called if at > begin), default=len(steps))
            returns = [at for at in range(begin, end) if steps[at].kind == RETURN]
            if not begin < inner.pc <= (returns[-1] if returns else end):
                return steps.labels[begin]
        return ""

    def set_time_slice(self) -> None:
        """Apply TASKQUANTUM, reduced by half a statement.

        The reduction keeps rounding from deciding whether the last statement still fits.
        """
        environment = self.environment
        quantum = environment.quanta.get(self.name)
        if quantum is not None:
            self.max_slice = (quantum - 0.5) * environment.machine.instruction_time

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

    def never(self) -> Wait:
        """Return the endless wait of a suspended task."""
        now = self.environment.clock.now
        return Wait(now, lambda: not self.suspended, lambda: INFINITY, f"for TASKRESUME({self.name})", "task")


def readings(loop: nodes.Node) -> str:
    """Return the first few readings in a loop, as its author would write them, or the variables that others set."""
    targets = [each.target for each in walk([loop]) if isinstance(each, nodes.Assign)]
    waits = [each for each in walk([loop]) if isinstance(each, nodes.Pause)]
    others, own = {id(each) for each in walk([*targets, *waits])}, {shown(each) for each in targets}
    names = [
        each
        for each in sorted(walk([loop]), key=lambda each: each.start)
        if isinstance(each, nodes.Name) and id(each) not in others
    ]
    found = [
        shown(each)
        for each in names
        if each.row is not None
        and each.row.kind in ("reading", "setting")
        and "time" not in (each.row.reads, each.row.waits)
    ] or [shown(each) for each in names if each.row is None and shown(each) not in own]
    return " and ".join([*dict.fromkeys(found)][:MAX_NAMED])


def _known(content: object) -> object:
    """Return a number or a text, and what tells another content from all others that exist."""
    return content if isinstance(content, (int, float, str)) else id(content)


def until_free(since: float, semaphore: list[MintTask | None]) -> Wait:
    """Return the wait until no task holds a semaphore."""
    return Wait(
        since,
        lambda: (holder := semaphore[0]) is None or holder.done,
        lambda: INFINITY,
        "for a semaphore",
        "task",
    )
