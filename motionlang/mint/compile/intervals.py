"""Intervals of numbers: the domain of the range analysis before a program runs.

A `Range` is `(low, high, kind)`. Kind "i" means that the value is certainly a Python int (and no bool)
between low and high; "f" that it is certainly a Python float; "a" that it may be either, with infinite
bounds. A Float that is stored as an int never exceeds 2^53, up to which ints and doubles give the same results.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from math import inf

INT_LOW, INT_HIGH = -(2**31), 2**31 - 1
EXACT = 2**53

Range = tuple[float, float, str]

INTEGER: Range = (INT_LOW, INT_HIGH, "i")
FLOAT: Range = (-inf, inf, "f")
ANY: Range = (-inf, inf, "a")
BOOL: Range = (0, 1, "i")

# How the compiler writes an operation, depending on whether its result is certain to fit.
PLAIN, CHECKED, COERCED = "plain", "checked", "coerced"


def constant(value: float) -> Range:
    """Return the range of a literal."""
    return (value, value, "i") if type(value) is int and abs(value) <= EXACT else FLOAT


def join(a: Range, b: Range) -> Range:
    """Return the range that contains both ranges."""
    if a == b:
        return a
    if a[2] == b[2] == "i":
        return (min(a[0], b[0]), max(a[1], b[1]), "i")
    return FLOAT if a[2] == b[2] == "f" else ANY


def widen(old: Range, new: Range, thresholds: list[int]) -> Range:
    """Join two ranges, with bounds that move only to one of `thresholds`.

    The thresholds are ascending and within ±2^53.
    """
    joined = join(old, new)
    if joined[2] != "i" or joined == old:
        return joined
    low, high = joined[0], joined[1]
    if old[2] == "i":
        if low < old[0]:
            below = bisect_right(thresholds, low)
            low = thresholds[below - 1] if below else -EXACT
        if high > old[1]:
            above = bisect_left(thresholds, high)
            high = thresholds[above] if above < len(thresholds) else EXACT
    return (low, high, "i")


def arithmetic(op: str, integer: bool, a: Range, b: Range) -> tuple[Range, str]:
    """Return the range of `a op b` (`+ - *`), and how the compiler must write it.

    `integer` is True if both sides are Integer.
    """
    if a[2] == "i" and b[2] == "i":
        low, high = _bounds(op, a, b)
        if integer:
            if low >= INT_LOW and high <= INT_HIGH:
                return (low, high, "i"), PLAIN
            return (max(low, INT_LOW), min(high, INT_HIGH), "i"), CHECKED
        if low >= -EXACT and high <= EXACT:
            return (low, high, "i"), PLAIN
        return FLOAT, COERCED
    return FLOAT, PLAIN if a[2] == "f" or b[2] == "f" else COERCED


def _bounds(op: str, a: Range, b: Range) -> tuple[float, float]:
    if op == "+":
        return a[0] + b[0], a[1] + b[1]
    if op == "-":
        return a[0] - b[1], a[1] - b[0]
    products = (a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1])
    return min(products), max(products)


def quotient(a: Range, b: Range) -> Range:
    """Return the range of integer division (toward zero) of two Integers."""
    if b[0] > 0:
        ends = [_whole(x, y) for x in a[:2] for y in b[:2]]
        return (min(ends), max(ends), "i")
    bound = max(abs(a[0]), abs(a[1]))
    return (max(-bound, INT_LOW), min(bound, INT_HIGH), "i")


def _whole(a: float, b: float) -> int:
    whole = abs(int(a)) // abs(int(b))
    return whole if (a < 0) is (b < 0) else -whole


def remainder(a: Range, b: Range) -> Range:
    """Return the range of the remainder of two Integers; it has the dividend's sign."""
    most = max(abs(b[0]), abs(b[1]), 1) - 1
    return (max(a[0], -most) if a[0] < 0 else 0, min(a[1], most) if a[1] > 0 else 0, "i")


_SWAPPED = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "=": "=", "<>": "<>"}
_OPPOSITE = {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "=": "<>", "<>": "="}


def swapped(op: str) -> str:
    """Return the comparison with its sides exchanged."""
    return _SWAPPED[op]


def opposite(op: str) -> str:
    """Return the comparison that is true when `op` is false (numbers only, not NaN)."""
    return _OPPOSITE[op]


def narrow(a: Range, op: str, b: Range) -> Range | None:
    """Return the range of `a` where `a op b` is true, None if it never is.

    Only integers are narrowed.
    """
    if a[2] != "i" or b[2] != "i":
        return a
    low, high = a[0], a[1]
    if op == "<":
        high = min(high, b[1] - 1)
    elif op == "<=":
        high = min(high, b[1])
    elif op == ">":
        low = max(low, b[0] + 1)
    elif op == ">=":
        low = max(low, b[0])
    elif op == "=":
        low, high = max(low, b[0]), min(high, b[1])
    elif b[0] == b[1]:  # <> a constant narrows only at an end
        low += low == b[0]
        high -= high == b[0]
    return (low, high, "i") if low <= high else None


def to_integer(a: Range) -> Range:
    """Return the range after a checked assignment to an Integer."""
    if a[2] != "i":
        return INTEGER
    return (max(a[0], INT_LOW), min(a[1], INT_HIGH), "i")


def fits_integer(a: Range) -> bool:
    """True if an assignment to an Integer needs no check."""
    return a[2] == "i" and a[0] >= INT_LOW and a[1] <= INT_HIGH
