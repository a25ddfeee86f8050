"""Servo figures as tables of plain text, the same on every machine."""

from __future__ import annotations

from dataclasses import fields
from math import floor, inf, log10
from typing import TYPE_CHECKING

from motionlang.servo.plant import Motor
from motionlang.views.grid import grid, headed

if TYPE_CHECKING:
    import argparse
    from collections.abc import Mapping, Sequence

    from motionlang.notes.chapter12 import ListingRun, Settings
    from motionlang.notes.dac_override import OverrideRun
    from motionlang.notes.slip import Slip
    from motionlang.notes.tn1069_servo import Row
    from motionlang.planners.dissect import DacTiming
    from motionlang.servo.plant import Drive
    from motionlang.servo.response import LoopFigures, StepFigures
    from motionlang.servo.trace import ServoTrace
    from motionlang.servo.tuning import Suggestion

WIDTH = 120
SHAPE_NAMES = {
    "trapezoid": "trapezoidal",
    "sinusoidal": "sinusoidal S-curve",
    "scurve": "trapezoidal S-curve",
    "parabolic": "parabolic",
}


def slip_lines(args: argparse.Namespace, figures: Mapping[str, float]) -> list[str]:
    """Return the chapter's example: the friction force and its consequences."""
    unit, speed = args.unit, f"{figure(args.speed)} {args.unit}/{'min' if args.per == 'minute' else 's'}"
    friction, gravity = figure(args.friction), figure(args.gravity)
    rows = [
        ("friction force", f"{figure(figures['friction_force'])}", f"{figure(args.weight)} · {friction}"),
        (
            "fastest acceleration",
            f"{figure(figures['limit'])} {unit}/s²",
            f"{friction} · {gravity}, whatever the weight",
        ),
        (
            f"fastest time to {speed}",
            f"{figures['fastest_time']:.7f} s",
            f"{figure(figures['speed'])} / {figure(figures['limit'])}",
        ),
    ]
    return _listed(rows)


def slip_check_lines(name: str, found: Slip, unit: str) -> list[str]:
    """Return whether a load slips in one move, with the times and the margin."""
    title = SHAPE_NAMES.get(name, name)
    peak = f"peak {figure(found.peak)} of {figure(found.limit)} {unit}/s² at {figure(found.peak_time)} s"
    if not found.slips:
        return [f"{title}: the load stays; {peak}, margin {found.margin:.1%}"]
    spans = ", ".join(f"{a:.6f} to {b:.6f} s" for a, b in found.spans[:4])
    more = f" and {len(found.spans) - 4} more" if len(found.spans) > 4 else ""
    return [
        f"{title}: the load slips; {peak}, margin {found.margin:.1%}",
        f"  beyond the limit from {spans}{more}",
    ]


def dac_lines(timings: Sequence[DacTiming], args: argparse.Namespace) -> list[str]:
    """Return one DAC step for each number of bits: its speed and the resulting times."""
    per = "min" if args.per == "minute" else "s"
    seconds = 60.0 if args.per == "minute" else 1.0
    columns = headed(
        "DAC", "steps", f"one step, {args.unit}/{per}", "takes at least, µs", "time constant, µs", "hold, µs"
    )
    rows = [
        [
            f"{t.bits} bits",
            f"±{t.steps}",
            figure(t.step_speed * seconds, 9),
            f"{t.step_time * 1e6:.4f}",
            f"{t.electrical_time_constant * 1e6:.4f}",
            f"{t.hold_time * 1e6:.4f}",
        ]
        for t in timings
    ]
    return grid(columns, rows, width=WIDTH)


def override_lines(runs: Sequence[OverrideRun], unit: str) -> list[str]:
    """Compare a move with and without override, in multiples of the slip limit."""
    columns = headed(
        "<DAC", "<override", "onset, × limit", "over an update, × limit", f"slid, {unit}", f"largest error, {unit}"
    )  # fmt: skip
    rows = [
        [
            run.name,
            f"{run.steps} step{'' if run.steps == 1 else 's'}, held {run.hold}" if run.steps else "none",
            f"{run.onset / run.limit:.3f}",
            f"{run.mean / run.limit:.3f}",
            f"{run.slid:.6f}",
            f"{run.error:.6f}",
        ]
        for run in runs
    ]
    limit = runs[0].limit
    return [
        *grid(columns, rows, width=WIDTH),
        "",
        f"limit {figure(limit)} {unit}/s²; beyond it the load slips",
    ]


