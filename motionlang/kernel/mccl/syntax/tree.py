"""The syntax tree of an MCCL text: a module of lines, a line of commands.

    Module([Line(1, [Command(1, 'MR', 1000), Command(None, 'OT', 'done')])])

Nodes are equal if their contents are equal; `start` and `end`, the offsets of their text, do not count.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields


@dataclass(slots=True, repr=False)
class Node:
    """A node of the tree, from offset `start` to offset `end` of the text."""

    start: int = field(default=0, compare=False, kw_only=True)
    end: int = field(default=0, compare=False, kw_only=True)

    def __repr__(self) -> str:
        values = [repr(getattr(self, each.name)) for each in fields(self) if each.compare]
        return f"{type(self).__name__}({', '.join(values)})"


@dataclass(slots=True, repr=False)
class Register(Node):
    """The argument `@n`: the content of register n."""

    number: int


@dataclass(slots=True, repr=False)
class Command(Node):
    """A command.

    `axis` is the number in front, or None. `word` is the mnemonic in capital letters, a `Word` if it was parsed.
    `argument` is an int, a float, a str for a text in quotes, a Register, or None.
    """

    axis: int | None
    word: str
    argument: int | float | str | Register | None


@dataclass(slots=True, repr=False)
class Wrong(Node):
    """A text that is no command.

    `axis` and `word` are what it begins with, None and "" if that is missing. The mistake is at offset `mistake`.
    """

    text: str
    axis: int | None = None
    word: str = ""
    mistake: int = field(default=0, compare=False, kw_only=True)


@dataclass(slots=True, repr=False)
class Line(Node):
    """A line with at least one command; `number` counts from 1."""

    number: int
    commands: list[Command | Wrong]


@dataclass(slots=True, repr=False)
class Module(Node):
    """A whole text, without blank lines and comments."""

    lines: list[Line]
