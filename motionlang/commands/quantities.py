"""The results that a sweep keeps of a run, by name: `time`, `peak.0`, `prints`.

A row of the table has a name, its unit, and a function that reads it from a run. `N` is an axis, numbered as
in the language; `K` is a line that the program printed, counted from 1.

`cycle` is the period of the cycle of the run (`kernel/log/cycle.py`). With a name it is the time between occurrences of
something else that the run repeats:

    cycle(12)            a move that line 12 starts; without one, a wait, an output or a printed line of line 12;
                         axes that start together start once
    cycle(output 3)      output 3 is switched on
    cycle(print placed)  a line with this text is printed

It is the median of these times; `.least`, `.most` and `.count` are the others.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

from motionlang.commands.certify import certificate, least_margin
from motionlang.commands.certify.extremes import extremes, motor_peak, peak_speed
from motionlang.kernel import Run
from motionlang.kernel.tools import nearest

ResultValue = float | str | bool | None
Reader = Callable[[Run, int], ResultValue]

CYCLE = re.compile(
    r"cycle(?:\((?:(\d{1,9})|output +(\d{1,4})|print +([^()]+))\)(?:\.(median|least|most|count))?)?"
)
CYCLES = "cycle, cycle(LINE), cycle(output N) or cycle(print TEXT); after a bracket .least, .most or .count"
# What a line can do twice, by the stream of the log, the most telling first.
_STATEMENTS = ("moves", "waits", "outputs", "analogue_outputs", "prints")
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


def _switched(run: Run, channel: int) -> int:
    return sum(each.channel == channel for each in run.machine.log.outputs)


def _margin(run: Run, number: int) -> float | None:
    return least_margin(certificate(run.controller, run.machine.settings, run.time))


def cycle_of(run: Run, name: str) -> float | int | None:
    """Return a cycle of a run by its name; None if nothing occurs twice. Raise ValueError for another form."""
    form = CYCLE.fullmatch(name)
    if form is None:
        raise ValueError(f"{name} is no cycle; write {CYCLES}")
    line, output, text, figure = form.groups()
    if not (line or output or text):
        found = run.cycle
        return None if found is None else found.period
    periods = [after - before for before, after in pairwise(cycle_times(run, name))]
    if figure == "count":
        return len(periods)
    if not periods:
        return None
    return {"least": min, "most": max}.get(figure, median)(periods)


def cycle_times(run: Run, name: str) -> Sequence[float]:
    """Return the times at which a cycle begins, by its name."""
    form = CYCLE.fullmatch(name)
    assert form is not None
    if form[0] == "cycle":
        found = run.cycle
        return () if found is None else found.times
    return _times(run, *form.groups()[:3])


def no_cycle_notes(run: Run, values: Mapping[str, object]) -> list[str]:
    """Return a note for the cycles among some quantities that have no value, with the cycle of the run."""
    lacking = [name for name, value in values.items() if value is None and CYCLE.fullmatch(name)]
    if not lacking:
        return []
    found = run.cycle
    there = f"the cycle of the run is {found}" if found else "the run repeats no work"
    return [f"{' and '.join(lacking)} {'has' if len(lacking) == 1 else 'have'} no value; {there}"]


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
    Quantity("switched.N", "", "how often output N was switched on or off", _switched),
    Quantity("cycle", "s", "period of the cycle that run names", lambda run, n: cycle_of(run, "cycle")),
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
    return {name: row.read(run, number) for name in names for row, number in [quantity(name)]}


def _cycle(name: str) -> Quantity:
    if CYCLE.fullmatch(name) is None:
        raise ValueError(f"{name} is no cycle; write {CYCLES}")
    unit = "" if name.endswith(".count") else "s"
    return Quantity(name, unit, "", lambda run, n: cycle_of(run, name))


def _times(run: Run, line: str | None, output: str | None, text: str | None) -> list[float]:
    log = run.machine.log
    if output is not None:
        return [each.time for each in log.outputs if each.channel == int(output) and each.value]
    if text is not None:
        return [each.time for each in log.prints if text.strip() in each.text]
    number = int(line or 0)
    found = (
        list(dict.fromkeys(time for at, time in _occurrences(run, name) if at == number))
        for name in _STATEMENTS
    )
    return next((times for times in found if times), [])


def _occurrences(run: Run, name: str) -> Iterator[tuple[int, float]]:
    """Yield line and time of each record of a stream of the log."""
    log = run.machine.log
    if name == "moves":
        yield from ((move.line, move.start_time) for move in log.moves)
        return
    records: Iterable[tuple[int, float]]
    if name == "waits":
        records = ((wait.at, wait.since) for wait in log.waits.written())
    else:
        records = ((each.at, each.time) for each in getattr(log, name))
    lines = {-1: 0}
    for at, time in records:
        if at not in lines:
            lines[at] = run.dialect.locate(run.source, at)[0]
        yield lines[at], time


def unit_of(name: str) -> str:
    """Return the unit of a result by name; empty if it has none."""
    return quantity(name)[0].unit
