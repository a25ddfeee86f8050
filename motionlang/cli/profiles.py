"""`motionlang profiles`: the comparison table of PMC's technical note TN1069.

The table is computed exactly, shown as printed, or computed for any move.
"""

from __future__ import annotations

import argparse
import json
import sys
import textwrap
from collections.abc import Sequence

from motionlang.cli.complaints import unwritten
from motionlang.cli.format_options import add_format
from motionlang.cli.output_files import need_writer
from motionlang.cli.parser import Commands, add_command
from motionlang.notes.tn1069 import ERRATA, Demand, Row, comparison
from motionlang.views.grid import Column, grid
from motionlang.views.terminal import draws, plain, styled, wants_colour

SCHEMA = "motionlang.profiles/1"
# The meanings of the row names.
MEANINGS = {
    "T_A": "acceleration time",
    "S_A": "acceleration distance",
    "T_D": "deceleration time",
    "S_D": "deceleration distance",
    "S_V": "slew distance",
    "T_V": "slew time",
    "peak": "peak velocity",
    "the whole move": "duration",
}
WIDTH = 100


OPTIONS = (
    ("acceleration", "A", "acceleration, counts/s² (100000)"),
    ("velocity", "V", "velocity, counts/s (40000)"),
    ("distance", "S", "distance, counts (40000)"),
    ("deceleration", "D", "deceleration, counts/s²; default: the acceleration"),
    (
        "ramp",
        "N",
        ("the fraction of T_A in which the acceleration of the trapezoidal S-curve rises, 0 to 0.5 (0.1)"),
    ),
)


def add_options(commands: Commands, name: str, summary: str) -> None:
    """Add the command `name` with the options of the note."""
    parser = add_command(commands, name, summary, profiles_command)
    for option, letter, help in OPTIONS:
        parser.add_argument(f"--{option}", type=float, metavar=letter, help=help)
    parser.add_argument(
        "--published",
        action="store_true",
        help="show the published figures next to the exact ones, and list the errata",
    )
    parser.add_argument("--plot", metavar="FILE", help="draw the four profiles into a .png or .svg file")
    add_format(parser)


def profiles_command(arguments: argparse.Namespace) -> int:
    """Print the table, and draw it on request; exit with 2 if the move is impossible."""
    parser = arguments.parser
    given = {name: value for name, *_ in OPTIONS if (value := getattr(arguments, name)) is not None}
    try:
        demand = Demand(**given)
        rows = comparison(demand)
    except (ValueError, OverflowError) as problem:
        parser.error(str(problem))
    if arguments.published and not demand.printed:
        parser.error("--published works only for the move of the note")
    if arguments.plot:
        if not arguments.plot.lower().endswith((".png", ".svg")):
            parser.error("--plot writes .png and .svg files")
        need_writer("--plot", arguments.plot)
        status = _draw(demand, arguments.plot)
        if status:
            return status
    if arguments.format == "json":
        sys.stdout.write(json.dumps(_data(demand, rows), indent=1) + "\n")
        return 0
    text = "\n".join(_lines(demand, rows, arguments.published, wants_colour(sys.stdout))) + "\n"
    sys.stdout.write(text if draws(sys.stdout) else plain(text))
    return 0


def _draw(demand: Demand, path: str) -> int:
    """Draw the four profiles; 1 if the file cannot be written, which is reported."""
    from motionlang.views.diagnostics import render
    from motionlang.views.profiles_plot import draw_profiles

    try:
        draw_profiles(demand, path)
    except OSError as problem:
        diagnostic = unwritten(path, problem)
    else:
        return 0
    sys.stderr.write(render(diagnostic, None))
    return 1


def _lines(demand: Demand, rows: Sequence[Row], as_printed: bool, colour: bool) -> list[str]:
    head = "TN1069: one move in four profiles"
    slowing = "" if demand.symmetric else f"D = {demand.deceleration:.10g} counts/s², "
    given = (
        f"A = {demand.acceleration:.10g} counts/s², {slowing}V = {demand.velocity:.10g} counts/s, S = "
        f"{demand.distance:.10g} counts; 1000 cycles per second"
    )
    lines = [styled(head, "bold", colour), given, ""]
    lines += _table(demand, rows, as_printed, colour)
    if as_printed:
        lines += ["", styled("the printed figure is wrong", "bold", colour)]
        for number, erratum in enumerate(ERRATA, 1):
            lines += textwrap.wrap(erratum, WIDTH, initial_indent=f"{number}. ", subsequent_indent="   ")
    return lines


def _table(demand: Demand, made: Sequence[Row], as_printed: bool, colour: bool) -> list[str]:
    columns = [
        Column("", align="<"),
        Column("", align="<"),
        *(Column(name) for name in demand.columns),
        Column("", align="<"),
    ]
    rows, styles = [], []
    for row in made:
        rows.append([row.name, MEANINGS.get(row.name, ""), *map(_exact, row.exact), row.unit])
        styles.append("")
        if as_printed and row.printed is not None:
            rows.append(["", "as printed", *(f"{value:.10g}" for value in row.printed), ""])
            styles.append("dim")
    return grid(columns, rows, width=10 * WIDTH, colour=colour, styles=styles)


def _exact(value: float | None) -> str:
    return "none" if value is None else f"{value:.10g}"


def _data(demand: Demand, rows: Sequence[Row]) -> dict[str, object]:
    return {
        "schema": SCHEMA,
        "given": {name: getattr(demand, name) for name, *_ in OPTIONS},
        "profiles": list(demand.columns),
        "rows": [
            {
                "name": row.name,
                "unit": row.unit,
                "exact": list(row.exact),
                "printed": None if row.printed is None else list(row.printed),
            }
            for row in rows
        ],
        "errata": list(ERRATA) if demand.printed else [],
    }
