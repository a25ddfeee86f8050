"""The syntax tree of an MCCL text: a module of lines, a line of commands.

    Module([Line(1, [Command(1, 'MR', 1000), Command(None, 'OT', 'done')])])

Nodes are equal if their contents are equal; `at`, the offset in the text, does not count.
"""

from __future__ import annotations

from motionlang.mccl.syntax.parser import head, parts, spans
from motionlang.record import record


class Node:
    """A node of the tree; its fields are those of its class, except `at`."""

    __slots__ = ()
    _fields: tuple[str, ...] = ()

    @property
    def contents(self) -> list[tuple[str, object]]:
        """The names and values of the fields, except `at`."""
        return [(name, getattr(self, name)) for name in self._fields if name != "at"]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(repr(value) for _, value in self.contents)})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Node) and type(self) is type(other) and self.contents == other.contents

    __hash__ = None  # type: ignore[assignment]


@record
class Register(Node):
    """The argument `@n`: the content of register n."""

    number: int


@record
class Command(Node):
    """A command.

    `axis` is the number in front, or None. `word` is the mnemonic in capital letters. `argument` is an
    int, a float, a str for a text in quotes, a Register, or None.
    """

    axis: int | None
    word: str
    argument: int | float | str | Register | None
    at: int = 0


@record
class Line(Node):
    """A line with at least one command; `number` counts from 1."""

    number: int
    commands: list[Command]
    at: int = 0


@record
class Module(Node):
    """A whole text, without blank lines and comments."""

    lines: list[Line]


class NotACommand(Exception):
    """Raised if texts of a module are not commands: `found` has the offset of each."""

    def __init__(self, found: list[int]) -> None:
        super().__init__(f"{len(found)} texts are not commands")
        self.found = found


def parse(text: str) -> Module:
    """Return the tree of a text; raise NotACommand if some texts are not commands."""
    lines, wrong, start = [], [], 0
    for number, line in enumerate(text.split("\n"), 1):
        commands = []
        for begin, end in spans(line):
            command = _command(line[begin:end], start + begin)
            if command is None:
                wrong.append(start + begin)
            else:
                commands.append(command)
        if commands:
            lines.append(Line(number, commands, commands[0].at))
        start += len(line) + 1
    if wrong:
        raise NotACommand(wrong)
    return Module(lines)


def _command(text: str, at: int) -> Command | None:
    found = parts(text)
    if found is None:
        return None
    _, whole, real, register, quoted = found
    axis, word = head(text)
    argument: int | float | str | Register | None = None
    if whole:
        argument = int(whole)
    elif real:
        argument = float(real)
    elif register:
        argument = Register(int(register[1:]))
    elif quoted:
        argument = quoted[1:-1]
    return Command(int(axis) if axis else None, word.upper(), argument, at)
