"""The eleven figures of "Dissecting a Move Profile" as numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from motionlang.notes import dissect
from motionlang.planners import Profile, plan
from motionlang.views.grid import filled, grid, headed

if TYPE_CHECKING:
    from motionlang.views.grid import Cells

LIMIT = dissect.slip_acceleration(dissect.FRICTION, dissect.GRAVITY_FT)
SPEED = dissect.SPEED_FT_MIN / 60.0
DISTANCE = 2.0
"""In ft: far enough for both profiles of the chapter's cube to reach their speed."""
CHANGES = (1, 2, 1)
TIME_CONSTANTS = {"C": 1.0 / 5.0, "D to G": 2.0 / 3.0, "whole": 1.0}
_WIDTH = 100


@dataclass(frozen=True, slots=True)
class Picture:
    """A figure: its title and its values."""

    title: str
    lines: Callable[[], list[str]]


def figure_lines(number: str) -> list[str]:
    """Return the title of a figure and its values."""
    picture = FIGURES[number]
    return [f"Figure {number}  {picture.title}", "", *picture.lines()]


# ------------------------------------------------------------------------------------------- profiles: 12.1, 7, 8, 9


def trapezoid() -> Profile:
    """Return the fastest trapezoid of the chapter's cube over `DISTANCE`, in ft and s."""
    return plan("trapezoid", 0.0, DISTANCE, SPEED, LIMIT, LIMIT)


def s_curve() -> Profile:
    """Return the same move as an S-curve, whose acceleration has two linear ramps."""
    return plan("scurve", 0.0, DISTANCE, SPEED, LIMIT, LIMIT, ramp=0.5)


def _steps_of_acceleration() -> list[str]:
    profile = trapezoid()
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
    columns = headed("<step", "time, s", "from, ft/s²", "to, ft/s²", "velocity, ft/s")
    return grid(columns, rows, width=_WIDTH)


def _progression() -> list[str]:
    made = dissect.discrete_trapezoid(200, 20, 2)
    shown = [0, 1, 2, 8, 9, 10, len(made) - 3, len(made) - 2, len(made) - 1]
    rows = [[str(i + 1), str(made[i][0]), str(made[i][1])] for i in shown]
    columns = headed("update", "velocity, counts/update", "position, counts")
    head = "every update: velocity += 2, up to 20; position += velocity; 200 counts"
    return [head, "", *grid(columns, rows, width=_WIDTH)]


def _s_against_time() -> list[str]:
    profile = s_curve()
    rows = []
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):
        time = share * profile.knots[2]
        state = profile.at(time)
        rows.append([f"{time:.6f}", f"{abs(state.acceleration):.6f}", f"{state.velocity:.6f}"])
    columns = headed("time, s", "acceleration, ft/s²", "velocity, ft/s")
    return grid(columns, rows, width=_WIDTH)


def _equations() -> list[str]:
    trapezoid = dissect.trapezoid_times(DISTANCE, SPEED, LIMIT)
    s_curve = dissect.s_curve_times(DISTANCE, SPEED, LIMIT)
    equal = dissect.s_curve_times(DISTANCE, SPEED, dissect.equal_time_accel(LIMIT))
    columns = headed("<profile", "A, ft/s²", "T_a, s", "D_a, ft", "T_s, s", "T_move, s")
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
    cells: Cells = {
        "acceleration, ft/s²": lambda accel: f"{accel:.2f}",
        "inertial force F_i, lb": lambda accel: f"{mass * accel:.4f}",
        "friction F_f, lb": lambda _: f"{force:.4f}",
        "<the cube": lambda accel: "slides" if mass * accel > force * (1 + 1e-12) else "stays",
    }
    return filled(cells, (0.5 * LIMIT, LIMIT, 1.5 * LIMIT), width=_WIDTH)


# ------------------------------------------------------------------------------------------ DAC steps: 12.5, 6, 10


def _one_step() -> list[str]:
    timing = dissect.dac_timing(SPEED, LIMIT)
    columns = headed("time, µs", "velocity, ft/min", "share, of a step")
    rows = []
    for share in (0.25, 0.5, 1.0, 2.0, 5.0):
        time = share * timing.electrical_time_constant
        fraction = dissect.buildup(time, timing.electrical_time_constant)
        rows.append([f"{time * 1e6:.2f}", f"{fraction * timing.step_speed * 60.0:.7f}", f"{fraction:.4f}"])
    head = f"one step of {timing.bits} bits: {timing.step_speed * 60.0:.9f} ft/min in {timing.step_time * 1e6:.4f} µs"
    return [
        head,
        f"time constant {timing.electrical_time_constant * 1e6:.4f} µs (2/3 of that)",
        "",
        *grid(columns, rows, width=_WIDTH),
    ]


def _segments() -> list[str]:
    cells: Cells = {
        "<curve": lambda row: row[0],
        "DAC change, steps": lambda row: f"{row[1].steps:g}",
        "time constant, updates": lambda row: f"{row[1].time_constant:.3f}",
        "velocity, steps": lambda row: f"{row[1].to_velocity:.4f}",
        "onset, × limit": lambda row: f"{row[1].onset:.3f}",
        "over the update, × limit": lambda row: f"{row[1].mean:.3f}",
    }
    rows = [
        (curve, segment)
        for curve, constant in TIME_CONSTANTS.items()
        for segment in dissect.step_segments(CHANGES, constant)
    ]
    note = "one update is the time that one step may take (252.7336 µs for 12 bits)"
    return [note, "", *filled(cells, rows, width=_WIDTH)]


def _resolutions() -> list[str]:
    cells: Cells = {
        "DAC": lambda timing: f"{timing.bits} bits",
        "one step, ft/min": lambda timing: f"{timing.step_speed * 60.0:.9f}",
        "every, µs": lambda timing: f"{timing.step_time * 1e6:.4f}",
        "steps in 1 ms": lambda timing: f"{1e-3 / timing.step_time:.2f}",
        "staircase off the line, ft/min": lambda timing: f"{timing.step_speed * 60.0:.9f}",
    }
    return filled(cells, [dissect.dac_timing(SPEED, LIMIT, bits) for bits in (12, 16)], width=_WIDTH)


# ------------------------------------------------------------------------------------------------ the system: 12.11


BLOCKS = (
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
    chain = " -> ".join(name for name, _ in BLOCKS)
    return [
        chain,
        "encoder: motor + load -> error (actual position)",
        "tachometer: motor + load -> A/D -> override (ActVel)",
        "",
        *(f"{name:<12}  {what.replace(chr(10), '; ')}" for name, what in BLOCKS),
    ]


FIGURES: dict[str, Picture] = {
    "12.1": Picture("Relationship of acceleration and velocity profiles", _steps_of_acceleration),
    "12.2": Picture("What is the maximum acceleration before the product will slip?", _cube),
    "12.3": Picture("How much time to attain max acceleration?", _cube_times),
    "12.4": Picture("Horizontal free-body force diagram", _forces),
    "12.5": Picture("The time it takes to accomplish a DAC step", _one_step),
    "12.6": Picture("The relationship between DAC steps and electrical time constant", _segments),
    "12.7": Picture("Trapezoidal velocity profile versus acceleration", _progression),
    "12.8": Picture("Diagram showing an S velocity profile versus acceleration over time", _s_against_time),
    "12.9": Picture("Trapezoidal and S profile calculations", _equations),
    "12.10": Picture("Acceleration slope with respect to DAC steps", _resolutions),
    "12.11": Picture("A typical microprocessor-based motion system", _system),
}
