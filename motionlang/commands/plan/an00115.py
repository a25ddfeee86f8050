"""ABB's note AN00115: formulas of a trapezoidal move, and its drawings.

`FORMULAS` has a formula for each figure; a function returns the points of each shape in the drawings. The note's
letters: D is the distance, T the time of the move, Ta, Ts and Td its parts, Sp the slew speed. The distance is the
area under the speed. If Ta = Td, the triangle of the deceleration, cut off and turned upside down, fits above the
triangle of the acceleration. The area is then that of the rectangle Sp · (Ta + Ts).
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from itertools import chain
from math import isclose, sqrt
from typing import NamedTuple

Move = Mapping[str, float]
Point = tuple[float, float]


class Formula(NamedTuple):
    """How a figure follows from others: their names, the note's formula, and its value for a move."""

    figure: str
    inputs: str
    text: str
    value: Callable[[Move], float]


# In the order of preference; the first two are equations (1) and (2) of the note.
FORMULAS: tuple[Formula, ...] = (
    Formula("speed", "distance accel_time slew_time", "D / (Ta + Ts)",
            lambda m: m["distance"] / (m["accel_time"] + m["slew_time"])),
    Formula("accel", "speed accel_time", "Sp / Ta", lambda m: m["speed"] / m["accel_time"]),
    Formula("decel", "speed decel_time", "Sp / Td", lambda m: m["speed"] / m["decel_time"]),
    Formula("accel_time", "speed accel", "Sp / Accel", lambda m: m["speed"] / m["accel"]),
    Formula("decel_time", "speed decel", "Sp / Decel", lambda m: m["speed"] / m["decel"]),
    Formula("slew_time", "distance speed accel_time decel_time", "(D - Da - Dd) / Sp",
            lambda m: m["distance"] / m["speed"] - 0.5 * (m["accel_time"] + m["decel_time"])),
    Formula("slew_time", "time accel_time decel_time", "T - Ta - Td",
            lambda m: m["time"] - m["accel_time"] - m["decel_time"]),
    Formula("time", "accel_time slew_time decel_time", "Ta + Ts + Td",
            lambda m: m["accel_time"] + m["slew_time"] + m["decel_time"]),
    Formula("distance", "speed accel_time slew_time", "Sp (Ta + Ts)",
            lambda m: m["speed"] * (m["accel_time"] + m["slew_time"])),
    Formula("distance", "speed slew_time time", "1/2 (Ts + T) Sp",
            lambda m: 0.5 * (m["slew_time"] + m["time"]) * m["speed"]),
    Formula("speed", "distance slew_time time", "2 D / (Ts + T)",
            lambda m: 2.0 * m["distance"] / (m["slew_time"] + m["time"])),
    Formula("speed", "accel accel_time", "Accel Ta", lambda m: m["accel"] * m["accel_time"]),
    Formula("speed", "decel decel_time", "Decel Td", lambda m: m["decel"] * m["decel_time"]),
    Formula("slew_time", "distance speed time", "2 D / Sp - T", lambda m: 2.0 * m["distance"] / m["speed"] - m["time"]),
    Formula("accel_time", "time slew_time decel_time", "T - Ts - Td",
            lambda m: m["time"] - m["slew_time"] - m["decel_time"]),
    Formula("decel_time", "time slew_time accel_time", "T - Ta - Ts",
            lambda m: m["time"] - m["slew_time"] - m["accel_time"]),
    Formula("accel_time", "time slew_time", "(T - Ts) / 2", lambda m: 0.5 * (m["time"] - m["slew_time"])),
    Formula("decel_time", "accel_time", "Ta", lambda m: m["accel_time"]),
    Formula("speed", "distance accel decel", "sqrt(D Accel)", lambda m: sqrt(m["distance"] * m["accel"])),
    Formula("speed", "distance accel decel", "sqrt(2 D / (1/Accel + 1/Decel))",
            lambda m: sqrt(2.0 * m["distance"] / (1.0 / m["accel"] + 1.0 / m["decel"]))),
)  # fmt: skip
# What a rule gives.
RULES = {
    "third": {"time": "3 D / (2 Sp)", "accel_time": "T / 3", "slew_time": "T / 3", "decel_time": "T / 3"},
    "quarter": {"time": "4 D / (3 Sp)", "accel_time": "T / 4", "slew_time": "T / 2", "decel_time": "T / 4"},
}
# Of the formula of a rule: the figures from which it follows, and the factor of T or D / Sp.
_RULED = {
    "T / 2": ("time", 1.0 / 2.0),
    "T / 3": ("time", 1.0 / 3.0),
    "T / 4": ("time", 1.0 / 4.0),
    "3 D / (2 Sp)": ("distance speed", 3.0 / 2.0),
    "4 D / (3 Sp)": ("distance speed", 4.0 / 3.0),
}


