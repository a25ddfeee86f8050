"""HTML pages and tables, and what is around the content of an SVG picture."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from html import escape

from motionlang.views.table import Table


def page(title: str, body: str, style: str, *, head: str = "") -> str:
    """Return a page that needs no other file; `body` and `head` are HTML, `style` is CSS."""
    return (
        f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8">{head}<title>{escape(title)}</title>'
        f"<style>{style}</style></head>\n<body>{body}</body></html>\n"
    )


def picture(width: str, height: str, font: str, lines: Iterable[str], more: str = "") -> str:
    """Return an SVG picture on white; its size is in points, `more` are further attributes of it."""
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}pt" height="{height}pt" '
            f'viewBox="0 0 {width} {height}" font-family="{font}"{more}>',
            "<desc>motionlang</desc>",
            f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
            *lines,
            "</svg>\n",
        ]
    )


def data_cell(heading: str, text: str) -> str:
    """Return a cell of text, which is escaped."""
    return f"<td>{escape(text)}</td>"


def html_table(table: Table, cell: Callable[[str, str], str] = data_cell) -> str:
    """Return a table as HTML; `cell` makes a cell from the heading of its column and its text."""
    heads, rows = table.cells()
    head = "".join(f"<th>{escape(each)}</th>" for each in heads)
    lines = ["".join(map(cell, heads, row)) for row in rows]
    return f"<table>{''.join(f'<tr>{each}</tr>' for each in [head, *lines])}</table>"
