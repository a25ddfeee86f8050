"""The options of `motionlang sweep`."""

from __future__ import annotations

import argparse

from motionlang.analysis.sweeps.quantities import ROWS
from motionlang.cli.format_options import add_format
from motionlang.cli.machine_options import add_machine
from motionlang.cli.numbers import machine_time, whole
from motionlang.cli.parser import arrange
from motionlang.cli.world_options import add_world

FORMATS = ("table", "csv", "json", "none")
# Rows of the table without --rows.
MAX_ROWS = 20
_MAX_COUNT = 999_999_999
_COUNT = whole("a whole number above 0", 1, _MAX_COUNT)
_ROWS = whole("a whole number, 0 or more", 0, _MAX_COUNT)
EPILOG = f"""\
Each variant is a complete run. Quantities for --keep:
{chr(10).join(f"  {row.name:<13} {row.help}{f', {row.unit}' if row.unit else ''}" for row in ROWS)}

Expressions may use these names, the varied names, numbers, + - * / % **, comparisons, and, or, not, abs, min, max.
Ctrl-C keeps the finished rows; --resume continues.

exit status: 0 all variants succeeded; 1 some failed; 2 the command line is invalid; 130 Ctrl-C

examples:
  motionlang sweep pick.mnt --vary rate=500:5000:10 --vary gain=1,2,4 --keep time,peak.0
  motionlang sweep pick.mnt --vary rate=500:5000 --latin 200 --minimise time --where "peak.0 < 400"
  motionlang sweep pick.mnt --scenarios pick.scenarios --keep time,status,prints --rows-to worlds.csv
  motionlang sweep pick.mnt --vary axis.0.plant.load_inertia=1e-5:1e-4:50 --keep time,torque.0 --plot load.png
"""

GROUPS = {
    "program": "dialect machine set",
    "variants": "vary machines scenarios random latin seed",
    "runs": "keep until prove certify jobs",
    "selection": "minimise maximise where pareto",
    "report": "format quiet output rows rows-to resume",
    "pictures": "plot",
}


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `sweep`."""
    add = parser.add_argument
    add(
        "file",
        metavar="FILE",
        help="the program; pick.sweep.toml next to pick.mnt has defaults for the options",
    )
    add_machine(parser)
    add_world(parser)
    add(
        "--vary",
        action="append",
        default=[],
        metavar="NAME=VALUES",
        help=(
            "vary a name of the program, or a key of the machine file by its dotted name: "
            "FIRST:LAST:COUNT or A,B,C; may be repeated, and each combination is a variant"
        ),
    )
    add("--machines", metavar="DIR", help="run on every machine file of a folder instead of the program's")
    add(
        "--scenarios",
        metavar="DIR",
        help="run in every scenario of a folder, each overlaid on the machine file",
    )
    add("--random", type=_COUNT, metavar="N", help="run a random sample of N variants")
    add(
        "--latin",
        type=_COUNT,
        metavar="N",
        help="run a Latin hypercube sample of N variants",
    )
    add(
        "--seed",
        type=int,
        metavar="S",
        help="the seed of the sample (0)",
    )
    add(
        "--keep", metavar="NAMES", help="quantities to record, separated by commas (time); see the list below"
    )
    add("--until", type=machine_time, metavar="S", help="end every run after S seconds of machine time")
    add(
        "--prove",
        action="store_true",
        help="verify the motion of every variant against the commanded limits",
    )
    add(
        "--certify",
        action="store_true",
        help="a variant fails if it exceeds a limit of the machine file",
    )
    _add_output(parser)
    arrange(parser, GROUPS)


def _add_output(parser: argparse.ArgumentParser) -> None:
    """Add the options of the search and of the output."""
    add = parser.add_argument
    add("--minimise", metavar="EXPR", help="find the variant with the smallest value")
    add("--maximise", metavar="EXPR", help="find the variant with the largest value")
    add("--where", metavar="EXPR", help="consider only variants for which this is true")
    add("--pareto", metavar="A,B", help="find the Pareto front of these quantities")
    add("--rows-to", dest="out", metavar="ROWS", help="write every row into a file: .csv or .parquet")
    add("--resume", action="store_true", help="continue an interrupted sweep")
    add(
        "--plot",
        metavar="PICTURE",
        help=(
            "draw the rows into a .png or .svg file: a line for one varied name, a heat map for two, or "
            "the Pareto front"
        ),
    )
    add_format(parser, FORMATS, "the printed rows (csv and json have all)")
    add(
        "--rows",
        type=_ROWS,
        default=MAX_ROWS,
        metavar="N",
        help=f"rows of the table ({MAX_ROWS}); 0 for all",
    )
    add(
        "-j",
        "--jobs",
        type=_COUNT,
        metavar="N",
        help="worker processes; default: one per core",
    )
