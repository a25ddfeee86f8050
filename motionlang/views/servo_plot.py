"""Servo plots: motion of the motor against the demand.

matplotlib is imported only when a plot is drawn.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from motionlang.errors import need
from motionlang.files import replacing
from motionlang.notes.tn1069_servo import Row
from motionlang.servo.trace import ServoTrace
from motionlang.views.outline import thinned
from motionlang.views.plot import DPI, STYLE
from motionlang.views.plot_panel import INK
from motionlang.views.servo import SHAPE_NAMES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

BLUE, GREEN, RED, GREY, VIOLET = "#1f5fae", "#0b7a5b", "#b4490f", "#9aa6b2", "#6b4fa0"
COLOURS = (BLUE, GREEN, RED, VIOLET)
WIDTH = 10.0


@contextmanager
def drawing(path: str, width: float, height: float) -> Iterator[Figure]:
    """Yield a figure that is written to `path` (.png or .svg) at the end.

    The same picture gives the same bytes. Raises OSError, and MissingExtra if matplotlib is missing.
    """
    need("a picture", "matplotlib")
    from matplotlib import rc_context
    from matplotlib.figure import Figure

    kind = os.path.splitext(path)[1].lower()[1:]
    with rc_context(STYLE), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        figure = Figure(figsize=(width, height), facecolor="white", layout="constrained")
        yield figure
        metadata: dict[str, Any] = {"Date": None} if kind == "svg" else {"Software": "motionlang"}
        with replacing(path) as file:
            figure.savefig(file, format=kind, dpi=DPI, metadata=metadata)


def dress(panel: Axes, label: str, unit: str = "") -> None:
    """Set labels and a light grid, and remove the frame."""
    panel.set_ylabel(f"{label}\n({unit})" if unit else label, fontsize=8.5)
    panel.grid(True, color="#8496a8", alpha=0.25, linewidth=0.7)
    panel.set_axisbelow(True)
    panel.tick_params(length=0, labelsize=8)
    for side in ("top", "right"):
        panel.spines[side].set_visible(False)


def plot_trace(trace: ServoTrace, title: str, path: str) -> None:
    """Plot position, velocity, following error, output and torque of one axis.

    Position is drawn over the demand, and output together with its integral term.
    """
    span = float(trace.time[0]), float(trace.time[-1])
    rows: list[tuple[str, str, list[tuple[str, str, str]]]] = [
        ("position", "counts", [("demand", GREY, "demand"), ("position", BLUE, "motor")]),
        ("velocity", "counts/s", [("velocity", GREEN, "")]),
        ("following error", "counts", [("error", RED, "")]),
        ("output", "V", [("output", VIOLET, "output"), ("integral", GREY, "integral")]),
        ("torque", "N m", [("torque", INK, "")]),
    ]
    with drawing(path, WIDTH, 8.4) as figure:
        panels = figure.subplots(len(rows), 1, sharex=True)
        figure.suptitle(title, x=0.01, ha="left", fontsize=12, fontweight="bold")
        for panel, (label, unit, lines) in zip(panels, rows, strict=True):
            for name, colour, legend in lines:
                points = thinned(trace.time, trace[name], span)
                panel.plot(*points, color=colour, linewidth=1.3, label=legend or None)
            dress(panel, label, unit)
            if any(legend for _, _, legend in lines):
                panel.legend(loc="upper right", frameon=False, fontsize=8, ncols=2)
        panels[-1].set_xlabel("time (s)")


def plot_comparison(tables: Mapping[str, Sequence[Row]], path: str) -> None:
    """Plot velocity, motor acceleration and following error of the four profiles.

    Each comparison is a column.
    """
    with drawing(path, 5.6 * len(tables) + 0.6, 7.2) as figure:
        grid = figure.subplots(3, len(tables), sharex="col", squeeze=False)
        for column, (basis, rows) in enumerate(tables.items()):
            title = "equal peak acceleration" if basis == "acceleration" else "equal time"
            grid[0][column].set_title(title, loc="left", fontsize=10.5, fontweight="bold")
            for row, colour in zip(rows, COLOURS, strict=True):
                time = row.trace.time
                for panel, name in zip(grid[:, column], ("velocity", "acceleration", "error"), strict=True):
                    panel.plot(
                        time, row.trace[name], color=colour, linewidth=1.2, label=SHAPE_NAMES[row.shape]
                    )
            for panel, label, unit in zip(
                grid[:, column],
                ("velocity", "acceleration", "following error"),
                ("counts/s", "counts/s²", "counts"),
                strict=True,
            ):
                dress(panel, label, unit)
            grid[2][column].set_xlabel("time (s)")
        lines, names = grid[0][0].get_legend_handles_labels()
        figure.legend(lines, names, loc="outside lower center", ncols=4, frameon=False, fontsize=9)
