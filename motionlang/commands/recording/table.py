"""The file of a recording as columns of text, with the names and the units that its head gives them.

A separator is detected from the lines (tab, semicolon, bar, comma, blanks), or named by the line `sep=;` of a
spreadsheet. Rows of names and of units may come first, preceded by any number of other lines. Rows of numbers begin
where at least half of the cells are values.

The groups of rows of a damaged Parquet file that are whole are read.
"""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Sequence
from math import isnan
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.commands.recording.clock import SECONDS, is_clock_time
from motionlang.commands.recording.values import number
from motionlang.kernel import Diagnostic, ProgramError, Source
from motionlang.kernel.tools import count_of, need

SEPARATORS = ("\t", ";", "|", ",", " ")
REMARKS = ("#", "%", "//")
# Lines that are read to detect the separator and the head.
_SAMPLED_LINES = 60
_SEPARATOR_LINE = re.compile(r"\"?sep=(.)\"?\s*", re.IGNORECASE)
# A unit behind a name: time [ms], time (ms), time/ms, time_ms, time in ms.
_UNIT = re.compile(
    rf"(.*?)(?:\s*\[(.*)\]|\s*\((.*)\)|(?:\s*[/,]\s*|[_ ]|\s+in\s+)({'|'.join(SECONDS)}))", re.IGNORECASE
)


# The possible names of the time column, without a unit.
TIMES = frozenset(
    [
        "time",
        "t",
        "zeit",
        "timestamp",
        "datetime",
        "date-time",
        "date/time",
        "date_time",
        "uhrzeit",
        "zeitstempel",
        "sec",
        "secs",
        "seconds",
        "ms",
        "us",
        "µs",
        "ns",
        "msec",
        "usec",
        "millis",
        "micros",
        "elapsed",
        "clock",
        "ts",
        "epoch",
        "unixtime",
        "zeitpunkt",
        "date time",
        "local time",
        "time stamp",
        "date and time",
        "datum uhrzeit",
        "elapsed time",
    ]
)


class RecordedTable(NamedTuple):
    """Columns of text of equal length by name.

    `lines` has the file line of each row; `source` is the text of the file, None if it has none. `remarks` are warnings
    about the file.
    """

    name: str
    source: Source | None
    columns: dict[str, list[str]]
    units: dict[str, str]
    lines: NDArray[np.int64]
    remarks: list[Diagnostic]


def bare(name: str) -> str:
    """Return a name without its unit, in lower case."""
    found = _UNIT.fullmatch(name.strip())
    return (found[1] if found else name).strip().lower()


def _unit(name: str) -> str:
    """Return the unit in a name such as "time [ms]" or "t_ms"."""
    if name.strip().lower() in SECONDS:
        return name.strip()
    found = _UNIT.fullmatch(name.strip())
    return next((each for each in found.groups()[1:] if each), "") if found else ""


def read_file(path: str) -> RecordedTable:
    """Return the table of a file; raise OSError, MissingExtra, or ProgramError if it is none."""
    suffix = os.path.splitext(path)[1].lower()
    name = os.path.basename(path)
    if suffix == ".parquet":
        return _from_parquet(path, name)
    return table_of(Source.read(path))


# ------------------------------------------------------------------------------------------ text


def table_of(source: Source) -> RecordedTable:
    """Return the table of a text; raise ProgramError if it has fewer than two rows of values."""
    filled = [(at, line) for at, line in enumerate(source.text.split("\n"), 1) if line.strip()]
    lines = [(at, line) for at, line in filled if not line.lstrip().startswith(REMARKS)]
    named = _SEPARATOR_LINE.fullmatch(lines[0][1].strip(" ")) if lines else None
    if named is not None:
        del lines[0]
    sample = [line for _, line in lines[:_SAMPLED_LINES]]
    separator, width = _separator(sample, (named[1],) if named else SEPARATORS)
    head: list[list[str]] = []
    rows: list[list[str]] = []
    numbers: list[int] = []
    for at, line in lines:
        cells = _cells(line, separator)
        if not rows and not _has_values(cells):
            head.append(cells)
        else:
            rows.append(cells)
            numbers.append(at)
    if len(rows) < 2:
        raise ProgramError.of(
            "recording",
            f"{source.name} is not a recording: it has fewer than two rows of numbers",
            hint="a recording has columns of numbers, as a drive or a scope exports them to CSV",
        )
    short = [at for at, row in zip(numbers, rows, strict=True) if len(row) != width]
    rows = [_of_width(row, width) for row in rows]
    used = max(map(_filled, rows))
    # A head may be a remark, as numpy writes it.
    remarks_above = [line.strip() for _, line in filled[:_SAMPLED_LINES] if line.lstrip().startswith(REMARKS)]
    for above in (head, [_cells(line.lstrip("#%/ "), separator) for line in remarks_above]):
        fitting = [row for row in above if _filled(row) <= width and len(row) >= used]
        if fitting:
            break
    else:  # names of columns that are empty, or columns without a name
        timed = [k for k, row in enumerate(head) if len(row) > 1 and any(map(is_time_name, row))]
        fitting = head[max(timed, key=lambda k: len(head[k])) :] if timed else []
    names, units = _names([_of_width(row, width) for row in fitting], width)
    columns = dict(zip(names, map(list, zip(*rows, strict=True)), strict=True))
    for k in range(width, used, -1):  # lines end with separators
        if names[k - 1] == f"column {k}":
            del columns[names[k - 1]]
    remarks = []
    if short:
        remarks.append(
            warning(
                f"{count_of(len(short), 'row')} without {width} columns",
                short[0],
                "missing values are left out",
            )
        )
    return RecordedTable(source.name, source, columns, units, np.array(numbers), remarks)


