"""The four profiles of one move overlaid: position, velocity and acceleration."""

from __future__ import annotations

from motionlang.notes.tn1069 import Demand, profiles
from motionlang.views.servo_plot import BLUE, GREEN, RED, VIOLET, WIDTH, drawing, dress

COLOURS = (BLUE, GREEN, VIOLET, RED)
POINTS = 1000


def draw_profiles(demand: Demand, path: str) -> None:
    """Draw a move in its four profiles into a .png or .svg file."""
    with drawing(path, WIDTH, 7.0) as figure:
        panels = figure.subplots(3, 1, sharex=True)
        for name, profile, colour in zip(demand.columns, profiles(demand), COLOURS, strict=True):
            span = profile.duration
            times = [-1e-9, *(span * i / POINTS for i in range(POINTS + 1)), span + 1e-9]
            for axes, curve in zip(
                panels, (profile.position, profile.velocity, profile.acceleration), strict=True
            ):
                axes.plot(times, [curve(t) for t in times], color=colour, linewidth=1.4, label=name)
        panels[0].legend(loc="lower right", frameon=False)
        for axes, (quantity, unit) in zip(
            panels,
            (("position", "counts"), ("velocity", "counts/s"), ("acceleration", "counts/s²")),
            strict=True,
        ):
            dress(axes, quantity, unit)
        panels[-1].set_xlabel("time (s)")
