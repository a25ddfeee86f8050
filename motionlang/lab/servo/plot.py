"""Servo figures: motion of the motor against the demand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from motionlang.kernel.servo import ServoTrace
from motionlang.lab.servo.tn1069 import Row
from motionlang.lab.servo.view import SHAPE_NAMES
from motionlang.views.figure import AXIS, BLUE, COLOURS, GREEN, INK, RED, VIOLET, Curve, Figure, Panel
from motionlang.views.outline import Array, thinned

WIDTH, NARROW = 720.0, 403.0


def trace_figure(trace: ServoTrace, title: str) -> Figure:
    """Return position, velocity, following error, output and torque of one axis.

    Position is drawn over the demand, and output together with its integral term.
    """
    span = float(trace.time[0]), float(trace.time[-1])
    rows: list[tuple[str, str, list[tuple[str, str, str]]]] = [
        ("position", "counts", [("demand", AXIS, "demand"), ("position", BLUE, "motor")]),
        ("velocity", "counts/s", [("velocity", GREEN, "")]),
        ("following error", "counts", [("error", RED, "")]),
        ("output", "V", [("output", VIOLET, "output"), ("integral", AXIS, "integral")]),
        ("torque", "N m", [("torque", INK, "")]),
    ]
    panels = [
        Panel(
            [
                _curve(*thinned(trace.time, trace[name], span), colour, 1.3, legend)
                for name, colour, legend in lines
            ],
            label,
            unit,
            height=92.0,
        )
        for label, unit, lines in rows
    ]
    return Figure([[panel] for panel in panels], x_label="time (s)", title=title, width=WIDTH)


def comparison_figure(tables: Mapping[str, Sequence[Row]]) -> Figure:
    """Return velocity, motor acceleration and following error of the four profiles.

    Each comparison is a column.
    """
    rows: list[list[Panel]] = []
    for name, label, unit in (
        ("velocity", "velocity", "counts/s"),
        ("acceleration", "acceleration", "counts/s²"),
        ("error", "following error", "counts"),
    ):
        panels = []
        for basis, profiles in tables.items():
            title = "equal peak acceleration" if basis == "acceleration" else "equal time"
            curves = [
                _curve(row.trace.time, row.trace[name], colour, 1.2)
                for row, colour in zip(profiles, COLOURS, strict=True)
            ]
            panels.append(Panel(curves, label, unit, title="" if rows else title))
        rows.append(panels)
    shapes = [row.shape for row in next(iter(tables.values()))]
    return Figure(
        rows,
        x_label="time (s)",
        legend=[(colour, SHAPE_NAMES[shape]) for colour, shape in zip(COLOURS, shapes, strict=True)],
        width=NARROW * len(tables) + 43.0,
    )


def _curve(times: Array, values: Array, colour: str, width: float, name: str = "") -> Curve:
    return Curve(times.tolist(), values.tolist(), colour, name, width)
