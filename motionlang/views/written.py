"""The table of the program's writes to other devices, for the report.

The devices are servers and remote nodes.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from motionlang.views.grid import Column, grid
from motionlang.views.terminal import printable, styled

Row = dict[str, Any]

# More rows than this are only in the JSON report.
MAX_ROWS = 40
_COLUMNS = (Column("written to", align="<", style="word"), Column("", align="<"), Column("value"))


def written(rows: Sequence[Row], width: int, colour: bool) -> list[str]:
    """Return the lines of the table."""
    texts = [[_device(row), _target(row), _value(row["value"])] for row in rows[:MAX_ROWS]]
    lines = grid(_COLUMNS, texts, width=width, colour=colour)
    if len(rows) > MAX_ROWS:
        lines.append(styled(f"… and {len(rows) - MAX_ROWS} more: --format json has all", "dim", colour))
    return lines


def _device(row: Row) -> str:
    return f"Modbus server {row['server']}" if "server" in row else f"node {row['node']} of bus {row['bus']}"


def _target(row: Row) -> str:
    if row["kind"] == "object":
        return f"object 0x{row['number']:04X}, {row['subindex']}"
    what = str(row["kind"]).replace("-", " ")
    return f"{what} {row['number']}" if "number" in row else what


def _value(value: float | str) -> str:
    return printable(value) if isinstance(value, str) else f"{value:.10g}"
