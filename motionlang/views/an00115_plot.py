"""Drawings of note AN00115 for any move: the trapezoid and its rectangle.

Both have the same area.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.notes.an00115 import Move, cut_triangle, moved_triangle, rectangle, trapezoid
from motionlang.views.servo_plot import BLUE, GREY, RED, WIDTH, drawing, dress

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def draw_plan(move: Move, path: str) -> None:
    """Draw a move into a .png or .svg file.

    The rectangle is drawn only if acceleration and deceleration are equal.
    """
    equal = move["accel_time"] == move["decel_time"]
    with drawing(path, WIDTH, 6.4 if equal else 3.4) as figure:
        panels = figure.subplots(2 if equal else 1, 1, sharex=True, squeeze=False)[:, 0]
        _trapezoid(panels[0], move)
        if equal:
            _rectangle(panels[1], move)
        panels[-1].set_xlabel("time (s)")


def _trapezoid(axes: Axes, move: Move) -> None:
    """Draw the speed over time with T, Ta, Ts, Td and Sp."""
    speed, up, slew, down = (move[name] for name in ("speed", "accel_time", "slew_time", "decel_time"))
    axes.plot(*zip(*trapezoid(move), strict=True), color=BLUE, linewidth=1.6)
    axes.fill(*zip(*trapezoid(move), strict=True), color=BLUE, alpha=0.08, linewidth=0)
    for at in (up, up + slew):
        axes.plot([at, at], [0.0, speed], color=GREY, linewidth=0.8, linestyle="--")
    begin = 0.0
    for name, length in (("Ta", up), ("Ts", slew), ("Td", down)):
        if length > 0.0:
            _span(axes, begin, begin + length, -0.1 * speed, f"{name} = {length:.6g} s")
        begin += length
    _span(axes, 0.0, move["time"], -0.24 * speed, f"T = {move['time']:.6g} s")
    axes.annotate(
        f"Sp = {speed:.6g}", (up + 0.5 * slew, speed), (0, 4), textcoords="offset points", ha="center"
    )
    axes.text(0.62 * up, 0.25 * speed, "Accel = Sp / Ta", ha="center", fontsize=8)
    axes.text(move["time"] - 0.62 * down, 0.25 * speed, "Decel = Sp / Td", ha="center", fontsize=8)
    axes.set_ylim(-0.36 * speed, 1.18 * speed)
    dress(axes, "speed", "uu/s")


def _rectangle(axes: Axes, move: Move) -> None:
    """Draw the rectangle, the triangle cut off the trapezoid and its new position."""
    speed, end = move["speed"], move["accel_time"] + move["slew_time"]
    axes.plot(*zip(*trapezoid(move), strict=True), color=BLUE, linewidth=1.6)
    axes.fill(*zip(*cut_triangle(move), strict=True), color=GREY, alpha=0.3, linewidth=0)
    axes.fill(*zip(*moved_triangle(move), strict=True), color=RED, alpha=0.2, linewidth=0)
    corners = [*rectangle(move), (0.0, 0.0)]
    axes.plot(*zip(*corners, strict=True), color=RED, linewidth=1.6)
    axes.annotate(
        "", (0.35 * move["accel_time"], 0.7 * speed), (move["time"] - 0.65 * move["decel_time"], 0.35 * speed),
        arrowprops={"arrowstyle": "->", "color": GREY, "connectionstyle": "arc3,rad=0.25"},
    )  # fmt: skip
    _span(axes, 0.0, end, -0.1 * speed, "Ta + Ts")
    text = f"Distance = Sp (Ta + Ts) = {speed:.6g} · {end:.6g} = {abs(move['distance']):.6g}"
    axes.text(0.5 * end, 1.05 * speed, text, ha="center", color=RED, fontsize=8)
    axes.set_ylim(-0.22 * speed, 1.18 * speed)
    dress(axes, "speed", "uu/s")


def _span(axes: Axes, begin: float, end: float, height: float, text: str) -> None:
    """Draw an arrow between two times, with a text above it."""
    axes.annotate("", (end, height), (begin, height), arrowprops={"arrowstyle": "<->", "color": GREY})
    axes.annotate(
        text, (0.5 * (begin + end), height), (0, 2), textcoords="offset points", ha="center", fontsize=8
    )
