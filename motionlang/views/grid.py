"""Columns of text, lined up: widths by content, the least important columns dropped where a terminal is narrow."""

from __future__ import annotations

from motionlang.views.terminal import cells, styled

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

GAP = "  "
MOST_DECIMALS = 6


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
    widths = [_width(columns[k], rows, k) for k in kept]
    heads = [[columns[k].title for k in kept], [columns[k].unit for k in kept]]
    lines = [_line(heads[0], columns, kept, widths, ["bold"] * len(kept), colour)]
    if any(heads[1]):
        lines.append(_line(heads[1], columns, kept, widths, ["dim"] * len(kept), colour))
    lines.append(styled("─" * (sum(widths) + len(GAP) * (len(widths) - 1)), "dim", colour))
    for i, row in enumerate(rows):
        style = styles[i] if styles else ""
        paints = [style or columns[k].style for k in kept]
        lines.append(_line([row[k] for k in kept], columns, kept, widths, paints, colour))
    return lines


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
    while True:
        total = sum(_width(columns[k], rows, k) for k in kept) + len(GAP) * (len(kept) - 1)
        droppable = [k for k in kept if columns[k].drop]
        if total <= width or not droppable:
            return kept
        kept.remove(max(droppable, key=lambda k: columns[k].drop))


def _width(column: Column, rows: Sequence[Sequence[str]], k: int) -> int:
    return max(cells(column.title), cells(column.unit), max((cells(row[k]) for row in rows), default=0))


def _line(
    texts: Sequence[str],
    columns: Sequence[Column],
    kept: Sequence[int],
    widths: Sequence[int],
    styles: Sequence[str],
    colour: bool,
) -> str:
    parts = []
    for text, k, width, style in zip(texts, kept, widths, styles, strict=True):
        blank = " " * (width - cells(text))
        shown = styled(text, style, colour)
        parts.append(shown + blank if columns[k].align == "<" else blank + shown)
    return GAP.join(parts).rstrip()
