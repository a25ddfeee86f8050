"""The results that a sweep keeps of a run, by name: `time`, `peak.0`, `prints`.

A row of the table has a name, its unit, and a function that reads it from a run. `N` is an axis, numbered as
in the language; `K` is a line that the program printed, counted from 1.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass

from motionlang.commands.certify import certificate, least_margin
from motionlang.commands.certify.extremes import extremes, motor_peak, peak_speed
from motionlang.commands.profile.periods import FORM, HELP, cycle_of
from motionlang.kernel import Run
from motionlang.kernel.tools import nearest

ResultValue = float | str | bool | None
Reader = Callable[[Run, int], ResultValue]

_NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


@dataclass(eq=False, slots=True)
class Quantity:
    """One row of the table: `name` is `time`, or `peak.N` with a number."""

    name: str
    unit: str
    help: str
    read: Reader


def _printed(run: Run, line: int) -> str | None:
    lines = run.output
    return lines[line - 1] if 0 < line <= len(lines) else None


def _number(run: Run, line: int) -> float | None:
    found = _NUMBER.search(_printed(run, line) or "")
    return None if found is None else float(found[0])


def _position(run: Run, axis: int) -> float:
    a = run.controller.axes[axis]
    counts = a.position(run.time) if a.feedback is None else a.feedback.position
    return a.scale.position_to_user(counts)


def _peak(run: Run, axis: int) -> float:
    return peak_speed(run.controller.axes[axis], run.time)


def _extreme(which: str) -> Reader:
    def read(run: Run, axis: int) -> float:
        found: float = getattr(extremes(run.controller.axes[axis], run.time), which).value
        return found

    return read


def _events(run: Run, number: int) -> int:
    return len(run.machine.log.events)


def _margin(run: Run, number: int) -> float | None:
    return least_margin(certificate(run.controller, run.machine.settings, run.time))


def _motor(column: str, rms: bool = False) -> Reader:
    def read(run: Run, axis: int) -> float | None:
        found = motor_peak(run.controller.axes[axis], run.time, column, rms=rms)
        return None if found is None else found.value

    return read


ROWS = (
    Quantity("time", "s", "duration of the run, machine time", lambda run, n: run.time),
    Quantity("status", "", "status at the end: ended, until, fault", lambda run, n: run.status),
    Quantity("moves", "", "number of moves started", lambda run, n: run.machine.moves_made),
    Quantity("events", "", "number of events: limits, faults, clamps, stops", _events),
    Quantity("prints", "", "the printed output", lambda run, n: "\n".join(run.output)),
    Quantity("prints.K", "", "printed line K, from 1", _printed),
    Quantity("number.K", "", "first number in printed line K", _number),
    Quantity("position.N", "uu", "position of axis N at the end", _position),
    Quantity("lowest.N", "uu", "lowest commanded position of axis N, from the zero of its homing", _extreme("lowest")),
    Quantity("highest.N", "uu", "highest commanded position of axis N, from that zero", _extreme("highest")),
    Quantity("peak.N", "uu/s", "highest speed of axis N", _peak),
    Quantity("accel.N", "uu/s²", "highest acceleration or deceleration of axis N", _extreme("acceleration")),
    Quantity("jerk.N", "uu/s³", "highest jerk of axis N, inf if the acceleration jumps", _extreme("jerk")),
    Quantity("error.N", "uu", "largest following error of the motor of axis N", _motor("error")),
    Quantity("torque.N", "N m", "largest torque of that motor", _motor("torque")),
    Quantity("rms_torque.N", "N m", "RMS torque over the run", _motor("torque", True)),
    Quantity("output.N", "V", "largest output to that motor", _motor("output")),
    Quantity("cycle(…)", "s", "median time between moves, waits, outputs or prints of a line: cycle(12); between an "
             "output's being switched on: cycle(output 3); between lines with a text: cycle(print placed); or .least, "
             ".most, .count",
             lambda run, n: None),
    Quantity("margin", "", "smallest margin of [axis.N.limits], as a fraction of the limit", _margin),
)  # fmt: skip
_BY_NAME = {row.name.partition(".")[0] + ("." if "." in row.name else ""): row for row in ROWS}


def quantity(name: str) -> tuple[Quantity, int]:
    """Return the row of a name and the number in it.

    Raises ValueError with a hint if the name is unknown.
    """
    if name.startswith("cycle("):
        return _cycle(name), 0
    stem, dot, number = name.partition(".")
    row = _BY_NAME.get(stem + dot)
    if row is not None and (not dot or (number.isascii() and number.isdigit() and len(number) < 10)):
        return row, int(number or 0)

    near = nearest(name, [each.name for each in ROWS])
    hint = f"did you mean {near}?" if near else f"there are {', '.join(each.name for each in ROWS)}"
    raise ValueError(f"a run has no {name}; {hint}")


def quantity_names(text: str) -> tuple[str, ...]:
    """Return the names of quantities of a run, separated by commas."""
    names = tuple(each.strip() for each in text.split(",") if each.strip())
    for name in names:
        quantity(name)
    return names


def values_of(run: Run, names: Iterable[str]) -> dict[str, ResultValue]:
    """Return results of a run by name."""
    return {name: row.read(run, number) for name in names for row, number in [quantity(name)]}


def _cycle(name: str) -> Quantity:
    if FORM.fullmatch(name) is None:
        raise ValueError(f"{name} is no cycle; write {HELP}")
    unit = "" if name.endswith(".count") else "s"
    return Quantity(name, unit, "", lambda run, n: cycle_of(run, name))


def unit_of(name: str) -> str:
    """Return the unit of a result by name; empty if it has none."""
    return quantity(name)[0].unit
