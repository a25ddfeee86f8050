"""PVT moves as text: segments, methods for velocities and results of a stream."""

from __future__ import annotations

from collections.abc import Sequence

from motionlang.errors import count_of
from motionlang.planners.curve import Profile
from motionlang.planners.pvt.points import Knot, knots, segments
from motionlang.views.grid import Column, decimals_of, grid, headed

WIDTH = 120
MAX_ROWS = 40
MAX_COLUMNS = 12
NOISE = 1e-12
"""Largest jump, relative to the accelerations around it, that is a rounding error."""


def segment_lines(profile: Profile) -> list[str]:
    """Return each segment with its jerk, acceleration and initial acceleration jump."""
    columns = headed(
        "segment", "start, ms", "time, ms", "end, counts", "end velocity, counts/s", "acceleration, counts/s²",
        "to, counts/s²", "jerk, counts/s³", "jump before, counts/s²"
    )  # fmt: skip
    marks, found = knots(profile), segments(profile)
    scale = max((abs(a) for s in found for a in (s.acceleration, s.end_acceleration)), default=0.0)
    cells = [
        (
            each.start_time * 1000.0,
            each.duration * 1000.0,
            marks[i + 1].position,
            marks[i + 1].velocity,
            quiet(each.acceleration, scale),
            quiet(each.end_acceleration, scale),
            each.jerk,
            quiet(marks[i].jump, scale),
        )
        for i, each in enumerate(found)
    ]
    shown = _figures(cells)
    lines = grid(columns, [[str(i), *row] for i, row in enumerate(shown[:MAX_ROWS])], width=WIDTH)
    if len(shown) > MAX_ROWS:
        lines.append(f"… and {len(shown) - MAX_ROWS} more segments")
    lines += ["", _summary(profile, marks, scale)]
    return lines


def _summary(profile: Profile, marks: Sequence[Knot], scale: float) -> str:
    count = len(marks) - 1
    text = f"{count_of(count, 'segment')}, {figure(profile.duration * 1000.0)} ms"
    step = max((abs(mark.next_velocity - mark.velocity) for mark in marks), default=0.0)
    if quiet(step, profile.peak_speed):
        text += f"; largest velocity jump {figure(step)} counts/s"
    largest = max((abs(quiet(mark.jump, scale)) for mark in marks[1:-1]), default=0.0)
    return f"{text}; largest acceleration jump {figure(largest)} counts/s² between the ends"


def comparison_lines(
    rows: Sequence[tuple[str, Sequence[float], float]], accelerations: Sequence[float]
) -> list[str]:
    """Compare the methods for velocities by their largest acceleration jump.

    For short moves the velocities are listed.
    """
    scale = max(map(abs, accelerations), default=0.0)
    inner = len(rows[0][1]) - 2
    columns = [Column("velocities", align="<"), Column("largest jump", "counts/s²")]
    count = inner if inner <= MAX_COLUMNS else 0
    columns += [Column(f"v{n}", "counts/s", drop=n) for n in range(1, count + 1)]
    jumps = _column([quiet(jump, scale) for _, _, jump in rows], 1)
    speeds = [_column([v[n] for _, v, _ in rows], 2) for n in range(1, count + 1)]
    cells = [[name, jumps[i], *(column[i] for column in speeds)] for i, (name, _, _) in enumerate(rows)]
    return grid(columns, cells, width=WIDTH)


def quiet(value: float, scale: float) -> float:
    """Return the value, or 0 if it is only a rounding error relative to `scale`."""
    return value if abs(value) > NOISE * scale else 0.0


def pairs_lines(pairs: Sequence[tuple[str, str]]) -> list[str]:
    """Return aligned names and values."""
    width = max(len(name) for name, _ in pairs)
    return [f"{name:<{width}}  {value}" for name, value in pairs]


def figure(value: float, most: int = 4) -> str:
    """Format a number with as many decimals as it needs, at most `most`."""
    return f"{value:.{decimals_of([value], most)}f}"


def _figures(rows: Sequence[Sequence[float]]) -> list[list[str]]:
    columns = [_column(list(column)) for column in zip(*rows, strict=True)]
    return [list(row) for row in zip(*columns, strict=True)]


def _column(values: Sequence[float], most: int = 4) -> list[str]:
    decimals = decimals_of(values, most)
    texts = [f"{value:.{decimals}f}" for value in values]
    return [text if float(text) else text.lstrip("-") for text in texts]
