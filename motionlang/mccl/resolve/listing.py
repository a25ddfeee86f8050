"""The commands of a program as text, each with the function that executes it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.lang.listing import Listing
from motionlang.mccl.resolve.command import NONE, REGISTER, TEXT
from motionlang.mccl.resolve.line import Line, lines_of

if TYPE_CHECKING:
    from motionlang.mccl.resolve.command import Command
    from motionlang.source import Source

HEAD = """\
MCCL is interpreted: there is no generated code. Below each line of the program
are its commands, each with the operation of motionlang/mccl/keywords that
carries it out."""


def listing(source: Source) -> Listing:
    """Return the commands of all lines that the controller accepts."""
    found = []
    for line in lines_of(source.text):
        if isinstance(line, Line):
            width = max(len(command.text) for command in line.commands)
            found += [(line.number, f" {each.text:{width}}", _described(each)) for each in line.commands]
    return Listing(HEAD, found, is_python=False)


def _described(command: Command) -> str:
    row = command.row
    if row is None or not row.simulated or row.actions.do is None:
        return "not simulated"
    module = row.actions.do.__module__.rpartition(".")[2]
    given = [f"axis {command.axis}"] if command.axis else []
    if command.kind == REGISTER:
        given.append(f"register {command.value}")
    elif command.kind != NONE:
        given.append(repr(command.value) if command.kind == TEXT else f"{command.value}")
    return f"{module}.{row.verb}({', '.join(given)})"
