"""`motionlang diff A B --explore`: compare two programs in all ways that an exploration of either finds."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Refused, WrongOption, flag, option
from motionlang.cli.complaints import unreadable
from motionlang.cli.output_files import written
from motionlang.commands.diff.command import MAX_LINES_OF_ALL, Diff, GivenProgram
from motionlang.kernel.files import replacing
from motionlang.kernel.tools import count_of
from motionlang_explore.diff.way_scenarios import write_scenarios
from motionlang_explore.diff.ways import Player, WaysCompared, compared_ways
from motionlang_explore.diff.ways_page import ways_page
from motionlang_explore.diff.ways_view import MAX_ROWS, input_names, ways_document, ways_text
from motionlang_explore.exploration import SECOND, SECONDS
from motionlang_explore.playing import explored_program, played_lines, playing, seconds_option


@dataclass
class DiffInAllWays(Diff):
    """Compare two runs: programs, values or machines, in one world or in all ways."""

    title: ClassVar[str] = "all ways"
    epilog: ClassVar[str] = f"""\
{Diff.epilog}  motionlang diff old/pick.prg pick.mnt --explore    in all ways of either

{played_lines()}"""
    removed: ClassVar[Mapping[str, str]] = {
        name: hint for name, hint in Diff.removed.items() if name not in Diff.EXPLORING
    }
    explore: bool = flag("compare two programs in all ways that an exploration of either finds")
    write_scenarios: str | None = option(
        "DIR", "with --explore: write a scenario for each difference, which passes on A and fails on B"
    )
    seconds: float | None = seconds_option(before="with --explore, for each program and for the ways: ")

    def run(self) -> int:
        if not self.explore and "seconds" in self.typed:
            raise WrongOption("--seconds limits the search of --explore")
        if self.write_scenarios is not None and not self.explore:
            raise WrongOption("--write-scenarios needs --explore")
        return super().run()

    def compare(self, other: str) -> int:
        if not self.explore:
            return super().compare(other)
        for name in ("scenarios", "tolerance", "until"):
            if getattr(self, name):
                raise WrongOption(f"--{name} and --explore exclude each other")
        a = explored_program(GivenProgram.of(self, "a", self.a), self.seconds)
        b = explored_program(GivenProgram.of(self, "b", other), self.seconds, a.switches.settings)
        work = 2.0 * SECOND * (self.seconds or SECONDS)
        with playing("ways") as progress:
            found = compared_ways(Player(a), Player(b), work, progress=progress)
        names = input_names(a)
        self.show(
            ways_document(found, names), ways_text(found, names, MAX_LINES_OF_ALL if self.all else MAX_ROWS)
        )
        status, page = 0 if found.same else 1, self.plot
        if page is not None:
            status = max(status, written(page, lambda: _write_page(page, ways_page(found, names))))
        if self.write_scenarios is not None:
            status = max(status, self._write(found, names, self.write_scenarios))
        return status

    def _write(self, found: WaysCompared, names: Mapping[int, str], folder: str) -> int:
        try:
            paths, left = write_scenarios(found, names, folder)
        except OSError as error:
            raise Refused([unreadable(str(error.filename or folder), error)], file=folder) from None
        written_files = count_of(len(paths), "scenario")
        missing = f"; {count_of(len(left), 'difference')} that no expectation shows" if left else ""
        sys.stderr.write(f"{written_files} written to {folder}{missing}\n")
        return 0


def _write_page(path: str, text: str) -> None:
    with replacing(path) as file:
        file.write(text.encode())
