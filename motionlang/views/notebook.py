"""Notebook views of runs, traces, moves and reports.

They consist of text, tables and velocity curves.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from math import inf
from typing import TYPE_CHECKING, Any

from motionlang.kernel import Controller, Move, Moves, Report, Run
from motionlang.views.chart import velocity_panel
from motionlang.views.diagnostics import render_all
from motionlang.views.documents import html_table
from motionlang.views.figure import Curve, Figure, Panel
from motionlang.views.figure_files import svg
from motionlang.views.quantities import COLOURS
from motionlang.views.report import moves_table, render
from motionlang.views.terminal import printable

if TYPE_CHECKING:
    from motionlang.kernel import Trace

WIDTH = 110
# The width of a curve in points, and the intervals over it; each shows its lowest and its highest velocity.
CURVE, COLUMNS = 560.0, 600
# The largest number of output lines; of more, the first and the last half of these are shown.
MAX_LINES = 200
# The largest number of moves in a table, and of points on the curve of one.
MOST_MOVES, POINTS = 50, 300


def html(run: Run) -> str:
    """Return the run as HTML, with all text of the program escaped."""
    lines = run.output
    if len(lines) > MAX_LINES:
        half = MAX_LINES // 2
        lines = [*lines[:half], f"… {len(lines) - 2 * half} lines …", *lines[-half:]]
    sections = ["\n".join(map(printable, lines))]
    if run.diagnostics:
        sections.append(render_all(run.diagnostics, run.source, width=WIDTH))
    if run.status != "fault" or run.time:
        sections.append(render(run, width=WIDTH, colour=False, charts=False))
    shown = [f"<pre>{escape(section)}</pre>" for section in sections if section.strip()]
    return "\n".join(shown + _curves(run.controller, run.time))


def trace_html(trace: Trace) -> str:
    """Return the velocity of every axis that moved."""
    return "\n".join([f"<pre>{escape(repr(trace))}</pre>", *_curves(trace.controller, trace.end)])


def move_html(move: Move, run: Run) -> str:
    """Return a move with the velocity of its axis from its start to its end."""
    import numpy as np

    begin, end = move.start_time, move.start_time + move.duration
    times = np.linspace(begin, end, POINTS)
    values = run.trace.at(move.axis, "velocity", times)
    curve = Curve(times.tolist(), values.tolist(), COLOURS["velocity"])
    panel = Panel([curve], "velocity", "uu/s", f"axis {move.axis}", height=90.0, x_limits=(begin, end))
    return f"<pre>{escape(repr(move))}</pre>\n{_drawn(panel)}"


def moves_html(moves: Moves, run: Run) -> str:
    """Return a table of moves and their curves; a remark states the number omitted."""
    columns = moves.columns()
    rows = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
    return "\n".join([_moves(rows), *_curves(run.controller, run.time)])


def report_html(report: Report, run: Run | None) -> str:
    """Return a report's run, or its table of moves if it has no run."""
    if run is not None:
        return html(run)
    return f"<pre>{escape(repr(report))}</pre>\n{_moves(report['moves'])}"


def _curves(controller: Controller, end: float) -> list[str]:
    moved = [axis for axis in controller.axes.values() if len(axis.starts) > 1]
    panels = [velocity_panel(axis, end, COLUMNS) for axis in moved]
    return [_drawn(panel) for panel in panels if 0.0 < max(map(abs, panel.curves[0].y)) < inf]


def _drawn(panel: Panel) -> str:
    return svg(Figure([[panel]], x_label="time (s)", width=CURVE))


def _moves(rows: Sequence[Mapping[str, Any]]) -> str:
    """Return the first moves as a table; a remark states the number omitted."""
    omitted = len(rows) - MOST_MOVES
    more = f"<p>… {omitted} more move{'s'[: omitted != 1]}</p>" if omitted > 0 else ""
    return html_table(moves_table([dict(row) for row in rows[:MOST_MOVES]])) + more
