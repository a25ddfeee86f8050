"""Print the eleven figures of "Dissecting a Move Profile": all of them, or those named, such as 12.6."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from motionlang.views.table import filled
from tests.lab.notes.vendor import dissect
from tests.lab.notes.vendor.figures import (
    BLOCKS,
    CHANGES,
    DISTANCE,
    LIMIT,
    SPEED,
    TIME_CONSTANTS,
    TITLES,
    acceleration_points,
    forces,
    s_curve,
)

if TYPE_CHECKING:
    from motionlang.views.table import Cells

WIDTH = 100
WEIGHT, FRICTION, FORCE = dissect.WEIGHT_LB, dissect.FRICTION, forces(LIMIT).friction
DACS = [dissect.dac_timing(SPEED, LIMIT, bits) for bits in (12, 16)]
STEP = DACS[0]


def acceleration_and_velocity() -> list[str]:
    cells: Cells = {
        "<step": lambda point: point.name,
        "time, s": lambda point: f"{point.time:.6f}",
        "from, ft/s²": lambda point: f"{point.before:.3f}",
        "to, ft/s²": lambda point: f"{point.after:.3f}",
        "velocity, ft/s": lambda point: f"{point.velocity:.6f}",
    }
    return filled(cells, acceleration_points(), width=WIDTH)


def the_cube() -> list[str]:
    return [
        f"a cube of {WEIGHT:g} lb on a plate, friction {FRICTION:g}",
        f"it slides when the force on it is above {FORCE:g} lb",
    ]


def fastest_time() -> list[str]:
    time = dissect.fastest_time(SPEED, LIMIT)
    return [
        f"fastest acceleration  {LIMIT:.2f} ft/s²  {FRICTION:g} · {dissect.GRAVITY_FT:g}",
        f"{dissect.SPEED_FT_MIN:g} ft/min are reached  {time:.7f} s  (100/60)/{LIMIT:.2f}",
    ]


def free_body() -> list[str]:
    cells: Cells = {
        "acceleration, ft/s²": lambda found: f"{found.acceleration:.2f}",
        "inertial force F_i, lb": lambda found: f"{found.inertial:.4f}",
        "friction F_f, lb": lambda found: f"{found.friction:.4f}",
        "<the cube": lambda found: "slides" if found.slides else "stays",
    }
    return filled(cells, [forces(share * LIMIT) for share in (0.5, 1.0, 1.5)], width=WIDTH)


def one_dac_step() -> list[str]:
    constant = STEP.electrical_time_constant
    cells: Cells = {
        "time, µs": lambda share: f"{share * constant * 1e6:.2f}",
        "velocity, ft/min": lambda share: f"{dissect.buildup(share, 1.0) * STEP.step_speed * 60.0:.7f}",
        "share, of a step": lambda share: f"{dissect.buildup(share, 1.0):.4f}",
    }
    return [
        f"one step of 12 bits: {STEP.step_speed * 60.0:.9f} ft/min in {STEP.step_time * 1e6:.4f} µs",
        f"time constant {constant * 1e6:.4f} µs (2/3 of that)",
        "",
        *filled(cells, (0.25, 0.5, 1.0, 2.0, 5.0), width=WIDTH),
    ]


def dac_steps() -> list[str]:
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
    note = f"one update is the time that one step may take ({STEP.step_time * 1e6:.4f} µs for 12 bits)"
    return [note, "", *filled(cells, rows, width=WIDTH)]


def progression() -> list[str]:
    made = list(enumerate(dissect.discrete_trapezoid(200, 20, 2), 1))
    cells: Cells = {
        "update": lambda row: f"{row[0]}",
        "velocity, counts/update": lambda row: f"{row[1].velocity}",
        "position, counts": lambda row: f"{row[1].position}",
    }
    head = "every update: velocity += 2, up to 20; position += velocity; 200 counts"
    return [head, "", *filled(cells, [*made[:3], *made[8:11], *made[-3:]], width=WIDTH)]


def s_velocity() -> list[str]:
    profile = s_curve()
    cells: Cells = {
        "time, s": lambda state: f"{state[0]:.6f}",
        "acceleration, ft/s²": lambda state: f"{abs(state[1].acceleration):.6f}",
        "velocity, ft/s": lambda state: f"{state[1].velocity:.6f}",
    }
    times = [share * profile.knots[2] for share in (0.0, 0.25, 0.5, 0.75, 1.0)]
    return filled(cells, [(time, profile.at(time)) for time in times], width=WIDTH)


def calculations() -> list[str]:
    cells: Cells = {
        "<profile": lambda row: row[0],
        "A, ft/s²": lambda row: f"{row[1]:.2f}",
        "T_a, s": lambda row: f"{row[2].accel_time:.7f}",
        "D_a, ft": lambda row: f"{row[2].accel_distance:.7f}",
        "T_s, s": lambda row: f"{row[2].slew_time:.7f}",
        "T_move, s": lambda row: f"{row[2].move_time:.7f}",
    }
    fast = dissect.equal_time_accel(LIMIT)
    found = [
        ("trapezoidal", LIMIT, dissect.trapezoid_times(DISTANCE, SPEED, LIMIT)),
        ("S-curve, same A", LIMIT, dissect.s_curve_times(DISTANCE, SPEED, LIMIT)),
        ("S-curve, A_s = 2A", fast, dissect.s_curve_times(DISTANCE, SPEED, fast)),
    ]
    return [
        f"D = {DISTANCE:g} ft, V = {SPEED:.7f} ft/s",
        "trapezoidal: T_a = V/A, D_a = V²/2A, T_s = D/V - V/A,  T_move = D/V + V/A",
        "S-curve:     T_a = 2V/A, D_a = V²/A, T_s = D/V - 2V/A, T_move = D/V + 2V/A",
        "",
        *filled(cells, found, width=WIDTH),
    ]


def two_dacs() -> list[str]:
    cells: Cells = {
        "DAC": lambda timing: f"{timing.bits} bits",
        "one step, ft/min": lambda timing: f"{timing.step_speed * 60.0:.9f}",
        "every, µs": lambda timing: f"{timing.step_time * 1e6:.4f}",
        "steps in 1 ms": lambda timing: f"{1e-3 / timing.step_time:.2f}",
        "staircase off the line, ft/min": lambda timing: f"{timing.step_speed * 60.0:.9f}",
    }
    return filled(cells, DACS, width=WIDTH)


def system() -> list[str]:
    return [
        " -> ".join(name for name, _ in BLOCKS),
        "encoder: motor + load -> error (actual position)",
        "tachometer: motor + load -> A/D -> override (ActVel)",
        "",
        *(f"{name:<12}  {what.replace(chr(10), '; ')}" for name, what in BLOCKS),
    ]


FIGURES = {
    "12.1": acceleration_and_velocity,
    "12.2": the_cube,
    "12.3": fastest_time,
    "12.4": free_body,
    "12.5": one_dac_step,
    "12.6": dac_steps,
    "12.7": progression,
    "12.8": s_velocity,
    "12.9": calculations,
    "12.10": two_dacs,
    "12.11": system,
}

numbers = sys.argv[1:] or list(FIGURES)
print("\n\n".join("\n".join([f"Figure {each}  {TITLES[each]}", "", *FIGURES[each]()]) for each in numbers))
