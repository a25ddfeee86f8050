"""A run as a notebook shows it: output, diagnostics and the table of moves."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from motionlang.views.diagnostics import render_all
from motionlang.views.table import render
from motionlang.views.terminal import printable

if TYPE_CHECKING:
    from motionlang.result import Run

WIDTH = 110
# The largest number of output lines; of more, the first and the last half of these are shown.
MOST_LINES = 200


def html(run: Run) -> str:
    """Return the run as HTML, with all text of the program escaped."""
    lines = run.output
    if len(lines) > MOST_LINES:
        half = MOST_LINES // 2
        lines = [*lines[:half], f"… {len(lines) - 2 * half} lines …", *lines[-half:]]
    parts = ["\n".join(map(printable, lines))]
    if run.diagnostics:
        parts.append(render_all(run.diagnostics, run.source, width=WIDTH))
    if run.status != "fault" or run.time:
        parts.append(render(run, width=WIDTH, colour=False, charts=False))
    return "\n".join(f"<pre>{escape(part)}</pre>" for part in parts if part.strip())
