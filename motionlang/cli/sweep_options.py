"""The options of `motionlang sweep`."""

from __future__ import annotations

import argparse

from motionlang.analysis.sweeps.quantities import ROWS
from motionlang.cli.machine_options import add_machine
from motionlang.cli.run_options import machine_time
from motionlang.cli.world_options import add_world

REPORTS = ("table", "csv", "none")
# Rows of the table without --rows.
MOST_ROWS = 20
EPILOG = f"""\
Every variant is a whole run. What can be kept of one:
{chr(10).join(f"  {row.name:<13} {row.help}{f', {row.unit}' if row.unit else ''}" for row in ROWS)}

Expressions have these names and those that are varied, numbers, + - * / % **, comparisons, and, or, not, abs, min, max.
Ctrl-C keeps the rows that are there; --resume goes on.

exit status: 0 every variant ran well; 1 some did not; 2 the command line is wrong; 130 Ctrl-C

examples:
  motionlang sweep pick.mnt --vary rate=500:5000:10 --vary gain=1,2,4 --keep time,peak.0
  motionlang sweep pick.mnt --vary rate=500:5000 --latin 200 --minimise time --where "peak.0 < 400"
  motionlang sweep pick.mnt --scenarios pick.scenarios --keep time,status,prints --out worlds.csv
  motionlang sweep pick.mnt --vary axis.0.plant.load_inertia=1e-5:1e-4:50 --keep time,torque.0 --plot load.png
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `sweep`."""
    add = parser.add_argument
    add(
        "file", metavar="FILE", help="the program; pick.sweep.toml beside pick.mnt says what is not said here"
    )
    add_machine(parser)
    add_world(parser)
    add(
        "--vary",
        action="append",
        default=[],
        metavar="NAME=VALUES",
        help="a name of the program, or by a dotted name a key of the machine file: FIRST:LAST:COUNT or A,B,C; "
        "may be repeated: every combination is a variant",
    )
    add(
        "--machines", metavar="DIR", help="run on every machine file of a folder instead of the program's own"
    )
    add(
        "--scenarios",
        metavar="DIR",
        help="run in every scenario of a folder, each on top of the machine file",
    )
    add("--random", type=_count, metavar="N", help="draw N variants at random instead of running them all")
    add(
        "--latin",
        type=_count,
        metavar="N",
        help="draw N variants as a Latin hypercube, which covers more with fewer",
    )
    add(
        "--seed",
        type=int,
        metavar="S",
        help="the beginning of what is drawn (0): the same for the same variants",
    )
    add("--keep", metavar="NAMES", help="what is kept of each run, by commas (time); the list is below")
    add("--until", type=machine_time, metavar="S", help="end every run after S seconds of machine time")
    add(
        "--prove",
        action="store_true",
        help="hold the motion of every variant against what the program ordered",
    )
    add(
        "--certify",
        action="store_true",
        help="a variant that passes a limit of the machine file is a bad one",
    )
    add("--minimise", metavar="EXPR", help="tell the variant for which this is smallest")
    add("--maximise", metavar="EXPR", help="tell the variant for which this is largest")
    add("--where", metavar="EXPR", help="of those only for which this is true")
    add("--pareto", metavar="A,B", help="tell the variants than which no other is better in all of these")
    add("--out", metavar="ROWS", help="write every row into a file: .csv or .parquet")
    add("--resume", action="store_true", help="go on with what a sweep that was ended has left beside --out")
    add(
        "--plot",
        metavar="PICTURE",
        help="draw the rows: a line over one name, a heat map over two, or the front (.png, .svg)",
    )
    add(
        "--report",
        choices=REPORTS,
        default="table",
        help="what is printed: a table (the default), all rows as CSV, nothing",
    )
    add(
        "--rows",
        type=_rows,
        default=MOST_ROWS,
        metavar="N",
        help=f"rows of the table ({MOST_ROWS}); 0 is all",
    )
    add(
        "--jobs",
        type=_count,
        metavar="N",
        help="processes that run at a time; without it as many as there are processors",
    )


def _count(text: str) -> int:
    if not text.isascii() or not text.isdigit() or not int(text[:12]) > 0 or len(text) > 9:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number above 0")
    return int(text)


def _rows(text: str) -> int:
    return 0 if text == "0" else _count(text)
