"""The environment of a running Mint program: tasks, waits, and the objects `kN`."""

from __future__ import annotations

from math import ceil, floor

from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Rejected
from motionlang.lang.dependencies import Dependencies
from motionlang.lang.nesting import MAX_DEPTH
from motionlang.lang.waits import Wait
from motionlang.mint.runtime.loop_log import looped, thrown
from motionlang.mint.runtime.operations import Operations
from motionlang.mint.runtime.task import MintTask, TaskEnd, until_free
from motionlang.mint.runtime.waits import Waits

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import TypeVar

    from motionlang.controller.controller import Controller
    from motionlang.lang.keyword import Keyword
    from motionlang.lang.machine.machine import Machine
    from motionlang.lang.task import Steps
    from motionlang.mint.runtime.errors import Errors
    from motionlang.mint.runtime.events import Events
    from motionlang.mint.runtime.loop_log import Begun
    from motionlang.mint.runtime.operations import PutOff
    from motionlang.mint.runtime.power_up import PowerUp

    Make = Callable[[], Steps]
    Component = TypeVar("Component")

# Rounding of a time in seconds must not cost a millisecond.
MILLISECOND = 1e-6
# A count of milliseconds is an Integer of 32 bits: -2147483648 follows 2147483647.
ROLLOVER = 1 << 31
# A wait that only a rollover could end, more than a day ahead, is reported as one that never ends.
DAY = 86400.0


