"""The state of the machine: time, and every axis that has changed since power-up."""

from __future__ import annotations

from math import inf

from motionlang.kernel import Axis, Machine
from motionlang.views.formatting import significant


def moving(machine: Machine) -> list[int]:
    """Return the axes in motion."""
    controller = machine.controller
    return [number for number in controller.axes if not controller.is_idle(number)]


def one_line(machine: Machine, now: float) -> str:
    """Return the time and the positions then for the bottom bar.

    For example: `1.5 s   0: 200   1: 12.5 moving`.
    """
    fields = [f"{number_text(now, 9)} s"]
    for axis in _touched(machine):
        state = _state(machine, axis)
        position = number_text(axis.scale.shown_position(axis.position(now)))
        fields.append(f"{axis.index}: {position}" + (f" {state}" if state != "idle" else ""))
    return "   ".join(fields)


def table(machine: Machine, now: float) -> str:
    """Return a table of the axes at a time, in user units.

    A line shows an axis with its position, velocity, target and activity.
    """
    rows = [("axis", "position", "velocity", "target", "")]
    rows += [_row(machine, axis, now) for axis in _touched(machine)]
    widths = [max(len(row[k]) for row in rows) for k in range(4)]
    lines = ["  ".join(text.rjust(width) for text, width in zip(row, widths, strict=False)) for row in rows]
    text = "".join(f"{line}  {row[4]}".rstrip() + "\n" for line, row in zip(lines, rows, strict=True))
    return text if len(rows) > 1 else f"{len(machine.controller.axes)} axes, none moved yet\n"


def number_text(value: float, digits: int = 10) -> str:
    """Format a number without the rounding noise of its last bits."""
    return significant(value, digits) if round(value, 12) else "0"


def _touched(machine: Machine) -> list[Axis]:
    return [
        axis
        for axis in machine.controller.axes.values()
        if len(axis.starts) > 1
        or axis.buffer
        or axis.faults
        or axis.scale.counts != 1.0
        or axis.scale.zero != 0.0
    ]


def _row(machine: Machine, axis: Axis, now: float) -> tuple[str, str, str, str, str]:
    scale, endless = axis.scale, abs(axis.target) == inf
    return (
        str(axis.index),
        number_text(scale.shown_position(axis.position(now))),
        number_text(scale.to_user(axis.velocity(now), "uu/s")),
        "-" if endless else number_text(scale.shown_position(axis.target)),
        _state(machine, axis),
    )


def _state(machine: Machine, axis: Axis) -> str:
    if axis.faults:
        return f"fault {axis.faults}"
    if not axis.enabled:
        return "off"
    waiting = f", {len(axis.buffer)} in the buffer" if axis.buffer else ""
    return ("idle" if machine.controller.is_idle(axis.index) else "moving") + waiting
