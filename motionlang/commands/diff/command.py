"""`motionlang diff A [B]`: compare two runs of programs, values or machines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from motionlang.cli.command import Command, Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import complain, unreadable
from motionlang.cli.option_groups import (
    Language,
    OutputOptions,
    ProgramOptions,
    WorldOptions,
    given_settings,
    machine_next_to,
    read,
    with_world,
)
from motionlang.cli.output_files import written
from motionlang.cli.readers import machine_time
from motionlang.cli.signals import SIGNALS
from motionlang.commands.compare.options import is_recording
from motionlang.commands.diff.runs import MAX_LINES, compared_runs, runs_document, runs_text
from motionlang.commands.scenarios import scenario_files
from motionlang.commands.scope import write_scope
from motionlang.comparison.tolerance import Tolerance
from motionlang.extras import installation
from motionlang.kernel import STDIN, Diagnostic, ProgramError, Run, read_machine, run
from motionlang.kernel.lang import layered
from motionlang.views.table import Column, Document, Table

# With --all the rows of a table are as many as there are.
MAX_LINES_OF_ALL = 1_000_000


@dataclass
class InWorld:
    """The result of a comparison in one world: the file of a scenario or, for its own world, the program."""

    world: str
    same: bool
    differences: str


@dataclass
class B(Command):
    """The machine and values of B alone."""

    title: ClassVar[str] = "B alone"
    machine_b: str | None = option("M.toml", "the machine file of B; default: the one next to it")
    set_b: list[str] = option("NAME=VALUE", "set a value for B, as --set of run", many=True)


@dataclass
class GivenProgram(ProgramOptions):
    """A program of one side, with its machine and its values."""

    @classmethod
    def of(cls, diff: Diff, side: str, file: str) -> GivenProgram:
        """Return what is given for a side, "a" or "b"."""
        made = cls(lang=diff.lang)
        if side == "b":
            made.machine, made.set = diff.machine_b, diff.set_b
        made.file = file
        made.check()
        return made


@dataclass
class Diff(OutputOptions, WorldOptions, B, Language):
    """Compare two runs: programs, values or machines."""

    title: ClassVar[str] = "comparison"
    epilog: ClassVar[str] = """\
What the tasks of both programs do is compared: their moves, outputs, prints and
events, in order, with their times and positions. Without B, A is compared with
itself under --set-b or --machine-b. `motionlang verify` compares a program with
its golden files, `motionlang compare` with a recording.

exit status: 0 no difference; 1 a difference; 2 the command line is invalid

examples:
  motionlang diff old/pick.mnt pick.mnt --tolerance time=1ms
  motionlang diff old/pick.prg pick.mnt --scenarios    in every world of A
  motionlang diff pick.mnt --set-b rate=2000     two values of a constant
