"""`motionlang diff A [B]`: compare two runs, or a run with its golden files.

B may also be a recording from a real controller.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
from collections.abc import Sequence
from typing import Any

from motionlang.analysis.diff.charged import Charge, charged
from motionlang.analysis.diff.literals import ChangedLiteral, changed_literals
from motionlang.analysis.diff.reports import checked, difference
from motionlang.analysis.diff.tolerance import Tolerance
from motionlang.analysis.quantities import values_of
from motionlang.cli.compare import add_mapping, compare_with
from motionlang.cli.complaints import complain, no_dialect, unreadable
from motionlang.cli.dialect_option import add_dialect
from motionlang.cli.format_options import add_format
from motionlang.cli.golden import golden_files
from motionlang.cli.machine_options import set_values
from motionlang.cli.numbers import machine_time, quantity_names
from motionlang.cli.output_files import written
from motionlang.cli.parser import Commands, add_all, add_command, arrange, flag, option
from motionlang.cli.signals import SIGNALS
from motionlang.cli.world_options import add_world, with_world, world_of
from motionlang.errors import ProgramError
from motionlang.execution import dialect_of, language_of, machine_of, run
from motionlang.lang.machine.file import read_machine
from motionlang.record import as_dict
from motionlang.report import build
from motionlang.result import Run
from motionlang.source import Source

EPILOG = """\
A and B are programs, or reports written by `run --format json`. B may also be a recording from a real controller, in
columns; it is compared with the run of A as in `compare`. Without B, A is compared with its golden files, or with
itself under --set-b, --machine-b or --variant-b. Moves, prints and events are aligned by content, so an inserted
program line is no difference.

exit status: 0 no difference; 1 a difference; 2 the command line is invalid

examples:
  motionlang diff pick.mnt                                compare with the golden files
  motionlang diff old/pick.mnt pick.mnt --tolerance time=1ms
  motionlang diff pick.mnt --set-b rate=2000              compare two values of a constant
  motionlang diff pick.mnt --machine-b worn.machine.toml
  motionlang diff pick.mnt --variant-a 0 --variant-b 12   compare two variants of pick.sweep.toml
  motionlang diff pick.mnt drive.csv --map position.0=PosAct --tolerance position=0.05uu
