"""`motionlang diff A [B]`: compare two runs, or a run with its golden files.

B may also be a recording from a real controller.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from motionlang.cli.command import Command, Refused, WrongOption, argument, flag, option
from motionlang.cli.complaints import complain, unreadable
from motionlang.cli.option_groups import (
    Language,
    ProgramOptions,
    WorldOptions,
    given_settings,
    machine_next_to,
    read,
    with_world,
)
from motionlang.cli.output_files import written
from motionlang.cli.readers import integer
from motionlang.cli.signals import SIGNALS
from motionlang.commands.compare.options import RECORDED, Compared, is_recording
from motionlang.commands.diff.charged import Charge, charged
from motionlang.commands.diff.golden import golden_files
from motionlang.commands.diff.literals import ChangedLiteral, changed_literals
from motionlang.commands.diff.reports import checked, difference
from motionlang.commands.diff.tolerance import Tolerance
from motionlang.commands.diff.view import MAX_LINES, diff_document, diff_lines, literal_lines, quantity_lines
from motionlang.commands.diff.way_scenarios import write_scenarios
from motionlang.commands.diff.ways import Player, WaysCompared, compared_ways
from motionlang.commands.diff.ways_page import ways_page
from motionlang.commands.diff.ways_view import MAX_ROWS, input_names, ways_document, ways_text
from motionlang.commands.playing import explored_program, playing
from motionlang.commands.quantities import no_cycle_notes, quantity_names, values_of
from motionlang.commands.scenarios import scenario_files
from motionlang.commands.scope import write_scope
from motionlang.commands.sweep import Sweep
from motionlang.commands.sweep.variants import Variants
from motionlang.commands.sweep.worlds import SUFFIX
from motionlang.kernel import STDIN, Diagnostic, ProgramError, Run, read_machine, run
from motionlang.kernel.files import replacing
from motionlang.kernel.lang import layered
from motionlang.kernel.report import build
from motionlang.kernel.tools import count_of
from motionlang.views.table import Column, Document, Table
from motionlang.views.terminal import wants_colour

SCHEMA = "motionlang.diff/2"
# With --all the rows of a table are as many as there are.
MAX_LINES_OF_ALL = 1_000_000

# The name of a quantity, and its value in both runs.
Kept = tuple[str, object, object]
# A report, and the run that it is of, unless it was read from a file.
Side = tuple[dict[str, Any], Run | None]


@dataclass
class InWorld:
    """The result of a comparison in one world: the file of a scenario or, for its own world, the program."""

    world: str
    same: bool
    differences: str


@dataclass
class A(Command):
    """The machine, values and inputs of A alone."""

    title: ClassVar[str] = "A alone"
    machine_a: str | None = option("M.toml", "the machine file of A; default: the one next to it")
    set_a: list[str] = option("NAME=VALUE", "set a value for A, as --set of run", many=True)
    variant_a: int | None = option("N", "use variant N of the sweep next to the program as A", read=integer)
    input_a: list[str] = option("CHANNEL=VALUE@S", "as --input", many=True)
    analog_a: list[str] = option("CHANNEL=PERCENT@S", "as --analog", many=True)
    answer_a: list[str] = option("TEXT", "as --answer", many=True)
    keys_a: list[str] = option("TEXT@S", "as --keys", many=True)


@dataclass
class B(Command):
    """The machine, values and inputs of B alone."""

    title: ClassVar[str] = "B alone"
    machine_b: str | None = option("M.toml", "the machine file of B; default: the one next to it")
    set_b: list[str] = option("NAME=VALUE", "set a value for B, as --set of run", many=True)
    variant_b: int | None = option("N", "use variant N of the sweep next to the program as B", read=integer)
    input_b: list[str] = option("CHANNEL=VALUE@S", "as --input", many=True)
    analog_b: list[str] = option("CHANNEL=PERCENT@S", "as --analog", many=True)
    answer_b: list[str] = option("TEXT", "as --answer", many=True)
    keys_b: list[str] = option("TEXT@S", "as --keys", many=True)


@dataclass
class GivenProgram(WorldOptions, ProgramOptions):
    """A program of one side, with its machine and what it receives."""

    variant: int | None = None

    @classmethod
    def of(cls, diff: Diff, side: str, file: str) -> GivenProgram:
        """Return what is given for a side, "a" or "b"."""
        own = {
            name: getattr(diff, f"{name}_{side}")
            for name in ("machine", "set", "variant", "input", "analog", "answer")
        }
        made = cls(lang=diff.lang, keys_=getattr(diff, f"keys_{side}"), **own)
        made.file = file
        made.check()
        return made


@dataclass
class Diff(Compared, WorldOptions, A, B, Language):
    """Compare two runs: programs, machines or variants, or a program and its golden files."""

    title: ClassVar[str] = "comparison"
    epilog: ClassVar[str] = """\
A and B are programs, or reports written by `run --format json`. B may also be a
recording from a real controller, in columns; it is compared with the run of A,
or with A as an older recording, as in `compare`. Without B, A is compared with
its golden files, or with itself under --set-b, --machine-b or --variant-b.
Moves, prints and events are aligned by content, so an inserted program line is
no difference.

