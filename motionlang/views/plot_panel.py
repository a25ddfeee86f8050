"""One panel of a picture of a run: curves, shaded phases and labels of moves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from motionlang.views.lanes import Lane
from motionlang.views.spans import visible
from motionlang.views.words import peak_of

if TYPE_CHECKING:
    import numpy as np
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    from motionlang.views.panels import Panel

Rows = Sequence[dict[str, Any]]

INK, FAINT, AXIS = "#1c2733", "#6b7785", "#9aa6b2"
PHASES = {
    "accel": "#e3f4ea",
    "slew": "#edf3fb",
    "decel": "#fdeee2",
    "stop": "#fadede",
    "segment": "#f1ebf9",
    "hold": "#f4f6f8",
}
ON, EVENT = "#3f6d9e", "#b3261e"
# With more than these, shading is noise and labels overlap.
MAX_SHADED, MAX_NAMED, MAX_EVENTS = 60, 40, 12
# The width of a letter of a label and half a gap between two labels, as fractions of the picture's width.
LETTER, GAP = 0.0072, 0.004
POINTS_PER_INCH = 72.0


def draw_panel(axes: Axes, panel: Panel, rows: Rows, span: tuple[float, float], second: float) -> None:
    """Draw the curves of a panel over the shaded phases of its moves.

    `rows` are the moves of its axis; `second` is one unit of the time axis in seconds.
    """
    if is_shaded(rows):
        _shade(axes, rows, pixel_of(axes, span), second)
    dense = len(rows) > MAX_SHADED
    for curve in panel.curves:
        axes.plot(
            curve.times / second,
            curve.values,
            color=curve.colour,
            label=curve.name or None,
            linewidth=0.6 if dense else 1.6,
            alpha=0.7 if dense else 1.0,
            solid_joinstyle="round",
            zorder=3,
        )
    if panel.quantity != "position":
        axes.axhline(0.0, color=AXIS, linewidth=0.8, zorder=1.5)
        _remark(axes, f"peak {peak_of(panel.peak)} {panel.unit}")
    if len(panel.curves) > 1:
        ends_high = _ends_high([curve.values for curve in panel.curves])
        axes.legend(
            loc="lower right" if ends_high else "upper right",
            ncols=len(panel.curves),
            frameon=False,
            fontsize=8,
            borderpad=0.1,
        )
    axes.set_ylabel(f"{panel.quantity}\n({panel.unit})", fontsize=8.5)
    values = [curve.values for curve in panel.curves]
    _dress(axes, min(float(each.min()) for each in values), max(float(each.max()) for each in values))


def _ends_high(curves: Sequence[NDArray[np.float64]]) -> bool:
    """True if the curves end in the upper half, where a legend would cover them."""
    low, high = min(float(each.min()) for each in curves), max(float(each.max()) for each in curves)
    return float(curves[0][-1]) > 0.5 * (low + high)


def draw_analogue(axes: Axes, lane: Lane, end: float, second: float) -> None:
    """Draw an analogue channel as steps, because each value holds until the next."""
    times = [time / second for time in (*lane.times, end)]
    axes.plot(
        times, [*lane.values, lane.values[-1]], color=ON, linewidth=1.3, drawstyle="steps-post", zorder=3
    )
    axes.set_ylabel(f"{lane.name}\n(%)", fontsize=8.5)
    _dress(axes, min(lane.values), max(lane.values))


def draw_lanes(axes: Axes, lanes: Sequence[Lane], span: tuple[float, float], second: float) -> None:
    """Draw digital channels one below the other: a bar while on, a line while off.

    Only the `span` of time is drawn.
    """
    begin, end = span
    for row, lane in enumerate(lanes):
        on = visible(lane.spans(end), span, pixel_of(axes, span))
        bars = [(start / second, (stop - start) / second) for start, stop in on]
        axes.hlines(row + 0.34, begin / second, end / second, color=AXIS, linewidth=0.8, zorder=1.5)
        # Above the frame (2.5), so that a pulse at the start is visible.
        axes.broken_barh(bars, (row - 0.34, 0.68), facecolor=ON, edgecolor="none", alpha=0.8, zorder=2.6)
    axes.set_yticks(range(len(lanes)), [lane.name for lane in lanes])
    axes.set_ylim(len(lanes) - 0.4, -0.6)
    axes.grid(True, axis="x", color="#8496a8", alpha=0.25, linewidth=0.7)
    _undress(axes)


def is_shaded(rows: Rows) -> bool:
    """True if the phases of these moves are long enough to be distinguished."""
    return 0 < sum(len(row["phases"]) for row in rows) <= MAX_SHADED


def name_moves(axes: Axes, rows: Rows, span: tuple[float, float], second: float) -> None:
    """Label the moves above a panel with their program lines, where there is room."""
    begin, end = span
    length = end - begin
    if len(rows) > MAX_NAMED or not length:
        return
    free = 0.0
    for row in rows:
        left = max(row["start_time"] - begin, 0.0) / length
        share = min((row["start_time"] + row["duration"] - begin) / length, 1.0) - left
        middle = left + 0.5 * share
        text = next((each for each in _names(row) if len(each) * LETTER < share), "")
        half = 0.5 * len(text) * LETTER
        if text and middle - half >= free:
            free = middle + half + GAP
            _above(axes, text, (begin + middle * length) / second, "data", "center", 8.0)


def mark_events(group: Sequence[Axes], rows: Rows, span: tuple[float, float], second: float) -> None:
    """Mark limits, faults and velocity jumps across all panels of their axis.

    The first panel has the labels.
    """
    named: dict[float, list[str]] = {}
    for row in rows[:MAX_EVENTS]:
        named.setdefault(row["time"], []).append(row["kind"])
    for time in named:
        for axes in group:
            axes.axvline(time / second, color=EVENT, linewidth=1.0, linestyle=(0, (3, 2)), zorder=2.5)
    for time, kinds in named.items():
        side = "right" if time > 0.5 * (span[0] + span[1]) else "left"
        group[0].annotate(
            f" {', '.join(dict.fromkeys(kinds))} ",
            (time / second, 0.04),
            xycoords=("data", "axes fraction"),
            ha=side,
            fontsize=7.5,
            color=EVENT,
            parse_math=False,
        )


def _names(row: dict[str, Any]) -> tuple[str, str, str]:
    """Return the possible labels of a move, the longest first."""
    command, line = row["command"] or "move", row["line"]
    return f"{command} · line {line}", f"{command} {line}", str(line)


def _remark(axes: Axes, text: str) -> None:
    _above(axes, text, 1.0, "axes fraction", "right", 7.5)


def _above(axes: Axes, text: str, x: float, across: str, side: str, size: float) -> None:
    axes.annotate(
        text,
        (x, 1.0),
        (0, 3),
        xycoords=(across, "axes fraction"),
        textcoords="offset points",
        ha=side,
        fontsize=size,
        color=FAINT,
        parse_math=False,
    )


def pixel_of(axes: Axes, span: tuple[float, float]) -> float:
    """Return the duration of one point when `axes` show `span`.

    A point is the unit of an SVG and at least a pixel of a PNG.
    """
    figure = axes.get_figure()
    assert figure is not None
    inches = axes.bbox.width / figure.dpi
    return (span[1] - span[0]) / (inches * POINTS_PER_INCH)


def _shade(axes: Axes, rows: Rows, pixel: float, second: float) -> None:
    """Shade the phases of every move.

    A phase shorter than a pixel is drawn on top of later ones.
    """
    for row in rows:
        begin = row["start_time"]
        for phase in row["phases"]:
            end = begin + phase["duration"]
            colour = PHASES.get(phase["name"], PHASES["hold"])
            is_short = end - begin < pixel
            shown = begin + pixel if is_short else end
            axes.axvspan(
                begin / second, shown / second, color=colour, linewidth=0, zorder=0.6 if is_short else 0.5
            )
            begin = end


def _dress(axes: Axes, low: float, high: float) -> None:
    """Set a few round ticks, a light grid, and margins above and below."""
    from matplotlib.ticker import MaxNLocator

    axes.grid(True, color="#8496a8", alpha=0.25, linewidth=0.7)
    axes.yaxis.set_major_locator(MaxNLocator(nbins=5, steps=[1, 2, 2.5, 5, 10], min_n_ticks=3))
    plain = max(abs(low), abs(high)) < 1e6
    axes.ticklabel_format(axis="y", style="plain" if plain else "sci", scilimits=(0, 0), useOffset=False)
    axes.yaxis.get_offset_text().set(fontsize=7.5, color=FAINT)
    room = 0.08 * ((high - low) or abs(high) or 1.0)
    axes.set_ylim(low - room, high + room)
    _undress(axes)


def _undress(axes: Axes) -> None:
    """Remove ticks and all of the frame except its left and bottom edges."""
    axes.set_axisbelow(True)
    axes.tick_params(length=0, labelsize=8)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
