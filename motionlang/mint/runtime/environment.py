"""What a running Mint program stands on: its tasks, its waits, and the objects that its text calls `kN`."""

from __future__ import annotations

from math import ceil, floor

from motionlang.controller.faults import Refusal
from motionlang.lang.attention import Attention
from motionlang.lang.nesting import MAX_DEPTH
from motionlang.lang.task import Wait
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
    Part = TypeVar("Part")

INFINITY = float("inf")
# Rounding of a time in seconds must not cost a millisecond.
_MILLISECOND = 1e-6


def _mint_ways(controller: Controller) -> None:
    """The settings of Mint's axes, and an axis with an error takes no motion."""
    from motionlang.controller.faults import ALL

    for axis in controller.axes:
        mint_settings(controller, axis)
        controller.lock(axis, ALL)


def mint_settings(controller: Controller, axis: int) -> None:
    """What an axis has otherwise than the controller's: a new speed acts at once on a move (FEEDRATEMODE 0)."""
    controller.configure(axis, "live_speed", True)


class Environment(Waits):
    """One program on one machine. `task` is the task that is running; each has its own TIME.

    `blocks` holds the tasks and event handlers by "task blink", "event timer"; `files` the places in the program of
    the lines of each piece of generated code.
    """

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.clock = machine.clock
        self._controller: Controller | None = None
        # What the operator will type at INPUT; None until the first one.
        self.answers: list[str] | None = None
        self.files: dict[str, Sequence[int]] = {}
        # The line of a place, where there is a text to look it up in.
        self.line_of: Callable[[int], int] | None = None
        self.blocks: dict[str, Make] = {}
        self.tasks: dict[str, MintTask] = {}
        # Priorities given to tasks, also to those that do not run yet.
        self.priorities: dict[str, int] = {}
        self.quanta: dict[str, int] = {}
        self.jogs: dict[int, float] = {}
        # User units after which POS begins again, of the axes that wrap.
        self.wraps: dict[int, float] = {}
        # What IDLE asks for beyond the end of the move, where a program asks for more.
        self.settled: Callable[[int], bool] | None = None
        # Told of the axis whenever something was put into its buffer, where a program chooses what starts moves.
        self.loaded: Callable[[int], None] | None = None
        self.task: MintTask
        # When its statements are, and what it notes of its readings.
        self.statements = machine.statements
        self.attention = Attention(machine.clock)
        self._waited = machine.log.waits.add
        self._ends = {}
        self._rests = None
        # The moment from which the parent task's TIME counts; event handlers belong to the parent.
        self.timer = [self.clock.now]
        # How often the program has done something; a loop that polls does nothing.
        self.acts = 0
        # How often a sub that may wait was called with part of an expression worked out.
        self.midways = 0
        # What the variables hold that functions of the program share.
        self.variables: Callable[[], list[object]] = list
        # How often a task has run after another one; which one ran last, and what the clock had counted by then.
        self.resumed = 0
        self.ran: MintTask | None = None
        self.fired = self.leaps = 0
        # What a WAIT waits for where it is more than time that passes.
        self.wait: Wait
        # What the machine file has settings be at power-up, where it speaks of any.
        self.power_up: PowerUp | None = None
        # The operation that the task which gives way has put off.
        self.put_off: PutOff | None = None
        self.operations = Operations(self)
        # What its functions count in, and what writes that.
        self.time_cells, self.set_time = self.operations.cells, self.operations.set_time
        self._parts: dict[type, object] = {Environment: self}
        self._events: Events | None = None
        self._errors: Errors | None = None
        self._random: Callable[[], float] | None = None

    @property
    def controller(self) -> Controller:
        """The controller; a program that never asks for it runs without one."""
        found = self._controller
        if found is None:
            found = self._controller = self.machine.controller
        return found

    def prepare(self) -> None:
        """Make the controller behave as Mint expects it to."""
        self.machine.at_power_up(_mint_ways)
        if self.machine.readings:
            from motionlang.mint.runtime.power_up import PowerUp

            self.power_up = PowerUp(self, self.machine.readings)
            for axis in self.controller.axes:
                self.power_up.set(axis)

    def part(self, kind: type[Part]) -> Part:
        """What a group of keywords works on, made of this environment at its first use."""
        found = self._parts.get(kind)
        if found is None:
            found = self._parts[kind] = kind(self)  # type: ignore[call-arg]
        return found  # type: ignore[return-value]

    @property
    def midway(self) -> None:
        """A sub that may wait is about to be called with part of the expression around it worked out."""
        self.midways += 1

    def state(self, alive: dict[int, object]) -> tuple[int, int, bytes]:
        """What tasks did to anything but variables, as counters, and what the variables hold that they share."""
        from motionlang.mint.runtime.task_state import of_values

        return self.acts, self.midways, of_values(self.variables(), alive)

    def parts(self) -> list[object]:
        """The parts that there are so far."""
        return list(self._parts.values())

    @property
    def events(self) -> Events:
        """Events and their handlers, from the first use on."""
        if self._events is None:
            from motionlang.mint.runtime.events import Events

            self._events = self.part(Events)
        return self._events

    @property
    def errors(self) -> Errors:
        """What has gone wrong so far, from the first use on."""
        if self._errors is None:
            from motionlang.mint.runtime.errors import Errors

            self._errors = self.part(Errors)
        return self._errors

    def make_operations(self, specs: Sequence[tuple[object, ...]]) -> tuple[object, ...]:
        """What each `kN` of the text stands for."""
        return tuple(self._operation(str(spec[0]), *spec[1:]) for spec in specs)

    def _operation(self, how: str, *details: object) -> object:
        if how == "loop":
            from motionlang.mint.runtime.loop_skipping import Site

            return Site(self, *details[:4])  # type: ignore[arg-type]
        if how == "env":
            return getattr(self, str(details[0]))
        if how == "wait":
            return self.rest_at(*details)  # type: ignore[arg-type]
        if how == "fn":
            from motionlang.mint.runtime import functions

            if details[0] == "shown" and self.machine.readings:
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
        operation = binding.bind(self, how, row)
        if how == "load":
            return self.operations.loading(operation, getattr(operation, "plain", None))
        if repeated:
            return self.operations.repeated(operation, binding.held(self, row))
        return operation if how == "read" else self.operations.timed(operation)

    def _on_axes(self, how: str, row: Keyword, axis: object, repeated: bool) -> object:
        """What a keyword does on an axis, or, where none is given, on each one that the program names as it runs."""
        from motionlang.mint.runtime import binding
        from motionlang.mint.runtime.binding import with_first

        if how == "load":
            load = binding.bind(self, how, row)
            return self.operations.loading(with_first(load, axis), getattr(load, "plain", None), axis)
        if isinstance(axis, tuple):
            do = with_first(binding.bind(self, how, row), axis)
            return (
                self.operations.repeated(do, with_first(binding.held(self, row), axis))
                if repeated
                else self.operations.timed(do)
            )
        if how == "read":
            bound: Callable[[int], Callable[..., object]] = binding.bind_to_axis(self, "read", row)
        elif repeated:
            write, held = binding.bind_to_axis(self, how, row), binding.held_by_axis(self, row)
            bound = lambda axis: self.operations.repeated(write(axis), held(axis))  # noqa: E731
        else:
            write = binding.bind_to_axis(self, how, row)
            bound = lambda axis: self.operations.timed(write(axis))  # noqa: E731
        return bound(axis) if isinstance(axis, int) else binding.Each(bound)

    # ---------------------------------------------------------------------------------------------- time

    def elapsed(self, base: float, level: float | None = None) -> int:
        """Whole milliseconds since a moment; `level` is what they are compared with, where that is known."""
        attention = self.attention
        if attention.notes is not None:
            if level is None:
                attention.note(attention.at_once)
            else:
                attention.note(self._counted, base, level)
        return int((self.clock.now - base) * 1000.0 + _MILLISECOND)

    def _counted(self, base: float, level: float) -> float:
        """When the milliseconds since a moment next pass `level`: they reach it, or are the first ones beyond it."""
        if level == INFINITY:
            return self.clock.now  # they are more than ever before
        if not level > -INFINITY:
            return INFINITY
        for milliseconds in (ceil(level), floor(level) + 1):
            moment = base + milliseconds / 1000.0
            if moment > self.clock.now:
                return moment
        return INFINITY

    def since(self, milliseconds: float) -> float:
        """The moment from which so many milliseconds have passed."""
        return self.clock.now - milliseconds / 1000.0

    def random(self) -> float:
        """The next number of `Rnd`."""
        if self._random is None:
            from motionlang.mint.runtime.functions import Random

            self._random = Random()
        self.acts += 1
        return self._random()

    def copy(self, record: list[object]) -> list[object]:
        """A copy of a value of a user type, with its arrays and its inner values."""
        return [self.copy(each) if each.__class__ is list else each for each in record]

    def place(self, axis: int, counts: float) -> float:
        """Where that is in user units, within the turn where the axis has one, as POS shows it."""
        place, wrap = self.controller.axes[axis].scale.position_to_user(counts), self.wraps.get(axis)
        return place % wrap if wrap else place

    def turn(self, axis: int) -> float:
        """Where the turn begins, in user units, in which a wrapped axis will be when its buffer is empty."""
        wrap = self.wraps.get(axis)
        if not wrap:
            return 0.0
        from motionlang.controller.moves.buffer import end

        a = self.controller.axes[axis]
        return a.scale.position_to_user(end(a)) // wrap * wrap

    def keep(self, name: str, place: list[object]) -> None:
        """`Dim nv`: the variable has what the run before left in it."""
        self.machine.kept.keep(name, place)

    def row(self, number: int) -> str:
        """What places the cursor at the begin of a row of the screen."""
        return f"\x1b[{max(number, 1)};1H"

    def looped(self, t: float, begun: Begun, at: int, called: tuple[int, ...] = ()) -> None:
        """A loop has ended at statement `t`, or a sub that was `called` at a place."""
        looped(self.machine.log, self.statements, self.task, t, begun, at, called)

    def thrown(self, t: float, jump: Exception) -> None:
        """A jump has left loops at statement `t`."""
        thrown(self.machine.log, self.statements, self.task, jump, t)

    # --------------------------------------------------------------------------------------------- waits

    def input(self, t: float) -> Wait:
        """`INPUT` waits for the operator's answer."""
        self.acts += 1
        from motionlang.mint.runtime.input_values import wait_for_answer

        return wait_for_answer(self, self.statements.leave(t))

    def typed(self, as_text: bool) -> object:
        """The operator's answer."""
        from motionlang.mint.runtime.input_values import take

        return take(self, as_text)

    # ----------------------------------------------------------------------------------------- semaphores

    def take(self, semaphore: list[MintTask | None], wanted: int) -> bool:
        """Take a semaphore, or give back what this task holds; false while another task holds it."""
        self.acts += 1
        return self.task.take(semaphore, wanted)

    def wait_for_semaphore(self, t: float, semaphore: list[MintTask | None]) -> Wait:
        """Wait until nobody holds a semaphore."""
        return until_free(self.statements.leave(t), semaphore)

    # ---------------------------------------------------------------------------------------------- axes

    def default_axes(self) -> tuple[int, ...]:
        """The axes that keywords without brackets mean; AXES sets them, each task has its own."""
        return self.task.axes

    def say(self, text: str) -> None:
        """Print."""
        self.acts += 1
        self.machine.terminal.write(text)

    def pairs(self, values: tuple[object, ...], repeat: bool) -> list[tuple[int, object]]:
        """Each default axis with its value; `repeat` gives the last value to all further axes."""
        axes = self.task.axes
        if repeat:
            values += values[-1:] * (len(axes) - len(values))
        if len(values) != len(axes):
            names = ", ".join(map(str, axes))
            raise Refusal(
                "values",
                f"AXES names {len(axes)} axes ({names}), and {len(values)} values are given",
                "end the list with ; to give the last value to all further axes",
            )
        return list(zip(axes, values, strict=True))

    # --------------------------------------------------------------------------------------------- tasks

    def start_task(self, name: str, make: Make) -> None:
        """`Run`: a task that is running goes on as it is."""
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
        """`End name`."""
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
        """The task that is running ends."""
        raise TaskEnd(self.statements.leave(t))

    def end_main(self, t: float) -> None:
        """`End`: the parent task ends, and with it everything."""
        scheduler = self.machine.scheduler
        if scheduler is not None:
            scheduler.parent.done = True
        raise TaskEnd(self.statements.leave(t))

    # -------------------------------------------------------------------------------------------- events

    def listen(self) -> None:
        """Enter the handlers of the program."""
        from motionlang.mint.runtime.events import listen

        listen(self)

    @property
    def Jump(self) -> type[Exception]:  # noqa: N802 - a name of generated code
        """How a Goto leaves loops."""
        return Jump

    @property
    def TROUBLE(self) -> tuple[type[Exception], ...]:  # noqa: N802 - a name of generated code
        """What a guarded statement may fail with."""
        from motionlang.mint.runtime.errors import TROUBLE

        return TROUBLE

    @property
    def stack(self) -> tuple[object, ...]:
        """The room of a task: tuples within one another, one for itself and one for each call that may nest in it.

        What a call hands on is the tuple within its own, which costs less than a number that is counted down.
        """
        room: tuple[object, ...] = ()
        for _ in range(MAX_DEPTH + 1):
            room = (room,)
        return room

    def too_deep(self) -> tuple[object, ...]:
        """A call finds no room on the stack."""
        words = f"calls are nested more than {MAX_DEPTH} deep"
        raise Refusal("recursion", words, "a sub or a Gosub calls itself without an end")

    def failed(self, trouble: Exception, t: float, line: int) -> float:
        """A guarded statement has failed; answers with the statement at which the program goes on."""
        self.acts += 1
        self.errors.failed(trouble, line)
        if self.clock.now > self.statements.at(t):
            t = self.statements.start(self.clock.now)
        return t + 1.0


class Jump(Exception):
    """A Goto out of loops."""
