"""A line of commands, ready to run; the body of a macro is also a line."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from motionlang.kernel.mccl import codes
from motionlang.kernel.mccl.codes import Fault
from motionlang.kernel.mccl.resolve.command import Command
from motionlang.kernel.mccl.resolve.decode import decoded
from motionlang.kernel.mccl.resolve.literals import parameter
from motionlang.kernel.mccl.syntax import tree
from motionlang.kernel.mccl.syntax.comments import without_comment
from motionlang.kernel.mccl.syntax.parser import MAX_LINE, parse
from motionlang.kernel.source import Source


class Line:
    """The commands of one source line, with its `number`.

    `origin` is the text that contained it, which a macro outlives. `offsets` are those of the commands in it.
    """

    __slots__ = ("commands", "number", "offsets", "origin")

    def __init__(
        self, commands: tuple[Command, ...], number: int, origin: str, offsets: tuple[int, ...]
    ) -> None:
        self.commands, self.number, self.origin, self.offsets = commands, number, origin, offsets

    def rest(self, first: int) -> Line:
        """Return the line from command `first` on."""
        return Line(self.commands[first:], self.number, self.origin, self.offsets[first:])

    @property
    def text(self) -> str:
        """The commands in source form, separated by commas."""
        return ",".join(command.text for command in self.commands)


def too_long(length: int) -> Fault:
    """Return the fault of a line that does not fit the controller's buffer."""
    return Fault(
        codes.TOO_LONG,
        f"the line has {length} characters; the controller accepts {MAX_LINE}",
        "break the line, or move commands into macros",
        "values",
    )


def line_of(text: str) -> Line | None:
    """Return the commands of one line of text, or None if it has none.

    Raises Fault if the line is too long.
    """
    _check_length(text)
    lines = parse(text).lines
    return _line(lines[0], text, 1, {}) if lines else None


def lines_of(
    source: Source, module: tree.Module | None = None, numbers: Mapping[int, float] | None = None
) -> Iterator[Line | tuple[Fault, int, int]]:
    """Yield the lines of a file, whose tree is `module` if that has been made.

    A line that is too long yields its fault, offset and number instead. `numbers` replace the parameters at some
    offsets.
    """
    start, lengths = 0, {}
    for number, raw in source.numbered():
        try:
            _check_length(raw)
        except Fault as fault:
            lengths[number] = fault, start, number
        start += len(raw) + 1
    for line in (module or parse(source.text)).lines:
        number = source.before + line.number
        yield lengths.get(number) or _line(line, source.text, number, numbers or {})


def _check_length(line: str) -> None:
    if len(line) > MAX_LINE:
        sent = without_comment(line)
        if len(sent.strip()) > MAX_LINE:
            raise too_long(len(sent))


def _line(line: tree.Line, text: str, number: int, numbers: Mapping[int, float]) -> Line:
    commands = tuple([_command(each, text, numbers) for each in line.commands])
    return Line(commands, number, text, tuple([each.start for each in line.commands]))


def _command(node: tree.Command | tree.Wrong, text: str, numbers: Mapping[int, float]) -> Command:
    if numbers and isinstance(node, tree.Command) and (at := parameter(node)) in numbers:
        return decoded(replace(node, argument=numbers[at]), f"{text[node.start : at]}{numbers[at]!r}")
    return decoded(node, text[node.start : node.end])


def locate(source: Source, at: int) -> tuple[int, int, int]:
    """Return line, column and length of the command at an offset."""
    line, column = source.location(at)
    text = source.line(line)
    if column == 1 and len(text) > MAX_LINE:
        return line, 1, min(len(text), 80)
    commands = [each for found in parse(text).lines for each in found.commands]
    end = next((each.end for each in commands if each.start == column - 1), column)
    return line, column, end - column + 1
