"""A file of commands, downloaded line by line as by a terminal program.

Each line is sent when the previous one has ended.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from motionlang.kernel.controller.clock import INFINITY
from motionlang.kernel.errors import Diagnostic, ProgramError, Rejected
from motionlang.kernel.lang.dialect import dialect
from motionlang.kernel.lang.literals import Literal, Placed, number, placed
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.names import Names
from motionlang.kernel.lang.program import Program, Target
from motionlang.kernel.lang.waits import Wait
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.models import written_for
from motionlang.kernel.mccl.resolve import literals
from motionlang.kernel.mccl.resolve.line import Line, lines_of, locate
from motionlang.kernel.mccl.runtime.board import Board
from motionlang.kernel.mccl.runtime.debugging import Inspection
from motionlang.kernel.mccl.runtime.task import CommandTask
from motionlang.kernel.mccl.syntax import tree
from motionlang.kernel.mccl.syntax.parser import parse
from motionlang.kernel.source import Source

if TYPE_CHECKING:
    from motionlang.kernel.lang.step_graph import StepGraph
    from motionlang.kernel.lang.structure import Structure


class Text:
    """A text, read once for all programs that are made of it."""

    def __init__(self, source: Source) -> None:
        self.source, self.module = source, parse(source.text)

    @cached_property
    def literals(self) -> list[Literal]:
        return literals.literals(self.source, self.module, dialect(MacroFile.language).jumps)


class MacroFile(Program):
    """The lines of a file, as a program.

    A command that the board would answer with `?` runs and gets that answer. `values` are in place of parameters, by
    address, and of registers, by name.
    """

    language = "mccl"

    def __init__(
        self,
        source: Source,
        settings: Mapping[str, object] | None = None,
        is_debug: bool = False,
        values: Mapping[str, float | str] | None = None,
        text: Text | None = None,
    ) -> None:
        super().__init__(source, settings)
        self.is_debug, self.values = is_debug, dict(values or {})
        self._text = text or Text(source)

    def __reduce__(self) -> tuple[Callable[..., MacroFile], tuple[object, ...]]:
        return MacroFile, (self.source, self.settings, self.is_debug, self.values)

    @cached_property
    def lines(self) -> list[Line | tuple[Fault, int, int]]:
        """The lines of commands; the fault, offset and number of one that is too long."""
        numbers = {at: number(name, self.values[name]) for at, name in self.places.literals.items()}
        return list(lines_of(self.source, self._text.module, numbers))

    @cached_property
    def places(self) -> Placed:
        return placed(self, self.values)

    @property
    def whole(self) -> list[Line]:
        """The lines that are not too long."""
        return [line for line in self.lines if isinstance(line, Line)]

    @property
    def tree(self) -> tree.Module:
        commands = [each for line in self._text.module.lines for each in line.commands]
        positions = {self.source.location(each.start) for each in commands if isinstance(each, tree.Wrong)}
        if positions:
            syntax = [each for each in self.errors if (each.line, each.column) in positions]
            raise ProgramError(syntax or self.errors)  # the line may be too long, too
        return self._text.module

    @cached_property
    def diagnostics(self) -> list[Diagnostic]:
        from motionlang.kernel.mccl.resolve.errors import diagnostics_of

        found = diagnostics_of(self.source, self.lines, self.settings)
        return sorted(found, key=lambda each: (each.line, each.column))

    @property
    def errors(self) -> list[Diagnostic]:
        return [each for each in self.diagnostics if each.severity == "error"]

    def require(self) -> None:
        """Raise ProgramError for wrong addresses of values; the board answers wrong commands."""
        self.places  # noqa: B018 - it raises the error

    @cached_property
    def names(self) -> Names:
        from motionlang.kernel.mccl.resolve.definitions import names

        return names(self.source, self.lines, self.settings)

    @property
    def literals(self) -> list[Literal]:
        return self._text.literals

    @cached_property
    def target(self) -> Target:
        from motionlang.kernel.mccl.resolve.board import written_for as target_of

        return target_of(self.source, self.whole)

    @property
    def graph(self) -> StepGraph:
        return self.structure.graph

    @cached_property
    def structure(self) -> Structure:
        from motionlang.kernel.mccl.runtime.structure import structure

        return structure(self.source, self.whole, self.settings)

    @cached_property
    def notes(self) -> list[str]:
        from motionlang.kernel.mccl.resolve.chosen_rates import chosen_rates
        from motionlang.kernel.mccl.resolve.errors import model_of
        from motionlang.kernel.mccl.runtime.structure import use_of

        model = model_of(self.source, self.settings)
        uses = [
            (line.number, use_of(command, command.row, at))
            for line in self.whole
            for command, at in zip(line.commands, line.offsets, strict=True)
            if command.row is not None
        ]
        return chosen_rates(uses, self.settings, model)

    @property
    def offsets(self) -> list[int]:
        return [at for line in self.whole for at in line.offsets]

    @property
    def entries(self) -> list[int]:
        """The first command of each macro that is defined within a line."""
        found = []
        for line in self.whole:
            defining = [each.function == "define_macro" for each in line.commands]
            found += [at for at, defined in zip(line.offsets[1:], defining, strict=False) if defined]
        return found

    @property
    def is_doubtful(self) -> bool:
        first = self.lines[0] if self.lines else None
        return first is not None and not (isinstance(first, Line) and first.commands[0].row is not None)

    def on(self, settings: Mapping[str, object]) -> MacroFile:
        return MacroFile(self.source, settings, self.is_debug, self.values, self._text)

    def with_values(self, values: Mapping[str, float | str]) -> MacroFile:
        return MacroFile(self.source, self.settings, self.is_debug, values, self._text)

    def start(self, machine: Machine) -> FileTask:
        """Return the foreground task.

        Its board is in the state at power-up, except for registers set by `--set`.
        """

        def complain(diagnostic: Diagnostic, task: CommandTask) -> None:
            span = locate(self.source, task.at)
            diagnostic.line, diagnostic.column, diagnostic.length = span
            machine.complain(diagnostic)

        program = (
            self if machine.overrides.items() <= self.values.items() else self.with_values(machine.overrides)
        )
        machine.model = machine.model or written_for(self.source.name)
        board = Board(machine, complain)
        if self.is_debug:
            board.hook = machine.hook
            assert board.hook is not None, "a debug build needs a machine with a hook"
        task = FileTask(program, board)
        if board.hook is not None:
            board.hook.inspection = Inspection(board, task)
        task.override({name: program.values[name] for name in program.places.names})
        return task


class FileTask(CommandTask):
    """Sends the lines of a file, and finally waits for remaining background tasks."""

    def __init__(self, program: MacroFile, board: Board) -> None:
        super().__init__(program.source.name, board)
        board.foreground(self)
        self._source = program.source
        self.carry_out(program.lines)

    def override(self, values: dict[str, float | str]) -> None:
        """Set registers by name."""
        override(self, values)

    def rest(self) -> Wait | None:
        """Return the wait for background tasks; None if none can do anything more."""
        board = self.board
        left = board.background
        if self._nothing_left():
            board.ended(self)
            board.machine.notes.update((note_on(self._source, task), None) for task in left.values())
            return None
        names = ", ".join(str(number) for number in left)
        return Wait(
            self.clock.now,
            self._nothing_left,
            lambda: INFINITY,
            f"for background task {names} to end",
            "task",
        )

    def _nothing_left(self) -> bool:
        """True if no background task can do anything more.

        Each has ended, or polls for something that nothing on this machine can cause.
        """
        board = self.board
        scheduler = board.machine.scheduler
        if not board.background:
            return True
        if scheduler is None or scheduler.outside is not None:
            return False
        return all(map(_only_watches, board.background.values())) and (
            board.controller.clock.next_time() == INFINITY
        )


def _only_watches(task: CommandTask) -> bool:
    """True if a task polls a value that no event changes, or waits for an input."""
    wait = task.wait
    return task.is_endless or (wait is not None and wait.cause == "input" and wait.due() == INFINITY)


def note_on(source: Source, task: CommandTask) -> str:
    """Return a note on a background task that still polls after the foreground ends."""
    line, _, _ = locate(source, task.at)
    if task.is_endless:
        doing, since = (
            f"polled {task.polled}" if task.polled else "ran a loop that polls nothing",
            task.futile_since,
        )
    else:
        assert task.wait is not None
        doing, since = f"waited {task.wait.why}", task.wait.since
    macro = next(
        (f" (macro {number})" for number, each in task.board.macros.items() if each is task.steps), ""
    )
    return (
        f"line {line}: background {task.name}{macro} still {doing} when the foreground ended; nothing could "
        f"change that since {since:.3f} s"
    )


def override(task: CommandTask, values: dict[str, float | str]) -> None:
    """Set registers by the names R0 to R255, for `--set`."""
    for name, value in values.items():
        number = name[1:]
        if name[:1] not in "Rr" or not number.isdecimal() or isinstance(value, str):
            raise Rejected(
                "unknown-word",
                f"{name} is not a register",
                "MCCL programs have registers, such as --set R10=5",
            )
        try:
            task.set_register(int(number), int(value) if value == int(value) else value)
        except Fault as fault:
            raise Rejected(fault.kind, fault.message, fault.hint) from None
