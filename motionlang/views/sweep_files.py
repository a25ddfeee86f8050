"""The rows of a sweep as a file: CSV with full precision, or Parquet."""

from __future__ import annotations

import codecs
import csv
from collections.abc import Iterable, Sequence
from typing import IO, Any

from motionlang.errors import need
from motionlang.files import replacing

Cells = Sequence[Any]


def write_rows(path: str, names: Sequence[str], rows: Iterable[Cells]) -> None:
    """Write a table to a .csv or .parquet file.

    Raises OSError, and leaves no incomplete file behind.
    """
    with replacing(path) as file:
        if path.lower().endswith(".parquet"):
            _write_parquet(file, names, list(rows))
        else:
            write_csv(codecs.getwriter("utf-8")(file), names, rows)


def write_csv(text: IO[str] | codecs.StreamWriter, names: Sequence[str], rows: Iterable[Cells]) -> None:
    """Write a table as CSV to any stream; a missing value is an empty cell."""
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(names)
    for row in rows:
        writer.writerow([_cell(value) for value in row])


def _cell(value: object) -> object:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return repr(value + 0.0)
    return "" if value is None else value


def _write_parquet(file: IO[bytes], names: Sequence[str], rows: list[Cells]) -> None:
    """Write a table as Parquet.

    A column with only numbers has a numeric type, any other is text.
    """
    need("a Parquet file", "pyarrow")
    import pyarrow as arrow  # type: ignore[import-untyped]
    from pyarrow.parquet import write_table  # type: ignore[import-untyped]

    columns = {}
    for index, name in enumerate(names):
        values = [row[index] for row in rows]
        there = [value for value in values if value is not None]
        if there and all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in there):
            whole = name == "variant" or all(isinstance(value, int) for value in there)
            columns[name] = arrow.array(
                [None if v is None else v if whole else float(v) for v in values],
                arrow.int64() if whole else arrow.float64(),
            )
        else:
            columns[name] = arrow.array(
                [None if v is None else str(_cell(v)) for v in values], arrow.string()
            )
    write_table(arrow.table(columns), file)
