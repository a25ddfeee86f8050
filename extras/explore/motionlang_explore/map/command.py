"""`motionlang map`: what a machine does, and what its program is made of."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Refused, WrongOption, argument, flag, option
from motionlang.cli.option_groups import OutputOptions, ProgramOptions
from motionlang.cli.parser import either
from motionlang.cli.readers import whole
from motionlang.cli.signals import SIGNALS
from motionlang.kernel import CheckedSettings, Diagnostic, ProgramError, Source
from motionlang.kernel.lang import Unit
from motionlang.kernel.tools import nearest
from motionlang.views.terminal import table_width, wants_colour
from motionlang_explore.map.program_map import ProgramMap, map_of_machine, program_map
from motionlang_explore.map.view.formats import FORMS, SUFFIXES, document, written
from motionlang_explore.map.view.text import line_text, render, unit_text
from motionlang_explore.playing import play_time, played_lines, playing, seconds_option


@dataclass
class Map(OutputOptions, ProgramOptions):
    """Show what a machine does: its cycle, states, channels and axes."""

    title: ClassVar[str] = "map"
    epilog: ClassVar[str] = f"""\
map plays the program: where it waits, each input, key, answer, analogue level
and number of a host that it reads is changed once, to see what leads on. A
machine file gives the axes; its inputs, answers and the like are not used.
Where no good piece is found it plays up to six times as long as usual.
Ctrl-C shows what was found so far.

exit status: 0 success; 1 the program has an error; 2 the command line is
invalid

{played_lines()}
examples:
  motionlang map old.prg
  motionlang map old.prg --all
  motionlang map old.prg -o old.html
  motionlang map old.prg --no-run     the text alone, at once
  motionlang map old.prg --unit cut   the statements of a sub
  motionlang map old.prg --line 141   the ways in which a line runs
"""
    suffixes: ClassVar[Mapping[str, str]] = SUFFIXES
    file: str = argument("FILE", "the program; - reads standard input")
    format: str = option(
        "",
        "the form: text, Markdown, a Mermaid graph of the states, one JSON document, CSV of the channels, an "
        f"HTML page, or none (by default that of the extension of --output: {either(list(SUFFIXES))}; else text)",
        choices=(*FORMS, "none"),
    )
    unit: str | None = option(
        "NAME", "show only the statements of one sub, task, handler or macro, and what each waits for"
    )
    line: int | None = option(
        "N", "show only the states and the ways in which line N runs", read=whole("a line number", 1, 10**9)
    )
    all: bool = flag("show all of the map; the text has one screen of what to know first")
    no_run: bool = flag("show only what the text says, without playing the program")
    seconds: float | None = seconds_option()

    def check(self) -> None:
        """Raise WrongOption if values of names are given without a run."""
        super().check()
        if self.no_run or self.unit is not None:
            if self.overrides():
                raise WrongOption("names of the program in --set need a run")
            if "seconds" in self.typed:
                raise WrongOption("--seconds limits a run")
        if self.line is not None and (self.no_run or self.unit is not None):
            raise WrongOption(f"--line and {'--no-run' if self.no_run else '--unit'} exclude each other")

    def run(self) -> int:
        source, language = self.source(), self.known_language()
        try:
            if self.no_run or self.unit is not None:
                made = program_map(language.program(source, self.settings()), language)
            else:
                made = self._played(source)
        except ProgramError as error:
            raise Refused(error.diagnostics, source=source, file=self.file) from None
        width, colour = table_width(sys.stdout), wants_colour(sys.stdout)
        if self.unit is not None:
            text = unit_text(made, _unit(made, self.unit), width=width, colour=colour)
        elif self.line is not None:
            text = line_text(made, self.line, width=width, colour=colour)
        else:
            text = render(made, width=width, colour=colour, has_all=self.all)
        if self.format in ("text", "json", "csv", "none"):
            self.show(document(made), text)
        else:
            sys.stdout.write(written(made, self.format))
        interrupted = None if made.behaviour is None else made.behaviour.exploration.interrupted
        if interrupted is not None:
            SIGNALS.end_with(interrupted)
        return 0

    def _played(self, source: Source) -> ProgramMap:
        with playing(source.name) as progress:
            return map_of_machine(
                source,
                self.known_language(),
                CheckedSettings(self.settings()),
                overrides=self.overrides(),
                progress=progress,
                keeps=True,
                **play_time(self.seconds),
            )


def _unit(made: ProgramMap, name: str) -> Unit:
    wanted = name.lower()
    found = [each for each in made.structure.units if wanted in (each.name.lower(), each.title.lower())]
    if found:
        return found[0]
    near = nearest(name, [each.name for each in made.structure.units])
    hint = f"did you mean {near}?" if near else "motionlang map lists them under Structure"
    raise Refused([Diagnostic("option", f"the program has no unit {name}", hint=hint)], status=2)