def plant_line(plant: Motor | Drive) -> str:
    """Describe a motor by the values that differ from the default plant."""
    kind = type(plant)
    values = [
        (field.name, getattr(plant, field.name), getattr(kind(), field.name)) for field in fields(plant)
    ]
    own = [f"{name} {value:g}" if isinstance(value, float) else f"{name} {value}"
           for name, value, default in values if value != default]  # fmt: skip
    name = "motor" if kind is Motor else "drive"
    rest = "the rest is that of [axis.N.plant] in docs/machine-file.md"
    return f"{name}: {', '.join([*own, rest])}"


def plant_lines(plants: Mapping[int, Motor | Drive]) -> list[str]:
    """Describe the motors of a run by axis, each once."""
    lines: dict[str, list[str]] = {}
    for axis, plant in plants.items():
        lines.setdefault(plant_line(plant), []).append(str(axis))
    return [f"axis {', '.join(axes)}: {line}" for line, axes in lines.items()]


def compare_lines(basis: str, rows: Sequence[Row], window: float) -> list[str]:
    """Return the four profiles side by side."""
    columns = headed(
        "<profile", "acceleration, counts/s²", "time, s", "settle, s", "peak error, counts", "RMS torque, N m",
        "jerk demanded, counts/s³", "jerk of the motor, counts/s³",
    )  # fmt: skip
    cells = [
        [
            SHAPE_NAMES[row.shape],
            f"{row.accel:.0f}",
            f"{row.time:.6f}",
            "never" if row.settle == inf else f"{row.settle:.5f}",
            f"{row.peak_error:.3f}",
            f"{row.rms_torque:.6f}",
            "∞" if row.jerk == inf else f"{row.jerk:.4g}",
            f"{row.motor_jerk:.4g}",
        ]
        for row in rows
    ]
    title = "equal peak acceleration" if basis == "acceleration" else "equal time"
    head = f"{title}; settled: within {_counts(window)} of the demand for good"
    return [head, *grid(columns, cells, width=WIDTH)]


def step_lines(figures: StepFigures, linear: LoopFigures | None) -> list[str]:
    """Return rise, overshoot, settling, and for a linear loop bandwidth and margins."""
    rows = [
        ("rise, 10 to 90 %", _seconds(figures.rise), ""),
        (
            "overshoot",
            f"{figures.overshoot:.2%}",
            f"{figures.peak:.4f} counts at {_seconds(figures.peak_time)}",
        ),
        ("settling, 2 %", _seconds(figures.settling), ""),
        ("error at the end", f"{_quiet(figures.final_error):.4f} counts", ""),
        ("largest output", f"{figures.peak_output:.4f} V", ""),
        ("bandwidth", f"{figures.bandwidth:.2f} Hz", "0.35 / rise"),
    ]
    return _listed([*rows, *_linear_rows(linear)])


def _linear_rows(linear: LoopFigures | None) -> list[tuple[str, str, str]]:
    if linear is None:
        return [("linear loop", "no", "quantisation, friction or a slow derivative: no frequency response")]
    if not linear.stable:
        return [("linear loop", "unstable", "without its limits it would not settle")]
    margin = "∞" if linear.gain_margin == inf else f"× {linear.gain_margin:.3f}"
    return [
        ("bandwidth, linear", f"{linear.bandwidth:.2f} Hz", "-3 dB of the closed loop"),
        ("phase margin", f"{linear.phase_margin:.2f}°", f"at {linear.crossover:.2f} Hz"),
        ("gain margin", margin, ""),
    ]


