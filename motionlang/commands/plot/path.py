"""The path of two axes as a figure, coloured by the speed along it.

This is `--path 0,1`.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel import Run, Trace
from motionlang.kernel.planners import ORDERS
from motionlang.kernel.report import moves as moves_of
from motionlang.views.figure import FAINT, TURBO, ColourScale, Curve, Figure, Note, Panel
from motionlang.views.formatting import dialect_name, outcome, peak_of
from motionlang.views.terminal import printable
from motionlang.views.window import Window

Array = NDArray[np.float64]

# The number of points along the path, of colours, and the largest number of lines labelled.
POINTS, LEVELS, MAX_NAMED = 6000, 64, 40
WIDTH, HEIGHT = 648.0, 470.0


def path_figure(run: Run, axes: tuple[int, ...], window: Window) -> Figure:
    """Return a figure of the path of two `axes` in a window of the run.

    Raises ValueError as `Window` does.
    """
    trace = run.trace
    window._replace(axes=axes).of(trace.axes)
    span = window.span(trace.end)
    times = np.linspace(*span, POINTS)
    positions = np.stack([_along(trace, axis, "position", times) for axis in axes], 1)
    speeds = np.linalg.norm(np.stack([_along(trace, axis, "velocity", times) for axis in axes]), axis=0)
    most = float(speeds.max())
    scale = ColourScale(f"speed (uu/s), at most {peak_of(most)}", 0.0, most or 1.0, TURBO)
    margins = 0.06 * max(float(np.ptp(positions, axis=0).max()), 1e-9)
    low, high = positions.min(axis=0) - margins, positions.max(axis=0) + margins
    panel = Panel(
        list(_coloured(positions, speeds, scale)),
        f"axis {axes[1]} (uu)",
        height=HEIGHT,
        is_equal=True,
        notes=list(_line_names(run, axes, span)),
        x_limits=(float(low[0]), float(high[0])),
        y_limits=(float(low[1]), float(high[1])),
    )
    return Figure(
        [[panel]],
        x_label=f"axis {axes[0]} (uu)",
        title=printable(run.source.name),
        subtitle=f"{dialect_name(run.dialect.name)} · {outcome(run)} · {span[0]:g} to {span[1]:g} s",
        scale=scale,
        width=WIDTH,
    )


def _along(trace: Trace, axis: int, quantity: str, times: Array) -> Array:
    """Return values of one axis at evenly spaced times."""
    step = max(float(times[-1] - times[0]) / (len(times) - 1), 1e-12)
    values = trace.table(axis).sample(float(times[0]), step, len(times), ORDERS[quantity])
    trace.to_user(axis, quantity, times, values)
    return values


def _coloured(points: Array, speeds: Array, scale: ColourScale) -> Iterator[Curve]:
    """Yield the path in sections of one colour, that of the mean speed of their segments."""
    middle = 0.5 * (speeds[:-1] + speeds[1:])
    levels = np.rint(middle / scale.high * LEVELS).astype(int).tolist()
    first = 0
    for level, group in groupby(levels):
        last = first + len(list(group))
        x, y = points[first : last + 1].T.tolist()
        yield Curve(x, y, scale.colour(level / LEVELS * scale.high), width=1.8)
        first = last


def _line_names(run: Run, of: tuple[int, ...], span: tuple[float, float]) -> Iterator[Note]:
    """Yield the program lines of the sections of the path, once per line."""
    rows: list[dict[str, Any]] = [row for row in moves_of(run) if row["axis"] == of[0] and row["line"]]
    named: set[int] = set()
    for row in rows:
        middle = row["start_time"] + 0.5 * row["duration"]
        if row["line"] in named or not span[0] <= middle <= span[1] or len(named) >= MAX_NAMED:
            continue
        named.add(row["line"])
        x, y = (float(_along(run.trace, axis, "position", np.array([middle, middle]))[0]) for axis in of)
        yield Note(x, y, f"line {row['line']}", FAINT, "start", 7.5)
