"""The steps of an MCCL program, as a list to read."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial

from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.lang.step_list import ListedUnit, listed
from motionlang.kernel.lang.steps import Step
from motionlang.kernel.mccl.models import written_for
from motionlang.kernel.mccl.resolve.line import Line
from motionlang.kernel.mccl.runtime.board import Board
from motionlang.kernel.mccl.runtime.writer import LineWriter
from motionlang.kernel.source import Source


def step_list(source: Source, lines: Iterable[Line], settings: Mapping[str, object]) -> list[ListedUnit]:
    """Return the steps of each line on a board; each line begins with step 0."""
    machine = Machine(dict(settings), first_axis=1)
    machine.model = machine.model or written_for(source.name)
    board, found = Board(machine), []
    for line in lines:
        found.append(listed(source, "", LineWriter(line, board).steps, partial(_line_of, line)))
    return found


def _line_of(line: Line, step: Step) -> int:
    return line.number
