"""A task of the controller's interpreter.

It has a line of commands, a program counter, and the duration of a command. Time is `base + count *
cost`, so that it is the same number whether commands are run one by one or skipped together.
"""

from __future__ import annotations

from motionlang.controller.clock import INFINITY
from motionlang.controller.faults import Rejected
from motionlang.lang.task import Task
from motionlang.lang.waits import until_idle
from motionlang.mccl import codes
from motionlang.mccl.codes import Fault
from motionlang.mccl.keywords import of_families
from motionlang.mccl.models import missing
from motionlang.mccl.motion.path import DESCRIBES
from motionlang.mccl.resolve.command import NONE, REGISTER, TEXT
from motionlang.mccl.resolve.decode import checked
from motionlang.mccl.runtime.loop_log import LoopLog
from motionlang.mccl.runtime.poll import Poll

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import TypeAlias

    from motionlang.lang.scheduler import Scheduler
    from motionlang.lang.waits import Wait
    from motionlang.mccl.axis.axis import AxisState
    from motionlang.mccl.motion.edge_search import Seek
    from motionlang.mccl.motion.path import Path
    from motionlang.mccl.resolve.command import Command
    from motionlang.mccl.resolve.line import Line
    from motionlang.mccl.runtime.board import Board

    Action: TypeAlias = Callable[["CommandTask", Command], Wait | None]
    Then: TypeAlias = Callable[[float], Wait | None]

PRIVATE = 10
# Formats of a report of an axis, by the machine file's assumption `mccl.reply-form`.
FORMS: dict[object, str] = {
    "01 1234": "{:02d} {}\n",
    "1 1234": "{} {}\n",
    "01=1234": "{:02d}={}\n",
    "1234": "{1}\n",
}
# The largest depth of macro calls.
MAX_DEPTH = 100
# Commands between two returns to the scheduler, so that a busy program can be paced and interrupted.
SLICE = 20_000