def _apply_mint_settings(controller: Controller) -> None:
    """Apply Mint's settings to the axes; an axis with an error accepts no motion."""
    from motionlang.controller.faults import ALL

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
    "task blink" and "event timer". `files` holds the source offsets of the lines, for each unit of generated code.
    """

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.clock = machine.clock
        self._controller: Controller | None = None
        # The operator's future answers to INPUT; None until the first one.
        self.answers: list[str] | None = None
        self.files: dict[str, Sequence[int]] = {}
        # Returns the line of a source offset, if the text is available.
        self.line_of: Callable[[int], int] | None = None
        self.blocks: dict[str, Make] = {}
        self.tasks: dict[str, MintTask] = {}
        # Priorities set for tasks, including tasks that do not run yet.
        self.priorities: dict[str, int] = {}
        self.quanta: dict[str, int] = {}
        self.jogs: dict[int, float] = {}
        # The wrap of POS in user units, for the axes that wrap.
        self.wraps: dict[int, float] = {}
        # The condition of IDLE beyond the end of the move, if the program sets one.
        self.settled: Callable[[int], bool] | None = None
        # Called with the axis after each load into its buffer, if a program chooses what starts moves.
        self.loaded: Callable[[int], None] | None = None
        self.task: MintTask
        # The times of its statements, and the dependencies that its readings record.
        self.statements = machine.statements
        self.dependencies = Dependencies(machine.clock)
        self._waited = machine.log.waits.add
        self._ends = {}
        self._rests = None
        # The start of the parent task's TIME, which event handlers share.
        self.timer = [self.clock.now]
        # Counts the actions of the program. A polling loop performs none.
        self.acts = 0
        # Counts the actions among them that did no more than write outputs.
        self.switches = 0
        # The number of other actions as the running task was resumed.
        self.acts_before = 0
        # The counters of handlers by their events: variables that decide nothing except by comparison with the
        # constants given. The first flag is true if a loop that may poll uses the variable, too, the second one
        # if the handler also sets it.
        self.handler_counters: dict[str, dict[str, tuple[tuple[float, ...], tuple[bool, bool]]]] = {}
        # The readings that alone decide its course, with their indices and the constants that they are compared with;
        # None if there may be others.
        self.outcomes: tuple[tuple[str, int, float | None], ...] | None = None
        # Counts writes to host memory that are no actions, and writes that changed nothing.
        self.copies = self.repeats = 0
        # Counts calls of subs that may wait, made with part of an expression evaluated.
        self.midways = 0
        # The values of the variables that functions of the program share.
        self.variables: Callable[[], list[object]] = list
        # The number of times that a task has run after another one, the one that ran last, and the clock's
        # counts then.
        self.resumed = 0
        self.ran: MintTask | None = None
        self.fired = self.leaps = 0
        # The wait of a WAIT or PAUSE that is more than time that passes.
        self.wait: Wait
        # The machine file's power-up values of settings, if it has any.
        self.power_up: PowerUp | None = None
        # The operation that was put off by the task giving way.
        self.put_off: PutOff | None = None
        self.operations = Operations(self)
        # The cells in which its functions count time, and the function that sets them.
        self.time_cells, self.set_time = self.operations.cells, self.operations.set_time
        self._components: dict[type, object] = {Environment: self}
        self._events: Events | None = None
        self._errors: Errors | None = None
        self._random: Callable[[], float] | None = None

    @property
    def controller(self) -> Controller:
        """The controller, created when the program first uses it."""
        found = self._controller
        if found is None:
            found = self._controller = self.machine.controller
        return found

    def prepare(self) -> None:
        """Give the controller Mint's settings and the machine file's power-up values."""
        self.machine.at_power_up(_apply_mint_settings)
        if self.machine.assumptions:
            from motionlang.mint.runtime.power_up import PowerUp

            self.power_up = PowerUp(self, self.machine.assumptions)
            for axis in self.controller.axes:
                self.power_up.set(axis)

    def component(self, kind: type[Component]) -> Component:
        """Return the component for a group of keywords, created on first use."""
        found = self._components.get(kind)
        if found is None:
            found = self._components[kind] = kind(self)  # type: ignore[call-arg]
        return found  # type: ignore[return-value]

    @property
    def midway(self) -> None:
        """Count a call within a partly evaluated expression, of a sub that may wait."""
        self.midways += 1

    def acted(self) -> tuple[int, int]:
        """Return the counters of what all tasks have done."""
        return self.acts + self.copies, self.midways

    def state(self, alive: dict[int, object]) -> bytes:
        """Return the variables that tasks share, as comparable bytes."""
        from motionlang.mint.runtime.task_state import of_values

        return of_values(self.variables(), alive)

    def forget_program(self) -> None:
        """Discard the tasks and handlers of a program that has ended; keep its settings."""
        for task in self.tasks.values():
            task.done = True
        self.tasks.clear()
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
            from motionlang.mint.runtime.events import Events

            self._events = self.component(Events)
        return self._events

    @property
    def errors(self) -> Errors:
        """The errors so far, created on first use."""
        if self._errors is None:
            from motionlang.mint.runtime.errors import Errors

            self._errors = self.component(Errors)
        return self._errors

    def make_operations(self, specs: Sequence[tuple[object, ...]]) -> tuple[object, ...]:
        """Return the object for each `kN` of the generated code."""
        self.outcomes = None  # a line typed at a prompt may read anything
        return tuple(self._operation(str(spec[0]), *spec[1:]) for spec in specs)

    def _operation(self, how: str, *details: object) -> object:
        if how == "loop":
            from motionlang.mint.runtime.loop_skipping import Site

            return Site(self, *details[:5])  # type: ignore[arg-type]
        if how == "counters":
            handler, names, levels, facts = details
            counters = zip(names, zip(levels, facts, strict=True), strict=True)  # type: ignore[call-overload]
            return self.handler_counters.setdefault(str(handler), dict(counters))
        if how == "outcomes":
            (self.outcomes,) = details  # type: ignore[assignment]
            return None
        if how == "env":
            return getattr(self, str(details[0]))
        if how == "wait":
            return self.rest_at(*details)  # type: ignore[arg-type]
        if how == "fn":
            from motionlang.mint.runtime import functions

            if details[0] == "shown" and self.machine.assumptions:
                return functions.shown_by(self.machine)
            return getattr(functions, str(details[0]))
        if how == "show":
            from motionlang.mint.runtime import printing

            return printing.show_integer if details[0] != "float" else printing.shows_float(self.machine)
        if how == "using":
            from motionlang.mint.runtime import formats

            return formats.USING[str(details[0])]
        from motionlang.mint.runtime import binding

        row = binding.row_of(str(details[0]))
        repeated = how in ("rewrite", "redo")
        how = how.removeprefix("re") if repeated else how
        repeated = repeated and binding.is_repeatable(how, row)
        if len(details) > 1:
            return self._on_axes(how, row, details[1], repeated)
        if how == "copy":
            return self.operations.copied(binding.bind(self, "write", row))
        operation = binding.bind(self, how, row)
        if how == "load":
            return self.operations.loading(operation, getattr(operation, "plain", None))
        if repeated and binding.is_reported(how, row):
            return self.operations.reported(operation)
        if repeated:
            return self.operations.repeated(operation, binding.replaced(self, row))
        return operation if how == "read" else self.operations.timed(operation)

    def _on_axes(self, how: str, row: Keyword, axis: object, repeated: bool) -> object:
        """Return the operation of a keyword on an axis.

        If `axis` is `EACH`, return all operations by axis; each is bound when the program first names its axis.
        """
        from motionlang.mint.runtime import binding
        from motionlang.mint.runtime.binding import with_first

        if how == "load":
            load = binding.bind(self, how, row)
            return self.operations.loading(with_first(load, axis), getattr(load, "plain", None), axis)
        if isinstance(axis, tuple):
            do = with_first(binding.bind(self, how, row), axis)
            return (
                self.operations.repeated(do, with_first(binding.replaced(self, row), axis))
                if repeated
                else self.operations.timed(do)
            )
        if how == "read":
            bound: Callable[[int], Callable[..., object]] = binding.bind_to_axis(self, "read", row)
        elif repeated:
            write, replaced = binding.bind_to_axis(self, how, row), binding.replaced_by_axis(self, row)
            bound = lambda axis: self.operations.repeated(write(axis), replaced(axis))  # noqa: E731
        else:
            write = binding.bind_to_axis(self, how, row)
            bound = lambda axis: self.operations.timed(write(axis))  # noqa: E731
        return bound(axis) if isinstance(axis, int) else binding.ByNumber(bound)

    # ---------------------------------------------------------------------------------------------- time

    def elapsed(self, base: float, level: float | None = None) -> int:
        """Return the milliseconds since a time, rolled over to the range of an Integer.

        `level` is the value that they are compared with, if it is known.
        """
        count = floor((self.clock.now - base) * 1000.0 + MILLISECOND)
        if count >= ROLLOVER:
            rolled = (count + ROLLOVER) // (2 * ROLLOVER) * 2 * ROLLOVER
            count, base = count - rolled, base + rolled / 1000.0
        dependencies = self.dependencies
        if dependencies.notes is not None:
            if level is None:
                dependencies.note(dependencies.at_once)
            else:
                dependencies.note(self._counted, base, level)
        return count

    def _counted(self, base: float, level: float) -> float:
        """Return the time at which the milliseconds since `base` next cross `level`.

        They cross it when they reach it, when they first exceed it, and when they roll over.
        """
        if level == INFINITY:
            return self.clock.now  # they are more than ever before
        if not level > -INFINITY:
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
            from motionlang.mint.runtime.functions import Random

            self._random = Random()
        self.acts += 1
        return self._random()

    def copy(self, record: list[object]) -> list[object]:
        """Return a copy of a value of a user type, including its arrays and nested values."""
        return [self.copy(each) if each.__class__ is list else each for each in record]

    def wrapped_position(self, axis: int, counts: float) -> float:
        """Return a position in user units, within its wrap, as POS shows it."""
        position, wrap = self.controller.axes[axis].scale.position_to_user(counts), self.wraps.get(axis)
        return position % wrap if wrap else position

    def absolute_counts(self, axis: int, value: float) -> float:
        """Return an absolute position of a move in counts; `value` is in user units.

        On an axis that wraps it is a position in the wrap in which the axis will be when its buffer is empty.
        """
        a, wrap = self.controller.axes[axis], self.wraps.get(axis)
        if wrap:
            from motionlang.controller.moves.buffer import end

            value += a.scale.position_to_user(end(a)) // wrap * wrap
        return a.scale.position_to_counts(value)

    def restore_variable(self, name: str, variable: list[object]) -> None:
        """`Dim nv`: set a variable to the value it had in the previous run."""
        self.machine.nonvolatile.restore(name, variable)

    def looped(self, t: float, begun: Begun, at: int, called: tuple[int, ...] = ()) -> None:
        """Log a loop that has ended at statement `t`, or a sub that was `called`."""
        looped(self.machine.log, self.statements, self.task, t, begun, at, called)

    def thrown(self, t: float, jump: Exception) -> None:
        """Log the loops that a jump has left at statement `t`."""
        thrown(self.machine.log, self.statements, self.task, jump, t)

    # --------------------------------------------------------------------------------------------- waits

    def input(self, t: float) -> Wait:
        """INPUT: return the wait for the operator's answer."""
        self.acts += 1
        from motionlang.mint.runtime.input_values import wait_for_answer

        return wait_for_answer(self, self.statements.leave(t))

    def typed(self, as_text: bool) -> object:
        """Return the operator's answer."""
        from motionlang.mint.runtime.input_values import take

        return take(self, as_text)

    # ----------------------------------------------------------------------------------------- semaphores

    def take(self, semaphore: list[MintTask | None], wanted: int) -> bool:
        """Take or release a semaphore; return False while another task holds it."""
        self.acts += 1
        return self.task.take(semaphore, wanted)

    def wait_for_semaphore(self, t: float, semaphore: list[MintTask | None]) -> Wait:
        """Return the wait until no task holds a semaphore."""
        return until_free(self.statements.leave(t), semaphore)

    # ---------------------------------------------------------------------------------------------- axes

    def default_axes(self) -> tuple[int, ...]:
        """Return the axes of keywords without brackets, which AXES sets for each task."""
        return self.task.axes

    def in_whole_counts(self, distance_uu: float, axis: int) -> float:
        """Return a distance of an axis in user units, rounded to whole counts."""
        scale = self.controller.axes[axis].scale
        return scale.to_user(float(round(scale.to_counts(distance_uu))))

    def print_text(self, text: str) -> None:
        """Print a text."""
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

    def start_task(self, name: str, make: Make) -> None:
        """`Run`: start a task; no-op if it is running."""
        task = self.tasks.get(name)
        if task is not None and not task.done:
            return
        scheduler = self.machine.scheduler
        assert scheduler is not None
        self.acts += 1
        task = self.tasks[name] = MintTask(name, make, self)
        task.priority = self.priorities.get(name, 0)
        scheduler.start(task)

    def end_task(self, name: str) -> None:
        """`End name`: end a task."""
        task = self.tasks.get(name)
        if task is None or task.done:
            return
        if task is self.task:
            raise TaskEnd(self.clock.now)
        self.acts += 1
        task.done = True
        scheduler = self.machine.scheduler
        if scheduler is not None:
            scheduler.end(task)

    def end_this(self, t: float) -> None:
        """End the running task."""
        raise TaskEnd(self.statements.leave(t))

    def end_main(self, t: float) -> None:
        """`End`: end the parent task, and with it the program."""
        scheduler = self.machine.scheduler
        if scheduler is not None:
            scheduler.parent.done = True
        raise TaskEnd(self.statements.leave(t))

    # -------------------------------------------------------------------------------------------- events

    def listen(self) -> None:
        """Register the handlers of the program."""
        from motionlang.mint.runtime.events import listen

        listen(self)

    @property
    def Jump(self) -> type[Exception]:  # noqa: N802 - a name of generated code
        """The exception with which a Goto leaves loops."""
        return Jump

    @property
    def TROUBLE(self) -> tuple[type[Exception], ...]:  # noqa: N802 - a name of generated code
        """The exceptions that a guarded statement may raise."""
        from motionlang.mint.runtime.errors import TROUBLE

        return TROUBLE

    @property
    def stack(self) -> tuple[object, ...]:
        """The stack depth of a task as nested tuples, one for each call that it allows.

        A call passes on the inner tuple, which is faster than counting down a number.
        """
        depth: tuple[object, ...] = ()
        for _ in range(MAX_DEPTH + 1):
            depth = (depth,)
        return depth

    def too_deep(self) -> tuple[object, ...]:
        """Raise Rejected for a call that exceeds the stack depth."""
        words = f"calls are nested more than {MAX_DEPTH} deep"
        raise Rejected("recursion", words, "a sub, a function or a Gosub calls itself endlessly")

    def failed(self, trouble: Exception, t: float, line: int) -> float:
        """Handle the failure of a guarded statement.

        Returns the statement at which the program continues.
        """
        self.acts += 1
        self.errors.failed(trouble, line)
        if self.clock.now > self.statements.at(t):
            t = self.statements.start(self.clock.now)
        return t + 1.0


class Jump(Exception):
    """A Goto out of loops."""
