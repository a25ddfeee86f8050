"""Columns of text, lined up by rich; the least important columns are dropped where a terminal is narrow."""

from __future__ import annotations

from motionlang.views.terminal import cells, console, styled

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.table import Table

GAP = 2
# Nothing but a rule below the head, which runs through the gaps: rich's way to draw a box, line by line.
BOX = "    \n    \n ── \n    \n    \n    \n    \n    \n"


class Column:
    """`title` over `unit`; `align` "<" or ">"; the columns with the highest `drop` go first when room is short.

    `drop` 0 means that the column stays whatever happens. `style` colours its cells.
    """

    __slots__ = ("align", "drop", "style", "title", "unit")

    def __init__(self, title: str, unit: str = "", align: str = ">", drop: int = 0, style: str = "") -> None:
        self.title, self.unit, self.align, self.drop, self.style = title, unit, align, drop, style


def grid(
    columns: Sequence[Column],
    rows: Sequence[Sequence[str]],
    *,
    width: int,
    colour: bool = False,
    styles: Sequence[str] = (),
) -> list[str]:
    """The lines of a table, header and rule first; `styles` may name a style for each row."""
    kept = _kept(columns, rows, width)
    screen = console(colour)
    with screen.capture() as captured:
        screen.print(_table([columns[k] for k in kept], [[row[k] for k in kept] for row in rows], styles))
    lines = [line.rstrip() for line in captured.get().splitlines()]
    return [styled(line, "dim", colour) if set(line) == {"─"} else line for line in lines]


def decimals_of(values: Sequence[float], most: int = 4) -> int:
    """The fewest decimals that show all of `values`, at most `most`, more where all are small."""
    largest = max((abs(value) for value in values), default=0.0)
    while most < 12 and 0.0 < largest < 10.0 ** (2 - most):
        most += 1
    for decimals in range(most):
        if all(abs(value - round(value, decimals)) <= 1e-9 * max(1.0, abs(value)) for value in values):
            return decimals
    return most


def _kept(columns: Sequence[Column], rows: Sequence[Sequence[str]], width: int) -> list[int]:
    """The columns for which there is room; one without a word in it is left out as well."""
    kept = [k for k in range(len(columns)) if not columns[k].drop or any(row[k] for row in rows)]
    widths = {
        k: max(map(cells, (columns[k].title, columns[k].unit, *(row[k] for row in rows)))) for k in kept
    }
    while sum(widths[k] + GAP for k in kept) - GAP > width and any(columns[k].drop for k in kept):
        kept.remove(max(kept, key=lambda k: columns[k].drop))
    return kept


def _table(columns: Sequence[Column], rows: Sequence[Sequence[str]], styles: Sequence[str]) -> Table:
    from rich.box import Box
    from rich.table import Table
    from rich.text import Text

    table = Table(box=Box(BOX), show_edge=False, pad_edge=False, padding=(0, GAP - 1, 0, 0), header_style="")
    units = any(column.unit for column in columns)
    for column in columns:
        head = [(column.title, "bold"), *([("\n", ""), (column.unit, "dim")] if units else [])]
        table.add_column(
            Text.assemble(*head), justify="left" if column.align == "<" else "right", no_wrap=True
        )
    for i, row in enumerate(rows):
        style = styles[i] if styles else ""
        # Assembled, so that the style is the word's alone and not that of the blanks around it.
        paints = [style or column.style for column in columns]
        table.add_row(*(Text.assemble(pair) for pair in zip(row, paints, strict=True)))
    return table