exit status: 0 no difference; 1 a difference; 2 the command line is invalid

examples:
  motionlang diff pick.mnt                       compare with the golden files
  motionlang diff old/pick.mnt pick.mnt --tolerance time=1ms
  motionlang diff old/pick.prg pick.mnt --scenarios    in every world of A
  motionlang diff old/pick.prg pick.mnt --explore    in all ways of either
  motionlang diff pick.mnt --set-b rate=2000     two values of a constant
  motionlang diff pick.mnt --variant-a 0 --variant-b 12    of pick.sweep.toml
  motionlang diff pick.mnt drive.csv --map position.0=PosAct
"""
    a: str = argument("A", "a program, or a report")
    b: str | None = argument("B", "another one", default=None)
    scenarios: bool = flag("compare in each scenario of A, too")
    explore: bool = flag("compare two programs in all ways that an exploration of either finds")
    write_scenarios: str | None = option(
        "DIR", "with --explore: write a scenario for each difference, which passes on A and fails on B"
    )
    tolerance: list[str] = option(
        "WHAT=SIZE",
        "ignore smaller differences: time=1ms, position=0.01uu, speed=2%%; may be repeated",
        many=True,
    )
    keep: tuple[str, ...] = option(
        "NAME,…",
        "quantities to compare, such as peak.0 or cycle(12); motionlang sweep --help lists all",
        read=quantity_names,
        default=(),
    )

    def unnamed_files(self) -> list[str]:
        return [*machine_next_to(self.a), *machine_next_to(self.b)]

    def run(self) -> int:
        try:
            tolerance = Tolerance(*self.tolerance)
        except ValueError as error:
            raise WrongOption(str(error)) from None
        other = self.b
        if other is None and self._has_own_b():
            other = self.a
        if self.write_scenarios is not None and not self.explore:
            raise WrongOption("--write-scenarios needs --explore")
        if self.explore:
            return self._in_all_ways(other)
        if other is not None and is_recording(other):
            return self._recorded(other, tolerance)
        if is_recording(self.a):
            raise WrongOption("a recording as A needs another one as B; a program comes before its recording")
        if self.map or self.delay is not None:
            raise WrongOption(f"--map and --delay need a recording as B: {', '.join(RECORDED)}")
        if self.scenarios:
            return self._in_scenarios(other, tolerance)
        if other is None and self.a.lower().endswith(".json"):
            raise WrongOption("a report needs a second report or program: give B")
        if other is None:
            old, old_run = self._golden()
            new, new_run = self._side("a", self.a)
        else:
            old, old_run = self._side("a", self.a)
            new, new_run = self._side("b", other)
        if old_run is None or new_run is None:
            for name in ("keep", "plot"):
                if getattr(self, name):
                    raise WrongOption(f"--{name} needs two runs, but one side is a report")
        found = difference(old, new, tolerance)
        diverged, charges, changed = None, [], []
        kept: list[Kept] = []
        if old_run is not None and new_run is not None:
            from motionlang.commands.diff.motion import divergence

            diverged = divergence(old_run, new_run, tolerance.size("position"))
            ran = old_run.program is not None and new_run.program is not None
            if ran and (found.time or found.cycle):
                charges = charged(old_run, new_run, None if found.time else found.cycle)
            changed = changed_literals(old_run, new_run)
            values = values_of(new_run, self.keep)
            kept = [(name, old, values[name]) for name, old in values_of(old_run, self.keep).items()]
            olds = {name: old for name, old, _ in kept}
            for note in dict.fromkeys([*no_cycle_notes(old_run, olds), *no_cycle_notes(new_run, values)]):
                sys.stderr.write(f"note: {note}\n")
        lines = _lines(found, diverged, charges, changed, self.all, kept)
        document = diff_document(found, diverged, charges, changed, kept)
        self.show(document, "\n".join(lines) + "\n")
        status, page = 0 if found.same else 1, self.plot
        if page is not None and old_run is not None and new_run is not None:
            status = max(status, written(page, lambda: write_scope(new_run, page, against=old_run)))
        return status

    def _in_scenarios(self, other: str | None, tolerance: Tolerance) -> int:
        if other is None or any(each.lower().endswith(".json") for each in (self.a, other)):
            raise WrongOption("--scenarios needs two programs")
        if self.keep or self.plot:
            raise WrongOption(
                f"--{'keep' if self.keep else 'plot'} compares in one world, without --scenarios"
            )
        worlds: list[InWorld] = []
        for scenario in ["", *scenario_files(self.a)]:
            old, new = self._side("a", self.a, scenario)[0], self._side("b", other, scenario)[0]
            found = difference(old, new, tolerance)
            lines = _lines(found, None, [], [], self.all, [])
            worlds.append(InWorld(scenario or self.a, found.same, "\n".join(lines)))
        table = Table("worlds", list(map(Column, ("world", "same", "differences"))), worlds)
        shown = (f"{each.world}:{' ' if each.same else chr(10)}{each.differences}\n" for each in worlds)
        self.show(Document([table]), "".join(shown))
        return 0 if all(each.same for each in worlds) else 1

    def _in_all_ways(self, other: str | None) -> int:
        if other is None or any(
            is_recording(each) or each.lower().endswith(".json") for each in (self.a, other)
        ):
            raise WrongOption("--explore needs two programs")
        for name in ("scenarios", "keep", "tolerance", "until", "map", "delay"):
            if getattr(self, name):
                raise WrongOption(f"--{name} and --explore exclude each other")
        a = explored_program(GivenProgram.of(self, "a", self.a))
        b = explored_program(GivenProgram.of(self, "b", other), a.switches.settings)
        with playing("ways") as progress:
            found = compared_ways(Player(a), Player(b), progress=progress)
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

    def _has_own_b(self) -> bool:
        own = (self.set_b, self.machine_b, self.input_b, self.analog_b, self.answer_b, self.keys_b)
        return any(own) or self.variant_b is not None

    def _recorded(self, path: str, tolerance: Tolerance) -> int:
        if self.a.lower().endswith(".json"):
            raise WrongOption("a recording is compared with a program, but A is a report")
        result = self.a if is_recording(self.a) else self._side("a", self.a)[1]
        assert result is not None
        sizes = {"position": tolerance.size("position"), "velocity": tolerance.size("speed")}
        return self.compare_with(result, path, {name: size for name, size in sizes.items() if size})

    def _side(self, side: str, path: str, scenario: str = "") -> Side:
        if path.lower().endswith(".json"):
            return _report(path)
        given = GivenProgram.of(self, side, path)
        language = given.known_language()
        settings: dict[str, object] = given.settings()
        if scenario:
            settings = {**_layered(settings, scenario), **given_settings(given.set, language)}
        settings = with_world(with_world(settings, self.entries()), given.entries())
        overrides = given.overrides()
        try:
            if given.variant is not None:
                settings, overrides = _variant(path, given.variant, settings, overrides)
            program = given.source() if path == STDIN else path
            result = run(
                program, dialect=language.name, machine=settings, until=self.until, overrides=overrides
            )
        except OSError as error:
            raise Refused([unreadable(str(error.filename or path), error)], file=path) from None
        except ProgramError as error:
            raise Refused(error.diagnostics, file=path) from None
        except ValueError as error:
            raise Refused([Diagnostic("option", f"{path}: {error}")], file=path) from None
        complain(result.diagnostics, result.source, path)
        SIGNALS.end_with(result)
        return build(result), result

    def _golden(self) -> Side:
        path = golden_files(self.a)[0]
        if not os.path.exists(path):
            missing = Diagnostic("file", f"{self.a}: no {os.path.basename(path)} next to it", hint="give B")
            raise Refused([missing], file=self.a)
        return _report(path)


def _layered(settings: dict[str, object], scenario: str) -> dict[str, object]:
    layer = read(scenario)
    try:
        above = read_machine(layer, is_layer=True)
    except ProgramError as error:
        raise Refused(error.diagnostics, source=layer, file=scenario) from None
    both = layered(settings, above)
    both.pop("expect", None)
    return both


def _variant(
    program: str, number: int, settings: dict[str, object], overrides: dict[str, float | str]
) -> tuple[dict[str, object], dict[str, float | str]]:
    path = os.path.splitext(program)[0] + SUFFIX
    if not os.path.isfile(path):
        raise ValueError(f"there is no {os.path.basename(path)} next to it")
    variants = Variants.of_file(path)
    worlds = variants.worlds()
    made = Sweep(
        program,
        variants.space(worlds),
        machine=settings,
        overrides=overrides,
        worlds=worlds,
        until=variants.until,
    )
    if not 0 <= number < len(made.space):
        raise ValueError(f"no variant {number}: {os.path.basename(path)} has 0 to {len(made.space) - 1}")
    return made.job.of(made.space[number])


def _report(path: str) -> Side:
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return checked(json.load(file)), None
    except OSError as error:
        raise Refused([unreadable(path, error)], file=path) from None
    except (ValueError, RecursionError) as error:
        is_json = not isinstance(error, json.JSONDecodeError | RecursionError)
        why = "cannot be compared with" if is_json else "is not JSON"
        raise Refused([Diagnostic("file", f"{path} {why}: {error}")], file=path) from None


def _write_page(path: str, text: str) -> None:
    with replacing(path) as file:
        file.write(text.encode())


def _lines(
    found: Any,
    diverged: Any,
    charges: Sequence[Charge],
    changed: Sequence[ChangedLiteral],
    everything: bool,
    kept: Sequence[Kept],
) -> list[str]:
    most = MAX_LINES_OF_ALL if everything else MAX_LINES
    lines = diff_lines(found, diverged, charges, colour=wants_colour(sys.stdout), most=most)
    return [*literal_lines(changed, most), *quantity_lines(kept), *(lines or ["no difference"])]
