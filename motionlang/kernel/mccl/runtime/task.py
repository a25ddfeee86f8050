"""A task of the controller's interpreter: it carries out lines of commands."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, TypeAlias

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.step_task import StepTask
from motionlang.kernel.lang.steps import CALL, END, JUMP, TRY, WAIT, Steps, Values
from motionlang.kernel.lang.variable_uses import Copy
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.axis.axis import AxisState
from motionlang.kernel.mccl.axis.variables import changes_by_event, crossing_time, levels
from motionlang.kernel.mccl.codes import Fault, LineAbandoned
from motionlang.kernel.mccl.motion.path import Path
from motionlang.kernel.mccl.resolve.command import NONE, REGISTER, TEXT, Command
from motionlang.kernel.mccl.resolve.decode import checked
from motionlang.kernel.mccl.runtime.register_uses import ACCUMULATOR, PRIVATE
from motionlang.kernel.mccl.runtime.writer import LineSteps

if TYPE_CHECKING:
    from motionlang.kernel.mccl.motion.edge_search import Seek
    from motionlang.kernel.mccl.resolve.line import Line
    from motionlang.kernel.mccl.runtime.board import Board

# The function of a command, which returns what to wait for.
Action: TypeAlias = Callable[[Any, Command], Wait | None]

# Formats of a report of an axis, by the machine file's assumption `mccl.reply-form`.
FORMS: dict[object, str] = {
    "01 1234": "{:02d} {}\n",
    "1 1234": "{} {}\n",
    "01=1234": "{:02d}={}\n",
    "1234": "{1}\n",
}
# The largest depth of macro calls.
MAX_DEPTH = 100
# The values of a call: the task's registers 0 to 9, the same in all its calls, and how often each RP still repeats.
REGISTERS, REPEATS = 0, 1


class CommandTask(StepTask):
    """Carries out lines; the outermost of its calls is that of the line.

    `registers` 0 to 9 are the task's own.
    """

    recovers = (Fault, Rejected, LineAbandoned)
    max_depth = MAX_DEPTH

    def __init__(self, name: str, board: Board, registers: list[float | int] | None = None) -> None:
        self.registers: list[float | int] = [0] * PRIVATE if registers is None else registers
        super().__init__(name, Steps(), [self.registers, {}], board.loops)
        self.board = board
        self.hook = board.hook
        self.lacks = board.lacks
        self.write = board.write
        # Moves that the current command starts when their axes have come to rest: axes and targets, counts.
        self.later: list[tuple[int, float]] = []
        # The search that the current command has begun and waits for.
        self.search: Seek | None = None
        # The contour path that the commands of the line are describing.
        self.path_open: Path | None = None
        # The reading in the accumulator: until when it is valid, its axis and address, and what it has of it.
        self.reading: tuple[float, AxisState | None, int, str] | None = None
        # The offset of the last line that was no line.
        self.stray = 0
        # The line that a host has sent.
        self._entered: Line | None = None

    # ---------------------------------------------------------------------------------------- as a task of steps

    @property
    def at(self) -> int:
        return max(self.at_statement, 0) if self.calls else self.stray

    @property
    def repeats(self) -> dict[int, int]:
        """How often each RP of the present line or macro still repeats, by the index of its command."""
        return self.values[REPEATS]  # type: ignore[no-any-return]

    @property
    def own(self) -> Values:
        return self.registers

    def context(self) -> object:
        return (
            tuple(self.repeats.items()),
            *[(id(call.steps), call.pc, *call.values[REPEATS].items()) for call in self.calls],
        )

    def others_ready(self) -> bool:
        return len(self.board.tasks) > 1 and self.board.is_shared(self)

    def recover(self, error: BaseException) -> bool:
        """Answer a refused command; go on with the next one, or leave the line and its macros."""
        if self.done:
            return False  # it has ended itself
        if isinstance(error, LineAbandoned) or self.refused(error):  # type: ignore[arg-type]
            if not self.calls:
                self.pc += 1
            self.abandon()
        elif isinstance(self.steps, LineSteps):
            self.pc = self.steps.after(self.pc)
        return False

    def too_deep(self) -> Fault:
        """Return the fault of macros that are nested too deeply."""
        return Fault(
            codes.PARAMETER,
            f"macros are nested deeper than {MAX_DEPTH}",
            "a macro that calls itself never returns; MJ jumps without returning",
            "recursion",
        )

    # -------------------------------------------------------------------------------------------------- lines

    @property
    def line(self) -> Line | None:
        """The line or macro that it carries out."""
        return self.steps.line if isinstance(self.steps, LineSteps) else None

    @property
    def source_line(self) -> int:
        """The number of the source line of the current command."""
        return self.line.number if self.line is not None else 0

    @property
    def word(self) -> str:
        """The mnemonic of the current command."""
        command = self.steps.command(self.pc) if isinstance(self.steps, LineSteps) else None
        return "" if command is None else command.name

    def enter(self, steps: LineSteps) -> tuple[Steps, Values]:
        """Return the call of a line."""
        return steps, self.new_values()

    def new_values(self) -> Values:
        """Return the values of a call of a line or a macro."""
        return [self.registers, {}]

    def carry_out(self, lines: Iterable[Line | tuple[Fault, int, int]]) -> None:
        """Carry out these lines and then `rest`; a line that is no line is refused."""
        for line in lines:
            if isinstance(line, tuple):
                self.steps.add(WAIT, self._stray(*line[:2]))
            else:
                self.steps.add(CALL, self._call(self.board.written(line)))
        self.steps.add(TRY, lambda values: self.rest())
        self.steps.add(END)

    def serve(self) -> None:
        """Carry out the lines that `next_line` supplies, one by one."""
        self.steps.add(TRY, lambda values: self._await_line())
        self.steps.add(CALL, self._enter_next)
        self.steps.add(JUMP, to=0)

    def next_line(self) -> Line | None:
        """Return the next line to carry out, None if there is none now."""
        return None

    def rest(self) -> Wait | None:
        """Return the wait after the last line; None ends the task."""
        return None

    def abandon(self) -> None:
        """Leave the current line and all macros around it."""
        if self.calls:
            self.steps, self.pc, self.values = self.calls[0]
            self.calls.clear()
        self.loop_log.leave()
        self.is_paid, self.path_open = False, None
        if self.search is not None:
            self.search.withdraw()
            self.search = None

    def refused(self, trouble: Fault | Rejected) -> bool:
        """Answer a rejected command; return True if the rest of the line is to be skipped."""
        if self.path_open is not None:
            self.path_open.is_refused = True
        return self.board.refused(self, trouble)

    def close_path(self) -> None:
        """Complete the contour path that the line describes."""
        path, self.path_open = self.path_open, None
        if path is not None:
            path.close(self)

    def _call(self, steps: LineSteps) -> Callable[[Values], tuple[Steps, Values]]:
        def call(values: Values) -> tuple[Steps, Values]:
            if self.board.machine.world is not None:
                self.board.machine.world.reach(steps.line.number)
            # A macro that the line calls is not at the position of its last call.
            self.board.effects += 1
            return self.enter(steps)

        return call

    def _stray(self, fault: Fault, at: int) -> Callable[[Values], None]:
        def refuse(values: Values) -> None:
            self.stray = at
            raise fault

        return refuse

    def _enter_next(self, values: Values) -> tuple[Steps, Values]:
        assert self._entered is not None
        return self.enter(self.board.written(self._entered))

    def _await_line(self) -> Wait | None:
        line = self.next_line()
        if line is None:
            return self.rest()
        self._entered = line
        self.board.effects += 1
        return None

    # -------------------------------------------------------------------------------------------- for the actions

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
            raise codes.no_register(number, len(self.board.registers))
        return self.board.registers[number]

    def set_register(self, number: int, value: float | int) -> None:
        if number < PRIVATE:
            self.registers[number] = value
            return
        if number >= len(self.board.registers):
            raise codes.no_register(number, len(self.board.registers))
        if self.board.registers[number] != value:
            self.board.stores += 1
        self.board.registers[number] = value

    def has_read(self, until: float, axis: AxisState | None = None, address: int = 0, kind: str = "") -> None:
        """Record that the accumulator has a reading, valid until a time if nothing happens.

        `kind` is what it has of the variable of an axis: "real", "whole", or its "low" bits.
        """
        self.reading = until, axis, address, kind
        self.board.dependencies.note(Copy(self.steps, self.pc, ACCUMULATOR), _valid, until)

    def tested(self, command: Command, is_bit: bool) -> None:
        """Record when a test of the accumulator gives another result, if that has a reading."""
        board, dependencies = self.board, self.board.dependencies
        if self.reading is None or dependencies.notes is None:
            return
        until, axis, address, kind = self.reading
        value = self.value(command)
        if is_bit and axis is not None and changes_by_event(board, address, [int(value)]):
            return
        if until > self.clock.now:
            dependencies.note(_valid, until)
        elif is_bit or axis is None or kind == "low":
            dependencies.note(dependencies.at_once)
        else:
            for level in levels(command.function, value, kind == "whole"):
                dependencies.note(crossing_time, board, axis, address, level)

    # ------------------------------------------------------------------------------------------- for the report

    @property
    def polled(self) -> str:
        """The channels and other commands that its futile loop polls, joined by "and"."""
        steps, first, last = self.last_loop
        assert isinstance(steps, LineSteps)
        found: dict[str, None] = {}
        macros = dict(self.board.macros)
        bodies = [steps.line.commands[steps.index_of(first) : steps.index_of(last) + 1]]
        for commands in bodies:  # the list grows meanwhile
            for command in commands:
                if command.function == "call_macro" and command.value in macros:
                    bodies.append(macros.pop(int(command.value)).line.commands)
                elif command.reads == "input":
                    found[f"channel {command.text.lstrip(_LETTERS)}"] = None
                elif command.reads:
                    found[command.text] = None
        return " and ".join(found)


_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz "


def _valid(until: float) -> float:
    return until


class BackgroundTask(CommandTask):
    """A macro in the background; the task ends with the macro."""

    def __init__(self, number: int, board: Board, macro: LineSteps) -> None:
        super().__init__(f"task {number}", board)
        self.steps.add(CALL, lambda values: (macro, self.new_values()))
        self.steps.add(END, lambda values: board.ended(self))

    def end(self) -> None:
        """End the task from outside; the scheduler drops it at its next time slice."""
        self.board.ended(self)
        self.done = True
        self.wait = None
