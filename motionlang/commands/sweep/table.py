"""The rows of a sweep as a table, and as a file: CSV with full precision, or Parquet."""

from __future__ import annotations

import codecs
from collections.abc import Collection, Sequence
from typing import IO, Any

from motionlang.kernel.files import replacing
from motionlang.kernel.tools import clipped, need
from motionlang.views.table import Column, Table, csv_cell
from motionlang.views.terminal import printable

Row = dict[str, Any]

# The largest number of characters of a text in a cell.
MAX_LETTERS = 40


def sweep_table(units: dict[str, str], rows: Sequence[Row], best: Collection[int] = ()) -> Table:
    """Return the rows of a sweep under the varied names and results, with their units; the `best` variants are marked.

    As data, each row also has the number of its variant, and the reason why it failed.
    """
    columns = [
        Column(
            name,
            name,
            unit,
            text=cell,
            left=any(isinstance(row.get(name), str) for row in rows),
            drop=k if k > 1 else 0,
        )
        for k, (name, unit) in enumerate(units.items())
    ]
    found = [Column("variant", data=True), *columns, Column("problem", data=True)]
    return Table("rows", found, rows, style=lambda row: "accel" if row["variant"] in best else "")


def cell(value: object) -> str:
    """Format a value of a row: a number to six digits, a text truncated to one line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int | float):
        return f"{value:.6g}"
    return clipped(printable(" · ".join(str(value).split("\n"))), MAX_LETTERS)


def write_rows(path: str, table: Table) -> None:
    """Write the rows to a .csv or .parquet file.

    Raises OSError, and leaves no incomplete file behind.
    """
    with replacing(path) as file:
        if path.lower().endswith(".parquet"):
            _write_parquet(file, table)
        else:
            table.csv(codecs.getwriter("utf-8")(file))


def _write_parquet(file: IO[bytes], table: Table) -> None:
    """Write the rows as Parquet.

    A column with only numbers has a numeric type, any other is text.
    """
    need("a Parquet file", "pyarrow")
    import pyarrow as arrow  # type: ignore[import-untyped]
    from pyarrow.parquet import write_table  # type: ignore[import-untyped]

    columns = {}
    for column in table.columns:
        values = list(map(column.value, table.rows))
        there = [value for value in values if value is not None]
        if there and all(isinstance(value, int | float) and not isinstance(value, bool) for value in there):
            whole = all(isinstance(value, int) for value in there)
            columns[column.key] = arrow.array(
                [None if v is None else v if whole else float(v) for v in values],
                arrow.int64() if whole else arrow.float64(),
            )
        else:
            texts = [None if v is None else str(csv_cell(v)) for v in values]
            columns[column.key] = arrow.array(texts, arrow.string())
    write_table(arrow.table(columns), file)
