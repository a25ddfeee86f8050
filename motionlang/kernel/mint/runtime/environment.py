"""The environment of a running Mint program: its tasks, variables and waits, and what its keywords share."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, floor
from typing import TYPE_CHECKING, Any, TypeVar

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.controller.faults import ALL
from motionlang.kernel.controller.operations import Controller
from motionlang.kernel.controller.queue.buffer import end
from motionlang.kernel.controller.readers import Level
from motionlang.kernel.errors import Diagnostic, Rejected
from motionlang.kernel.lang.change_times import Dependencies
from motionlang.kernel.lang.loops import Loops
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.statement_time import UNITS, units
from motionlang.kernel.lang.steps import Steps
from motionlang.kernel.mint.runtime.functions import Random
from motionlang.kernel.mint.runtime.task import MintTask
from motionlang.kernel.mint.runtime.waits import Waits

if TYPE_CHECKING:
    from motionlang.kernel.mint.resolve.symbols import Function
    from motionlang.kernel.mint.runtime.errors import Errors
    from motionlang.kernel.mint.runtime.events import Events
    from motionlang.kernel.mint.runtime.power_up import PowerUp
    from motionlang.kernel.mint.steps.places import Places
    from motionlang.kernel.mint.steps.program import FunctionSteps, ProgramWriter

Component = TypeVar("Component")

# Rounding of a time in seconds must not cost a millisecond.
MILLISECOND = 1e-6
# A count of milliseconds is an Integer of 32 bits: -2147483648 follows 2147483647.
ROLLOVER = 1 << 31
# A wait that only a rollover could end, more than a day ahead, is reported as one that never ends.
DAY = 86400.0


def _apply_mint_settings(controller: Controller) -> None:
    for axis in controller.axes:
        mint_settings(controller, axis)
        controller.lock(axis, ALL)


def mint_settings(controller: Controller, axis: int) -> None:
    """Set how Mint differs from the controller's defaults for an axis.

    A new speed acts at once on the move in progress (FEEDRATEMODE 0).
    """
    controller.configure(axis, "live_speed", True)


class Environment(Waits):
    """One program on one machine.

    `task` is the running task; each task has its own TIME. `blocks` holds the tasks and event handlers by names such as
    "task blink" and "event timer".
    """

    def __init__(self, machine: Machine, places: Places) -> None:
        self.machine = machine
        self.clock = machine.clock
        self.controller = machine.controller
        # The operator's future answers to INPUT; None until the first one.
        self.answers: list[str] | None = None
        # Returns the line of a source offset, if the text is available.
        self.line_of: Callable[[int], int] | None = None
        self.blocks: dict[str, FunctionSteps] = {}
        # The tasks by name, and the handlers that run.
        self.by_name: dict[str, MintTask] = {}
        # Priorities set for tasks, including tasks that do not run yet.
        self.priorities: dict[str, int] = {}
        self.quanta: dict[str, int] = {}
        self.jogs: dict[int, float] = {}
        # The source offset of the speed of 0 about which each axis has warned.
        self.holds: dict[int, int] = {}
        # The condition of IDLE beyond the end of the move, if the program sets one.
        self.settled: Callable[[int], bool] | None = None
        # Called with the axis after each load into its buffer, if a program chooses what starts moves.
        self.loaded: Callable[[int], None] | None = None
        self.task: MintTask
        # Where its variables are, and the steps of its functions.
        self.places = places
        self.steps: dict[Function, Steps] = {}
        # True if the program goes on after an error.
        self.is_guarded = False
        # The times of its statements, the dependencies that its readings record, and the rule for its loops.
        self.statements = machine.statements
        self.dependencies = Dependencies(machine.clock)
        self.has_slices = True
        self.loops: Loops = Loops(machine, machine.statements, self)
        # The start of the parent task's TIME, which event handlers share.
        self.timer = [self.clock.now]
        # Counts the actions of the program. A polling loop performs none.
        self.acts = 0
        # Counts switches of outputs that nothing hears, and changes of the memory that only hosts read.
        self.switched = self.copies = 0
        # True if the program reads the memory that hosts read.
        self.reads_host_memory = False
        # The machine file's power-up values of settings, if it has any.
        self.power_up: PowerUp | None = None
        self._components: dict[type, object] = {Environment: self}
        self._events: Events | None = None
        self._errors: Errors | None = None
        self._random: Callable[[], float] | None = None

    def prepare(self) -> None:
        """Give the controller Mint's settings and the machine file's power-up values."""
        _apply_mint_settings(self.controller)
        self.controller.listeners.append(self._held, "held")
        if self.machine.assumptions:
            from motionlang.kernel.mint.runtime.power_up import PowerUp

            self.power_up = PowerUp(self, self.machine.assumptions)
            for axis in self.controller.axes:
                self.power_up.set(axis)

    def _held(self, what: str, axis: int) -> None:
        a = self.controller.axes[axis]
        move, at = a.move, a.zeroed_at
        if at >= 0 and self.holds.get(axis) == at:
            return
        self.holds[axis] = at
        line = self.line_of(at) if at >= 0 and self.line_of is not None else 0 if move is None else move.line
        message, hint = f"axis {axis} holds: its speed is 0", "it goes on when its speed is above 0"
        self.machine.complain(Diagnostic("zero-speed", message, line, hint=hint, severity="warning"))

    def component(self, kind: type[Component]) -> Component:
        """Return the component for a group of keywords, created on first use."""
        found = self._components.get(kind)
        if found is None:
            found = self._components[kind] = kind(self)  # type: ignore[call-arg]
        return found  # type: ignore[return-value]

    def forget_program(self) -> None:
        """Discard the tasks and handlers of a program that has ended; keep its settings."""
        for task in self.by_name.values():
            task.done = True
        self.by_name.clear()
        self.blocks.clear()
        self.priorities.clear()
        self.quanta.clear()
        if self._events is not None:
            self._events.forget_handlers()

    def components(self) -> list[object]:
        """Return the components created so far."""
        return list(self._components.values())

    @property
    def events(self) -> Events:
        """The events and their handlers, created on first use."""
        if self._events is None:
            from motionlang.kernel.mint.runtime.events import Events

            self._events = self.component(Events)
        return self._events

    @property
    def errors(self) -> Errors:
        """The errors so far, created on first use."""
        if self._errors is None:
            from motionlang.kernel.mint.runtime.errors import Errors

            self._errors = self.component(Errors)
        return self._errors

    def steps_of(self, function: Function) -> Steps:
        """Return the steps of a function, which its writer fills."""
        found = self.steps.get(function)
        if found is None:
            found = self.steps[function] = Steps()
        return found

    def forget(self, function: Function) -> None:
        """Discard the steps of a function that never runs again."""
        self.steps.pop(function, None)
        self.places.forget(function)

    def take(self, writer: ProgramWriter) -> None:
        """Take over the tasks and handlers of a program, or of a line typed at a prompt."""
        self.is_guarded = self.is_guarded or writer.is_guarded
        self.blocks |= writer.blocks
        if writer.blocks:
            from motionlang.kernel.mint.runtime.events import listen

            listen(self)

    # ---------------------------------------------------------------------------------- for the rule of loops

    @property
    def tasks(self) -> list[MintTask]:
        """All tasks that may run, those that wait included: while there is a handler, only that."""
        scheduler = self.machine.scheduler
        if scheduler is None:
            return [self.task]
        tasks = scheduler.interrupts[-1:] or scheduler.tasks
        return [each for each in tasks if isinstance(each, MintTask)]

    @property
    def shared(self) -> list[Any]:
        """The variables that the functions of the program share."""
        return self.places.shared

    def changes(self) -> tuple[int, int]:
        """Return counters of the actions whose effects cannot be compared, and of events."""
        return self.acts, self.clock.fired

    def acted(self) -> object:
        """Return counters of all that a loop could wait for."""
        return self.acts, self.clock.fired, self.switched, self.copies

    def levels(self) -> tuple[object, ...]:
        """Return the levels of the outputs that nothing hears."""
        return self.controller.outputs.values if self.switched else ()

    def stands_still(self) -> None:
        """Let a loop that repeats until something else acts run on to the end of the run; it must have one."""
        scheduler = self.machine.scheduler
        if scheduler is not None and scheduler.until == INFINITY:
            raise Rejected("never", "the loop polls for something that can no longer happen", "")

    def period(self, delays: list[tuple[float, float]]) -> int:
        """Return how long some waits take together, in units of time."""
        cost = self.statements.cost
        return sum(round((count * cost + seconds) * UNITS) for count, seconds in delays)

    def end_of_wait(self, base: float, count: float, seconds: float) -> float:
        """Return when a wait ends that began at a statement: a whole number of units, so that waits add up."""
        return (units(base) + round((count * self.statements.cost + seconds) * UNITS)) / UNITS

    # ---------------------------------------------------------------------------------------------- time

    def elapsed(self, base: float, level: Level = None) -> int:
        """Return the milliseconds since a time, rolled over to the range of an Integer.

        `level` is the value that they are compared with, if it is known.
        """
        count = self.milliseconds(base, self.clock.now)
        if count >= ROLLOVER:
            rolled = (count + ROLLOVER) // (2 * ROLLOVER) * 2 * ROLLOVER
            count, base = count - rolled, base + rolled / 1000.0
        dependencies = self.dependencies
        if dependencies.notes is not None:
            if level is None:
                dependencies.note(dependencies.ticks, base, self._counted)
            else:
                dependencies.note(self._counted, base, level)
        return count

    @staticmethod
    def milliseconds(base: float, now: float) -> int:
        """Return the whole milliseconds between two times."""
        return floor((now - base) * 1000.0 + MILLISECOND)

    def _counted(self, base: float, level: float) -> float:
        """Return the time at which the milliseconds since `base` next cross `level`.

        They cross it when they reach it, when they first exceed it, and when they roll over.
        """
        if not abs(level) < INFINITY:
            return INFINITY
        rollover = base + ROLLOVER / 1000.0
        for milliseconds in (ceil(level), floor(level) + 1):
            moment = base + milliseconds / 1000.0
            if self.clock.now < moment < rollover:
                return moment
        return rollover if rollover - self.clock.now < DAY else INFINITY

    def since(self, milliseconds: float) -> float:
        """Return the time that was some milliseconds ago, in seconds."""
        return self.clock.now - milliseconds / 1000.0

    def random(self) -> float:
        """Return the next number of `Rnd`."""
        if self._random is None:
            self._random = Random()
        self.acts += 1
        return self._random()

    def absolute_counts(self, axis: int, value: float) -> float:
        """Return an absolute position of a move in counts; `value` is in user units.

        On an axis that wraps it is a position in the wrap in which the axis will be when its buffer is empty.
        """
        a = self.controller.axes[axis]
        if a.scale.wrap:
            value += a.scale.position_to_user(end(a)) // a.scale.wrap * a.scale.wrap
        return a.scale.position_to_counts(value)

    # ----------------------------------------------------------------------------------------- semaphores

    def take_semaphore(self, semaphore: list[MintTask | None], wanted: int) -> bool:
        """Take or release a semaphore; return False while another task holds it."""
        self.acts += 1
        return self.task.take(semaphore, wanted)

    # ---------------------------------------------------------------------------------------------- axes

    def default_axes(self) -> tuple[int, ...]:
        """Return the axes of keywords without brackets, which AXES sets for each task."""
        return self.task.axes

    def in_whole_counts(self, distance_uu: float, axis: int) -> float:
        """Return a distance of an axis in user units, rounded to whole counts."""
        scale = self.controller.axes[axis].scale
        return scale.to_user(float(round(scale.to_counts(distance_uu))))

    def print_text(self, text: str) -> None:
        self.acts += 1
        self.machine.terminal.write(text)

    def say_on_row(self, row: int, text: str) -> None:
        """LINE: print on a row of the screen; a no-op if the row already shows the text."""
        self.acts += self.machine.terminal.write_on_row(row, text)

    def pairs(self, values: tuple[object, ...], repeat: bool) -> list[tuple[int, object]]:
        """Return each default axis with its value.

        With `repeat` the last value applies to all further axes.
        """
        axes = self.task.axes
        if repeat:
            values += values[-1:] * (len(axes) - len(values))
        if len(values) != len(axes):
            names = ", ".join(map(str, axes))
            raise Rejected(
                "values",
                f"AXES selects {len(axes)} axes ({names}), but {len(values)} values are given",
                "end the list with ; to give the last value to all further axes",
            )
        return list(zip(axes, values, strict=True))

    # --------------------------------------------------------------------------------------------- tasks

    def start_task(self, name: str, unit: FunctionSteps) -> None:
        """`Run`: start a task; no-op if it is running."""
        task = self.by_name.get(name)
        if task is not None and not task.done:
            return
        scheduler = self.machine.scheduler
        assert scheduler is not None
        self.acts += 1
        task = self.by_name[name] = MintTask(name, unit, self)
        scheduler.start(task)

    def end_task(self, name: str) -> None:
        task = self.by_name.get(name)
        if task is None or task.done:
            return
        self.acts += 1
        task.done = True
        scheduler = self.machine.scheduler
        if task is not self.task and scheduler is not None:
            scheduler.end(task)

    def end_program(self) -> None:
        """`End`: end the parent task, and with it the program."""
        scheduler = self.machine.scheduler
        if scheduler is not None:
            scheduler.parent.done = True

    def failed(self, trouble: BaseException, line: int) -> None:
        """Handle the failure of a guarded statement; the program goes on after it, one statement later."""
        self.acts += 1
        self.errors.failed(trouble, line)
        statements = self.statements
        if self.clock.now > statements.at(statements.count):
            statements.count = statements.start(self.clock.now)
        statements.count += 1.0
