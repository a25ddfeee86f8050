"""A table as HTML, for pages and notebooks."""

from __future__ import annotations

from collections.abc import Callable
from html import escape

from motionlang.views.table import Table


def data_cell(heading: str, text: str) -> str:
    """Return a cell of text, which is escaped."""
    return f"<td>{escape(text)}</td>"


def html_table(table: Table, cell: Callable[[str, str], str] = data_cell) -> str:
    """Return a table as HTML; `cell` makes a cell from the heading of its column and its text."""
    heads, rows = table.cells()
    head = "".join(f"<th>{escape(each)}</th>" for each in heads)
    lines = ["".join(map(cell, heads, row)) for row in rows]
    return f"<table>{''.join(f'<tr>{each}</tr>' for each in [head, *lines])}</table>"
