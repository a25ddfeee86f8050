"""The rows of a sweep on a terminal."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.views.grid import Column, grid
from motionlang.views.terminal import printable, styled

# The largest number of characters of a text in a cell.
MAX_LETTERS = 40


def sweep_table(
    names: Sequence[str],
    units: Sequence[str],
    rows: Sequence[Sequence[object]],
    *,
    width: int,
    colour: bool = False,
    best: int | None = None,
) -> list[str]:
    """Return the lines of a table of `rows`; the row with the index `best` is marked."""
    columns = [
        Column(
            name, unit, "<" if any(isinstance(row[k], str) for row in rows) else ">", drop=k if k > 1 else 0
        )
        for k, (name, unit) in enumerate(zip(names, units, strict=True))
    ]
    styles = ["accel" if n == best else "" for n in range(len(rows))]
    return grid(
        columns, [[cell(value) for value in row] for row in rows], width=width, colour=colour, styles=styles
    )


def cell(value: object) -> str:
    """Format a value of a row: a number to six digits, a text truncated to one line."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return f"{value:.6g}"
    lines = str(value).split("\n")
    text = printable(" · ".join(lines))
    return text if len(text) <= MAX_LETTERS else text[: MAX_LETTERS - 1] + "…"


def heading(text: str, colour: bool) -> str:
    """Return a line above a table."""
    return styled(text, "bold", colour)