def warning(message: str, line: int = 0, hint: str = "") -> Diagnostic:
    """Return a warning about a recording."""
    return Diagnostic("recording", message, line, severity="warning", hint=hint)


def _filled(cells: Sequence[str]) -> int:
    """Return the number of cells up to the last one that is not empty."""
    return max((k for k, cell in enumerate(cells, 1) if cell), default=0)


def _of_width(cells: list[str], width: int) -> list[str]:
    return cells[:width] + [""] * (width - len(cells))


def _separator(lines: Sequence[str], separators: Sequence[str]) -> tuple[str, int]:
    """Return the separator of the columns, and how many of them most lines have."""
    for separator in separators:
        counts = [len(_cells(line, separator)) for line in lines]
        usual = max(set(counts), key=lambda count: (counts.count(count), count), default=1)
        if usual > 1 and counts.count(usual) > len(counts) / 2:
            return separator, usual
    return separators[-1], 1


def _cells(line: str, separator: str) -> list[str]:
    if separator == " ":
        cells = line.split()
    elif '"' in line:
        try:
            # A reader for each line: a quote that is never closed ends with its line.
            cells = next(csv.reader([line], delimiter=separator, skipinitialspace=True))
        except csv.Error:
            cells = line.split(separator)
    else:
        cells = line.split(separator)
    return [cell.strip().strip("\"'") for cell in cells]


def _has_values(cells: Sequence[str]) -> bool:
    """True if at least half of the cells that are not empty are values."""
    filled = [cell for cell in cells if cell]
    values = [cell for cell in filled if not isnan(number(cell)) or is_clock_time(cell)]
    return 2 * len(values) >= len(filled) > 0


def _names(head: Sequence[Sequence[str]], width: int) -> tuple[list[str], dict[str, str]]:
    """Return the column names from the rows of `width` above the numbers, and their units.

    A name that is missing, or that two columns share, is that in the rows above.
    """
    rows = [row for row in head if any(row)]
    named = next((row for row in rows if any(is_time_name(cell) for cell in row)), rows[0] if rows else None)
    names = [cell or f"column {k + 1}" for k, cell in enumerate(named or [""] * width)]
    for k, name in enumerate(names):
        while names[k] in names[:k]:
            names[k] = f"{name} ({k + 1})" if names[k] == name else f"{names[k]}'"
    units = {name: _unit(name) for name in names}
    below = [row for row in rows if row is not named]
    if named is not None and below:
        after = below[-1]
        units |= {name: cell for name, cell in zip(names, after, strict=True) if cell}
    return names, {name: unit.strip("[]() ") for name, unit in units.items() if unit}


def is_time_name(name: str) -> bool:
    """True if a column of this name has the times of the rows."""
    return bare(name) in TIMES or bare(name).rsplit("_", 1)[0] in TIMES


# ------------------------------------------------------------------------------------------ other formats


def _from_parquet(path: str, name: str) -> RecordedTable:
    """Return the columns of a Parquet file; row groups that cannot be read are left out."""
    need("a Parquet recording", "pyarrow")
    from pyarrow.parquet import ParquetFile  # type: ignore[import-untyped]

    with open(path, "rb") as file:
        # The library raises many types for bytes that are damaged, some of them no errors of its own.
        try:
            parquet = ParquetFile(file)
            schema, groups = parquet.schema_arrow, parquet.num_row_groups
        except Exception:
            hint = "the index of a Parquet file is at its end: a file that is cut off cannot be read"
            raise ProgramError.of("recording", f"{name} is not a Parquet file", hint=hint) from None
        columns: dict[str, list[str]] = {field.name: [] for field in schema}
        lost = 0
        for group in range(groups):
            try:
                batch = parquet.read_row_group(group)
                texts = {each: _texts(batch.column(each)) for each in columns}
            except Exception:
                lost += 1
                continue
            for each, cells in texts.items():
                columns[each] += cells
    units = {}
    for field in schema:
        unit = (field.metadata or {}).get(b"unit", b"").decode("utf-8", "replace")
        if unit or _unit(field.name):
            units[field.name] = unit or _unit(field.name)
    remarks = [warning(f"{lost} of {count_of(groups, 'group')} of rows cannot be read")] if lost else []
    return _whole(name, columns, units, remarks)


def _texts(column: Any) -> list[str]:
    """Return the cells of a column of pyarrow; times keep their nanoseconds."""
    from pyarrow import types  # type: ignore[import-untyped]

    if types.is_timestamp(column.type):
        return ["" if each is None else each for each in column.cast("string").to_pylist()]
    if types.is_duration(column.type):
        seconds = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}[column.type.unit]
        return ["" if each is None else repr(each * seconds) for each in column.cast("int64").to_pylist()]
    return ["" if each is None else str(each) for each in column.to_pylist()]


def _whole(
    name: str, columns: dict[str, list[str]], units: dict[str, str], remarks: list[Diagnostic]
) -> RecordedTable:
    """Return a table without a text, whose lines are its rows; raise ProgramError if it has fewer than two."""
    count = len(next(iter(columns.values()), []))
    if count < 2:
        raise ProgramError.of("recording", f"{name} is not a recording: it has fewer than two rows")
    return RecordedTable(name, None, columns, units, np.arange(1, count + 1), remarks)
