"""The paths of a run as a table, one per line: `profile --paths`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from motionlang.views.formatting import figure, line_number
from motionlang.views.table import Column, Table

if TYPE_CHECKING:
    from motionlang.commands.profile.paths import PathRow

# Smaller angles, in degrees, are not corners.
SMOOTH = 0.05


def paths_table(rows: Sequence[PathRow]) -> Table:
    """Return the table of paths; speeds are those along the path."""
    columns = (
        Column("line", text=line_number),
        Column("command", left=True, style="word"),
        Column("axes", left=True, drop=2),
        Column("start_time", "start", "s", text="{:.6f}".format, drop=1),
        Column("duration", "time", "s", decimals=6),
        Column("length", unit="uu", decimals=4),
        Column("entry_speed", "entry", "uu/s", text=figure, drop=3),
        Column("peak_speed", "peak", "uu/s", text=figure),
        Column("exit_speed", "exit", "uu/s", text=figure),
        Column("corner", unit="°", text="{:.1f}".format),
        Column("end", "at its end", get=at_its_end, left=True),
    )
    empty = "no path was run: no axes begin and end together on one line"
    return Table("paths", columns, rows, most=60, empty=empty)


def at_its_end(row: PathRow) -> str:
    """Return how a path continues into the next, or why it stops.

    This is inferred from the motion alone.
    """
    if row.ended:
        return f"ended by {row.ended}"
    if row.exit_speed:
        return "continues"
    if row.corner is None:
        return "stops: no next path"
    return f"stops: corner of {row.corner:.1f}°" if row.corner > SMOOTH else "stops: the paths are not joined"
