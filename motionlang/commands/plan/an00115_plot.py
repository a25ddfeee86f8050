"""Figures of note AN00115 for any move: the trapezoid and its rectangle.

Both have the same area.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from motionlang.commands.plan.an00115 import Move, cut_triangle, moved_triangle, rectangle, trapezoid
from motionlang.views.figure import AXIS, BLUE, FAINT, INK, RED, Area, Curve, Figure, Note, Panel

Point = tuple[float, float]

WIDTH, HEIGHT = 720.0, 185.0


def plan_figure(move: Move) -> Figure:
    """Return the figure of a move, with the rectangle if acceleration and deceleration are equal."""
    is_equal = move["accel_time"] == move["decel_time"]
    panels = [_trapezoid(move), _rectangle(move)] if is_equal else [_trapezoid(move)]
    return Figure([[panel] for panel in panels], x_label="time (s)", width=WIDTH)


def _trapezoid(move: Move) -> Panel:
    """Return the speed over time with T, Ta, Ts, Td and Sp."""
    speed, up, slew, down = (move[name] for name in ("speed", "accel_time", "slew_time", "decel_time"))
    spans: list[tuple[Curve, Note]] = []
    begin = 0.0
    for name, length in (("Ta", up), ("Ts", slew), ("Td", down)):
        if length > 0.0:
            spans.append(_span(begin, begin + length, -0.14 * speed, f"{name} = {length:.6g} s"))
        begin += length
    spans.append(_span(0.0, move["time"], -0.32 * speed, f"T = {move['time']:.6g} s"))
    sides = [Curve([at, at], [0.0, speed], AXIS, width=0.8, is_dashed=True) for at in (up, up + slew)]
    return Panel(
        [_line(trapezoid(move), BLUE), *sides, *(curve for curve, _ in spans)],
        "speed",
        "uu/s",
        height=HEIGHT,
        areas=[_area(trapezoid(move), "#eef3f8")],
        notes=[
            *(note for _, note in spans),
            Note(up + 0.5 * slew, speed, f"Sp = {speed:.6g}", size=9.0),
            Note(0.62 * up, 0.22 * speed, "Accel = Sp / Ta"),
            Note(move["time"] - 0.62 * down, 0.22 * speed, "Decel = Sp / Td"),
        ],
        y_limits=(-0.4 * speed, 1.2 * speed),
    )


def _rectangle(move: Move) -> Panel:
    """Return the rectangle, the triangle cut off the trapezoid and its new position."""
    speed, end = move["speed"], move["accel_time"] + move["slew_time"]
    length, note = _span(0.0, end, -0.14 * speed, "Ta + Ts")
    text = f"Distance = Sp (Ta + Ts) = {speed:.6g} · {end:.6g} = {abs(move['distance']):.6g}"
    tail = move["time"] - 0.65 * move["decel_time"], 0.35 * speed
    tip = 0.35 * move["accel_time"], 0.7 * speed
    return Panel(
        [
            _line(trapezoid(move), BLUE),
            _line([*rectangle(move), (0.0, 0.0)], RED),
            _line(list(_arc(tail, tip, 0.3 * speed)), FAINT, width=0.8, marker="arrow"),
            length,
        ],
        "speed",
        "uu/s",
        height=HEIGHT,
        areas=[_area(cut_triangle(move), "#e1e5e8"), _area(moved_triangle(move), "#f0dad1")],
        notes=[note, Note(0.5 * end, 1.02 * speed, text, RED)],
        y_limits=(-0.26 * speed, 1.22 * speed),
    )


def _line(points: Sequence[Sequence[float]], colour: str, **style: object) -> Curve:
    return Curve([p[0] for p in points], [p[1] for p in points], colour, **style)  # type: ignore[arg-type]


def _arc(tail: Point, tip: Point, height: float) -> Iterator[Point]:
    """Yield the points of an arc between two points, `height` above the middle of their line."""
    for n in range(21):
        share = n / 20
        x, y = (a + (b - a) * share for a, b in zip(tail, tip, strict=True))
        yield x, y + 4.0 * height * share * (1.0 - share)


def _area(points: Sequence[Sequence[float]], colour: str) -> Area:
    return Area([p[0] for p in points], [p[1] for p in points], colour)


def _span(begin: float, end: float, height: float, text: str) -> tuple[Curve, Note]:
    """Return an arrow between two times, and a text above it."""
    arrow = Curve([begin, end], [height, height], FAINT, width=0.8, marker="arrows")
    return arrow, Note(0.5 * (begin + end), height, text, INK)
