"""The text of a command as a page, Markdown or a picture, for files with such an extension."""

from __future__ import annotations

from collections.abc import Callable
from html import escape

from motionlang.views.terminal import cells

# Returns the content of a file from a text and the name of the file.
Page = Callable[[str, str], str]

MONOSPACED = "DejaVu Sans Mono, Consolas, Menlo, monospace"
# The size of the font of a picture, the width of a character and the distance of lines, and the margin, all in points.
SIZE, ADVANCE, LEADING, MARGIN = 10.0, 6.02, 13.0, 12.0


def html(text: str, name: str) -> str:
    """Return a page with a text."""
    return (
        f'<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>{escape(name)}</title>\n'
        f"<style>body{{margin:2rem}}pre{{font:14px/1.3 {MONOSPACED}}}</style>\n<pre>{escape(text)}</pre></html>\n"
    )


def markdown(text: str, name: str) -> str:
    """Return a text as a block of Markdown."""
    fence = "```"
    while fence in text:
        fence += "`"
    return f"{fence}text\n{text.rstrip()}\n{fence}\n"


def svg(text: str, name: str) -> str:
    """Return a picture of a text."""
    lines = text.rstrip().split("\n")
    width = 2.0 * MARGIN + ADVANCE * max(map(cells, lines))
    height = 2.0 * MARGIN + LEADING * len(lines)
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}pt" height="{height:.0f}pt" '
            f'viewBox="0 0 {width:.0f} {height:.0f}" font-family="{MONOSPACED}" font-size="{SIZE:.0f}">',
            f"<title>{escape(name)}</title>",
            '<rect width="100%" height="100%" fill="#ffffff"/>',
            *(
                f'<text x="{MARGIN:.0f}" y="{MARGIN + LEADING * (number + 0.75):.2f}" xml:space="preserve">'
                f"{escape(line, quote=False)}</text>"
                for number, line in enumerate(lines)
                if line.strip()
            ),
            "</svg>\n",
        ]
    )


PAGES: dict[str, Page] = {".html": html, ".md": markdown, ".svg": svg}
