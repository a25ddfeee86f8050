"""Velocity over time as an SVG of a few kilobytes, for a notebook."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from math import inf

from motionlang.controller.axis import Axis
from motionlang.views.chart import velocity_spans
from motionlang.views.words import clock_time

Point = tuple[float, float]

WIDTH, HEIGHT, LEFT, BELOW = 720, 90, 70, 18
# Intervals over the width; each shows its lowest and its highest velocity.
COLUMNS = 600


def velocity_curve(axis: Axis, end: float) -> str:
    """Return a drawing of an axis's velocity (uu/s) from 0 to `end` seconds.

    The result is "" if the axis never moved.
    """
    scale = axis.scale.counts or 1.0
    step = (end or 1.0) / COLUMNS
    spans = [sorted((low / scale, high / scale)) for low, high in velocity_spans(axis, end, COLUMNS)]
    points: list[Point] = []
    for number, (low, high) in enumerate(spans):
        # Rising and falling by turns, so that one line passes through all extremes.
        first, second = (low, high) if number % 2 else (high, low)
        points += [((number + 0.5) * step, first), ((number + 0.5) * step, second)]
    return curve(points, 0.0, end, f"axis {axis.index}: velocity, uu/s")


def curve(points: Sequence[Point], begin: float, end: float, title: str) -> str:
    """Return a curve of points (seconds, value) from `begin` to `end`.

    The result is "" if all values are 0.
    """
    low = min(0.0, *(value for _, value in points))
    high = max(0.0, *(value for _, value in points))
    if not 0.0 < high - low < inf:
        return ""
    across, up = (WIDTH - LEFT) / ((end - begin) or 1.0), HEIGHT / (high - low)
    line = " ".join(
        f"{LEFT + (time - begin) * across:.1f},{(high - value) * up:.1f}" for time, value in points
    )
    zero = high * up
    texts = [
        _text(LEFT - 4, 9.0, f"{high:.6g}" if high else "", "end"),
        _text(LEFT - 4, HEIGHT, f"{low:.6g}" if low else "", "end"),
        _text(LEFT, HEIGHT + BELOW - 5, clock_time(begin) if begin else "0", "start"),
        _text(WIDTH, HEIGHT + BELOW - 5, clock_time(end), "end"),
    ]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT + BELOW}" '
        f'font-family="monospace" font-size="11" fill="currentColor"><title>{escape(title)}</title>'
        f'<path d="M{LEFT} {zero:.1f}H{WIDTH}" stroke="currentColor" stroke-opacity="0.3"/>'
        f'<polyline points="{line}" fill="none" stroke="#3b7dd8"/>{"".join(texts)}</svg>'
    )


def _text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}">{escape(text)}</text>' if text else ""
