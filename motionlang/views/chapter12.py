"""The eleven figures of "Dissecting a Move Profile": what each shows in numbers, and drawn from them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from motionlang.profile import dissect, plan
from motionlang.views.grid import Column, grid
from motionlang.views.plot import INK
from motionlang.views.servo_plot import BLUE, GREEN, GREY, RED, VIOLET, WIDTH, drawing, dress

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from motionlang.profile import Profile

LIMIT = dissect.slip_acceleration(dissect.FRICTION, dissect.GRAVITY_FT)
SPEED = dissect.SPEED_FT_MIN / 60.0
DISTANCE = 2.0
"""ft: far enough for both profiles of the chapter's cube to reach their speed."""
CHANGES = (1, 2, 1)
TIME_CONSTANTS = {"C": 1.0 / 5.0, "D to G": 2.0 / 3.0, "whole": 1.0}
_WIDTH = 100


@dataclass(frozen=True, slots=True)
class Picture:
    """A figure: its title, its numbers and its drawing."""

    title: str
    lines: Callable[[], list[str]]
    draw: Callable[[Figure], None]


def figure_lines(number: str) -> list[str]:
    """The title of a figure and its numbers."""
    picture = FIGURES[number]
    return [f"Figure {number}  {picture.title}", "", *picture.lines()]


def draw_figure(number: str, path: str) -> None:
    """Draw a figure into a .png or .svg file."""
    with drawing(path, WIDTH, 5.6) as figure:
        figure.suptitle(
            f"{number}  {FIGURES[number].title}", x=0.01, ha="left", fontsize=12, fontweight="bold"
        )
        FIGURES[number].draw(figure)


# ------------------------------------------------------------------------------------------- profiles: 12.1, 7, 8, 9


def _trapezoid() -> Profile:
    return plan("trapezoid", 0.0, DISTANCE, SPEED, LIMIT, LIMIT)


def _s_curve() -> Profile:
    return plan("scurve", 0.0, DISTANCE, SPEED, LIMIT, LIMIT, ramp=0.5)


def _steps_of_acceleration() -> list[str]:
    profile = _trapezoid()
    knots = profile.knots
    rows = []
    for name, time, before, after in (
        ("A1", knots[0], 0.0, LIMIT),
        ("A2", 0.5 * knots[1], LIMIT, LIMIT),
        ("A3", knots[1], LIMIT, 0.0),
        ("A4", knots[2], 0.0, -LIMIT),
        ("A5", 0.5 * (knots[2] + knots[3]), -LIMIT, -LIMIT),
        ("A6", knots[3], -LIMIT, 0.0),
    ):
        speed = profile.velocity(time)
        rows.append([name, f"{time:.6f}", f"{before:.3f}", f"{after:.3f}", f"{speed:.6f}"])
    columns = (
        Column("step", align="<"),
        Column("time", "s"),
        Column("from", "ft/s²"),
        Column("to", "ft/s²"),
        Column("velocity", "ft/s"),
    )
    return grid(columns, rows, width=_WIDTH)


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
    profile = _trapezoid()
    _draw_motion([("trapezoid", profile, BLUE)], figure)
    lower, knots = figure.axes[1], profile.knots
    places = [
        (knots[0], 0.5 * LIMIT),
        (0.5 * knots[1], LIMIT),
        (knots[1], 0.5 * LIMIT),
        (knots[2], -0.5 * LIMIT),
        (0.5 * (knots[2] + knots[3]), -LIMIT),
        (knots[3], -0.5 * LIMIT),
    ]
    for i, place in enumerate(places):
        lower.annotate(f"A{i + 1}", place, (6, 4), textcoords="offset points", color=RED, fontweight="bold")
    lower.margins(y=0.2)


def _progression() -> list[str]:
    made = dissect.discrete_trapezoid(200, 20, 2)
    shown = [0, 1, 2, 8, 9, 10, len(made) - 3, len(made) - 2, len(made) - 1]
    rows = [[str(i + 1), str(made[i][0]), str(made[i][1])] for i in shown]
    columns = (Column("update"), Column("velocity", "counts/update"), Column("position", "counts"))
    head = "every update: velocity += 2, up to 20; position += velocity; 200 counts"
    return [head, "", *grid(columns, rows, width=_WIDTH)]


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


