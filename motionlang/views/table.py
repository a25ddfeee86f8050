"""A table: columns say where a value comes from and how it is shown; the rows are the records themselves.

Text, JSON, CSV, Markdown and HTML come from the same columns. On a narrow terminal the least important columns of the
text are dropped.
"""

from __future__ import annotations

import csv
import json
from codecs import StreamWriter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from math import isfinite
from textwrap import wrap
from typing import IO, Any

from motionlang.views import terminal
from motionlang.views.formatting import formatter, grouped
from motionlang.views.terminal import printable, styled

# The name of the one schema of the commands' JSON documents; the report of a run has its own.
SCHEMA = "motionlang/1"
GAP = 2
# The indentation of the cells below a row.
FOLDED = "    "


@dataclass(frozen=True)
class Column:
    """A column with `title` over `unit` in text, and `key` in JSON and CSV.

    The value is the item or attribute `key` of a row, unless `get` returns it; a value that is None is an empty cell.
    `text` shows a value. Instead, numbers of a column with `decimals` all have the fewest decimals that show them, at
    most so many. Columns with the highest `drop` are left out first if a text is too wide; 0 means never. `style`
    colours the cells. A column with `data` is in JSON and CSV only.
    """

    key: str
    title: str | None = None
    unit: str = ""
    get: Callable[[Any], Any] | None = None
    text: Callable[[Any], str] | None = None
    decimals: int | None = None
    left: bool = False
    drop: int = 0
    style: str = ""
    data: bool = False

    @property
    def heading(self) -> str:
        """The title, by default the key as words."""
        return self.key.replace("_", " ") if self.title is None else self.title

    def value(self, row: Any) -> Any:
        """Return the value of a row in this column; None for an empty cell."""
        if self.get is not None:
            return self.get(row)
        return row.get(self.key) if isinstance(row, Mapping) else getattr(row, self.key)

    def texts(self, rows: Iterable[Any]) -> list[str]:
        """Return the cells of the column as text."""
        values = list(map(self.value, rows))
        if self.decimals is not None:
            text = formatter([value for value in values if isinstance(value, float | int)], self.decimals)
            return [text(value) if isinstance(value, float | int) else _plain(value) for value in values]
        return ["" if value is None else (self.text or _plain)(value) for value in values]


@dataclass
class Table:
    """Rows under columns; `name` is that of the rows in JSON, and in the remark about rows left out.

    The text has at most `most` rows unless all are wanted; 0 is no limit. `empty` is the text of a table without rows,
    `head` a line above the table, `notes` are lines below it. `style` returns the style of a row, "" for those of the
    columns. With `folds` the cells of columns that do not fit are below their row.
    """

    name: str
    columns: Sequence[Column]
    rows: Sequence[Any]
    most: int = 0
    empty: str = ""
    head: str = ""
    style: Callable[[Any], str] = lambda row: ""
    notes: list[str] = field(default_factory=list)
    folds: bool = False

    def lines(self, width: int, *, colour: bool = False, everything: bool = False) -> list[str]:
        """Return the table as lines of text."""
        head = [styled(self.head, "bold", colour)] if self.head else []
        rows = self.rows if everything or not self.most else self.rows[: self.most]
        if not rows and self.empty:
            return [*head, self.empty, *self.notes]
        columns = [column for column in self.columns if not column.data]
        found = [column.texts(rows) for column in columns]
        shown = _fitting(columns, found, width)
        folded = [k for k in range(len(columns)) if k not in shown and any(found[k])] if self.folds else []
        below = [
            "; ".join(f"{columns[k].heading} {found[k][row]}".strip() for k in folded if found[k][row])
            for row in range(len(rows))
        ]
        columns, found = [columns[k] for k in shown], [found[k] for k in shown]
        laid = _laid(columns, found, list(map(self.style, rows)), colour)
        first = len(laid) - len(rows)
        lines = laid[:first]
        for line, text in zip(laid[first:], below, strict=True):
            lines += [line, *wrap(text, width, initial_indent=FOLDED, subsequent_indent=FOLDED)]
        left = len(self.rows) - len(rows)
        if left:
            lines.append(styled(f"… and {grouped(left)} more {self.name}: --all shows all", "dim", colour))
        return [*head, *lines, *(styled(note, "dim", colour) for note in self.notes)]

    def dicts(self) -> Iterator[dict[str, Any]]:
        """Yield the rows as plain data, by the keys of the columns; a number without a value is None."""
        columns = [column for column in self.columns if column.key]
        return ({column.key: _finite(column.value(row)) for column in columns} for row in self.rows)

    def csv(self, out: IO[str] | StreamWriter) -> None:
        """Write the rows as CSV under the keys of the columns, with full precision; a missing value is empty."""
        columns = [column for column in self.columns if column.key]
        rows = ([column.value(row) for column in columns] for row in self.rows)
        write_csv(out, [column.key for column in columns], rows)

    def markdown(self) -> list[str]:
        """Return the table as lines of Markdown."""
        heads, rows = self.cells()
        lines = [f"| {' | '.join(heads)} |", "|---" * len(heads) + "|"]
        return lines + [f"| {' | '.join(cell.replace('|', '&#124;') for cell in row)} |" for row in rows]

    def cells(self) -> tuple[list[str], list[tuple[str, ...]]]:
        """Return the headings with units, and the cells of the rows, at most so many as the text has."""
        columns = [column for column in self.columns if not column.data]
        heads = [f"{column.heading}, {column.unit}" if column.unit else column.heading for column in columns]
        rows = self.rows[: self.most] if self.most else self.rows
        return heads, list(zip(*(column.texts(rows) for column in columns), strict=True))


