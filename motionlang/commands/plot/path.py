"""The path of two or three axes as a figure, coloured by the speed along it.

This is `--path 0,1`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import groupby
from math import cos, radians, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motionlang.kernel import Run, Trace
from motionlang.kernel.planners import ORDERS
from motionlang.kernel.report import moves as moves_of
from motionlang.views.figure import AXIS, FAINT, INK, TURBO, Area, ColourScale, Curve, Figure, Note, Panel
from motionlang.views.figure_layout import Ticks
from motionlang.views.formatting import dialect_name, outcome, peak_of
from motionlang.views.terminal import printable
from motionlang.views.window import Window

Array = NDArray[np.float64]

# The number of points along the path, of colours, and the largest number of lines labelled.
POINTS, LEVELS, MAX_NAMED = 6000, 64, 40
WIDTH, HEIGHT = 648.0, 470.0
# The sides of the box around three axes and their grid lines.
SIDE, LINE = "#f5f6f8", "#d3d9df"
# The directions from which three axes are seen, in degrees.
AZIMUTH, ELEVATION = -60.0, 30.0


def path_figure(run: Run, axes: tuple[int, ...], window: Window) -> Figure:
    """Return a figure of the path of two or three `axes` in a window of the run.

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
    names = [f"axis {axis} (uu)" for axis in axes]
    panel = Panel(height=HEIGHT, is_equal=True)
    if len(axes) == 3:
        frame = list(_box(positions.min(axis=0), positions.max(axis=0), names))
        panel = replace(
            panel,
            curves=[each for each in frame if isinstance(each, Curve)],
            areas=[each for each in frame if isinstance(each, Area)],
            notes=[each for each in frame if isinstance(each, Note)],
            has_frame=False,
        )
    else:
        panel = replace(panel, label=names[1], notes=list(_line_names(run, axes, span)))
    drawn = _seen(positions)
    margins = 0.06 * max(float(np.ptp(drawn, axis=0).max()), 1e-9)
    curves = [*panel.curves, *_coloured(drawn, speeds, scale)]
    shown = [*((x, y) for curve in curves for x, y in zip(curve.x, curve.y, strict=True))]
    shown += [(note.x, note.y) for note in panel.notes]
    low, high = np.min(shown, axis=0) - margins, np.max(shown, axis=0) + margins
    panel = replace(
        panel,
        curves=curves,
        x_limits=(float(low[0]), float(high[0])),
        y_limits=(float(low[1]), float(high[1])),
    )
    return Figure(
        [[panel]],
        x_label=names[0],
        title=printable(run.source.name),
        subtitle=f"{dialect_name(run.dialect.name)} · {outcome(run)} · {span[0]:g} to {span[1]:g} s",
        scale=scale,
        width=WIDTH,
    )


def _along(trace: Trace, axis: int, quantity: str, times: Array) -> Array:
    """Return values of one axis at evenly spaced times."""
    step = max(float(times[-1] - times[0]) / (len(times) - 1), 1e-12)
    values = trace.table(axis).sample(float(times[0]), step, len(times), ORDERS[quantity])
    trace.to_user(axis, quantity, values)
    return values


def _seen(positions: Array) -> Array:
    """Return the points on the paper; those of three axes are projected in parallel."""
    if positions.shape[1] == 2:
        return positions
    a, e = radians(AZIMUTH), radians(ELEVATION)
    right = np.array([-sin(a), cos(a), 0.0])
    up = np.array([-sin(e) * cos(a), -sin(e) * sin(a), cos(e)])
    return np.stack((positions @ right, positions @ up), 1)


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


def _box(low: Array, high: Array, names: list[str]) -> Iterator[Curve | Note | Area]:
    """Yield the far sides of a box around a path in space, with grid lines, ticks and names."""
    size = max(float((high - low).max()), 1e-9)
    low, high = low - 0.06 * size, high + 0.06 * size
    far, near = np.array([low[0], high[1], low[2]]), np.array([high[0], low[1], high[2]])
    # Each side has one coordinate of the far corner.
    for n in range(3):
        others = [other for other in range(3) if other != n]
        corners = np.stack([far] * 4)
        corners[1:3, others[0]] = near[others[0]]
        corners[2:4, others[1]] = near[others[1]]
        x, y = _seen(corners).T.tolist()
        yield Area(x, y, SIDE)
    right, front = np.array([1.0, 0.0, 0.0]), np.array([0.0, -1.0, 0.0])
    edges = (near[0], near[1], far[2]), (near[0], near[1], far[2]), (near[0], far[1], far[2])
    for n, (name, edge, out) in enumerate(zip(names, edges, (front, right, right), strict=True)):
        ticks = Ticks(float(low[n]), float(high[n]), 6 if high[n] - low[n] > 0.4 * size else 3)
        for value in ticks.values:
            for other in range(3):
                if other != n:
                    ends = np.stack((far, far))
                    ends[:, n], ends[1, other] = value, near[other]
                    x, y = _seen(ends).T.tolist()
                    yield Curve(x, y, LINE, width=0.7)
        ends = np.array((edge, edge))
        ends[:, n] = low[n], high[n]
        x, y = _seen(ends).T.tolist()
        yield Curve(x, y, AXIS, width=0.8)
        texts = [(value, 0.06, text, FAINT) for value, text in zip(ticks.values, ticks.names, strict=True)]
        if n < 2:
            texts.append((float(0.5 * (low[n] + high[n])), 0.2, name, INK))
        else:
            texts.append((float(high[n] + 0.05 * size), 0.0, name, INK))
        for value, away, text, colour in texts:
            at = np.array(edge) + away * size * out
            at[n] = value
            x, y = _seen(at[None, :])[0].tolist()
            yield Note(x, y, text, colour)


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
