"""Recordings of a drive, an oscilloscope or a data logger: columns in a text file, or in one of Parquet or MCAP.

The separator is detected from the lines (tab, semicolon, comma, blanks). If it is not a comma, a comma may be
the decimal point. A row of names and a row of units may come first, preceded by any number of comment lines.

A Parquet or MCAP file is read as the text that it would be. MCAP has a topic for each axis and channel: there is a row
for each message of the topic that has the most, with the last values of the others.
"""

from __future__ import annotations

import json
import os
import struct
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from math import isfinite, nan
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel import Diagnostic, ProgramError, Source
from motionlang.kernel.tools import count_of, nearest, need

Array = NDArray[np.float64]

SEPARATORS = ("\t", ";", ",", " ")
REMARKS = ("#", "%", "//")
# Lines that are read to detect the separator and the head.
_SAMPLED_LINES = 60
# The possible names of the time column, and the seconds of a unit in a name.
TIMES = ("time", "t", "time_s", "zeit", "timestamp", "sec", "seconds")
UNITS = {"s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "ns": 1e-9}


class RecordedColumns(NamedTuple):
    """Columns of equal length by name, NaN for missing numbers.

    `lines` has the file line of each row. `remarks` are warnings about the file, `doubts` about single
    columns of it.
    """

    columns: dict[str, Array]
    units: dict[str, str]
    lines: NDArray[np.int64]
    remarks: list[Diagnostic]
    doubts: dict[str, Diagnostic]

    def find(self, name: str, source: Source) -> str:
        """Return the column with a name or a number.

        Case is ignored, and the unit in a name may be omitted. Numbers count from 1. Raises ProgramError,
        with the alternatives, if there is no such column.
        """
        plain = {column.strip().lower(): column for column in self.columns}
        names = list(self.columns)
        wanted = name.strip().lower()
        if wanted in plain:
            return plain[wanted]
        bare = {_bare(column): column for column in reversed(names)}
        if wanted in bare:
            return bare[wanted]
        if wanted.isdecimal() and 1 <= int(wanted) <= len(names):
            return names[int(wanted) - 1]
        near = nearest(name, names)
        hint = f"did you mean {near}? " if near else ""
        raise ProgramError.of(
            "recording",
            f"{source.name} has no column {name!r}",
            hint=f"{hint}its columns are {', '.join(names)}",
        )


def text_of(path: str) -> Source:
    """Return a Parquet or MCAP file as columns of text; raise OSError, MissingExtra, or ProgramError if it is none."""
    name = os.path.basename(path)
    columns, units = BINARY[os.path.splitext(path)[1].lower()](path, name)
    rows = zip(*(values.tolist() for values in columns.values()), strict=True)
    lines: list[Iterable[object]] = [columns, *([units.values()] if any(units.values()) else []), *rows]
    return Source(name, "\n".join("\t".join(map(str, line)) for line in lines))


def _from_parquet(path: str, name: str) -> tuple[dict[str, Array], dict[str, str]]:
    """Return the columns of numbers of a Parquet file, and their units; dates become seconds."""
    need("a Parquet recording", "pyarrow")
    from pyarrow import ArrowInvalid  # type: ignore[import-untyped]
    from pyarrow.parquet import read_table  # type: ignore[import-untyped]

    try:
        table = read_table(path)
    except ArrowInvalid:
        raise ProgramError.of("recording", f"{name} is not a Parquet file") from None
    columns: dict[str, Array] = {}
    units: dict[str, str] = {}
    for field in table.schema:
        values = table.column(field.name).to_numpy()
        if values.dtype.kind == "M":
            values = (values - values[:1]) / np.timedelta64(1, "s")
        if values.dtype.kind in "biuf":
            columns[field.name] = values.astype(np.float64)
            units[field.name] = (field.metadata or {}).get(b"unit", b"").decode()
    return columns, units


def _from_mcap(path: str, name: str) -> tuple[dict[str, Array], dict[str, str]]:
    """Return the numbers of the JSON messages of an MCAP file; other messages are left out."""
    need("an MCAP recording", "mcap")
    from mcap.exceptions import McapError
    from mcap.reader import make_reader

    topics: dict[str, list[tuple[int, dict[str, object]]]] = defaultdict(list)
    try:
        with open(path, "rb") as file:
            for _, channel, message in make_reader(file).iter_messages():
                found = json.loads(message.data) if channel.message_encoding == "json" else None
                if isinstance(found, dict):
                    topics[channel.topic].append((message.log_time, found))
    except (McapError, ValueError, struct.error):
        raise ProgramError.of("recording", f"{name} is not an MCAP file") from None
    if not topics:
        hint = "save it as CSV"
        raise ProgramError.of("recording", f"{name} has no messages in JSON", hint=hint)
    rows = np.array([time for time, _ in max(topics.values(), key=len)])
    columns: dict[str, Array] = {"time_s": rows / 1e9}
    for topic, messages in topics.items():
        at = np.searchsorted([time for time, _ in messages], rows, "right") - 1
        last = topic.rpartition("/")[2]
        for field, first in messages[0][1].items():
            if isinstance(first, (int, float)):
                found = (each.get(field) for _, each in messages)
                values = np.array([float(each) if isinstance(each, (int, float)) else nan for each in found])
                columns[last if field == "value" else f"{last}_{field}"] = np.where(at < 0, nan, values[at])
    return columns, {}


BINARY = {".parquet": _from_parquet, ".mcap": _from_mcap}


def read_table(source: Source) -> RecordedColumns:
    """Return the columns of a file.

    Raises ProgramError if it has fewer than two rows of numbers.
    """
    lines = [
        (number, line)
        for number, line in enumerate(source.text.split("\n"), 1)
        if line.strip() and not line.lstrip().startswith(REMARKS)
    ]
    separator, width = _separator([line for _, line in lines[:_SAMPLED_LINES]])
    head: list[list[str]] = []
    rows: list[list[float]] = []
    numbers: list[int] = []
    bad: dict[int, tuple[int, int, str]] = {}
    short: list[int] = []
    for number, line in lines:
        cells = _cells(line, separator)
        values = [_number(cell, separator) for cell in cells]
        if not rows and sum(value is not None for value in values) < max(1, (len(values) + 1) // 2):
            head.append(cells)
            continue
        if len(cells) != width:
            short.append(number)
        row = []
        for k in range(width):
            value = values[k] if k < len(values) else None
            if value is None:
                count, first, text = bad.get(k, (0, number, cells[k] if k < len(cells) else ""))
                bad[k] = (count + 1, first, text)
            row.append(nan if value is None else value)
        rows.append(row)
        numbers.append(number)
    if len(rows) < 2:
        raise ProgramError.of(
            "recording",
            f"{source.name} is not a recording: it has fewer than two rows of numbers",
            hint="a recording has columns of numbers, as a drive or a scope exports them to CSV",
        )
    names, units = _names(head, width)
    data = np.array(rows, dtype=np.float64)
    if len(names) > 1 and np.isnan(data[:, -1]).all() and not (head and head[0][-1:] != [""]):
        names.pop()  # every line ends with a separator
    doubts = {name: _bad_cells(name, *bad[k], len(rows)) for k, name in enumerate(names) if k in bad}
    remarks = []
    if short:
        remarks.append(
            Diagnostic(
                "recording",
                f"{count_of(len(short), 'row')} without {width} columns",
                short[0],
                severity="warning",
                hint="missing values are left out of the comparison",
            )
        )
    columns = {name: data[:, k] for k, name in enumerate(names)}
    return RecordedColumns(columns, units, np.array(numbers), remarks, doubts)


def _separator(lines: Sequence[str]) -> tuple[str, int]:
    """Return the separator of the columns, and how many of them most lines have."""
    best, width = " ", 1
    for separator in SEPARATORS:
        counts = [len(_cells(line, separator)) for line in lines]
        if not counts:
            break
        usual = max(set(counts), key=lambda count: (counts.count(count), count))
        if usual > 1 and counts.count(usual) > len(counts) / 2:
            return separator, usual
    return best, width


def _cells(line: str, separator: str) -> list[str]:
    cells = line.split() if separator == " " else line.split(separator)
    return [cell.strip().strip("\"'") for cell in cells]


def _number(cell: str, separator: str) -> float | None:
    if separator != "," and cell.count(",") == 1 and "." not in cell:
        cell = cell.replace(",", ".")
    try:
        value = float(cell)
    except ValueError:
        return None
    return value if isfinite(value) else None


def _names(head: Sequence[Sequence[str]], width: int) -> tuple[list[str], dict[str, str]]:
    """Return the column names from the rows above the numbers, and their units."""
    named = next((row for row in head if len(row) == width and any(row)), None)
    names = [cell or f"column {k + 1}" for k, cell in enumerate(named)] if named is not None else []
    names = names or [f"column {k + 1}" for k in range(width)]
    for k, name in enumerate(names):
        if name in names[:k]:
            names[k] = f"{name} ({k + 1})"
    units = {name: _unit(name) for name in names}
    below = [row for row in head if len(row) == width and row is not named]
    if named is not None and below:
        units |= {name: cell for name, cell in zip(names, below[0], strict=True) if cell}
    return names, {name: unit.strip("[]()") for name, unit in units.items() if unit}


def _unit(name: str) -> str:
    """Return the unit in a name such as "time [ms]" or "t_ms"."""
    for opening, closing in ("[]", "()"):
        if opening in name and name.rstrip().endswith(closing):
            return name[name.rindex(opening) + 1 : name.rindex(closing)]
    return name.rsplit("_", 1)[-1] if name.rsplit("_", 1)[-1].lower() in UNITS else ""


def _bare(name: str) -> str:
    """Return a name without its unit."""
    for opening in "[(":
        name = name.partition(opening)[0] or name
    return name.strip().lower()


def _bad_cells(name: str, count: int, line: int, text: str, rows: int) -> Diagnostic:
    what = f"{text!r}" if text else "nothing"
    return Diagnostic(
        "recording",
        f"{name}: {count_of(count, 'value')} of {rows} not a number, the first is {what}",
        line,
        severity="warning",
        hint="they are left out of the comparison",
    )


def time_column(table: RecordedColumns, source: Source, wanted: str | None) -> str:
    """Return the time column: the requested one, or the first one named like a time."""
    if wanted is not None:
        return table.find(wanted, source)
    for name in table.columns:
        if _bare(name) in TIMES or _bare(name).rsplit("_", 1)[0] in TIMES:
            return name
    raise ProgramError.of(
        "recording",
        f"{source.name} has no column named time",
        hint=f"choose one with --map time=NAME; its columns are {', '.join(table.columns)}",
    )


def seconds(
    table: RecordedColumns, name: str, factor: float | None, units: Mapping[str, float] = UNITS
) -> Array:
    """Return the times of a column in seconds.

    Without a `factor` the unit decides: the one in the column's name, or the one in the row of units.
    """
    scale = units.get(table.units.get(name, "s").lower(), 1.0) if factor is None else factor
    return table.columns[name] * scale


def usable_rows(times: Array, table: RecordedColumns) -> tuple[NDArray[np.int64], list[Diagnostic]]:
    """Return the rows with increasing times, and diagnostics about the dropped rows.

    Rows without a time are dropped. Of several rows at one time the last one is used. If time runs backwards,
    the longest increasing stretch is used.
    """
    remarks: list[Diagnostic] = []
    rows = np.flatnonzero(np.isfinite(times))
    back = np.flatnonzero(np.diff(times[rows]) < 0.0)
    if len(back):
        edges = [0, *(back + 1).tolist(), len(rows)]
        first, last = max(pairwise(edges), key=lambda edge: edge[1] - edge[0])
        remarks.append(
            Diagnostic(
                "recording",
                f"time runs backwards {count_of(len(back), 'time')}",
                int(table.lines[rows[back[0] + 1]]),
                severity="warning",
                hint=f"only the longest stretch is compared: lines {table.lines[rows[first]]} to "
                f"{table.lines[rows[last - 1]]}",
            )
        )
        rows = rows[first:last]
    advances = np.append(np.diff(times[rows]) > 0.0, True)
    return rows[advances], remarks
