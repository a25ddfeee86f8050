"""The text of a command as a page, Markdown or a picture, for files with such an extension."""

from __future__ import annotations

from collections.abc import Callable
from html import escape

from motionlang.views.documents import page, picture
from motionlang.views.terminal import cells

# Returns the content of a file from a text and the name of the file.
Page = Callable[[str, str], str]

MONOSPACED = "DejaVu Sans Mono, Consolas, Menlo, monospace"
# The size of the font of a picture, the width of a character and the distance of lines, and the margin, all in points.
SIZE, ADVANCE, LEADING, MARGIN = 10.0, 6.02, 13.0, 12.0


def html(text: str, name: str) -> str:
    """Return a page with a text."""
    return page(name, f"<pre>{escape(text)}</pre>", f"body{{margin:2rem}}pre{{font:14px/1.3 {MONOSPACED}}}")


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
    rows = (
        f'<text x="{MARGIN:.0f}" y="{MARGIN + LEADING * (number + 0.75):.2f}" xml:space="preserve">'
        f"{escape(line, quote=False)}</text>"
        for number, line in enumerate(lines)
        if line.strip()
    )
    named = [f"<title>{escape(name)}</title>", *rows]
    return picture(f"{width:.0f}", f"{height:.0f}", MONOSPACED, named, f' font-size="{SIZE:.0f}"')


PAGES: dict[str, Page] = {".html": html, ".md": markdown, ".svg": svg}
