"""Figures as PNG images by matplotlib, without a display."""

from __future__ import annotations

import warnings
from io import BytesIO
from typing import Any

from matplotlib import figure as mpl
from matplotlib import rc_context
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from motionlang.kernel.version import __version__
from motionlang.views.figure import Figure
from motionlang.views.figure_layout import Item, Shape, layout

DPI, POINTS_PER_INCH = 120, 72.0
SIDES = {"start": "left", "middle": "center", "end": "right"}


def png(figure: Figure) -> bytes:
    """Return a figure as a PNG image."""
    width, height, items = layout(figure)
    with rc_context({"font.family": "DejaVu Sans"}), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # a letter that the font lacks is drawn as a box
        image = mpl.Figure(figsize=(width / POINTS_PER_INCH, height / POINTS_PER_INCH), facecolor="white")
        paper = image.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0.0, width), ylim=(height, 0.0))
        paper.set_axis_off()
        for order, item in enumerate(items):
            _draw(paper, item, order)
        file = BytesIO()
        image.savefig(file, format="png", dpi=DPI, metadata={"Software": f"motionlang {__version__}"})
    return file.getvalue()


def _draw(paper: Any, item: Item, order: int) -> None:
    if isinstance(item, Shape):
        paths = [Path(points, closed=False) for points in item.paths if points]
        if paths:
            paper.add_patch(
                PathPatch(
                    Path.make_compound_path(*paths),
                    facecolor=item.fill or "none",
                    edgecolor=item.stroke or "none",
                    linewidth=item.width if item.stroke else 0.0,
                    linestyle=(0, (3, 2)) if item.is_dashed else "-",
                    alpha=item.opacity,
                    capstyle="butt",
                    joinstyle="round",
                    zorder=order,
                )
            )
        return
    # The base line of an upright text is its right side.
    x = item.x - 0.3 * item.size if item.is_upright else item.x
    paper.text(
        x, item.y, item.text, fontsize=item.size, color=item.colour, ha=SIDES[item.side],
        va="center" if item.is_upright else "baseline", rotation=90.0 * item.is_upright,
        fontweight="bold" if item.is_bold else "normal", parse_math=False, zorder=order,
    )  # fmt: skip