"""
    # The options that motionlang-explore adds.
    EXPLORING: ClassVar[tuple[str, ...]] = ("explore", "write-scenarios", "seconds")
    removed: ClassVar[Mapping[str, str]] = {
        **{f"{name}-{side}": "write a scenario of the world: motionlang diff A B --scenarios"
           for name in ("input", "analog", "answer", "keys") for side in "ab"},
        "set-a": "give the values of A in its program, or swap A and B: --set-b",
        "machine-a": "put the machine file next to A, or swap A and B: --machine-b",
        "variant-a": "motionlang sweep shows all variants; --set-b takes the values of one",
        "variant-b": "motionlang sweep shows all variants; --set-b takes the values of one",
        "keep": "motionlang sweep FILE --keep shows quantities",
        "map": "motionlang compare takes recordings, with --map",
        "delay": "motionlang compare takes recordings, with --delay",
        **dict.fromkeys(EXPLORING, f"motionlang-explore compares in all ways: {installation('explore')}"),
    }  # fmt: skip
    a: str = argument("A", "a program")
    b: str | None = argument("B", "another one", default=None)
    scenarios: bool = flag("compare in each scenario of A, too")
    tolerance: list[str] = option(
        "WHAT=SIZE",
        "ignore smaller differences: time=1ms, position=0.01uu, speed=2%%; may be repeated",
        many=True,
    )
    all: bool = flag("list everything, not only the first rows of each kind")
    plot: str | None = option("PAGE", "draw the motion of both runs as a page", suffixes=(".html",))
    until: float | None = option("S", "end each run after S seconds of machine time", read=machine_time)

    def unnamed_files(self) -> list[str]:
        return [*machine_next_to(self.a), *machine_next_to(self.b)]

    def run(self) -> int:
        try:
            Tolerance(*self.tolerance)
        except ValueError as error:
            raise WrongOption(str(error)) from None
        other = self.b or (self.a if self.set_b or self.machine_b else None)
        if is_recording(self.a) or (other is not None and is_recording(other)):
            raise WrongOption(
                f"a recording is compared by motionlang compare {self.a} {other or 'RECORDING'}"
            )
        if other is None or any(each.lower().endswith(".json") for each in (self.a, other)):
            raise WrongOption(
                f"give two programs, or --set-b or --machine-b; motionlang verify {self.a} "
                "compares a program with its golden files"
            )
        return self.compare(other)

    def compare(self, other: str) -> int:
        """Compare A with another program and return the exit status."""
        tolerance = Tolerance(*self.tolerance)
        most = MAX_LINES_OF_ALL if self.all else MAX_LINES
        if self.scenarios:
            return self._in_scenarios(other, tolerance, most)
        a, b = self._side("a", self.a), self._side("b", other)
        found = compared_runs(a, b, tolerance)
        self.show(runs_document(found), runs_text(found, most))
        status, page = 0 if found.same else 1, self.plot
        if page is not None:
            status = max(status, written(page, lambda: write_scope(b, page, against=a)))
        return status

    def _in_scenarios(self, other: str, tolerance: Tolerance, most: int) -> int:
        if self.plot:
            raise WrongOption("--plot compares in one world, without --scenarios")
        worlds: list[InWorld] = []
        for scenario in ["", *scenario_files(self.a)]:
            sides = (self._side("a", self.a, scenario), self._side("b", other, scenario))
            found = compared_runs(*sides, tolerance)
            worlds.append(InWorld(scenario or self.a, found.same, runs_text(found, most)))
        table = Table("worlds", list(map(Column, ("world", "same", "differences"))), worlds)
        shown = (f"{each.world}:{' ' if each.same else chr(10)}{each.differences}" for each in worlds)
        self.show(Document([table]), "".join(shown))
        return 0 if all(each.same for each in worlds) else 1

    def _side(self, side: str, path: str, scenario: str = "") -> Run:
        given = GivenProgram.of(self, side, path)
        language = given.known_language()
        settings: dict[str, object] = given.settings()
        if scenario:
            settings = {**_layered(settings, scenario), **given_settings(given.set, language)}
        settings = with_world(settings, self.entries())
        program = given.source() if path == STDIN else path
        try:
            result = run(
                program,
                dialect=language.name,
                machine=settings,
                until=self.until,
                overrides=given.overrides(),
            )
        except OSError as error:
            raise Refused([unreadable(str(error.filename or path), error)], file=path) from None
        except ProgramError as error:
            raise Refused(error.diagnostics, file=path) from None
        except ValueError as error:
            raise Refused([Diagnostic("option", f"{path}: {error}")], file=path) from None
        complain(result.diagnostics, result.source, path)
        SIGNALS.end_with(result)
        return result


def _layered(settings: dict[str, object], scenario: str) -> dict[str, object]:
    layer = read(scenario)
    try:
        above = read_machine(layer, is_layer=True)
    except ProgramError as error:
        raise Refused(error.diagnostics, source=layer, file=scenario) from None
    both = layered(settings, above)
    both.pop("expect", None)
    return both
