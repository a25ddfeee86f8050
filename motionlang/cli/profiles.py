"""`motionlang profiles`: the comparison table of PMC's technical note TN1069, exact, and as it was printed."""

from __future__ import annotations

import json
import sys
import textwrap

from motionlang.profile.tn1069 import ACCELERATION, COLUMNS, DISTANCE, ERRATA, VELOCITY, comparison
from motionlang.views.grid import Column, grid
from motionlang.views.terminal import draws, plain, styled, wants_colour

SCHEMA = "motionlang.profiles/1"
# What the names of the rows stand for.
MEANINGS = {
    "T_A": "acceleration time",
    "S_A": "acceleration distance",
    "S_V": "slew distance",
    "T_V": "slew time",
    "peak": "peak velocity",
    "the whole move": "duration",
}
WIDTH = 100


def profiles_command(as_printed: bool, as_json: bool) -> int:
    """Print the table; 0."""
    if as_json:
        sys.stdout.write(json.dumps(_data(), indent=1) + "\n")
        return 0
    text = "\n".join(_lines(as_printed, wants_colour(sys.stdout))) + "\n"
    sys.stdout.write(text if draws(sys.stdout) else plain(text))
    return 0


def _lines(as_printed: bool, colour: bool) -> list[str]:
    head = "TN1069: one move in four profiles"
    given = f"A = {ACCELERATION:g} counts/s², V = {VELOCITY:g} counts/s, S = {DISTANCE:g} counts; 1000 cycles a second"
    lines = [styled(head, "bold", colour), given, ""]
    lines += _table(as_printed, colour)
    if as_printed:
        lines += ["", styled("the print is wrong here", "bold", colour)]
        for number, erratum in enumerate(ERRATA, 1):
            lines += textwrap.wrap(erratum, WIDTH, initial_indent=f"{number}. ", subsequent_indent="   ")
    return lines


def _table(as_printed: bool, colour: bool) -> list[str]:
    columns = [
        Column("", align="<"),
        Column("", align="<"),
        *(Column(name) for name in COLUMNS),
        Column("", align="<"),
    ]
    rows, styles = [], []
    for row in comparison():
        rows.append([row.name, MEANINGS.get(row.name, ""), *map(_exact, row.exact), row.unit])
        styles.append("")
        if as_printed and row.printed is not None:
            rows.append(["", "as printed", *(f"{value:.10g}" for value in row.printed), ""])
            styles.append("dim")
    return grid(columns, rows, width=10 * WIDTH, colour=colour, styles=styles)


def _exact(value: float | None) -> str:
    return "none" if value is None else f"{value:.10g}"


def _data() -> dict[str, object]:
    return {
        "schema": SCHEMA,
        "given": {"acceleration": ACCELERATION, "velocity": VELOCITY, "distance": DISTANCE},
        "profiles": list(COLUMNS),
        "rows": [
            {
                "name": row.name,
                "unit": row.unit,
                "exact": list(row.exact),
                "printed": None if row.printed is None else list(row.printed),
            }
            for row in comparison()
        ],
        "errata": list(ERRATA),
    }