"""
SCHEMA = "motionlang.diff/2"
# The suffixes of a recording; any other file is a program or a report.
RECORDED = (".csv", ".tsv", ".dat")

GROUPS = {
    "program": "dialect",
    "two sides": "machine-a set-a variant-a machine-b set-b variant-b until",
    "recording": "map delay",
    "report": "format output all keep tolerance",
    "pictures": "plot",
}


# The name of a quantity, and its value in both runs.
Compared = tuple[str, object, object]

_OPTIONS = (
    option("--tolerance", "WHAT=SIZE", "ignore smaller differences: time=1ms, position=0.01uu, speed=2%%; may be "
           "repeated", action="append", default=[]),
    option("--until", "S", "end the runs after S seconds of machine time", machine_time),
    option("--plot", "PAGE", "draw both runs into an .html page"),
    option("--keep", "NAME,…", "quantities to compare, such as peak.0 or cycle(12); motionlang sweep --help lists all",
           quantity_names, default=()),
    flag("--all", "list every difference, not only the first ones of each kind"),
)  # fmt: skip


def add_parser(commands: Commands, summary: str) -> None:
    """Add `motionlang diff` and its options."""
    parser = add_command(commands, "diff", summary, diff_command, EPILOG)
    add = parser.add_argument
    add("a", metavar="A", help="a program, or a report")
    add("b", metavar="B", nargs="?", help="another one")
    add_dialect(parser)
    for side in "ab":
        add(
            f"--machine-{side}",
            metavar="M.toml",
            help=f"the machine file of {side.upper()}; default: the one next to it",
        )
        add(
            f"--set-{side}",
            action="append",
            default=[],
            metavar="NAME=VALUE",
            help=f"set a value for {side.upper()}, as --set of run",
        )
        add(
            f"--variant-{side}",
            type=int,
            metavar="N",
            help=f"use variant N of the sweep next to the program as {side.upper()}",
        )
    add_world(parser)
    for side in "ab":
        add_world(parser, side)
    add_mapping(parser)
    add_all(parser, _OPTIONS)
    add_format(parser)
    arrange(parser, GROUPS)


def diff_command(arguments: argparse.Namespace) -> int:
    """Compare, print the result, and return the exit status."""
    parser = arguments.parser
    try:
        tolerance = Tolerance(*arguments.tolerance)
    except ValueError as error:
        parser.error(str(error))
    if arguments.plot is not None and not arguments.plot.lower().endswith(".html"):
        parser.error("--plot writes .html files here")
    other = arguments.b
    if other is None and (
        arguments.set_b or arguments.machine_b or arguments.variant_b is not None or world_of(arguments, "b")
    ):
        other = arguments.a
    if other is not None and other.lower().endswith(RECORDED) and dialect_of(other) is None:
        return _recorded(arguments, other, tolerance)
    if arguments.map or arguments.delay is not None:
        parser.error(f"--map and --delay need a recording as B: {', '.join(RECORDED)}")
    if other is None and arguments.a.lower().endswith(".json"):
        parser.error("a report needs a second report or program: give B")
    golden = other is None
    sides = []
    for side, path in (("a", arguments.a), ("b", other)):
        read = _golden(arguments.a) if path is None else _side(arguments, side, path)
        if read is None:
            return 1
        sides.append(read)
    if golden:
        sides.reverse()  # the old one comes first
    (old, old_run), (new, new_run) = sides
    found = difference(old, new, tolerance)
    diverged, charges, changed = None, [], []
    if old_run is not None and new_run is not None:
        from motionlang.analysis.diff.motion import divergence

        diverged = divergence(old_run, new_run, tolerance.size("position"))
        ran = old_run.program is not None and new_run.program is not None
        charges = charged(old_run, new_run) if ran and found.time is not None else []
        changed = changed_literals(old_run, new_run)
    if arguments.keep and (old_run is None or new_run is None):
        parser.error("--keep needs two runs, but one side is a report")
    kept: list[Compared] = []
    if old_run is not None and new_run is not None:
        new_values = values_of(new_run, arguments.keep)
        kept = [(name, old, new_values[name]) for name, old in values_of(old_run, arguments.keep).items()]
    if arguments.format == "json":
        data = _data(found, diverged, charges, changed)
        if kept:
            data["quantities"] = [dict(zip(("name", "old", "new"), each, strict=True)) for each in kept]
        sys.stdout.write(json.dumps(data, default=vars) + "\n")
    else:
        _print(found, diverged, charges, changed, arguments.all, kept)
    status = 0 if found.same else 1
    if arguments.plot is not None:
        status = max(status, _plot(old_run, new_run, arguments.plot, parser))
    return status


def _recorded(arguments: argparse.Namespace, path: str, tolerance: Tolerance) -> int:
    """Compare a run with a recording and return the exit status."""
    if arguments.a.lower().endswith(".json"):
        arguments.parser.error("a recording is compared with a program, but A is a report")
    read = _side(arguments, "a", arguments.a)
    if read is None or read[1] is None:
        return 1
    sizes = {"position": tolerance.size("position"), "velocity": tolerance.size("speed")}
    return compare_with(read[1], path, {name: size for name, size in sizes.items() if size}, arguments)


def _plot(old: Run | None, new: Run | None, path: str, parser: argparse.ArgumentParser) -> int:
    """Draw the new run in front of the old one; return 1 on failure."""
    if old is None or new is None:
        parser.error("--plot needs two runs, but one side is a report")
    from motionlang.views.scope import write_scope

    return written(path, lambda: write_scope(new, path, against=old))


def _side(arguments: argparse.Namespace, side: str, path: str) -> tuple[dict[str, Any], Run | None] | None:
    """Return the report of one side, and its run if it is a program.

    Returns None if there is no report; the reason has been printed.
    """
    try:
        if path.lower().endswith(".json"):
            return _report(path)
        language = language_of(arguments.dialect, path)
        if language is None:
            complain([no_dialect(path)], None, path)
            return None
        settings: dict[str, object] = {}
        overrides: dict[str, float | str] = {}
        set_values(getattr(arguments, f"set_{side}"), settings, overrides, arguments.parser, language)
        machine = machine_of(path, getattr(arguments, f"machine_{side}"))
        if machine is not None:
            try:
                settings = read_machine(Source.read(machine), language=language) | settings
            except ProgramError as error:
                complain(error.diagnostics, Source.read(machine), machine)
                return None
        for whose in ("", side):
            laid = with_world(settings, world_of(arguments, whose), path)
            if laid is None:
                return None
            settings = laid
        variant = getattr(arguments, f"variant_{side}")
        if variant is not None:
            settings, overrides = _variant(path, variant, settings, overrides)
        result = run(
            path, dialect=arguments.dialect, machine=settings, until=arguments.until, overrides=overrides
        )
        if result.diagnostics:
            complain(result.diagnostics, result.source, path)
        SIGNALS.end_with(result)
        return build(result), result
    except OSError as error:
        complain([unreadable(str(error.filename or path), error)], None, path)
    except ProgramError as error:
        complain(error.diagnostics, None, path)
    except ValueError as error:
        sys.stderr.write(f"{path}: {error}\n")
    return None


def _variant(
    program: str, number: int, settings: dict[str, object], overrides: dict[str, float | str]
) -> tuple[dict[str, object], dict[str, float | str]]:
    """Return settings and overrides of a variant of the program's sweep.

    Raises ValueError if there is no such variant.
    """
    from motionlang.analysis.sweeps import Sweep
    from motionlang.analysis.sweeps.description import SUFFIX, read_description

    path = os.path.splitext(program)[0] + SUFFIX
    if not os.path.isfile(path):
        raise ValueError(f"there is no {os.path.basename(path)} next to it")
    description = read_description(path)
    worlds = description.worlds()
    made = Sweep(
        program,
        description.space(worlds),
        machine=settings,
        overrides=overrides,
        worlds=worlds,
        until=description.until,
    )
    if not 0 <= number < len(made.space):
        raise ValueError(f"no variant {number}: {os.path.basename(path)} has 0 to {len(made.space) - 1}")
    return made.job.of(made.space[number])


def _golden(program: str) -> tuple[dict[str, Any], Run | None] | None:
    path = golden_files(program)[0]
    if not os.path.exists(path):
        sys.stderr.write(f"{program}: no {os.path.basename(path)} next to it; give B\n")
        return None
    try:
        return _report(path)
    except OSError as error:
        complain([unreadable(path, error)], None, path)
        return None


def _report(path: str) -> tuple[dict[str, Any], None] | None:
    """Read a report from a file; return None if it is not a report or is truncated."""
    with open(path, encoding="utf-8", errors="replace") as file:
        try:
            found = json.load(file)
        except (ValueError, RecursionError) as error:
            sys.stderr.write(f"{path} is not JSON: {error}\n")
            return None
    try:
        return checked(found), None
    except ValueError as error:
        sys.stderr.write(f"{path} cannot be compared with: {error}\n")
        return None


def _data(
    found: Any, diverged: Any, charges: Sequence[Charge], changed: Sequence[ChangedLiteral]
) -> dict[str, Any]:
    return {
        "schema": SCHEMA,
        "equal": found.same,
        "literals": [as_dict(each) for each in changed],
        "time": found.time,
        "time_by_line": [as_dict(each) for each in charges],
        "status": found.status,
        "lines": [as_dict(each) for each in found.lines],
        "removed_moves": found.removed,
        "added_moves": found.new,
        "prints": [
            dict(zip(("old", "new", "old_text", "new_text"), each, strict=True)) for each in found.prints
        ],
        "events": [dict(zip(("old", "new", "shift"), each, strict=True)) for each in found.events],
        "errors": [{"change": change, "message": message} for change, message in found.errors],
        "other_differences": found.others,
        "divergence": None if diverged is None else as_dict(diverged),
    }


def _print(
    found: Any,
    diverged: Any,
    charges: Sequence[Charge],
    changed: Sequence[ChangedLiteral],
    everything: bool,
    kept: Sequence[Compared],
) -> None:
    from motionlang.views.diff import MAX_LINES, diff_lines, literal_lines, quantity_lines
    from motionlang.views.terminal import draws, plain, wants_colour

    most = 1_000_000 if everything else MAX_LINES
    lines = diff_lines(found, diverged, charges, colour=wants_colour(sys.stdout), most=most) or [
        "no difference"
    ]
    text = "\n".join([*literal_lines(changed, most), *quantity_lines(kept), *lines]) + "\n"
    sys.stdout.write(text if draws(sys.stdout) else plain(text).replace("→", "->"))
