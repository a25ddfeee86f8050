"""Files of figures: SVG, written here, and PNG, drawn by matplotlib."""

from __future__ import annotations

import os
from collections.abc import Sequence
from html import escape

from motionlang.kernel.files import replacing
from motionlang.kernel.tools import need
from motionlang.views.documents import picture
from motionlang.views.figure import Figure
from motionlang.views.figure_layout import Point, Shape, TextLine, layout

FONT = "DejaVu Sans, Verdana, Arial, sans-serif"


def write_figure(figure: Figure, path: str) -> None:
    """Write a .svg or .png file; the same figure gives the same bytes.

    Raises OSError, and MissingExtra for a .png without matplotlib.
    """
    if os.path.splitext(path)[1].lower() == ".svg":
        content = svg(figure).encode()
    else:
        content = _png(figure)
    with replacing(path) as file:
        file.write(content)


def _png(figure: Figure) -> bytes:
    need("a .png picture", "matplotlib")
    from motionlang.views.figure_matplotlib import png

    return png(figure)


def svg(figure: Figure) -> str:
    """Return a figure as an SVG document."""
    width, height, items = layout(figure)
    lines = [_text(each) if isinstance(each, TextLine) else _shape(each) for each in items]
    return picture(_number(width), _number(height), FONT, lines, ' stroke-linejoin="round"')


def _shape(shape: Shape) -> str:
    close = "Z" if shape.fill else ""
    path = "".join(f"M{_points(points)}{close}" for points in shape.paths if points)
    more = f' fill="{shape.fill or "none"}"'
    if shape.stroke:
        more += f' stroke="{shape.stroke}" stroke-width="{_number(shape.width)}"'
    if shape.opacity < 1.0:
        more += f' opacity="{_number(shape.opacity)}"'
    if shape.is_dashed:
        more += ' stroke-dasharray="3 2"'
    return f'<path d="{path}"{more}/>'


def _points(points: Sequence[Point]) -> str:
    return "L".join(f"{_number(x)} {_number(y)}" for x, y in points)


def _text(text: TextLine) -> str:
    x, y = _number(text.x), _number(text.y)
    more = ' font-weight="bold"' if text.is_bold else ""
    if text.is_upright:
        more += f' transform="rotate(-90 {x} {y})"'
    return (
        f'<text x="{x}" y="{y}" font-size="{_number(text.size)}" fill="{text.colour}" '
        f'text-anchor="{text.side}"{more}>{escape(text.text, quote=False)}</text>'
    )


def _number(value: float) -> str:
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
