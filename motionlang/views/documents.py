"""HTML pages and SVG pictures: what is around the content of each."""

from __future__ import annotations

from collections.abc import Iterable
from html import escape


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
