"""Rates of a file's moves that no command sets and no source gives.

A move without SV, SA or DS runs at a default that is a choice of this program, so its time is one, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from motionlang.kernel.lang.chosen_rates import note, unset
from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.structure import AxisKey, Use
from motionlang.kernel.mccl.keywords import trajectory
from motionlang.kernel.mccl.models import Model

# The name of the assumption about the rates at power-up.
POWER_UP = "mccl.power-up"
RATES = ("speed", "accel", "decel")
_UNITS = {"uu/s": "counts/s", "uu/s2": "counts/s²"}


def chosen_rates(uses: Sequence[tuple[int, Use]], settings: Mapping[str, object], model: Model) -> list[str]:
    """Return a line about the rates that the moves of a file take from a chosen default, if there are any.

    `uses` are those of its commands, each with its line.
    """
    rows = [row for row in trajectory.ROWS if row.family not in model.lacks]
    axes = _moved(uses)
    chosen = unset(rows, (use for _, use in uses), RATES) if axes else []
    figures = [_default(row, axis, settings, model) for row in chosen for axis in sorted(axes, key=str)]
    return note(chosen, figures, [POWER_UP], ",".join(f"1{row.name}…" for row in chosen))


def _default(row: Keyword, axis: AxisKey, settings: Mapping[str, object], model: Model) -> str:
    """Return the value of a rate of an axis at power-up; that of a stepper may differ."""
    is_stepper = settings.get(f"axis.{axis}.motor") == "stepper"
    value = model.stepper[row.gives != "speed"] if is_stepper else row.default
    return f"{value:.10g} {_UNITS[row.unit]}"


def _moved(uses: Sequence[tuple[int, Use]]) -> set[AxisKey]:
    """Return the axes that a command moves at these rates; the commands on the line of a path only describe it."""
    paths = {line for line, use in uses if use.row is not None and use.row.function == "path"}
    runs = any(use.row is not None and use.row.does("endless") for _, use in uses)
    roles = ("start", "run") if runs else ("start",)
    return {axis for line, use in uses if use.role in roles and line not in paths for axis in use.axes}
