"""The limit certificate: machine file limits, extremes reached, and margins.

The extremes come from the closed form of the motion (`commands/certify/extremes.py`).
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from math import inf, isinf

from motionlang.commands.certify.extremes import Extreme, extremes, motor_peak, peak_speed
from motionlang.kernel import MACHINE_SUFFIX, STDIN_NAME, Axis, Controller, Diagnostic, Run

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
    """Return the hint that names the machine file in which limits of an axis are missing, or that to write."""
    if machine is None:
        stem = os.path.splitext(program)[0]
        machine = "a machine file" if program == STDIN_NAME else f"{stem}{MACHINE_SUFFIX} next to the program"
    return f"add a section such as [axis.{axis}.limits] with speed = 500, acceleration = 8000 to {machine}"


def violations(run: Run, lines: Sequence[CertifiedLimit], hint: Callable[[int], str]) -> list[Diagnostic]:
    """Return a diagnostic per exceeded or unknown limit, and for what the certificate does not cover.

    `hint` returns the hint for an axis without limits.
    """
    found = [_diagnostic_of(line) for line in lines if line.verdict != "within"]
    if not lines:
        message = "nothing to certify: the machine has no limits"
        return [*found, Diagnostic("beyond-limit", message, hint=hint(run.dialect.first_axis))]
    found += [
        Diagnostic("beyond-limit", _NO_LIMITS.format(axis), hint=hint(axis))
        for axis in _unlimited(run, lines)
    ]
    return found if _failure(run) else found + _cut(run, lines)


def omissions(run: Run, lines: Sequence[CertifiedLimit]) -> list[str]:
    """Return what a certificate does not cover: axes without limits, and motion that the end of the run cut off."""
    found = [_NO_LIMITS.format(axis) for axis in _unlimited(run, lines)]
    return found + (_failure(run) or [each.message for each in _cut(run, lines)])


_NO_LIMITS = "axis {} moved and has no limits"


def _unlimited(run: Run, lines: Sequence[CertifiedLimit]) -> list[int]:
    """Return the axes that moved and have no limits."""
    limited = {line.axis for line in lines}
    return [n for n, a in run.controller.axes.items() if n not in limited and peak_speed(a, run.time)]


def _failure(run: Run) -> list[str]:
    """Return how a run failed, which its own errors report."""
    at = f"at {run.time:.6g} s"
    if run.status == "interrupted":
        return [f"the run was cut off {at}"]
    hangs = [f"the run hangs at line {each.line}" for each in run.diagnostics if _is_hang(each)]
    return hangs or ([f"the run failed {at}"] if run.status == "fault" else [])


def _is_hang(diagnostic: Diagnostic) -> bool:
    return diagnostic.code == "never" and diagnostic.severity == "error"


def _cut(run: Run, lines: Sequence[CertifiedLimit]) -> list[Diagnostic]:
    """Return where the end of a run cut off its motion.

    A motion of the cycle that the run repeats is complete, and so is a jog at its speed, unless its axis has a limit of
    position.
    """
    controller, cut = run.controller, f"the run was cut off at {run.time:.6g} s"
    placed = {line.axis for line in lines if "position" in line.name}
    repeated = () if run.cycle is None else run.cycle.lines
    found = []
    for axis in controller.moving():
        a = controller.axes[axis]
        line, is_steady = _line(controller, a, run.time), isinf(controller.idle_time(axis))
        is_steady = is_steady and not a.at(run.time).acceleration and axis not in placed
        if line not in repeated and not is_steady:
            found.append(Diagnostic("beyond-limit", f"{cut}, while axis {axis} was moving", line))
    scheduler = run.machine.scheduler
    is_over = bool(repeated) or run.status != "until" or scheduler is None or scheduler.is_over()
    if not found and not is_over:
        hint = "let the program end, or repeat its cycle"
        found.append(Diagnostic("beyond-limit", f"{cut}, before the program ended", hint=hint))
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
