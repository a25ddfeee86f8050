"""Draw a figure of "Dissecting a Move Profile": `python -m tests.lab.notes.scripts.chapter12_drawn 12.6 12-6.svg`."""

from __future__ import annotations

import sys
from itertools import accumulate, pairwise
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyBboxPatch, Rectangle

from motionlang.kernel.planners import Profile
from tests.lab.notes.vendor import dissect
from tests.lab.notes.vendor.figures import (
    BLOCKS,
    CHANGES,
    LIMIT,
    SPEED,
    TIME_CONSTANTS,
    TITLES,
    acceleration_points,
    forces,
    s_curve,
    trapezoid,
)

COARSE, FINE = (dissect.dac_timing(SPEED, LIMIT, bits) for bits in (12, 16))
LINE: dict[str, Any] = {"color": "black", "linestyle": "--", "linewidth": 1.2}
CUBE: dict[str, Any] = {"facecolor": "#eef3f8", "edgecolor": "black"}


def motion(figure: Figure, profiles: dict[str, Profile]) -> None:
    """Draw velocity over acceleration, which begins and ends with a jump."""
    upper, lower = figure.subplots(2, 1, sharex=True)
    for name, profile in profiles.items():
        end = profile.duration
        times = [end * k / 1000.0 for k in range(1001)]
        upper.plot(times, [profile.velocity(time) for time in times], label=name)
        times = [-1e-9, *times, end + 1e-9]
        lower.plot(times, [profile.acceleration(time) for time in times])
    upper.legend(loc="lower center")
    upper.set_ylabel("velocity (ft/s)")
    lower.set(xlabel="time (s)", ylabel="acceleration (ft/s²)")


def acceleration_and_velocity(figure: Figure) -> None:
    motion(figure, {"trapezoid": trapezoid()})
    for point in acceleration_points():
        figure.axes[1].text(point.time, 0.5 * (point.before + point.after), point.name, color="red")
    figure.axes[1].margins(y=0.2)


def cube(figure: Figure) -> Axes:
    panel = figure.subplots()
    panel.add_patch(Rectangle((0.0, 0.0), 8.0, 0.5, **CUBE))
    panel.add_patch(Rectangle((3.0, 0.5), 2.0, 2.0, **CUBE))
    panel.text(4.0, 1.5, f"{dissect.WEIGHT_LB:g} lb", ha="center")
    panel.text(4.0, 0.2, f"friction {dissect.FRICTION:g}", ha="center")
    arrow(panel, (8.2, 0.25), (9.6, 0.25), "A")
    panel.set(xlim=(-1.5, 10.0), ylim=(-1.0, 4.0), aspect="equal")
    panel.axis("off")
    return panel


def arrow(panel: Axes, start: tuple[float, float], end: tuple[float, float], text: str) -> None:
    panel.annotate("", end, start, arrowprops={"arrowstyle": "-|>"})
    panel.text(0.5 * (start[0] + end[0]), start[1] + 0.15, text, ha="center")


def fastest_time(figure: Figure) -> None:
    time, panel = dissect.fastest_time(SPEED, LIMIT), figure.subplots()
    panel.plot([0.0, time, 1.5 * time], [0.0, SPEED, SPEED])
    panel.text(time, 0.95 * SPEED, f"{time:.4f} s")
    panel.text(0.55 * time, 0.5 * SPEED, f"slope {LIMIT:.2f} ft/s²")
    panel.set(xlabel="time (s)", ylabel="velocity (ft/s)")


def free_body(figure: Figure) -> None:
    panel = cube(figure)
    arrow(panel, (5.0, 0.75), (7.4, 0.75), f"F_f = {forces(LIMIT).friction:g} lb")
    arrow(panel, (3.0, 2.0), (0.6, 2.0), "F_i = m A")


def one_dac_step(figure: Figure) -> None:
    panel, step = figure.subplots(), COARSE.step_speed * 60.0
    times = [COARSE.hold_time * k / 400.0 for k in range(401)]
    speeds = [step * dissect.buildup(time, COARSE.electrical_time_constant) for time in times]
    panel.plot([time * 1e6 for time in times], speeds)
    panel.plot([0.0, COARSE.step_time * 1e6], [0.0, step], label=f"{LIMIT:.2f} ft/s²", **LINE)
    panel.axhline(step, color="grey")
    panel.legend()
    panel.set(xlabel="time after the DAC step (µs)", ylabel="velocity (ft/min)")