def _s_against_time() -> list[str]:
    profile = _s_curve()
    rows = []
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):
        time = share * profile.knots[2]
        state = profile.at(time)
        rows.append([f"{time:.6f}", f"{abs(state.acceleration):.6f}", f"{state.velocity:.6f}"])
    columns = (Column("time", "s"), Column("acceleration", "ft/s²"), Column("velocity", "ft/s"))
    return grid(columns, rows, width=_WIDTH)


def _equations() -> list[str]:
    trapezoid = dissect.trapezoid_times(DISTANCE, SPEED, LIMIT)
    s_curve = dissect.s_curve_times(DISTANCE, SPEED, LIMIT)
    equal = dissect.s_curve_times(DISTANCE, SPEED, dissect.equal_time_accel(LIMIT))
    columns = (
        Column("profile", align="<"),
        Column("A", "ft/s²"),
        Column("T_a", "s"),
        Column("D_a", "ft"),
        Column("T_s", "s"),
        Column("T_move", "s"),
    )
    rows = [
        [
            name,
            f"{accel:.2f}",
            *(f"{value:.7f}" for value in (t.accel_time, t.accel_distance, t.slew_time, t.move_time)),
        ]
        for name, accel, t in (
            ("trapezoidal", LIMIT, trapezoid),
            ("S-curve, same A", LIMIT, s_curve),
            ("S-curve, A_s = 2A", 2.0 * LIMIT, equal),
        )
    ]
    return [
        f"D = {DISTANCE:g} ft, V = {SPEED:.7f} ft/s",
        "trapezoidal: T_a = V/A, D_a = V²/2A, T_s = D/V - V/A,  T_move = D/V + V/A",
        "S-curve:     T_a = 2V/A, D_a = V²/A, T_s = D/V - 2V/A, T_move = D/V + 2V/A",
        "",
        *grid(columns, rows, width=_WIDTH),
    ]


def _draw_equations(figure: Figure) -> None:
    quick = plan("scurve", 0.0, DISTANCE, SPEED, 2.0 * LIMIT, 2.0 * LIMIT, ramp=0.5)
    named = [
        ("trapezoidal, A", _trapezoid(), BLUE),
        ("S-curve, A", _s_curve(), GREEN),
        ("S-curve, 2A", quick, RED),
    ]
    _draw_motion(named, figure)


# -------------------------------------------------------------------------------------------- the cube: 12.2, 3, 4


def _cube() -> list[str]:
    return [
        f"a cube of {dissect.WEIGHT_LB:g} lb on a plate, friction {dissect.FRICTION:g}",
        f"it slides when the force on it is above {dissect.friction_force(dissect.WEIGHT_LB, dissect.FRICTION):g} lb",
    ]


def _cube_times() -> list[str]:
    time = dissect.fastest_time(SPEED, LIMIT)
    return [
        f"fastest acceleration  {LIMIT:.2f} ft/s²  {dissect.FRICTION:g} · {dissect.GRAVITY_FT:g}",
        f"{dissect.SPEED_FT_MIN:g} ft/min are reached  {time:.7f} s  ({dissect.SPEED_FT_MIN:g}/60)/{LIMIT:.2f}",
    ]


def _forces() -> list[str]:
    force = dissect.friction_force(dissect.WEIGHT_LB, dissect.FRICTION)
    mass = dissect.WEIGHT_LB / dissect.GRAVITY_FT
    rows = [
        [
            f"{accel:.2f}",
            f"{mass * accel:.4f}",
            f"{force:.4f}",
            "slides" if mass * accel > force * (1 + 1e-12) else "stays",
        ]
        for accel in (0.5 * LIMIT, LIMIT, 1.5 * LIMIT)
    ]
    columns = (
        Column("acceleration", "ft/s²"),
        Column("inertial force F_i", "lb"),
        Column("friction F_f", "lb"),
        Column("the cube", align="<"),
    )
    return grid(columns, rows, width=_WIDTH)


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


# ------------------------------------------------------------------------------------------ DAC steps: 12.5, 6, 10


def _one_step() -> list[str]:
    timing = dissect.dac_timing(SPEED, LIMIT)
    columns = (Column("time", "µs"), Column("velocity", "ft/min"), Column("share", "of a step"))
    rows = []
    for share in (0.25, 0.5, 1.0, 2.0, 5.0):
        time = share * timing.electrical_time_constant
        part = dissect.buildup(time, timing.electrical_time_constant)
        rows.append([f"{time * 1e6:.2f}", f"{part * timing.step_speed * 60.0:.7f}", f"{part:.4f}"])
    head = f"one step of {timing.bits} bits: {timing.step_speed * 60.0:.9f} ft/min in {timing.step_time * 1e6:.4f} µs"
    return [
        head,
        f"time constant {timing.electrical_time_constant * 1e6:.4f} µs (2/3 of that)",
        "",
        *grid(columns, rows, width=_WIDTH),
    ]


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


