"""The options of `motionlang sweep`."""

from __future__ import annotations

import argparse

from motionlang.analysis.quantities import ROWS
from motionlang.cli.format_options import add_format
from motionlang.cli.machine_options import add_machine
from motionlang.cli.numbers import machine_time, whole
from motionlang.cli.parser import add_all, arrange, flag, option
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


_VARIANTS = (
    option("file", "FILE", "the program; pick.sweep.toml next to pick.mnt has defaults for the options"),
    option("--vary", "NAME=VALUES", "vary a name of the program, or a key of the machine file by its dotted name: "
           "FIRST:LAST:COUNT or A,B,C; may be repeated, and each combination is a variant",
           action="append", default=[]),
    option("--machines", "DIR", "run on every machine file of a folder instead of the program's"),
    option("--scenarios", "DIR", "run in every scenario of a folder, each overlaid on the machine file"),
    option("--random", "N", "run a random sample of N variants", _COUNT),
    option("--latin", "N", "run a Latin hypercube sample of N variants", _COUNT),
    option("--seed", "S", "the seed of the sample (0)", int),
    option("--keep", "NAMES", "quantities to record, separated by commas (time); see the list below"),
    option("--until", "S", "end every run after S seconds of machine time", machine_time),
    flag("--prove", "verify the motion of every variant against the commanded limits"),
    flag("--certify", "a variant fails if it exceeds a limit of the machine file"),
)  # fmt: skip


_SELECTION = (
    option("--minimise", "EXPR", "find the variant with the smallest value"),
    option("--maximise", "EXPR", "find the variant with the largest value"),
    option("--where", "EXPR", "consider only variants for which this is true"),
    option("--pareto", "A,B", "find the Pareto front of these quantities"),
    option("--rows-to", "ROWS", "write every row into a file: .csv or .parquet", dest="out"),
    flag("--resume", "continue an interrupted sweep"),
    option("--plot", "PICTURE", "draw the rows into a .png or .svg file: a line for one varied name, a heat map for "
           "two, or the Pareto front"),
)  # fmt: skip


_OUTPUT = (
    option("--rows", "N", f"rows of the table ({MAX_ROWS}); 0 for all", _ROWS, default=MAX_ROWS),
    option("-j --jobs", "N", "worker processes; default: one per core", _COUNT),
)  # fmt: skip


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of `sweep`."""
    add_machine(parser)
    add_world(parser)
    add_all(parser, _VARIANTS)
    add_all(parser, _SELECTION)
    add_format(parser, FORMATS, "the printed rows (csv and json have all)")
    add_all(parser, _OUTPUT)
    arrange(parser, GROUPS)
