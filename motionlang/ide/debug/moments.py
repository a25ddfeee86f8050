"""Moments of a run without a statement: motion, limits, faults, outputs.

They are found in the log of a run: events, moves, changes of channels, and the motion of the axes. A search covers the
times after a first one, up to a second one.

    axis 0 starts     axis 0 stops     input 5 rises     output 2 falls     position(0) > 120 and input(3)

A condition occurs when its value changes from false to true. Between two changes in the log the motion is sampled,
`SAMPLES` times in each profile, and the time is then found by bisection.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from motionlang.ide.debug.expressions import Expression, WrongExpression, parse
from motionlang.kernel import INFINITY, Machine
from motionlang.kernel.log import Changed, Switched
from motionlang.kernel.tools import bisected

# Yields the moments after one time up to another.
Search = Callable[[Machine, float, float], Iterable["Occurrence"]]

# Samples of each profile in which a condition is looked for, and the resolution of its time, s.
SAMPLES = 64
RESOLUTION = 1e-9
# A reading at which an expression such as `1 / (position(0) - 1)` does not divide by zero.
READING = 0.7320508
# Texts of moments at the same time in one message: an e-stop has one for each axis.
MAX_TEXTS = 2
# The exception filters by name: what they are called, and the kinds of events.
FILTERS = {
    "error": ("Run-time errors", ()),
    "fault": ("Faults of an axis", ("fault", "following error", "e-stop", "abort")),
    "limit": ("Limits reached", ("limit", "soft limit")),
    "clamp": ("Values clamped to a limit", ("clamp",)),
}
_AXIS = re.compile(r"\s*axis\s+(\d+)\s+(starts|stops)\s*", re.IGNORECASE)
_CHANNEL = re.compile(r"\s*(input|output)\s+(\d+)\s+(rises|falls|changes)\s*", re.IGNORECASE)
FORMS = "axis 0 starts, axis 0 stops, input 5 rises, output 2 falls or a condition such as position(0) > 120"


@dataclass(eq=False, slots=True)
class Occurrence:
    """An occurrence at a time, s.

    `at` is the program's source offset at that time, if it is known, and `reason` the reason of the stop after it.
    """

    time: float
    text: str
    at: int | None = None
    reason: str = "moment"


def together(found: list[Occurrence]) -> Occurrence:
    """Return the first of ordered moments, with the texts of all at the same time."""
    first = found[0]
    texts = list(dict.fromkeys(each.text for each in found if each.time == first.time))
    more = f"; {len(texts) - MAX_TEXTS} more" if len(texts) > MAX_TEXTS else ""
    return Occurrence(first.time, "; ".join(texts[:MAX_TEXTS]) + more, first.at, first.reason)


def search(text: str, axes: range) -> Search:
    """Return the search for a motion breakpoint on a controller with these axes.

    Raises WrongExpression if it is invalid or names another axis.
    """
    match = _AXIS.fullmatch(text)
    if match is not None:
        _check_axis(int(match[1]), axes)
        return _axis(int(match[1]), match[2].lower())
    match = _CHANNEL.fullmatch(text)
    if match is not None:
        return channel(match[1].lower(), int(match[2]), match[3].lower())
    blank = _Blank()
    try:
        expression = parse(text)
        expression(blank)
    except WrongExpression as error:
        raise WrongExpression(f"{error}; a motion breakpoint is {FORMS}") from None
    for number in blank.axes:
        _check_axis(number, axes)
    return lambda machine, after, until: _becomes_true(expression, text, machine, after, until)


def _check_axis(number: int, axes: range) -> None:
    if number not in axes:
        raise WrongExpression(f"there is no axis {number}; this controller has axes {axes[0]} to {axes[-1]}")


def filtered(kinds: Iterable[str]) -> Search:
    """Return the search for events of some kinds."""
    wanted = frozenset(kinds)

    def find(machine: Machine, after: float, until: float) -> Iterator[Occurrence]:
        for event in _since(machine.log.events, after):
            if event.time <= until and event.kind in wanted:
                axis = "" if event.axis is None else f" of axis {event.axis}"
                text = f": {event.text}" if event.text else ""
                yield Occurrence(event.time, f"{event.kind}{axis}{text}", event.at, "exception")

    return find


def complaints(machine: Machine, after: float, until: float) -> Iterator[Occurrence]:
    """Yield the errors that did not end the program, such as rejected commands."""
    for each in machine.diagnostics:
        if each.severity == "error" and after < each.first <= until:
            yield Occurrence(each.first, f"{each.message}, line {each.line}", None, "exception")


def channel(what: str, number: int, how: str, reason: str = "moment") -> Search:
    """Return the search for changes of a digital input or output."""

    def find(machine: Machine, after: float, until: float) -> Iterator[Occurrence]:
        log = machine.log.inputs if what == "input" else machine.log.outputs
        for each in _since(log, after):
            if each.channel == number and each.time <= until:
                rises = bool(each.value)
                if how == "changes" or (how == "rises") is rises:
                    yield Occurrence(
                        each.time, f"{what} {number} {'rises' if rises else 'falls'}", None, reason
                    )

    return find


def _since(stream: Any, after: float) -> list[Any]:
    """Return the records of a stream after a time, in order."""
    found = []
    for each in reversed(stream):
        if each.time <= after:
            break
        found.append(each)
    return found[::-1]


def _axis(number: int, how: str) -> Search:
    if how == "stops":
        return lambda machine, after, until: _stops(machine, number, after, until)

    def starts(machine: Machine, after: float, until: float) -> Iterator[Occurrence]:
        found = []
        for move in reversed(machine.log.moves):
            if move.start_time <= after:
                break
            found.append(move)
        for move in reversed(found):
            if (
                move.axis == number
                and move.start_time <= until
                and (move.profile is None or move.profile.duration)
            ):
                yield Occurrence(move.start_time, f"axis {number} starts {move.command}")

    return starts


def _stops(machine: Machine, number: int, after: float, until: float) -> Iterator[Occurrence]:
    axis = machine.controller.axes.get(number)
    if axis is None:
        return
    first = max(axis.index_at(after), 0)
    starts, profiles = axis.starts[first:], axis.profiles[first:]
    for k, (start, profile) in enumerate(zip(starts, profiles, strict=True)):
        end = min(start + profile.duration, starts[k + 1] if k + 1 < len(starts) else INFINITY)
        moved = profile.duration > 0 and any(
            profile.velocity(profile.duration * fraction) for fraction in (0.25, 0.5, 0.75)
        )
        if moved and after < end <= until and abs(axis.at(end + RESOLUTION).velocity) < RESOLUTION:
            yield Occurrence(end, f"axis {number} stops")


# --------------------------------------------------------------------------------------------------- conditions


class _Blank:
    """A state whose readings are all `READING`, to check an expression without a run.

    Targets are rejected: the log has the motion of an axis, not its targets. `axes` lists the axes that were read.
    """

    def __init__(self) -> None:
        self.axes: list[int] = []

    def variable(self, name: str, subscripts: list[float]) -> float | None:
        return None

    def reading(self, what: str, number: int) -> float:
        if what == "target":
            raise WrongExpression("the target of an axis has no history; use position")
        if what not in ("input", "output", "time"):
            self.axes.append(number)
        return READING


class Past:
    """The state of a machine at an earlier time, taken from the log."""

    def __init__(self, machine: Machine, time: float) -> None:
        self._machine, self.time = machine, time

    def variable(self, name: str, subscripts: list[float]) -> float | None:
        """Return None: the log has no variables."""
        return None

    def reading(self, what: str, number: int) -> float:
        """Return a reading at `time`."""
        if what == "time":
            return self.time
        if what in ("input", "output"):
            log: Iterable[Changed | Switched] = (
                reversed(self._machine.log.inputs) if what == "input" else reversed(self._machine.log.outputs)
            )
            for each in log:
                if each.channel == number and each.time <= self.time:
                    return each.value
            return 0.0
        axis = self._machine.controller.axes.get(number)
        if axis is None:
            raise WrongExpression(f"there is no axis {number}")
        state = axis.at(self.time)
        if what == "velocity":
            return axis.scale.rate * state.velocity / axis.scale_at(self.time)[0]
        if what == "idle":
            return float(state.velocity == 0.0)
        return axis.place_at(self.time)


def _becomes_true(
    expression: Expression, text: str, machine: Machine, after: float, until: float
) -> Iterator[Occurrence]:
    state = Past(machine, after)

    def holds(time: float) -> bool:
        state.time = time
        return bool(expression(state))

    before, was_true = after, holds(after)
    for time in _samples(machine, after, until):
        now = holds(time)
        if now and not was_true:
            yield Occurrence(bisected(time, before, holds), f"{text.strip()} holds")
        before, was_true = time, now


def _samples(machine: Machine, after: float, until: float) -> list[float]:
    """Return the times at which a condition is evaluated."""
    found = {until}
    for log in (machine.log.inputs, machine.log.outputs):
        found.update(each.time for each in _since(log, after))
    for axis in machine.controller.axes.values():
        first = max(axis.index_at(after), 0)
        for start, profile in zip(axis.starts[first:], axis.profiles[first:], strict=True):
            length = min(profile.duration, until - start)
            if start + length > after:
                found.update(start + length * k / SAMPLES for k in range(SAMPLES + 1))
    return sorted(each for each in found if after < each <= until)