# The cells of a table by the heading of their column: "title, unit", with < before a title that is aligned left.
Cells = Mapping[str, Callable[[Any], str]]


def filled(cells: Cells, rows: Sequence[Any], *, width: int) -> list[str]:
    """Return the lines of a table with a row for each of `rows`."""
    columns = []
    for heading, cell in cells.items():
        title, _, unit = heading.removeprefix("<").partition(", ")
        columns.append(Column("", title, unit, get=cell, left=heading.startswith("<")))
    return Table("", columns, rows).lines(width)


@dataclass
class Document:
    """The results of a command as data: tables, the most important first, and single values by name."""

    tables: Sequence[Table] = ()
    values: Mapping[str, Any] = field(default_factory=dict)

    def json(self) -> str:
        """Return one JSON document with the values and the rows of the tables."""
        tables = {table.name: list(table.dicts()) for table in self.tables}
        found = {"schema": SCHEMA, **{name: _finite(value) for name, value in self.values.items()}, **tables}
        return json.dumps(found, indent=1, allow_nan=False) + "\n"

    def csv(self, out: IO[str] | StreamWriter) -> None:
        """Write the first table as CSV, which has only one."""
        self.tables[0].csv(out)


def records_table(name: str, records: Sequence[Any]) -> Table:
    """Return a table of dataclass objects of one class, with a column for each field with a simple value."""
    names = [each.name for each in fields(records[0])] if records else []
    simple = [name for name in names if isinstance(getattr(records[0], name), str | float | int | None)]
    return Table(name, list(map(Column, simple)), records)


def write_csv(out: IO[str] | StreamWriter, names: Sequence[str], rows: Iterable[Iterable[Any]]) -> None:
    """Write rows as CSV under names; a missing value is an empty cell."""
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(names)
    writer.writerows(map(csv_cell, row) for row in rows)


def _plain(value: object) -> str:
    if isinstance(value, str):
        return printable(value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.10g}"
    return (
        "" if value is None else ", ".join(map(str, value)) if isinstance(value, tuple | list) else str(value)
    )


def _finite(value: Any) -> Any:
    """Return a value that JSON can represent: a number that is none is None."""
    return None if isinstance(value, float) and not isfinite(value) else value


def csv_cell(value: object) -> object:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return repr(value + 0.0)
    return "" if value is None else _plain(value) if isinstance(value, tuple | list) else value


def _fitting(columns: Sequence[Column], found: Sequence[Sequence[str]], width: int) -> list[int]:
    """Return the columns that fit; one that may be dropped and has no text is dropped, too."""
    shown = [k for k in range(len(columns)) if not columns[k].drop or any(found[k])]
    widths = [_width(column, texts) + GAP for column, texts in zip(columns, found, strict=True)]
    while sum(widths[k] for k in shown) - GAP > width and any(columns[k].drop for k in shown):
        shown.remove(max(shown, key=lambda k: columns[k].drop))
    return shown


def _width(column: Column, texts: Sequence[str]) -> int:
    return max(1, *map(terminal.cells, (column.heading, column.unit, *texts)))


def _laid(
    columns: Sequence[Column], found: Sequence[Sequence[str]], styles: Sequence[str], colour: bool
) -> list[str]:
    """Return head, rule and rows; the rule runs through the gaps."""
    widths = [_width(column, texts) for column, texts in zip(columns, found, strict=True)]
    lines = [_line(columns, widths, [column.heading for column in columns], "bold", colour)]
    if any(column.unit for column in columns):
        lines.append(_line(columns, widths, [column.unit for column in columns], "dim", colour))
    lines.append(styled("─" * (sum(widths) + GAP * (len(widths) - 1)), "dim", colour))
    rows = zip(*found, strict=True)
    return lines + [
        _line(columns, widths, row, style, colour) for row, style in zip(rows, styles, strict=True)
    ]


def _line(
    columns: Sequence[Column], widths: Sequence[int], texts: Sequence[str], style: str, colour: bool
) -> str:
    """Return the cells of a row, padded to their columns; padding has no style."""
    padded = []
    for column, width, text in zip(columns, widths, texts, strict=True):
        text = text if column.left else text.rstrip()
        blanks, shown = " " * (width - terminal.cells(text)), styled(text, style or column.style, colour)
        padded.append(shown + blanks if column.left else blanks + shown)
    return (" " * GAP).join(padded).rstrip()
