"""PVT moves as text: segments, methods for velocities and results of a stream."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from operator import itemgetter
from typing import Any

from motionlang.kernel.planners import Profile
from motionlang.kernel.tools import count_of
from motionlang.lab.pvt.points import Knot, knots, segments
from motionlang.views.formatting import ROUNDING, decimals_of
from motionlang.views.table import Column, Document, Table

WIDTH = 120
MAX_ROWS = 40
MAX_COLUMNS = 12


def motion_document(name: str, profile: Profile) -> Document:
    """Return the motion of a drive as data: its knots and segments."""
    marks = [
        {
            "time": mark.time,
            "position": mark.position,
            "velocity": mark.velocity,
            "acceleration_before": mark.acceleration,
            "acceleration_after": mark.next_acceleration,
            "jump": mark.jump,
        }
        for mark in knots(profile)
    ]
    columns = tuple(map(Column, marks[0]))
    values = {"move": name, "duration": profile.duration}
    return Document([segments_table(profile), Table("knots", columns, marks)], values)


def segments_table(profile: Profile) -> Table:
    """Return each segment with its jerk, acceleration and initial acceleration jump."""
    marks, found = knots(profile), segments(profile)
    rows = [
        {
            "segment": i,
            "start_time": each.start_time,
            "duration": each.duration,
            "end_position": marks[i + 1].position,
            "end_velocity": marks[i + 1].velocity,
            "acceleration": each.acceleration,
            "end_acceleration": each.end_acceleration,
            "jerk": each.jerk,
            "jump_before": marks[i].jump,
        }
        for i, each in enumerate(found)
    ]
    scale = _scale(profile)
    columns = (
        Column("segment"),
        _fixed(rows, "start_time", "start", "ms"),
        _fixed(rows, "duration", "time", "ms"),
        _fixed(rows, "end_position", "end", "counts"),
        _fixed(rows, "end_velocity", "end velocity", "counts/s"),
        _fixed(rows, "acceleration", "acceleration", "counts/s²", scale=scale),
        _fixed(rows, "end_acceleration", "to", "counts/s²", scale=scale),
        _fixed(rows, "jerk", "jerk", "counts/s³"),
        _fixed(rows, "jump_before", "jump before", "counts/s²", scale=scale),
    )
    return Table("segments", columns, rows)


def segment_lines(profile: Profile) -> list[str]:
    """Return the first segments as lines of text, with a summary of the motion."""
    table = segments_table(profile)
    if len(table.rows) > MAX_ROWS:
        table.notes.append(f"… and {len(table.rows) - MAX_ROWS} more segments")
        table.rows = table.rows[:MAX_ROWS]
    return [*table.lines(WIDTH), "", _summary(profile, knots(profile), _scale(profile))]


def _scale(profile: Profile) -> float:
    found = segments(profile)
    return max((abs(a) for s in found for a in (s.acceleration, s.end_acceleration)), default=0.0)


def _summary(profile: Profile, marks: Sequence[Knot], scale: float) -> str:
    count = len(marks) - 1
    text = f"{count_of(count, 'segment')}, {figure(profile.duration * 1000.0)} ms"
    step = max((abs(mark.next_velocity - mark.velocity) for mark in marks), default=0.0)
    if step > ROUNDING * profile.peak_speed:
        text += f"; largest velocity jump {figure(step)} counts/s"
    largest = max((abs(mark.jump) for mark in marks[1:-1]), default=0.0)
    shown = figure(largest if largest > ROUNDING * scale else 0.0)
    return f"{text}; largest acceleration jump {shown} counts/s² between the ends"


def methods_table(
    rows: Sequence[tuple[str, Sequence[float], float]], accelerations: Sequence[float]
) -> Table:
    """Return the methods for velocities with their largest acceleration jump, counts/s².

    For short moves the velocities are shown; in JSON all of them are `values`.
    """
    scale = max(map(abs, accelerations), default=0.0)
    methods: list[dict[str, object]] = [
        {"velocities": name, "largest_jump": jump, "values": velocities}
        | {f"v{n}": velocity for n, velocity in enumerate(velocities)}
        for name, velocities, jump in rows
    ]
    inner = len(rows[0][1]) - 2
    columns = [
        Column("velocities", left=True),
        _fixed(methods, "largest_jump", "largest jump", "counts/s²", most=1, scale=scale),
        Column("values", data=True),
    ]
    for n in range(1, inner + 1 if inner <= MAX_COLUMNS else 1):
        shown = _fixed(methods, f"v{n}", f"v{n}", "counts/s", most=2)
        columns.append(replace(shown, key="", get=itemgetter(f"v{n}"), drop=n))
    return Table("methods", columns, methods)


def figure(value: float, most: int = 4) -> str:
    """Format a number with as many decimals as it needs, at most `most`."""
    return f"{value:.{decimals_of([value], most)}f}"


def _fixed(
    rows: Sequence[dict[str, Any]], key: str, title: str, unit: str, most: int = 4, scale: float = 0.0
) -> Column:
    """Return a column of numbers with the same decimals, at most so many; `scale` is their usual size."""
    factor = 1000.0 if unit == "ms" else 1.0
    values = [factor * row[key] for row in rows]
    least = ROUNDING * max(map(abs, [*values, scale]))
    form = f"{{:z.{decimals_of((value for value in values if abs(value) > least), most)}f}}"
    return Column(key, title, unit, text=lambda value: form.format(factor * value))