class CommandTask(Task):
    """Executes lines one after another; `next_line` supplies them.

    `line` is the current line or macro, `pc` the index of its next command, `calls` the lines to return to.
    `registers` 0 to 9 are the task's own. `then` is called after the wait that the task is in.
    """

    __slots__ = (
        "base",
        "board",
        "calls",
        "cost",
        "count",
        "here",
        "horizon",
        "lacks",
        "line",
        "loop_log",
        "paid",
        "path_open",
        "pc",
        "poll",
        "registers",
        "repeats",
        "search",
        "then",
        "write",
    )

    def __init__(self, name: str, board: Board) -> None:
        super().__init__(name)
        self.board = board
        self.cost = board.cost
        self.lacks = of_families(board.model.lacks)
        self.write = board.write
        self.registers: list[float | int] = [0] * PRIVATE
        self.line: Line | None = None
        self.pc = 0
        self.repeats: dict[int, int] = {}
        self.calls: list[tuple[Line, int, dict[int, int]]] = []
        self.then: Then | None = None
        # The search that the current command has begun and waits for.
        self.search: Seek | None = None
        # The contour path that the commands of the line are describing.
        self.path_open: Path | None = None
        self.here = 0
        # The end of the time slice; the machine time of the first command, and the number of commands since.
        self.horizon = INFINITY
        self.base = 0.0
        self.count = 0
        self.paid = False
        self.poll = Poll(self)
        self.loop_log = LoopLog(self)

    # ------------------------------------------------------------------------------------- for the scheduler

    @property
    def at(self) -> int:
        return self.offset

    @property
    def offset(self) -> int:
        """The offset of the current command in the text that contained its line."""
        line = self.line
        return line.offsets[self.here] if line is not None and self.here < len(line.offsets) else 0

    @property
    def stack(self) -> tuple[int, ...]:
        called = (line.offsets[pc - 1] for line, pc, _ in self.calls if 0 < pc <= len(line.offsets))
        return (*called, self.offset)

    @property
    def stack_offsets(self) -> tuple[int, tuple[int, ...]]:
        if self.calls:
            return super().stack_offsets
        return self.offset, ()

    @property
    def loops(self) -> list[tuple[int, float, tuple[int, ...]]]:
        return self.loop_log.open()

    @property
    def source_line(self) -> int:
        """The number of the source line of the current command."""
        return self.line.number if self.line is not None else 0

    @property
    def word(self) -> str:
        """The mnemonic of the current command."""
        line = self.line
        return line.commands[self.here].name if line is not None and self.here < len(line.commands) else ""

    def resume(self, now: float, horizon: float) -> tuple[float, Wait | None]:
        """Run commands until the horizon, a wait or another task's time slice.

        Returns the time, s, and the wait, if any.
        """
        if now != self.base + self.count * self.cost:
            self.base, self.count = now, 0
        self.horizon = horizon
        board, cost, lacks, gated = self.board, self.cost, self.lacks, self.gated
        clock, left = board.controller.clock, SLICE
        wait = self._go_on(now)
        if wait is not None:
            if (wait := self._pass(wait)) is not None:
                return now, wait
            now = clock.now
        if (hook := board.hook) is not None:
            tally = hook.tally
        loop_log = self.loop_log
        if shared := len(board.tasks) > 1:
            board.count_time_slice(self)
            shared = board.is_shared(self)
        while left:
            line, pc = self.line, self.pc
            if line is None or pc >= len(line.commands):
                if loop_log.running:
                    loop_log.left()
                if self._step_out():
                    continue
                return now, self._rest(now)
            if self.paid:
                self.paid = False
            else:
                self.count += 1
                now = self.base + self.count * cost
                if now >= self.horizon or now >= clock.horizon:
                    self.paid = True
                    return now, None
                clock.now = now
            if gated and (wait := self._gate(line)) is not None:
                return now, wait
            if hook is not None:
                tally[0] = begun = tally[0] + 1
                if begun >= tally[1]:
                    hook.consider(self, now, line.offsets[pc])
            if pc > loop_log.end:
                loop_log.passed()
            # One command. It is inlined, because a call would be a tenth of its cost.
            command = line.commands[pc]
            self.here, self.pc = pc, pc + 1
            if not command.pure:
                board.effects += 1
            try:
                if self.path_open is not None and command.verb not in DESCRIBES:
                    self.close_path()
                if command.name in lacks and command.row is not None:
                    raise missing(board.model, command.row)
                wait = command.action(self, command)
            except (Fault, Rejected) as trouble:
                self._refused(trouble)
            else:
                if wait is not None:
                    if (wait := self._pass(wait)) is not None:
                        return now, wait
                    now = clock.now
            if not command.pure:  # it may have started or ended a task
                shared = board.is_shared(self)
            if shared:
                return self.base + self.count * cost, None
            left -= 1
        return now, None

    # ----------------------------------------------------------------------------------------- for the actions

    def reply(self, text: str) -> None:
        """Write one line of a reply."""
        self.write(text + "\n")

    def tell(self, axis: int, text: str) -> None:
        """Report a value of an axis or a channel.

        The default form is the number in two digits, a blank and the value.
        """
        self.write(FORMS[self.board.assumptions.get("mccl.reply-form", "01 1234")].format(axis, text))

    def whole_text(self, value: int) -> str:
        """Format an integer of a reply in the base set by DM or HM."""
        return self.board.whole(value)

    def quantity(self, axis: AxisState, counts: float, unit: str = "position") -> str:
        """Format a quantity of an axis: integer counts, or user units with 6 decimals."""
        return axis.say(counts, unit, self.whole_text)

    def value(self, command: Command) -> float | int:
        """Return the parameter as a number, or the register's value after `@`; 0 if none."""
        if command.kind == REGISTER:
            assert command.row is not None
            return checked(self.register(int(command.value)), command.row)
        return command.value if command.kind != TEXT else 0  # type: ignore[return-value]

    def given(self, command: Command) -> bool:
        """True if the command has a parameter."""
        return command.kind != NONE

    def whole(self, command: Command) -> int:
        """Return the parameter as an integer; a fraction is a parameter error (Fault)."""
        value = self.value(command)
        if value != int(value):
            raise Fault(
                codes.PARAMETER, f"{command.name} needs a whole number, not {value:.10g}", kind="range"
            )
        return int(value)

    def axes(self, command: Command) -> tuple[AxisState, ...]:
        """Return the axes that the command addresses: the one it names, or all."""
        if command.axis == 0:
            return self.board.all_axes
        return (self.board.axis(command.axis),)

    def axis(self, command: Command) -> AxisState:
        """Return the axis that the command has to name."""
        if command.axis == 0:
            raise codes.needs_axis(command.name, command.text)
        return self.board.axis(command.axis)

    def register(self, number: int) -> float | int:
        """Return the content of a register; the first ten are the task's own."""
        if number < PRIVATE:
            return self.registers[number]
        if number >= len(self.board.registers):
            raise self._no_register(number)
        return self.board.registers[number]

    def set_register(self, number: int, value: float | int) -> None:
        """Set a register."""
        if number < PRIVATE:
            if number and self.registers[number] != value:
                self.board.effects += 1
            self.registers[number] = value
            return
        if number >= len(self.board.registers):
            raise self._no_register(number)
        if self.board.registers[number] != value:
            self.board.effects += 1
        self.board.registers[number] = value

    def call(self, line: Line) -> None:
        """Execute a macro, then return."""
        if len(self.calls) >= MAX_DEPTH:
            raise Fault(
                codes.PARAMETER,
                f"macros are nested deeper than {MAX_DEPTH}",
                "a macro that calls itself never returns; MJ jumps without returning",
                "recursion",
            )
        if self.line is not None:
            self.calls.append((self.line, self.pc, self.repeats))
        self.enter(line)

    def enter(self, line: Line) -> None:
        """Execute a line from its first command."""
        self.line, self.pc, self.repeats = line, 0, {}
        self.loop_log.entered = self.base + self.count * self.cost
        if self.loop_log.running:
            self.loop_log.find_end()

    def jump(self, target: int) -> Wait | None:
        """Continue with command `target` of the line."""
        assert self.line is not None
        if not 0 <= target <= len(self.line.commands):
            first: int = self.board.assumptions.get("mccl.jump-base", 0)  # type: ignore[assignment]
            last = first + len(self.line.commands) - 1
            raise Fault(
                codes.PARAMETER,
                f"there is no command {first + target} here",
                f"they are numbered {first} to {last}",
                "range",
            )
        here, log = self.here, self.loop_log
        self.pc = target
        if target > here:
            return None
        if here != log.end or target != log.target:
            log.back(self.line, target, here)
        return self.poll.again()

    def abandon(self) -> None:
        """Leave the current line and all macros around it."""
        self.calls.clear()
        self.loop_log.left()
        self.line, self.repeats, self.then, self.paid = None, {}, None, False
        self.path_open = None
        if self.search is not None:
            self.search.withdraw()
            self.search = None

    def comes_to_rest(self, axes: tuple[int, ...]) -> bool:
        """Let time pass within the slice until axes are at rest; False to yield."""
        scheduler = self.board.machine.scheduler
        if scheduler is None:
            return False
        since = scheduler.clock.now
        if not scheduler.comes_to_rest(since, self.board.controller.end_of_moves(axes)):
            return False
        at, callers = self.stack_offsets
        now = self._continue(scheduler)
        scheduler.waited((self.name, at, since, now, "axis", axes, until_idle(axes), callers))
        return True

    # ----------------------------------------------------------------------------------------- for subclasses

    def next_line(self) -> Line | None:
        """Return the next line to execute, or None at the end."""
        return None

    # True if `_gate` is called before each command.
    gated = False

    def _gate(self, line: Line) -> Wait | None:
        """Return the wait before the next command of a line, if any."""
        return None

    def _rest(self, now: float) -> Wait | None:
        """Return the wait after the last line; None ends the task."""
        self.done = True
        return None

    # ------------------------------------------------------------------------------------------------ private

    def _go_on(self, now: float) -> Wait | None:
        while self.then is not None:
            then, self.then = self.then, None
            try:
                wait = then(now)
            except (Fault, Rejected) as trouble:
                self._refused(trouble)
                return None
            if wait is not None:
                return wait
        return None

    def _pass(self, wait: Wait) -> Wait | None:
        """Let waits pass within the time slice if nothing else can happen meanwhile.

        Returns the wait for which the task must yield, if any.
        """
        scheduler = self.board.machine.scheduler
        if scheduler is None:
            return wait
        left: Wait | None = wait
        while left is not None and scheduler.passes(left):
            now = self._continue(scheduler)
            scheduler.waited(self.waited(left, now))
            left = self._go_on(now)
        return left

    def _continue(self, scheduler: Scheduler) -> float:
        """Continue at the present machine time and return that time."""
        clock = scheduler.clock
        now, horizon, until = clock.now, clock.horizon, scheduler.until
        if now != self.base + self.count * self.cost:
            self.base, self.count = now, 0
        self.horizon = horizon if horizon < until else until
        return now

    def _refused(self, trouble: Fault | Rejected) -> None:
        if self.board.refused(self, trouble):
            self.abandon()

    def close_path(self) -> None:
        """Complete the contour path that the line describes."""
        path, self.path_open = self.path_open, None
        if path is not None:
            path.close(self)

    def _step_out(self) -> bool:
        """Return from a macro, or begin the next line; return False if there is none."""
        if self.path_open is not None:
            try:
                self.close_path()
            except (Fault, Rejected) as trouble:
                self._refused(trouble)
        if self.calls:
            self.line, self.pc, self.repeats = self.calls.pop()
            self.loop_log.find_end()
            return True
        line = self.next_line()
        self.line = line
        if line is None:
            return False
        if self.board.machine.world is not None:
            self.board.machine.world.reach(line.number)
        # A macro that the line calls is not at the position of its last call.
        self.board.effects += 1
        self.enter(line)
        return True

    def _no_register(self, number: int) -> Fault:
        last = len(self.board.registers) - 1
        return Fault(codes.PARAMETER, f"there is no register {number}", f"registers are 0 to {last}", "range")


class BackgroundTask(CommandTask):
    """A macro in the background; the task ends with the macro."""

    __slots__ = ("_number",)

    def __init__(self, number: int, board: Board, macro: Line) -> None:
        super().__init__(f"task {number}", board)
        self._number = number
        self.base = board.controller.clock.now
        self.enter(macro)

    def end(self) -> None:
        """End the task from outside; the scheduler drops it at its next time slice."""
        self.board.ended(self)
        self.done = True
        self.wait = None

    def _rest(self, now: float) -> Wait | None:
        self.board.ended(self)
        self.done = True
        return None
