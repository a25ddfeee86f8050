"""The paths of a run as a table, one per line: `profile --paths`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from motionlang.views.grid import Column, decimals_of, grid
from motionlang.views.terminal import styled
from motionlang.views.words import figure

if TYPE_CHECKING:
    from motionlang.log.paths import PathRow

MAX_ROWS = 60
# Smaller angles, in degrees, are not corners.
SMOOTH = 0.05
_COLUMNS = (
    Column("line"),
    Column("command", align="<", style="word"),
    Column("axes", align="<", drop=2),
    Column("start", "s", drop=1),
    Column("time", "s"),
    Column("length", "uu"),
    Column("entry", "uu/s", drop=3),
    Column("peak", "uu/s"),
    Column("exit", "uu/s"),
    Column("corner", "°"),
    Column("at its end", align="<"),
)


def render_paths(
    rows: Sequence[PathRow], *, width: int = 100, colour: bool = False, everything: bool = False
) -> str:
    """Return the table as text that ends with a newline."""
    if not rows:
        return "no path was run: no axes begin and end together on one line\n"
    shown = rows if everything else rows[:MAX_ROWS]
    time = decimals_of([row.duration for row in shown], 6)
    length = decimals_of([row.length for row in shown])
    texts = [
        [
            str(row.line or ""),
            row.command,
            ", ".join(map(str, row.axes)),
            f"{row.start_time:.6f}",
            figure(row.duration, time),
            figure(row.length, length),
            figure(row.entry_speed),
            figure(row.peak_speed),
            figure(row.exit_speed),
            "" if row.corner is None else f"{row.corner:.1f}",
            at_its_end(row),
        ]
        for row in shown
    ]
    lines = grid(_COLUMNS, texts, width=width, colour=colour)
    if len(shown) < len(rows):
        lines.append(styled(f"… and {len(rows) - len(shown)} more paths: --all shows all", "dim", colour))
    return "\n".join(lines) + "\n"


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
