"""Servo figures as tables of plain text, the same on every machine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields
from math import floor, inf, log10
from typing import TYPE_CHECKING

from motionlang.notes.tn1069_servo import Row
from motionlang.servo.plant import Drive, Motor
from motionlang.views.grid import Cells, filled

if TYPE_CHECKING:
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


def plant_line(plant: Motor | Drive) -> str:
    """Describe a motor by the values that differ from the default plant."""
    kind = type(plant)
    values = [
        (field.name, getattr(plant, field.name), getattr(kind(), field.name)) for field in fields(plant)
    ]
    own = [f"{name} {value:.10g}" if isinstance(value, float) else f"{name} {value}"
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


# Heads and cells of the profiles of `compare_lines`.
_PROFILES: Cells = {
    "<profile": lambda row: SHAPE_NAMES[row.shape],
    "acceleration, counts/s²": lambda row: f"{row.accel:.0f}",
    "time, s": lambda row: f"{row.time:.6f}",
    "settle, s": lambda row: "never" if row.settle == inf else f"{row.settle:.5f}",
    "peak error, counts": lambda row: f"{row.peak_error:.3f}",
    "RMS torque, N m": lambda row: f"{row.rms_torque:.6f}",
    "jerk demanded, counts/s³": lambda row: "∞" if row.jerk == inf else f"{row.jerk:.4g}",
    "jerk of the motor, counts/s³": lambda row: f"{row.motor_jerk:.4g}",
}


def compare_lines(basis: str, rows: Sequence[Row], window: float) -> list[str]:
    """Return the four profiles side by side."""
    title = "equal peak acceleration" if basis == "acceleration" else "equal time"
    head = f"{title}; settled: within {_counts(window)} of the demand for good"
    return [head, *filled(_PROFILES, rows, width=WIDTH)]


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


# Heads and cells of the axes of `run_lines`.
_AXES: Cells = {
    "axis": lambda row: str(row[0]),
    "peak error, counts": lambda row: f"{row[1].peak_error:.3f}",
    "error at the end, counts": lambda row: f"{_quiet(float(row[1].error[-1])):.3f}",
    "settled at, s": lambda row: "never" if row[2] == inf else f"{row[2]:.5f}",
    "RMS torque, N m": lambda row: f"{row[1].rms_torque:.6f}",
    "peak torque, N m": lambda row: f"{float(abs(row[1].torque).max()):.6f}",
    "peak output, V": lambda row: f"{row[1].peak_output:.4f}",
}


def run_lines(rows: Sequence[tuple[int, ServoTrace, float]], window: float) -> list[str]:
    """Return the axes of a run: error, settling, torque and output."""
    last = f"settled: within {_counts(window)} of the demand for good"
    return [*filled(_AXES, rows, width=WIDTH), "", last]


def _counts(value: float) -> str:
    return f"{value:.7g} count{'' if value == 1.0 else 's'}"


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