def _segments() -> list[str]:
    columns = (
        Column("curve", align="<"),
        Column("DAC change", "steps"),
        Column("time constant", "updates"),
        Column("velocity", "steps"),
        Column("onset", "× limit"),
        Column("over the update", "× limit"),
    )
    rows = []
    for curve, constant in TIME_CONSTANTS.items():
        for segment in dissect.step_segments(CHANGES, constant):
            rows.append(
                [
                    curve,
                    f"{segment.steps:g}",
                    f"{constant:.3f}",
                    f"{segment.to_velocity:.4f}",
                    f"{segment.onset:.3f}",
                    f"{segment.mean:.3f}",
                ]
            )
    note = "one update is the time that one step may take (252.7336 µs for 12 bits)"
    return [note, "", *grid(columns, rows, width=_WIDTH)]


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


def _resolutions() -> list[str]:
    columns = (
        Column("DAC"),
        Column("one step", "ft/min"),
        Column("every", "µs"),
        Column("steps in 1 ms"),
        Column("staircase off the line", "ft/min"),
    )
    rows = []
    for bits in (12, 16):
        timing = dissect.dac_timing(SPEED, LIMIT, bits)
        step = timing.step_speed * 60.0
        rows.append(
            [
                f"{bits} bits",
                f"{step:.9f}",
                f"{timing.step_time * 1e6:.4f}",
                f"{1e-3 / timing.step_time:.2f}",
                f"{step:.9f}",
            ]
        )
    return grid(columns, rows, width=_WIDTH)


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


# ------------------------------------------------------------------------------------------------ the system: 12.11

_BLOCKS = (
    ("host", "moves, settings"),
    ("trajectory", "velocity += accel\nposition += velocity"),
    ("error", "desired - actual"),
    ("PID", "P + I + D, /16"),
    ("override", "near ActVel, held"),
    ("DAC", "±2048 steps"),
    ("amplifier", "volts to current"),
    ("motor + load", "slips beyond μ g"),
)


def _system() -> list[str]:
    chain = " -> ".join(name for name, _ in _BLOCKS)
    return [
        chain,
        "encoder: motor + load -> error (actual position)",
        "tachometer: motor + load -> A/D -> override (ActVel)",
        "",
        *(f"{name:<12}  {what.replace(chr(10), '; ')}" for name, what in _BLOCKS),
    ]


def _draw_12_11(figure: Figure) -> None:
    from matplotlib.patches import FancyBboxPatch

    panel = figure.subplots()
    for i, (name, what) in enumerate(_BLOCKS):
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
    last = 1.3 * (len(_BLOCKS) - 1) + 0.5
    target = 1.3 * to + 0.5
    panel.plot([last, last, target], [1.96, level, level], color=colour, linewidth=1.4)
    panel.annotate("", (target, 1.96), (target, level), arrowprops={"arrowstyle": "-|>", "color": colour})
    box = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    panel.text(last - 0.2, level, text, color=colour, ha="right", va="center", fontsize=8.5, bbox=box)


FIGURES: dict[str, Picture] = {
    "12.1": Picture("Relationship of acceleration and velocity profiles", _steps_of_acceleration, _draw_12_1),
    "12.2": Picture("What is the maximum acceleration before the product will slip?", _cube, _draw_12_2),
    "12.3": Picture("How much time to attain the speed?", _cube_times, _draw_12_3),
    "12.4": Picture("Horizontal free-body force diagram", _forces, _draw_12_4),
    "12.5": Picture("The time it takes to accomplish a DAC step", _one_step, _draw_12_5),
    "12.6": Picture("DAC steps and the electrical time constant", _segments, _draw_12_6),
    "12.7": Picture("Trapezoidal velocity profile and acceleration", _progression, _draw_progression),
    "12.8": Picture(
        "An S velocity profile and its acceleration over time",
        _s_against_time,
        lambda figure: _draw_motion([("S-curve", _s_curve(), GREEN)], figure),
    ),
    "12.9": Picture("Trapezoidal and S profile calculations", _equations, _draw_equations),
    "12.10": Picture("Acceleration slope with respect to DAC steps", _resolutions, _draw_12_10),
    "12.11": Picture("A typical microprocessor-based motion system", _system, _draw_12_11),
}