def dac_steps(figure: Figure) -> None:
    panel, levels = figure.subplots(), list(accumulate(CHANGES))
    panel.step(range(len(levels) + 1), [*levels, levels[-1]], where="post", color="grey", label="DAC")
    for name, constant in TIME_CONSTANTS.items():
        times, velocities = [], []
        for k, (level, segment) in enumerate(
            zip(levels, dissect.step_segments(CHANGES, constant), strict=True)
        ):
            for part in (i / 100.0 for i in range(101)):
                times.append(k + part)
                gap = level - segment.from_velocity
                velocities.append(segment.from_velocity + gap * dissect.buildup(part, constant))
        panel.plot(times, velocities, label=f"{name}: time constant {constant:.2f} updates")
    panel.plot([0.0, len(levels)], [0.0, len(levels)], label="limit", **LINE)
    panel.legend()
    panel.set(xlabel="updates", ylabel="velocity (DAC steps)")


def progression(figure: Figure) -> None:
    velocities = [0, *(update.velocity for update in dissect.discrete_trapezoid(200, 20, 2)), 0]
    changes = [after - before for before, after in pairwise(velocities)]
    upper, lower = figure.subplots(2, 1, sharex=True)
    upper.step(range(len(velocities)), velocities, where="post")
    lower.step(range(len(changes)), changes, where="post")
    upper.set_ylabel("velocity (counts/update)")
    lower.set(xlabel="update", ylabel="acceleration (counts/update²)")


def two_dacs(figure: Figure) -> None:
    panel, end = figure.subplots(), 1500.0
    for dac in (COARSE, FINE):
        steps = range(int(end / (dac.step_time * 1e6)) + 2)
        times = [k * dac.step_time * 1e6 for k in steps]
        panel.step(times, [k * dac.step_speed * 60.0 for k in steps], where="post", label=f"{dac.bits} bits")
    panel.plot([0.0, end], [0.0, LIMIT * end * 60e-6], label=f"{LIMIT:.2f} ft/s²", **LINE)
    panel.legend()
    panel.set(xlim=(0.0, end), xlabel="time (µs)", ylabel="velocity (ft/min)")


def system(figure: Figure) -> None:
    panel = figure.subplots()
    for k, (name, what) in enumerate(BLOCKS):
        panel.add_patch(FancyBboxPatch((1.3 * k, 2.0), 1.0, 1.0, boxstyle="round,pad=0.02", **CUBE))
        panel.text(1.3 * k + 0.5, 2.6, name, ha="center", fontsize=9)
        panel.text(1.3 * k + 0.5, 2.2, what, ha="center", fontsize=6)
        if k:
            arrow(panel, (1.3 * k - 0.3, 2.5), (1.3 * k, 2.5), "")
    names, last = [name for name, _ in BLOCKS], 1.3 * len(BLOCKS) - 0.8
    for to, level, text in (
        ("error", 1.0, "encoder: actual position"),
        ("override", 0.2, "tachometer and A/D: actual velocity"),
    ):
        target = 1.3 * names.index(to) + 0.5
        panel.plot([last, last, target], [2.0, level, level], color="grey")
        arrow(panel, (target, level), (target, 2.0), "")
        panel.text(last - 0.2, level + 0.05, text, ha="right")
    panel.set(xlim=(-0.2, 10.4), ylim=(-0.2, 3.6))
    panel.axis("off")


DRAWINGS = {
    "12.1": acceleration_and_velocity,
    "12.2": cube,
    "12.3": fastest_time,
    "12.4": free_body,
    "12.5": one_dac_step,
    "12.6": dac_steps,
    "12.7": progression,
    "12.8": lambda figure: motion(figure, {"S-curve": s_curve()}),
    "12.9": lambda figure: motion(
        figure, {"trapezoidal, A": trapezoid(), "S-curve, A": s_curve(), "S-curve, 2A": s_curve(2.0 * LIMIT)}
    ),
    "12.10": two_dacs,
    "12.11": system,
}

number, path = sys.argv[1:]
made = Figure(figsize=(10.0, 5.6), layout="constrained")
made.suptitle(f"{number}  {TITLES[number]}")
DRAWINGS[number](made)
made.savefig(path)
