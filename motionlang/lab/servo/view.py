"""Servo figures as tables of plain text, the same on every machine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields
from math import floor, inf, log10
from typing import TYPE_CHECKING

from motionlang.kernel.servo import Motor, VelocityDrive
from motionlang.lab.servo.tn1069 import Row
from motionlang.views.table import Column, Table

if TYPE_CHECKING:
    from motionlang.kernel.servo import LoopFigures, ServoTrace, StepFigures, Suggestion

WIDTH = 120
SHAPE_NAMES = {
    "trapezoid": "trapezoidal",
    "sinusoidal": "sinusoidal S-curve",
    "scurve": "trapezoidal S-curve",
    "parabolic": "parabolic",
}


def plant_line(plant: Motor | VelocityDrive) -> str:
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


def plant_lines(plants: Mapping[int, Motor | VelocityDrive]) -> list[str]:
    """Describe the motors of a run by axis, each once."""
    lines: dict[str, list[str]] = {}
    for axis, plant in plants.items():
        lines.setdefault(plant_line(plant), []).append(str(axis))
    return [f"axis {', '.join(axes)}: {line}" for line, axes in lines.items()]


def profiles_table(basis: str, rows: Sequence[Row], window: float) -> Table:
    """Return the four profiles side by side; they settle within `window` counts."""
    title = "equal peak acceleration" if basis == "acceleration" else "equal time"
    head = f"{title}; settled: within {_counts(window)} of the demand for good"
    columns = (
        Column("shape", "profile", text=SHAPE_NAMES.__getitem__, left=True),
        Column("accel", "acceleration", "counts/s²", text="{:.0f}".format),
        Column("time", unit="s", text="{:.6f}".format),
        Column("settle", unit="s", text=_settled),
        Column("peak_error", unit="counts", text="{:.3f}".format),
        Column("rms_torque", "RMS torque", "N m", text="{:.6f}".format),
        Column("peak_torque", data=True),
        Column("jerk", "jerk demanded", "counts/s³", text=lambda jerk: "∞" if jerk == inf else f"{jerk:.4g}"),
        Column("motor_jerk", "jerk of the motor", "counts/s³", text="{:.4g}".format),
    )
    return Table(basis, columns, rows, head=head)


def plants_table(plants: Mapping[int, Motor | VelocityDrive]) -> Table:
    """Return the motors of a run by axis, with the value of each of their settings, as data."""
    rows = [
        {"axis": axis, "setting": each.name, "value": getattr(plant, each.name)}
        for axis, plant in plants.items()
        for each in fields(plant)
    ]
    return Table("plants", (Column("axis"), Column("setting"), Column("value")), rows)


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


def axes_table(rows: Sequence[tuple[int, ServoTrace, float]], window: float) -> Table:
    """Return the axes of a run: error, settling within `window` counts, torque and output."""
    last = f"settled: within {_counts(window)} of the demand for good"
    columns = (
        Column("axis"),
        Column("peak_error", unit="counts", text="{:.3f}".format),
        Column("final_error", "error at the end", "counts", text=lambda error: f"{_quiet(error):.3f}"),
        Column("settled_at", unit="s", text=_settled),
        Column("rms_torque", "RMS torque", "N m", text="{:.6f}".format),
        Column("peak_torque", unit="N m", text="{:.6f}".format),
        Column("peak_output", unit="V", text="{:.4f}".format),
    )
    found = [
        {
            "axis": axis,
            "peak_error": trace.peak_error,
            "final_error": float(trace.error[-1]),
            "settled_at": settled,
            "rms_torque": trace.rms_torque,
            "peak_torque": float(abs(trace.torque).max()),
            "peak_output": trace.peak_output,
        }
        for axis, trace, settled in rows
    ]
    return Table("axes", columns, found, empty="no axis was moved", notes=["", last] if found else [])


def _settled(time: float) -> str:
    return "never" if time == inf else f"{time:.5f}"


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
