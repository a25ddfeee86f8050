"""The limit certificate: machine file limits, extremes reached, and margins.

The extremes come from the closed form of the motion (`commands/certify/extremes.py`).
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from math import inf

from motionlang.commands.certify.extremes import Extreme, extremes, motor_peak
from motionlang.kernel import MACHINE_SUFFIX, STDIN_NAME, Axis, Controller, Diagnostic

# The limits of `[axis.N.limits]`: the field of the extremes or the column of the motor, and the unit.
LIMITS = {
    "position": ("", "uu"),
    "speed": ("speed", "uu/s"),
    "acceleration": ("acceleration", "uu/s²"),
    "jerk": ("jerk", "uu/s³"),
    "torque": ("torque", "N m"),
    "following_error": ("error", "uu"),
}
MOTOR = ("torque", "following_error")
# A figure that exceeds a limit by less than this fraction of it equals it.
SLACK = 1e-9
# The derivative that jumps where another one is infinite.
JUMPS = {"acceleration": "velocity", "jerk": "acceleration"}


class CertifiedLimit:
    """One line of the certificate: a limit, the extreme `reached`, when and where.

    `reached` is None if it is unknown because no motor is simulated. `margin` is the remaining fraction of
    the limit, negative if the limit is exceeded. The margin of a position is in user units.
    """

    def __init__(
        self, axis: int, name: str, unit: str, limit: float, found: Extreme | None, line: int
    ) -> None:
        self.axis, self.name, self.unit, self.limit, self.line = axis, name, unit, limit, line
        self.reached = None if found is None else found.value
        self.time = None if found is None else found.time
        self.margin: float | None = None
        if found is None:
            return
        if name == "lowest position":
            self.margin = found.value - limit
        elif name == "highest position":
            self.margin = limit - found.value
        else:
            self.margin = 1.0 - found.value / limit

    @property
    def verdict(self) -> str:
        """ "within", "exceeded" or "unknown"."""
        if self.margin is None:
            return "unknown"
        size = max(abs(self.limit), 1.0) if "position" in self.name else 1.0
        return "within" if self.margin >= -SLACK * size else "exceeded"

    def as_dict(self) -> dict[str, object]:
        """Return the line in the form of the JSON report."""
        return {name: getattr(self, name) for name in ("axis", "name", "unit", "limit", "reached", "time", "line",
                                                       "margin", "verdict")}  # fmt: skip


def certificate(controller: Controller, settings: Mapping[str, object], until: float) -> list[CertifiedLimit]:
    """Return one line per limit of the machine file, by axis; two lines per position."""
    found = []
    for number, a in controller.axes.items():
        given = {
            name: settings[key] for name in LIMITS if (key := f"axis.{number}.limits.{name}") in settings
        }
        if given:
            found += list(_of_axis(controller, a, given, until))
    return found


def _of_axis(
    controller: Controller, a: Axis, given: Mapping[str, object], until: float
) -> Iterator[CertifiedLimit]:
    reached = extremes(a, until)
    for name, limit in given.items():
        field, unit = LIMITS[name]
        if name == "position":
            assert isinstance(limit, list)
            pairs = (
                ("lowest position", limit[0], reached.lowest),
                ("highest position", limit[1], reached.highest),
            )
            for which, bound, extreme in pairs:
                yield CertifiedLimit(a.index, which, unit, bound, extreme, _line(controller, a, extreme.time))
            continue
        assert isinstance(limit, (int, float))
        most = motor_peak(a, until, field) if name in MOTOR else getattr(reached, field)
        line = 0 if most is None else _line(controller, a, most.time)
        yield CertifiedLimit(a.index, name.replace("_", " "), unit, float(limit), most, line)


def _line(controller: Controller, a: Axis, time: float) -> int:
    """Return the line of the move of an axis at a time; 0 before its first move."""
    line = 0
    for move in controller.log.moves:
        if move.start_time > time + SLACK:
            break
        if move.axis == a.index:
            line = move.line
    return line


def missing_limits(program: str, machine: str | None, axis: int) -> str:
    """Return the hint that names the machine file in which limits are missing, or that to write, for an axis."""
    if machine is None:
        stem = os.path.splitext(program)[0]
        machine = "a machine file" if program == STDIN_NAME else f"{stem}{MACHINE_SUFFIX} next to the program"
    return f"add a section such as [axis.{axis}.limits] with speed = 500, acceleration = 8000 to {machine}"


def violations(lines: list[CertifiedLimit], hint: str) -> list[Diagnostic]:
    """Return a diagnostic per exceeded or unknown limit; `hint` is for a machine without limits."""
    found = [_diagnostic_of(line) for line in lines if line.verdict != "within"]
    if not lines:
        found.append(Diagnostic("beyond-limit", "nothing to certify: the machine has no limits", hint=hint))
    return found


def _diagnostic_of(line: CertifiedLimit) -> Diagnostic:
    if line.reached is None:
        message = f"the {line.name} of axis {line.axis} cannot be certified: no motor is simulated"
        return Diagnostic("beyond-limit", message, hint=f"add [axis.{line.axis}.plant] to the machine file")
    what = f"the {line.name} of axis {line.axis} reaches {line.reached:.6g} {line.unit} at {line.time:.6f} s"
    if line.reached == inf:
        jumps = JUMPS[line.name]
        what = (
            f"the {line.name} of axis {line.axis} is infinite at {line.time:.6f} s, because its {jumps} jumps"
        )
    return Diagnostic("beyond-limit", f"{what}; the machine allows {line.limit:.6g}", line.line)


def least_margin(lines: list[CertifiedLimit]) -> float | None:
    """Return the smallest relative margin of the limits; None if none is known.

    The margin of a position is taken relative to the magnitude of the limit.
    """
    shares = [
        line.margin / max(abs(line.limit), 1e-12) if "position" in line.name else line.margin
        for line in lines
        if line.margin is not None
    ]
    return min(shares, default=None)
