"""Aligned columns of text.

Cell widths are computed by rich. On a narrow terminal the least important columns are dropped.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any

from motionlang.views.terminal import cells, styled

# The cells of a table by the head of their column, as in `headed`.
Cells = dict[str, Callable[[Any], str]]

GAP = 2


class Column:
    """A column of a grid, with `title` over `unit`; `align` is "<" or ">".

    Columns with the highest `drop` are removed first if the table is too wide; 0 means never. `style` colours the
    cells.
    """

    __slots__ = ("align", "drop", "style", "title", "unit")

    def __init__(self, title: str, unit: str = "", align: str = ">", drop: int = 0, style: str = "") -> None:
        self.title, self.unit, self.align, self.drop, self.style = title, unit, align, drop, style


def headed(*texts: str) -> list[Column]:
    """Return columns of "title, unit"; those with < before the title are aligned left."""
    made = []
    for text in texts:
        title, _, unit = text.removeprefix("<").partition(", ")
        made.append(Column(title, unit, "<" if text.startswith("<") else ">"))
    return made


def filled(table: Cells, rows: Iterable[Any], *, width: int) -> list[str]:
    """Return the lines of a table with a row for each of `rows`."""
    return grid(headed(*table), [[cell(row) for cell in table.values()] for row in rows], width=width)


def grid(
    columns: Sequence[Column],
    rows: Sequence[Sequence[str]],
    *,
    width: int,
    colour: bool = False,
    styles: Sequence[str] = (),
) -> list[str]:
    """Return the lines of a table, beginning with header and rule.

    `styles` may name a style for each row.
    """
    indices, widths = _shown_columns(columns, rows, width)
    columns = [columns[k] for k in indices]
    heads = [([column.title for column in columns], "bold")]
    if any(column.unit for column in columns):
        heads.append(([column.unit for column in columns], "dim"))
    lines = [_line(columns, widths, texts, [style] * len(indices), colour) for texts, style in heads]
    # The rule runs through the gaps.
    lines.append(styled("─" * (sum(widths) + GAP * (len(indices) - 1)), "dim", colour))
    paints = [column.style for column in columns]
    for i, row in enumerate(rows):
        paint = [styles[i]] * len(indices) if styles and styles[i] else paints
        lines.append(_line(columns, widths, [row[k] for k in indices], paint, colour))
    return lines


def decimals_of(values: Sequence[float], most: int = 4) -> int:
    """Return the fewest decimals that show all of `values`, at most `most`.

    The result may exceed `most` if all values are small.
    """
    largest = max((abs(value) for value in values), default=0.0)
    while most < 12 and 0.0 < largest < 10.0 ** (2 - most):
        most += 1
    for decimals in range(most):
        if all(abs(value - round(value, decimals)) <= 1e-9 * max(1.0, abs(value)) for value in values):
            return decimals
    return most


def _shown_columns(
    columns: Sequence[Column], rows: Sequence[Sequence[str]], width: int
) -> tuple[list[int], list[int]]:
    """Return the columns that fit, with the width of each.

    A column without text is dropped, too.
    """
    indices = [k for k in range(len(columns)) if not columns[k].drop or any(row[k] for row in rows)]
    widths = {
        k: max(map(cells, (columns[k].title, columns[k].unit, *(row[k] for row in rows)))) for k in indices
    }
    while sum(widths[k] + GAP for k in indices) - GAP > width and any(columns[k].drop for k in indices):
        indices.remove(max(indices, key=lambda k: columns[k].drop))
    return indices, [max(widths[k], 1) for k in indices]


def _line(
    columns: Sequence[Column],
    widths: Sequence[int],
    texts: Sequence[str],
    styles: Sequence[str],
    colour: bool,
) -> str:
    """Return the cells of a row, padded to their columns; padding has no style."""
    padded = []
    for column, width, text, style in zip(columns, widths, texts, styles, strict=True):
        if column.align == ">":
            text = text.rstrip()
        blanks, shown = " " * (width - cells(text)), styled(text, style, colour)
        padded.append(shown + blanks if column.align == "<" else blanks + shown)
    return (" " * GAP).join(padded).rstrip()
