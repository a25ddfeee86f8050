"""`motionlang explore`: the states of a program, what leads on, and its cycles."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import argument
from motionlang.cli.option_groups import OutputOptions, ProgramOptions
from motionlang.cli.signals import SIGNALS
from motionlang.commands.explore.playing import explored_program
from motionlang.exploration import Exploration, causes_of, lines_of
from motionlang.views.table import Column, Document, Table


@dataclass
class Explore(OutputOptions, ProgramOptions):
    """Play a program, and show its states, what leads on from each, and its cycles."""

    title: ClassVar[str] = "exploration"
    epilog: ClassVar[str] = """\
explore plays the program: where it waits, each input, key, answer, analogue
level and number of a host that it reads is changed once, to see what leads on.
A machine file gives the axes; its inputs, answers and the like are not used.
map shows the same in words, init writes the world of a cycle into a machine
file. Ctrl-C shows what was found so far.

exit status: 0 success; 1 the program has an error; 2 the command line is
invalid

examples:
  motionlang explore old.prg
"""
    file: str = argument("FILE", "the program; - reads standard input")

    def run(self) -> int:
        found = explored_program(self, keeps=True)
        self.show(_document(found), str(found))
        if found.interrupted is not None:
            SIGNALS.end_with(found.interrupted)
        return 0


def _document(found: Exploration) -> Document:
    """Return each transition as data: its states, its cause, how long it takes, s, and what it does."""
    rows = [
        {
            "from": lines_of(node.state, found.line),
            "cause": causes_of(each),
            "to": "end" if each.target is None else lines_of(each.target, found.line),
            "seconds": each.seconds,
            "acts": ", ".join(map(str, each.acts)),
        }
        for node in found.nodes
        for each in node.transitions
    ]
    columns = [Column(name) for name in ("from", "cause", "to", "seconds", "acts")]
    return Document([Table("transitions", columns, rows)])
