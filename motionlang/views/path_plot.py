"""The path of two or three axes as a picture, coloured by speed along it.

This is `--plot OUT --path 0,1`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from mpl_toolkits.mplot3d import art3d
from numpy.typing import NDArray

from motionlang.log.trace import Trace
from motionlang.planners.sample import ORDERS
from motionlang.report import moves as moves_of
from motionlang.result import Run
from motionlang.views.plot_panel import FAINT
from motionlang.views.terminal import printable
from motionlang.views.window import Window
from motionlang.views.words import dialect_name, outcome, peak_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

# The number of points along the path, and the largest number of lines labelled.
POINTS, MAX_NAMED = 6000, 40
SIZE = 9.0


def path_figure(run: Run, axes: tuple[int, ...], window: Window) -> Figure:
    """Return a figure of the path of two or three `axes` in a window of the run.

    Raises ValueError as `Window` does.
    """
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize
    from matplotlib.figure import Figure

    trace = run.trace
    window._replace(axes=axes).of(trace.axes)
    span = window.span(trace.end)
    times = np.linspace(*span, POINTS)
    positions = np.stack([_along(trace, axis, "position", times) for axis in axes], 1)
    speeds = np.linalg.norm(np.stack([_along(trace, axis, "velocity", times) for axis in axes]), axis=0)
    most = float(speeds.max())
    figure = Figure(figsize=(SIZE, SIZE * 0.86), facecolor="white")
    drawn: Any = figure.add_axes((0.1, 0.09, 0.76, 0.78), projection="3d" if len(axes) == 3 else None)
    colours = ScalarMappable(Normalize(0.0, most or 1.0), "turbo")
    _draw(drawn, positions, speeds, colours)
    for name, axis in zip("xyz", axes, strict=False):
        getattr(drawn, f"set_{name}label")(f"axis {axis} (uu)", fontsize=8.5)
    drawn.tick_params(length=0, labelsize=8)
    drawn.grid(True, color="#8496a8", alpha=0.25, linewidth=0.7)
    if len(axes) == 2:
        _name_lines(drawn, run, axes, span)
    bar = figure.colorbar(colours, cax=figure.add_axes((0.89, 0.2, 0.018, 0.5)))
    bar.set_label(f"speed (uu/s), at most {peak_of(most)}", fontsize=8.5)
    bar.ax.tick_params(length=0, labelsize=8)
    bar.outline.set_visible(False)
    figure.text(0.1, 0.955, printable(run.source.name), fontsize=14, fontweight="bold", parse_math=False)
    figure.text(
        0.1,
        0.922,
        f"{dialect_name(run.dialect.name)}  ·  {outcome(run)}  ·  {span[0]:g} to {span[1]:g} s",
        fontsize=9,
        color=FAINT,
        parse_math=False,
    )
    return figure


def _along(trace: Trace, axis: int, quantity: str, times: Array) -> Array:
    """Return values of one axis at evenly spaced times."""

    values = np.empty(len(times))
    step = max(float(times[-1] - times[0]) / (len(times) - 1), 1e-12)
    trace.table(axis).sample(float(times[0]), step, len(times), ORDERS[quantity], values)
    trace.to_user(axis, quantity, values)
    return values


def _draw(axes: Any, positions: Array, speeds: Array, colours: Any) -> None:
    """Draw segments, each in the colour of its mean speed."""
    stretches = np.stack((positions[:-1], positions[1:]), 1)
    middle = 0.5 * (speeds[:-1] + speeds[1:])
    kind: Any
    if positions.shape[1] == 3:
        kind = art3d.Line3DCollection
    else:
        from matplotlib import collections

        kind = collections.LineCollection
    axes.add_collection(kind(stretches, colors=colours.to_rgba(middle), linewidths=1.8, capstyle="round"))
    low, high = positions.min(axis=0), positions.max(axis=0)
    room = 0.06 * max(float((high - low).max()), 1e-9)
    for name, first, last in zip("xyz", low, high, strict=False):
        getattr(axes, f"set_{name}lim")(first - room, last + room)
    axes.set_aspect("equal")


def _name_lines(axes: Axes, run: Run, of: tuple[int, ...], span: tuple[float, float]) -> None:
    """Label the sections of the path with their program lines, once per line."""
    rows: list[dict[str, Any]] = [row for row in moves_of(run) if row["axis"] == of[0] and row["line"]]
    named: set[int] = set()
    for row in rows:
        middle = row["start_time"] + 0.5 * row["duration"]
        if row["line"] in named or not span[0] <= middle <= span[1] or len(named) >= MAX_NAMED:
            continue
        named.add(row["line"])
        at = [float(_along(run.trace, axis, "position", np.array([middle, middle]))[0]) for axis in of]
        axes.annotate(
            f"line {row['line']}",
            (at[0], at[1]),
            (5, 4),
            textcoords="offset points",
            fontsize=7.5,
            color=FAINT,
        )
