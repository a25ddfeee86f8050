"""The tokens of a text, for highlighting: read from its tree, and what lies between the commands."""

from __future__ import annotations

import re
from collections.abc import Iterator

from motionlang.kernel.mccl.keywords import table
from motionlang.kernel.mccl.syntax.parser import parse
from motionlang.kernel.mccl.syntax.tree import Command, Register, Wrong

# The text between two commands: comments, line ends, separators.
_BETWEEN = re.compile(r"(?P<comment>[;#][^\r\n]*)|(?P<separator>\r?\n|.)", re.DOTALL)
_DIGITS = "0123456789"


def tokens(text: str) -> Iterator[tuple[str, str, int]]:
    """Yield kind, text and offset of each token; together they make up all of `text`."""
    end = 0
    for line in parse(text.replace("\r", " ")).lines:
        for command in line.commands:
            yield from _between(text, end, command.start)
            yield from _command(text, command)
            end = command.end
    yield from _between(text, end, len(text))


def _between(text: str, start: int, end: int) -> Iterator[tuple[str, str, int]]:
    for match in _BETWEEN.finditer(text, start, end):
        assert match.lastgroup is not None
        yield match.lastgroup, match[0], match.start()


def _command(text: str, command: Command | Wrong) -> Iterator[tuple[str, str, int]]:
    whole = text[command.start : command.end]
    count = len(whole) - len(whole.lstrip(_DIGITS))
    axis, name = whole[:count], whole[count : count + 2]
    if axis:
        yield "axis", axis, command.start
    if name:
        known = table().get(name)
        kind = "unknown" if known is None else "command" if known.simulated else "not-simulated"
        yield kind, name, command.start + count
    begin = count + len(name)
    if begin < len(whole):
        yield _argument(command, whole[begin]), whole[begin:], command.start + begin


def _argument(command: Command | Wrong, first: str) -> str:
    if isinstance(command, Command):
        return (
            "register"
            if isinstance(command.argument, Register)
            else "text"
            if isinstance(command.argument, str)
            else "number"
        )
    return {'"': "text", "@": "register"}.get(first, "number")
