"""The table of the program's writes to other devices: servers and remote nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from motionlang.views.table import Column, Table

Row = dict[str, Any]

# More rows than this are only in the JSON report.
MAX_ROWS = 40


def writes_table(rows: Sequence[Row]) -> Table:
    """Return the table of what was written into other devices, the first rows of many."""
    columns = (
        Column("", "written to", get=_device, left=True, style="word"),
        Column("", get=_target, left=True),
        Column("value"),
    )
    table = Table("writes", columns, rows[:MAX_ROWS])
    if len(rows) > MAX_ROWS:
        table.notes.append(f"… and {len(rows) - MAX_ROWS} more: --format json has all")
    return table


def _device(row: Row) -> str:
    return f"Modbus server {row['server']}" if "server" in row else f"node {row['node']} of bus {row['bus']}"


def _target(row: Row) -> str:
    if row["kind"] == "object":
        return f"object 0x{row['number']:04X}, {row['subindex']}"
    what = str(row["kind"]).replace("-", " ")
    return f"{what} {row['number']}" if "number" in row else what