def formulas(move: Move, given: Collection[str], rule: str | None) -> dict[str, str]:
    """Return the formula for each figure in terms of the given ones.

    A figure that requires solving an equation has no formula. The distance of `move` is positive.

    >>> move = {"distance": 20.0, "time": 0.6, "accel_time": 0.2, "slew_time": 0.2, "decel_time": 0.2,
    ...         "speed": 50.0, "accel": 250.0, "decel": 250.0}
    >>> formulas(move, {"distance", "time"}, "third")["speed"]
    'D / (Ta + Ts)'
    """
    known, found = set(given), dict[str, str]()
    by_rule = {name: text for name, text in RULES.get(rule or "", {}).items() if name not in known}
    while True:
        name, text = next(chain(_by_rule(move, known, by_rule), _following(move, known)), ("", ""))
        if not name:
            return found
        known.add(name)
        found[name] = text


def _by_rule(move: Move, known: set[str], by_rule: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    for name, text in by_rule.items():
        inputs, factor = _RULED[text]
        if name not in known and known.issuperset(inputs.split()):
            base = move["time"] if inputs == "time" else move["distance"] / move["speed"]
            if isclose(move[name], factor * base, rel_tol=1e-9):
                yield name, text


def _following(move: Move, known: set[str]) -> Iterator[tuple[str, str]]:
    for name, inputs, text, value in FORMULAS:
        if name not in known and known.issuperset(inputs.split()):
            try:
                result = value(move)
            except ZeroDivisionError:
                continue
            if isclose(result, move[name], rel_tol=1e-9, abs_tol=1e-12 * move["time"]):
                yield name, text


# ------------------------------------------------------------------------------------------------- drawings


def trapezoid(move: Move) -> list[Point]:
    """Return the corners of the trapezoid of speed over time.

    >>> trapezoid({"speed": 8, "accel_time": 0.5, "slew_time": 1, "time": 2})
    [(0.0, 0.0), (0.5, 8), (1.5, 8), (2, 0.0)]
    """
    speed, up, slew = move["speed"], move["accel_time"], move["slew_time"]
    return [(0.0, 0.0), (up, speed), (up + slew, speed), (move["time"], 0.0)]


def cut_triangle(move: Move) -> list[Point]:
    """Return the triangle of the deceleration.

    >>> cut_triangle({"speed": 8, "accel_time": 0.5, "slew_time": 1, "time": 2})
    [(1.5, 0.0), (1.5, 8), (2, 0.0)]
    """
    begin = move["accel_time"] + move["slew_time"]
    return [(begin, 0.0), (begin, move["speed"]), (move["time"], 0.0)]


def moved_triangle(move: Move) -> list[Point]:
    """Return the deceleration triangle turned upside down, above the acceleration.

    >>> moved_triangle({"speed": 8, "accel_time": 0.5})
    [(0.0, 0.0), (0.0, 8), (0.5, 8)]
    """
    return [(0.0, 0.0), (0.0, move["speed"]), (move["accel_time"], move["speed"])]


def rectangle(move: Move) -> list[Point]:
    """Return the rectangle with the area of the trapezoid, for Ta = Td.

    >>> rectangle({"speed": 8, "accel_time": 0.5, "slew_time": 1})
    [(0.0, 0.0), (0.0, 8), (1.5, 8), (1.5, 0.0)]
    """
    end, speed = move["accel_time"] + move["slew_time"], move["speed"]
    return [(0.0, 0.0), (0.0, speed), (end, speed), (end, 0.0)]
