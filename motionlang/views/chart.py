"""Panels in braille dots, for a terminal, and the velocity of an axis as a panel.

A character has two columns of four dots. Every column of dots spans the range between the lowest and the highest
velocity in its interval. This range is computed from the pieces of the motion, so a short move in a long run
remains visible.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, islice
from math import inf

from motionlang.kernel import Axis
from motionlang.kernel.planners import Profile
from motionlang.views.figure import Curve, Panel
from motionlang.views.formatting import clock_time
from motionlang.views.quantities import COLOURS
from motionlang.views.terminal import styled

Span = tuple[float, float]

# The width of the values at the left, in characters.
LABEL = 10
# The bits of the dots in U+2800…28FF, left and right column, from the top.
_DOTS = ((0x01, 0x02, 0x04, 0x40), (0x08, 0x10, 0x20, 0x80))


def velocity_panel(axis: Axis, end: float, count: int) -> Panel:
    """Return the velocity of `axis` from 0 to `end` seconds, with the extremes of `count` equal intervals."""
    step = (end or 1.0) / count
    x: list[float] = []
    y: list[float] = []
    for number, (low, high) in enumerate(velocity_spans(axis, end, count)):
        counts, _ = axis.scale_at((number + 0.5) * step)
        extremes = sorted((low / counts, high / counts))
        # Rising and falling by turns, so that one line passes through all extremes.
        y += extremes if number % 2 else extremes[::-1]
        x += [(number + 0.5) * step] * 2
    curve = Curve(x, y, COLOURS["velocity"], width=1.2)
    return Panel(
        [curve], "velocity", "uu/s", f"axis {axis.index}", height=90.0, x_limits=(0.0, end), has_zero=True
    )


def velocity_chart(axis: Axis, end: float, *, width: int, height: int, colour: bool = False) -> list[str]:
    """Return the lines of a chart of the velocity of `axis` from 0 to `end` seconds."""
    return chart(velocity_panel(axis, end, 2 * _across(width)), width=width, height=height, colour=colour)


def chart(panel: Panel, *, width: int, height: int, colour: bool = False) -> list[str]:
    """Return the lines of a chart of the curve of `panel` over time.

    `width` is the total width in characters, `height` the number of rows of dots. There are no lines if all values are
    0.
    """
    (curve,) = panel.curves
    across, (begin, end) = _across(width), panel.x_limits or (0.0, curve.x[-1])
    spans = _spans(curve, begin, end, 2 * across)
    low = min(0.0, *(span[0] for span in spans))
    high = max(0.0, *(span[1] for span in spans))
    if low == high:
        return []
    zero = round(high / (high - low) * (4 * height - 1)) // 4
    lines = []
    for row, text in enumerate(dots(spans, low, high, height)):
        value = {0: high, height - 1: low}.get(row)
        if row == zero:
            value = 0.0
        name = "" if value is None else f"{value:.6g}"
        mark = "│" if value is None else "┼" if row == zero else "┤"
        lines.append(
            f"{name:>{LABEL}} {styled(mark, 'dim', colour)}{styled(text.rstrip(chr(0x2800)), 'chart', colour)}"
        )
    first, last = clock_time(begin) if begin else "0", clock_time(end)
    gap = max(1, across - len(first) - len(last))
    lines.append(" " * (LABEL + 2) + styled(first + " " * gap + last, "dim", colour))
    return lines


def _across(width: int) -> int:
    return max(10, width - LABEL - 2)


def _spans(curve: Curve, begin: float, end: float, count: int) -> list[Span]:
    """Return the lowest and the highest value of a curve in each of `count` columns."""
    found: list[list[float]] = [[] for _ in range(count)]
    factor = count / ((end - begin) or 1.0)
    at, last = 0, 0.0
    for x, y in zip(curve.x, curve.y, strict=True):
        here = min(max(int((x - begin) * factor), 0), count - 1)
        for column in range(at + 1, here):  # a line passes through the columns between two points
            found[column].append(last + (y - last) * (column - at) / (here - at))
        found[here].append(y)
        at, last = here, y
    return [(min(values), max(values)) if values else (0.0, 0.0) for values in found]


def velocity_spans(axis: Axis, end: float, count: int) -> list[Span]:
    """Return the lowest and highest velocity in each of `count` equal intervals.

    The intervals divide 0…`end`; the velocities are in counts/s.
    """
    step = (end or 1.0) / count
    lows, highs = [inf] * count, [-inf] * count

    def note(at: int, *values: float) -> None:
        at = min(max(at, 0), count - 1)
        lows[at] = min(lows[at], *values)
        highs[at] = max(highs[at], *values)

    ends = chain(islice(axis.starts, 1, None), (end,))
    for start, following, profile in zip(axis.starts, ends, axis.profiles, strict=True):
        first, last = int(start / step), int(min(following, end) / step)
        if first == last:
            note(first, profile.start_velocity, *_turning_velocities(profile, following - start))
            continue
        for at in range(max(first, 0), min(last, count - 1) + 1):
            a, b = max(at * step, start) - start, min((at + 1) * step, following) - start
            note(at, *_velocities(profile, a, b))
    return [(low, high) if low <= high else (0.0, 0.0) for low, high in zip(lows, highs, strict=True)]


def dots(spans: Sequence[Span], low: float, high: float, height: int) -> list[str]:
    """Return rows of braille characters, two spans per character.

    Each span is drawn from its lowest to its highest value and joined to the next one.
    """
    top = 4 * height - 1
    factor = top / (high - low)
    columns = [(round((high - b) * factor), round((high - a) * factor)) for a, b in spans]
    for i in range(1, len(columns)):
        (upper, lower), (left_upper, left_lower) = columns[i], columns[i - 1]
        columns[i] = (min(upper, left_lower), max(lower, left_upper))
    cells = [[0] * ((len(spans) + 1) // 2) for _ in range(height)]
    for i, (upper, lower) in enumerate(columns):
        for y in range(upper, lower + 1):
            cells[y // 4][i // 2] |= _DOTS[i % 2][y % 4]
    return ["".join(chr(0x2800 + cell) for cell in row) for row in cells]


def _velocities(profile: Profile, begin: float, finish: float) -> list[float]:
    """Return the velocities at both ends of an interval and at the knots inside it.

    Between these points the velocity is monotonic.
    """
    found = [profile.velocity(begin), profile.velocity(finish)]
    if profile.shape != "hold":
        found += [profile.velocity(knot) for knot in profile.knots if begin < knot < finish]
    return found


def _turning_velocities(profile: Profile, length: float) -> list[float]:
    """Return the velocities that a profile within one interval reaches.

    The pieces of the profile are not computed.
    """
    if profile.shape == "hold" or length >= profile.duration:
        return [phase.end_velocity for phase in profile.phases]
    return _velocities(profile, 0.0, length)
