"""The names of an MCCL file, for an editor: macros and registers with every use."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from motionlang.kernel.lang.names import Block, Definition, Names
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.keywords import table
from motionlang.kernel.mccl.models import DEFAULT, MODELS, named, written_for
from motionlang.kernel.mccl.resolve.command import NUMBER, REGISTER, Command
from motionlang.kernel.mccl.resolve.line import Line
from motionlang.kernel.source import Source

_DEFINES = "define_macro"
# Verbs whose parameter is the number of a macro, and those whose parameter is the number of a register.
_MACROS = frozenset((_DEFINES, "call_macro", "jump_macro", "start_task", "tell_macro"))
_REGISTERS = frozenset(("store", "recall", "tell_register"))
# Each task has its own registers with numbers below this one.
_LOCAL = 10


def names(
    source: Source, lines: Iterable[Line | tuple[Fault, int, int]], settings: Mapping[str, object]
) -> Names:
    """Return the macros and registers of the lines of a file; invalid commands are skipped."""
    return _Finder(source, settings).found(lines)


class _Finder:
    """One pass over the commands of a file."""

    def __init__(self, source: Source, settings: Mapping[str, object]) -> None:
        self.source = source
        self.whole = 0, len(source.text)
        wanted = str(settings.get("controller.model", "")) or written_for(source.name)
        self.model = named(wanted) or MODELS[DEFAULT]
        self.macros: dict[int, Definition] = {}
        self.registers: dict[int, Definition] = {}
        self.blocks: list[Block] = []
        self.complete = True
        # The first line with a macro number that is known only when the program runs.
        self.computed = 0

    def found(self, lines: Iterable[Line | tuple[Fault, int, int]]) -> Names:
        """Return the names."""
        for line in lines:
            if isinstance(line, Line):
                for command, at in zip(line.commands, line.offsets, strict=True):
                    self._command(line, command, at)
            else:
                self.complete = False
        return Names(
            [*self.macros.values(), *self.registers.values()],
            self.blocks,
            self.complete,
            self._problem,
        )

    def _command(self, line: Line, command: Command, at: int) -> None:
        row = command.row
        if row is None:
            self.complete = False
            return
        # The parameter is the end of the command's text.
        head = command.text.upper().find(row.name) + len(row.name)
        span = at + head, at + len(command.text)
        if command.kind == REGISTER:
            self._register(int(command.value), (span[0] + 1, span[1]))
        if row.function in _MACROS:
            if command.kind == REGISTER:
                self.computed = self.computed or line.number
            elif command.number is not None and command.number >= 0:
                self._macro(line, command, span)
        elif row.function in _REGISTERS and command.kind == NUMBER and command.number is not None:
            self._register(command.number, span)

    def _macro(self, line: Line, command: Command, span: tuple[int, int]) -> None:
        number = command.number
        assert number is not None
        assert command.row is not None
        made = self.macros.setdefault(number, Definition(str(number), "macro", self.whole))
        if span[0] == span[1]:
            span = span[0] - len(command.row.name), span[1]
            made.fixed = f"line {line.number} means macro {number} without its number"
        made.use(span)
        if command.row.function == _DEFINES:
            if not made.is_declared:
                made.declare(span)
                made.text = line.text
                first, last = line.offsets[0], line.offsets[-1] + len(line.commands[-1].text)
                self.blocks.append(Block("macro", str(number), span, (first, last)))
            else:
                made.fixed = f"macro {number} is defined more than once"

    def _register(self, number: int, span: tuple[int, int]) -> None:
        made = self.registers.get(number)
        if made is None:
            made = self.registers[number] = Definition(
                str(number), "register", self.whole, f"register {number}"
            )
            if number == 0:
                made.text, made.fixed = "register 0, the accumulator", "register 0 is the accumulator"
            elif number < _LOCAL:
                made.text = f"register {number}; each task has its own"
        made.use(span)

    def _problem(self, definition: Definition, name: str) -> str:
        if definition.fixed:
            return definition.fixed
        if not name.isascii() or not name.isdecimal() or len(name) > 4:
            return f"{name} is not a number"
        number, old = int(name), int(definition.name)
        if number == old:
            return ""
        if definition.kind == "macro":
            if number > self.model.macros:
                return f"macros are numbered 0 to {self.model.macros}, not {number}"
            if self.computed:
                command = table().doing(_DEFINES)
                return f"line {self.computed} calls a macro by a register, so {command}{old} must keep its number"
            return f"there is already a macro {number}" if number in self.macros else ""
        if not 0 < number < self.model.registers:
            return f"registers are numbered 1 to {self.model.registers - 1}, not {number}"
        if (number < _LOCAL) is not (old < _LOCAL):
            return f"each task has its own registers below {_LOCAL}; the others are shared"
        return f"register {number} is already in use" if number in self.registers else ""
