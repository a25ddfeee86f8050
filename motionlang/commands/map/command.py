"""`motionlang map`: what a program does, from its text or with a run of it."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import complain
from motionlang.cli.option_groups import Output, ProgramOptions, World, with_world
from motionlang.cli.parser import either
from motionlang.cli.readers import machine_time
from motionlang.commands.map.program_map import UNTIL, ProgramMap, map_of_run, program_map
from motionlang.commands.map.view.formats import FORMS, SUFFIXES, written
from motionlang.commands.map.view.text import render, render_states
from motionlang.kernel import Checked, Diagnostic, ProgramError
from motionlang.kernel.tools import nearest
from motionlang.views.terminal import table_width, wants_colour


@dataclass
class Map(Output, World, ProgramOptions):
    """Show what a program does: channels, axes, structure, states."""

    title: ClassVar[str] = "map"
    epilog: ClassVar[str] = """\
The map is made from the text alone. With --run the program also runs, and the
transitions that the run takes have counts and times.

exit status: 0 success; 1 the program has an error; 2 the command line is
invalid

examples:
  motionlang map old.prg
  motionlang map old.prg --run -o old.html
"""
    suffixes: ClassVar[Mapping[str, str]] = SUFFIXES
    file: str = argument("FILE", "the program; - reads standard input")
    format: str = option(
        "",
        "the form: text, Markdown, a Mermaid or DOT graph of the states, one JSON document, CSV of the channels, an "
        f"HTML page, or none (by default that of the extension of --output: {either(list(SUFFIXES))}; else text)",
        choices=(*FORMS, "none"),
    )
    unit: str | None = option("NAME", "show the states of one sub, task, handler or macro only")
    run_: bool = flag("run the program, too, and show which transitions it takes")
    until: float | None = option(
        "S", f"end the run after S seconds of machine time (run.until of the machine file, or {UNTIL:.0f})",
        read=machine_time,
    )  # fmt: skip

    def check(self) -> None:
        """Raise WrongOption if a world or values of names are given without a run."""
        super().check()
        if not self.run_ and (self.entries() or self.overrides() or self.until is not None):
            words = "--input, --analog, --answer, --keys, --until and names of the program in --set"
            raise WrongOption(f"{words} need --run")

    def run(self) -> int:
        source, language, settings = self.source(), self.known_language(), self.settings()
        try:
            if self.run_:
                settings = Checked(with_world(settings, self.entries()))
                overrides = self.overrides()
                made = map_of_run(source, language, settings, until=self.until, overrides=overrides)
            else:
                made = program_map(language.program(source, settings), language)
        except ProgramError as error:
            raise Refused(error.diagnostics, source=source, file=self.file) from None
        if self.unit is not None:
            self._choose(made, self.unit)
        if made.run is not None:
            complain(made.run.diagnostics, source, self.file)
        if self.format == "text":
            width = table_width(sys.stdout)
            colour = wants_colour(sys.stdout)
            shown = render if self.unit is None else render_states
            sys.stdout.write(shown(made, width=width, colour=colour))
        elif self.format != "none":
            sys.stdout.write(written(made, self.format))
        return 0

    def _choose(self, made: ProgramMap, name: str) -> None:
        """Leave only the diagram of one unit; Refused if there is none of this name."""
        wanted = name.lower()
        found = [
            each
            for each in made.diagrams.diagrams
            if wanted in (each.unit.name.lower(), each.unit.title.lower())
        ]
        if not found:
            near = nearest(name, [each.name for each in made.structure.units])
            hint = f"did you mean {near}?" if near else "motionlang map lists them under Structure"
            raise Refused([Diagnostic("option", f"the program has no unit {name}", hint=hint)], status=2)
        made.diagrams.diagrams[:] = found
