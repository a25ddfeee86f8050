"""A run as a notebook shows it: what was printed, what is wrong, and the table of its moves."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from motionlang.views.diagnostics import render_all
from motionlang.views.table import render
from motionlang.views.terminal import printable

if TYPE_CHECKING:
    from motionlang.result import Run

WIDTH = 110
# Lines that the program printed, of more the first and the last half of so many.
MOST_LINES = 200


def html(run: Run) -> str:
    """The run as HTML, with nothing in it that a program could have made of it."""
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
