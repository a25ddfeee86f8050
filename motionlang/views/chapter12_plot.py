"""The eleven figures of "Dissecting a Move Profile", drawn from `chapter12`."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from motionlang.notes import dissect
from motionlang.planners import plan
from motionlang.views.chapter12 import (
    BLOCKS,
    CHANGES,
    DISTANCE,
    FIGURES,
    LIMIT,
    SPEED,
    TIME_CONSTANTS,
    s_curve,
    trapezoid,
)
from motionlang.views.plot_panel import INK
from motionlang.views.servo_plot import BLUE, GREEN, GREY, RED, VIOLET, WIDTH, drawing, dress

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from motionlang.planners import Profile


def draw_figure(number: str, path: str) -> None:
    """Draw a figure into a .png or .svg file."""
    with drawing(path, WIDTH, 5.6) as figure:
        figure.suptitle(
            f"{number}  {FIGURES[number].title}", x=0.01, ha="left", fontsize=12, fontweight="bold"
        )
        DRAWINGS[number](figure)


def _draw_motion(profiles: Sequence[tuple[str, Profile, str]], figure: Figure) -> None:
    upper, lower = figure.subplots(2, 1, sharex=True)
    for label, profile, colour in profiles:
        span = profile.duration
        times = [span * i / 1000.0 for i in range(1001)]
        upper.plot(times, [profile.velocity(t) for t in times], color=colour, linewidth=1.6, label=label)
        edges = [-1e-9, *times, span + 1e-9]
        lower.plot(edges, [profile.acceleration(t) for t in edges], color=colour, linewidth=1.6)
    if len(profiles) > 1:
        upper.legend(loc="lower center", frameon=False)
    dress(upper, "velocity", "ft/s")
    dress(lower, "acceleration", "ft/s²")
    lower.set_xlabel("time (s)")


def _draw_12_1(figure: Figure) -> None:
    profile = trapezoid()
    _draw_motion([("trapezoid", profile, BLUE)], figure)
    lower, knots = figure.axes[1], profile.knots
    points = [
        (knots[0], 0.5 * LIMIT),
        (0.5 * knots[1], LIMIT),
        (knots[1], 0.5 * LIMIT),
        (knots[2], -0.5 * LIMIT),
        (0.5 * (knots[2] + knots[3]), -LIMIT),
        (knots[3], -0.5 * LIMIT),
    ]
    for i, point in enumerate(points):
        lower.annotate(f"A{i + 1}", point, (6, 4), textcoords="offset points", color=RED, fontweight="bold")
    lower.margins(y=0.2)


def _draw_progression(figure: Figure) -> None:
    made = dissect.discrete_trapezoid(200, 20, 2)
    velocities = [0, *(v for v, _ in made), 0]
    changes = [b - a for a, b in pairwise(velocities)]
    upper, lower = figure.subplots(2, 1, sharex=True)
    upper.step(range(len(velocities)), velocities, where="post", color=BLUE, linewidth=1.6)
    lower.step(range(len(changes)), changes, where="post", color=RED, linewidth=1.6)
    dress(upper, "velocity", "counts/update")
    dress(lower, "acceleration", "counts/update²")
    lower.set_xlabel("update")


def _draw_equations(figure: Figure) -> None:
    quick = plan("scurve", 0.0, DISTANCE, SPEED, 2.0 * LIMIT, 2.0 * LIMIT, ramp=0.5)
    named = [
        ("trapezoidal, A", trapezoid(), BLUE),
        ("S-curve, A", s_curve(), GREEN),
        ("S-curve, 2A", quick, RED),
    ]
    _draw_motion(named, figure)


def _draw_cube(panel: Axes) -> None:
    from matplotlib.patches import Rectangle

    panel.add_patch(Rectangle((0.0, 0.0), 8.0, 0.5, facecolor="#d7dee6", edgecolor=INK))
    panel.add_patch(Rectangle((3.0, 0.5), 2.0, 2.0, facecolor="#eef3f8", edgecolor=INK))
    panel.text(4.0, 1.5, "5 lb", ha="center", va="center", fontsize=13)
    panel.text(4.0, 0.22, "friction 0.1", ha="center", va="center", fontsize=9)
    panel.set(xlim=(-1.5, 9.5), ylim=(-1.0, 4.0), aspect="equal")
    panel.axis("off")


def _arrow(panel: Axes, start: tuple[float, float], end: tuple[float, float], text: str, colour: str) -> None:
    style = {"arrowstyle": "-|>", "color": colour, "linewidth": 2.0}
    panel.annotate("", end, start, arrowprops=style)
    middle = (0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1]) + 0.15)
    panel.text(*middle, text, color=colour, ha="center", va="bottom", fontsize=10)


def _draw_12_2(figure: Figure) -> None:
    panel = figure.subplots()
    _draw_cube(panel)
    _arrow(panel, (8.2, 0.25), (9.3, 0.25), "A = ?", RED)


def _draw_12_3(figure: Figure) -> None:
    panel = figure.subplots()
    time = dissect.fastest_time(SPEED, LIMIT)
    panel.plot([0.0, time, 1.5 * time], [0.0, SPEED, SPEED], color=BLUE, linewidth=2.0)
    panel.annotate(f"{time:.4f} s", (time, SPEED), (8, -16), textcoords="offset points", color=RED)
    panel.annotate(
        f"slope {LIMIT:.2f} ft/s²", (0.5 * time, 0.5 * SPEED), (12, -6), textcoords="offset points"
    )
    dress(panel, "velocity", "ft/s")
    panel.set_xlabel("time (s)")
    panel.margins(y=0.15)


def _draw_12_4(figure: Figure) -> None:
    panel = figure.subplots()
    _draw_cube(panel)
    force = dissect.friction_force(dissect.WEIGHT_LB, dissect.FRICTION)
    _arrow(panel, (5.0, 0.75), (7.4, 0.75), f"F_f = {force:g} lb", GREEN)
    _arrow(panel, (3.0, 2.0), (0.6, 2.0), "F_i = m A", VIOLET)
    _arrow(panel, (8.2, 0.25), (9.3, 0.25), "A", RED)


def _draw_12_5(figure: Figure) -> None:
    timing, panel = dissect.dac_timing(SPEED, LIMIT), figure.subplots()
    step = timing.step_speed * 60.0
    times = [timing.hold_time * 1e6 * i / 400 for i in range(401)]
    panel.plot(
        times, [step * dissect.buildup(t * 1e-6, timing.electrical_time_constant) for t in times], color=BLUE
    )
    panel.plot([0.0, timing.step_time * 1e6], [0.0, step], color=INK, linestyle="--", linewidth=1.2)
    panel.axhline(step, color=GREY, linewidth=1.0)
    panel.annotate("3.22 ft/s²", (timing.step_time * 0.5e6, 0.5 * step), (-70, 0), textcoords="offset points")
    dress(panel, "velocity", "ft/min")
    panel.set_xlabel("time after the DAC step (µs)")


def _draw_12_6(figure: Figure) -> None:
    panel = figure.subplots()
    edges, level = [0.0], 0.0
    for change in CHANGES:
        level += change
        edges.append(level)
    panel.step(
        range(len(edges)), edges[1:] + edges[-1:], where="post", color=GREY, linewidth=1.4, label="DAC"
    )
    for (name, constant), colour in zip(TIME_CONSTANTS.items(), (RED, BLUE, GREEN), strict=True):
        times, values = _answer(constant)
        panel.plot(
            times, values, color=colour, linewidth=1.6, label=f"{name}: time constant {constant:.2f} updates"
        )
    panel.plot(
        [0.0, len(CHANGES)], [0.0, len(CHANGES)], color=INK, linestyle="--", linewidth=1.2, label="limit"
    )
    panel.legend(loc="upper left", frameon=False)
    dress(panel, "velocity", "DAC steps")
    panel.set_xlabel("updates")


def _answer(constant: float) -> tuple[list[float], list[float]]:
    times, values, dac = [], [], 0.0
    for k, segment in enumerate(dissect.step_segments(CHANGES, constant)):
        dac += segment.steps
        for i in range(101):
            times.append(k + i / 100.0)
            values.append(dac - (dac - segment.from_velocity) * (1.0 - dissect.buildup(i / 100.0, constant)))
    return times, values


def _draw_12_10(figure: Figure) -> None:
    panel = figure.subplots()
    end = 1500e-6
    for bits, colour in ((12, RED), (16, BLUE)):
        timing = dissect.dac_timing(SPEED, LIMIT, bits)
        count = int(end / timing.step_time) + 1
        times = [i * timing.step_time * 1e6 for i in range(count + 1)]
        panel.step(
            times,
            [i * timing.step_speed * 60.0 for i in range(count + 1)],
            where="post",
            color=colour,
            label=f"{bits} bits",
        )
    panel.plot(
        [0.0, end * 1e6],
        [0.0, LIMIT * end * 60.0],
        color=INK,
        linestyle="--",
        linewidth=1.2,
        label="3.22 ft/s²",
    )
    panel.set_xlim(0.0, end * 1e6)
    panel.legend(loc="upper left", frameon=False)
    dress(panel, "velocity", "ft/min")
    panel.set_xlabel("time (µs)")


def _draw_12_11(figure: Figure) -> None:
    from matplotlib.patches import FancyBboxPatch

    panel = figure.subplots()
    for i, (name, what) in enumerate(BLOCKS):
        x = 1.3 * i
        panel.add_patch(
            FancyBboxPatch((x, 2.0), 1.0, 1.0, boxstyle="round,pad=0.02", facecolor="#eef3f8", edgecolor=INK)
        )
        panel.text(x + 0.5, 2.62, name, ha="center", va="center", fontsize=9, fontweight="bold")
        panel.text(x + 0.5, 2.28, what, ha="center", va="center", fontsize=6.6, color="#4a5764")
        if i:
            style = {"arrowstyle": "-|>", "color": INK, "linewidth": 1.2}
            panel.annotate("", (x - 0.02, 2.5), (x - 0.28, 2.5), arrowprops=style)
    _feedback(panel, 2, 1.0, "encoder: actual position", GREEN)
    _feedback(panel, 4, 0.2, "tachometer and A/D: actual velocity", VIOLET)
    panel.set(xlim=(-0.2, 10.4), ylim=(-0.2, 3.6))
    panel.axis("off")


def _feedback(panel: Axes, to: int, level: float, text: str, colour: str) -> None:
    last = 1.3 * (len(BLOCKS) - 1) + 0.5
    target = 1.3 * to + 0.5
    panel.plot([last, last, target], [1.96, level, level], color=colour, linewidth=1.4)
    panel.annotate("", (target, 1.96), (target, level), arrowprops={"arrowstyle": "-|>", "color": colour})
    box = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    panel.text(last - 0.2, level, text, color=colour, ha="right", va="center", fontsize=8.5, bbox=box)


DRAWINGS: dict[str, Callable[[Figure], None]] = {
    "12.1": _draw_12_1,
    "12.2": _draw_12_2,
    "12.3": _draw_12_3,
    "12.4": _draw_12_4,
    "12.5": _draw_12_5,
    "12.6": _draw_12_6,
    "12.7": _draw_progression,
    "12.8": lambda figure: _draw_motion([("S-curve", s_curve(), GREEN)], figure),
    "12.9": _draw_equations,
    "12.10": _draw_12_10,
    "12.11": _draw_12_11,
}
