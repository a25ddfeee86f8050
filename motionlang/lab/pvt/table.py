"""PVT points in a CSV file, one line per point.

The columns are position, velocity, time and relative. Positions are in counts, velocities in counts/s, times
in whole milliseconds. An empty velocity means a linear segment. A file may omit all columns but the first.
Lines that begin with # are comments. The separator is a tab, a semicolon, a comma or blanks, as the first line has it;
if it is not a comma, a comma may be the decimal point, as a European spreadsheet saves it.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass, field

from motionlang.kernel import Diagnostic, ProgramError, Source
from motionlang.kernel.tools import nearest
from motionlang.lab.pvt.points import Point

SEPARATORS = ("\t", ";", ",", " ")
COLUMNS = ("position", "velocity", "time", "relative")
YES, NO = ("1", "yes", "true"), ("0", "no", "false", "")


@dataclass(slots=True)
class PointTable:
    """Points, each with its line number; `has` names the file's columns."""

    points: list[Point] = field(default_factory=list)
    lines: list[int] = field(default_factory=list)
    has: tuple[str, ...] = COLUMNS


def read_points(source: Source) -> PointTable:
    """Return the points of a CSV file; raise `ProgramError` with all mistakes.

    NaN is accepted as a number here; `check_points` rejects it.
    """
    table, wrong = PointTable(), list[Diagnostic]()
    names: tuple[str, ...] = ()
    separator = ""
    for number, line in enumerate(source.text.split("\n"), 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        separator = separator or next((each for each in SEPARATORS if each in line.strip()), ",")
        cells = _cells(line, separator)
        if not cells[-1] and len(cells) == (len(names) or len(cells)) + bool(names):
            cells.pop()  # the line ends with a separator
        if not names:
            names = _names(cells, number, wrong)
            if wrong:
                break
            table.has = names
            if names[0] == cells[0].lower():
                continue
        _add_row(table, names, cells, number, wrong)
    if not wrong and not table.points:
        wrong.append(
            Diagnostic("values", "there are no points", hint=f"a line per point: {','.join(COLUMNS)}")
        )
    if wrong:
        raise ProgramError(wrong)
    return table


def _cells(line: str, separator: str) -> list[str]:
    """Return the values of a line; a decimal comma becomes a point."""
    cells = line.split() if separator == " " else next(csv.reader([line], delimiter=separator))
    if separator != ",":
        cells = [
            cell.replace(",", ".") if cell.count(",") == 1 and "." not in cell else cell for cell in cells
        ]
    return [cell.strip() for cell in cells]


def write_points(points: Sequence[Point]) -> list[str]:
    """Return the lines of a CSV file that `read_points` reads.

    The relative column is written only if a point needs it.
    """
    extra = any(point.relative for point in points)
    lines = [",".join(COLUMNS if extra else COLUMNS[:3])]
    for point in points:
        velocity = "" if point.velocity is None else f"{point.velocity:.15g}"
        row = [f"{point.position:.15g}", velocity, f"{point.time * 1000.0:.12g}"]
        lines.append(",".join([*row, str(int(point.relative))] if extra else row))
    return lines


def _names(cells: list[str], number: int, wrong: list[Diagnostic]) -> tuple[str, ...]:
    """Return the columns of a header line, or the default order without one.

    A file that begins with numbers has no header line.
    """
    if _number(cells[0]) is not None:
        return COLUMNS[: len(cells)]
    names = tuple(cell.lower() for cell in cells)
    for name in names:
        if name not in COLUMNS:
            near = nearest(name, COLUMNS)
            hint = f"did you mean {near}?" if near else f"the columns are {', '.join(COLUMNS)}"
            wrong.append(Diagnostic("unknown-word", f"there is no column {name!r}", number, 1, hint=hint))
    if "position" not in names and not wrong:
        wrong.append(Diagnostic("values", "there is no column 'position'", number, 1))
    return names


def _add_row(
    table: PointTable, names: tuple[str, ...], cells: list[str], number: int, wrong: list[Diagnostic]
) -> None:
    if len(cells) > len(names):
        message = f"{len(cells)} values for {len(names)} columns"
        wrong.append(Diagnostic("values", message, number, 1))
        return
    row = dict(zip(names, cells, strict=False))
    bad = [name for name in names if not _legible(name, row.get(name, ""))]
    for name in bad:
        message = f"the {name} {row.get(name, '')!r} is not a number"
        wrong.append(Diagnostic("syntax", message, number, 1))
    if bad:
        return
    velocity, time = row.get("velocity", ""), row.get("time", "")
    table.points.append(
        Point(
            _number(row["position"]) or 0.0,
            _number(velocity) if velocity else None,
            (_number(time) or 0.0) / 1000.0,
            row.get("relative", "").lower() in YES,
        )
    )
    table.lines.append(number)


def _legible(name: str, text: str) -> bool:
    if name == "relative":
        return text.lower() in YES + NO
    return (name == "velocity" and not text) or _number(text) is not None


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None