def tune_lines(
    made: Suggestion, figures: StepFigures, mint: Mapping[str, float], mccl: Mapping[str, float]
) -> list[str]:
    """Return the gains in volts and in both languages, and the step response."""
    loop = made.loop
    rows = [
        ("proportional", f"{loop.proportional:.6g}", "V per count"),
        ("integral", f"{loop.integral:.6g}", "V per count and sample"),
        ("derivative", f"{loop.derivative:.6g}", "V per count and sample"),
        ("velocity feed-forward", f"{loop.velocity_ff:.6g}", "V per count/s"),
        ("acceleration feed-forward", f"{loop.accel_ff:.6g}", "V per count/s²"),
    ]
    words = ", ".join(f"{word} = {_plain(value)}" for word, value in mint.items())
    commands = ",".join(f"1{word}{_plain(value)}" for word, value in mccl.items())
    lines = [
        *_listed(rows),
        "",
        f"Mint: {words}",
        f"MCCL: {commands}",
        "",
        *step_lines(figures, made.figures),
    ]
    return [*lines, *(f"warning: {text}" for text in made.warnings)]


def listing_lines(settings: Settings, made: ListingRun) -> list[str]:
    """Return a few rows of a run of the listing, and the largest accelerations."""
    columns = headed("update", "demand, counts", "position, counts", "velocity, counts/update", "DAC, steps")
    last = len(made.demand) - 1
    shown = sorted({0, 1, 2, *(round(last * k / 10) for k in range(11))} & set(range(last + 1)))
    rows = [
        [
            str(i),
            str(made.demand[i]),
            f"{_quiet(made.position[i]):.2f}",
            f"{_quiet(made.velocity[i]):.3f}",
            str(made.dac[i]),
        ]
        for i in shown
    ]
    demanded = settings.accel / settings.hold
    return [
        *grid(columns, rows, width=WIDTH),
        "",
        f"demanded acceleration {figure(demanded)} counts/update²; largest over an update {figure(made.peak_mean)}, "
        f"just after a DAC change {figure(made.peak_onset)}",
    ]


def run_figures(axis: int, trace: ServoTrace, settled: float) -> dict[str, object]:
    """Return one axis of a run as JSON data."""
    return {
        "axis": axis,
        "peak_error": trace.peak_error,
        "final_error": float(trace.error[-1]),
        "settled_at": None if settled == inf else settled,
        "rms_torque": trace.rms_torque,
        "peak_torque": float(abs(trace.torque).max()),
        "peak_output": trace.peak_output,
    }


def run_lines(rows: Sequence[tuple[int, ServoTrace, float]], window: float) -> list[str]:
    """Return the axes of a run: error, settling, torque and output."""
    columns = headed(
        "axis", "peak error, counts", "error at the end, counts", "settled at, s", "RMS torque, N m",
        "peak torque, N m", "peak output, V",
    )  # fmt: skip
    cells = [
        [
            str(axis),
            f"{trace.peak_error:.3f}",
            f"{_quiet(float(trace.error[-1])):.3f}",
            "never" if settled == inf else f"{settled:.5f}",
            f"{trace.rms_torque:.6f}",
            f"{float(abs(trace.torque).max()):.6f}",
            f"{trace.peak_output:.4f}",
        ]
        for axis, trace, settled in rows
    ]
    return [
        *grid(columns, cells, width=WIDTH),
        "",
        f"settled: within {_counts(window)} of the demand for good",
    ]


def figure(value: float, digits: int = 7) -> str:
    """Format a number to seven significant digits, without trailing zeros."""
    return f"{value:.{digits}g}"


def _counts(value: float) -> str:
    return f"{figure(value)} count{'' if value == 1.0 else 's'}"


def _plain(value: float) -> str:
    """Format a number to six digits without an exponent, which both languages read."""
    decimals = max(0, 5 - floor(log10(abs(value)))) if value else 0
    text = f"{value:.{decimals}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def _seconds(value: float) -> str:
    return "never" if value == inf else f"{value:.5f} s"


def _quiet(value: float) -> float:
    """Return the value, or 0.0 if it is rounding noise, so that no minus sign appears."""
    return 0.0 if abs(value) < 5e-4 else value


def _listed(rows: Sequence[tuple[str, str, str]]) -> list[str]:
    first = max(len(name) for name, _, _ in rows)
    second = max(len(value) for _, value, _ in rows)
    return [f"{name:<{first}}  {value:<{second}}  {note}".rstrip() for name, value, note in rows]
