"""A PVT point in wire units, and the limits of the wire format."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import isfinite, isnan

from motionlang.lab.pvt.points import Point

# The largest time in milliseconds, from the eight bits of its field.
MAX_TIME = 255
INT32 = range(-(2**31), 2**31)


@dataclass(frozen=True, slots=True)
class WirePoint:
    """Position in counts, velocity in 0.1 counts/s, time in ms to the next point.

    A velocity of None means a linear segment, a time of 0 the end.
    """

    position: int
    velocity: int | None
    time: int
    relative: bool = False


@dataclass(frozen=True, slots=True)
class BadPoint:
    """A point that a drive would not execute as intended, with reason and consequence.

    `index` counts from 0. A `severe` point cannot be sent. Any other can, but its effect differs from the
    table.
    """

    index: int
    reason: str
    consequence: str
    severe: bool = True


def to_wire(points: Sequence[Point]) -> list[WirePoint]:
    """Round points to wire units; raise ValueError for the first that does not fit."""
    for bad in check_points(points):
        if bad.severe:
            raise ValueError(f"point {bad.index}: {bad.reason}")
    return [_rounded(point) for point in points]


def from_wire(points: Iterable[WirePoint]) -> list[Point]:
    """Convert points to counts, counts/s and seconds."""
    return [
        Point(
            float(p.position), None if p.velocity is None else p.velocity / 10.0, p.time / 1000.0, p.relative
        )
        for p in points
    ]


def check_points(points: Sequence[Point], start: float | None = None) -> list[BadPoint]:
    """Return every point that a drive would misinterpret, in order.

    `start` is the position of the motor, if known.
    """
    if not points:
        return [BadPoint(0, "there are no points", "the drive would have nothing to start with")]
    found = []
    for i, point in enumerate(points):
        found.extend(_troubles(i, point, len(points)))
    if points[-1].time != 0.0:
        found.append(_endless(points))
    first = points[0]
    if start is not None and not first.relative and isfinite(first.position) and first.position != start:
        found.append(
            BadPoint(
                0,
                f"the move begins at {first.position:.10g} but the motor is at {start:.10g}",
                f"the drive would command a step of {first.position - start:.10g} counts at once",
                severe=False,
            )
        )
    return found


def _rounded(point: Point) -> WirePoint:
    velocity = None if point.velocity is None else round(point.velocity * 10.0)
    return WirePoint(round(point.position), velocity, round(point.time * 1000.0), point.relative)


def _troubles(i: int, point: Point, count: int) -> list[BadPoint]:
    return [
        trouble
        for trouble in (
            _field_trouble(i, "position", point.position, 1.0, "counts"),
            _field_trouble(i, "velocity", point.velocity, 10.0, "counts/s"),
            _time_trouble(i, point.time, count),
        )
        if trouble
    ]


def _field_trouble(i: int, name: str, value: float | None, per_unit: float, unit: str) -> BadPoint | None:
    if value is None:
        return None
    if not isfinite(value):
        word = "not a number" if isnan(value) else "infinite"
        return BadPoint(
            i, f"the {name} is {word}", "there is nothing that could be sent: no drive would see it"
        )
    wire = round(value * per_unit)
    if wire in INT32:
        return None
    seen = (wire + 2**31) % 2**32 - 2**31
    return BadPoint(
        i,
        f"the {name} {value:.15g} {unit} does not fit 32 bits",
        f"the drive would read {seen / per_unit:.15g} {unit}",
    )


def _time_trouble(i: int, time: float, count: int) -> BadPoint | None:
    if not isfinite(time) or time < 0.0:
        word = "not a number" if isnan(time) else "infinite" if time > 0.0 else "negative"
        return BadPoint(
            i, f"the time is {word}", "there is nothing that could be sent: no drive would see it"
        )
    exact = time * 1000.0
    wire = round(exact)
    if wire > MAX_TIME:
        seen = wire % 256
        effect = "end the move at this point" if seen == 0 else f"take {seen} ms"
        return BadPoint(
            i,
            f"the time {exact:.15g} ms is longer than {MAX_TIME} ms",
            f"the field holds eight bits: the drive would {effect}",
        )
    if abs(exact - wire) > 1e-6:
        effect = "end the move at this point" if wire == 0 else f"take {wire} ms"
        return BadPoint(
            i, f"the time {exact:.6g} ms is not a whole number of milliseconds", f"the drive would {effect}"
        )
    if wire == 0 and i + 1 < count:
        left = count - i - 1
        rest = "the point after it" if left == 1 else f"the {left} points after it"
        return BadPoint(
            i,
            "the time is 0 in mid-move",
            f"the drive would end the move at this point and keep {rest} for the next start",
        )
    return None


def _endless(points: Sequence[Point]) -> BadPoint:
    return BadPoint(
        len(points) - 1,
        "the last point does not end the move: its time is not 0",
        "the drive would reach it, find its buffer empty, flag an underflow and brake",
    )
