"""The facts about a file in MCCL: its lines, its steps, and the controller that it is for."""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.kernel.mccl import Command, MacroFile
from motionlang.kernel.mccl.resolve.errors import model_of
from motionlang.kernel.mccl.resolve.flow import flow_of


class MacroFacts:
    """The facts about a file in MCCL without errors."""

    def __init__(self, program: MacroFile) -> None:
        self.lines, self.structure, self.settings = program.whole, program.structure, program.settings
        self.flow = flow_of(program.settings)
        self.model = model_of(program.source, program.settings)

    @property
    def commands(self) -> Iterator[tuple[Command, int]]:
        """The commands of all lines, each with its offset."""
        for line in self.lines:
            yield from zip(line.commands, line.offsets, strict=True)
