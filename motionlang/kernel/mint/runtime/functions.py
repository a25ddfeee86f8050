"""Mint's functions, and the operators that Python lacks.

Every function here is named by a row of the keyword table or called by a step. Errors are raised as `Rejected`.
"""

from __future__ import annotations

import math
from collections.abc import Callable

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.machine.machine import Machine
from motionlang.kernel.mint.runtime.printing import show_float, show_integer, shows_float
from motionlang.kernel.tools import signed

INT_LOW, INT_HIGH = -(2**31), 2**31 - 1
_DEGREE = math.pi / 180.0


# ------------------------------------------------------------------------------------- operators and checks


def overflow(value: float) -> int:
    """Raise Rejected for a value that does not fit in an Integer of 32 bits."""
    raise Rejected(
        "overflow", f"{value} does not fit an Integer", "an Integer holds -2147483648 to 2147483647"
    )


def integer(value: float) -> int:
    """Convert a number to an Integer: drop the fraction and check the range.

    That the fraction is dropped is an assumption (docs/contributing/assumptions.md).
    """
    try:
        whole = math.trunc(value)
    except (ValueError, OverflowError):
        raise Rejected("overflow", f"{show_float(value)} has no Integer value", "") from None
    return whole if INT_LOW <= whole <= INT_HIGH else overflow(whole)


def divide(a: float, b: float) -> int:
    """Divide integers toward zero."""
    a, b = integer(a), integer(b)
    whole = abs(a) // abs(b)
    return integer(whole if (a < 0) is (b < 0) else -whole)


def modulo(a: float, b: float) -> float:
    """Return the remainder, with the sign of the dividend."""
    rest = abs(a) % abs(b)
    return -rest if a < 0 else rest


def power(a: float, b: float) -> float:
    if a == 0 and b < 0:
        raise ZeroDivisionError
    try:
        return _number("^", math.pow, a, b)
    except OverflowError:
        return -math.inf if a < 0 and b % 2 == 1 else math.inf


def shift_left(a: float, b: float) -> int:
    """Shift the bits of an Integer left; bits beyond 32 are lost."""
    return signed(integer(a) << _shift_count(b))


def shift_right(a: float, b: float) -> int:
    """Shift the bits of an Integer right, with the sign preserved."""
    return integer(a) >> _shift_count(b)


def _shift_count(b: float) -> int:
    count = integer(b)
    if count < 0:
        raise Rejected(
            "argument", f"bits cannot be shifted by {count} positions", "shift in the other direction"
        )
    return min(count, 32)


def index(value: int, size: int) -> int:
    """Raise Rejected for a subscript outside 1 … size."""
    raise Rejected("index", f"there is no element {value}: the subscript must be 1 to {size}",
                  "the first element of an array has the subscript 1")  # fmt: skip


def subscript(value: float, size: int) -> int:
    """Return a subscript; raise Rejected if it is outside the array."""
    whole = value if isinstance(value, int) else integer(value)
    return whole if 1 <= whole <= size else index(whole, size)


# The length of a String without a size. Without a bound a loop could exhaust the computer's memory.
MAX_TEXT = 65_535


def fit(text: str, size: int) -> str:
    """Return a text for a String of `size` characters; raise Rejected if it is longer."""
    if len(text) > size:
        raise Rejected("string-overflow", f"a text of {len(text)} characters does not fit a String * {size}",
                      "make the String longer")  # fmt: skip
    return text


# ------------------------------------------------------------------------------------------------- numbers


def _number(name: str, function: Callable[..., float], *arguments: float) -> float:
    try:
        return function(*arguments)
    except ValueError:
        shown = ", ".join(f"{each:.15g}" for each in arguments)
        raise Rejected(
            "argument", f"{name} has no value for {shown}", "test the value before this line"
        ) from None


def absolute(value: float) -> float:
    return overflow(2**31) if value == INT_LOW and isinstance(value, int) else abs(value)


def sign(value: float) -> int:
    return (value > 0) - (value < 0)


def whole(value: float) -> int:
    return integer(value)


def least(a: float, b: float) -> float:
    return min(a, b)


def greatest(a: float, b: float) -> float:
    return max(a, b)


def root(value: float) -> float:
    return _number("Sqrt", math.sqrt, value)


def exponential(value: float) -> float:
    try:
        return math.exp(value)
    except OverflowError:
        return math.inf


def logarithm(value: float) -> float:
    return _number("Log", math.log, value)


def sine(angle: float) -> float:
    """Return the sine, exact at those multiples of 30 degrees where it is rational."""
    exact = _SINES.get(angle % 360.0)
    return _number("Sin", math.sin, angle * _DEGREE) if exact is None else exact


def cosine(angle: float) -> float:
    return sine(angle + 90.0)


def tangent(angle: float) -> float:
    below = cosine(angle)
    if below == 0:
        raise Rejected("argument", f"Tan has no value at {angle:.10g} degrees", "")
    return 1.0 if angle % 180.0 == 45.0 else -1.0 if angle % 180.0 == 135.0 else sine(angle) / below


_SINES = {0.0: 0.0, 30.0: 0.5, 90.0: 1.0, 150.0: 0.5, 180.0: 0.0, 210.0: -0.5, 270.0: -1.0, 330.0: -0.5}


def arcsine(value: float) -> float:
    return _number("Asin", math.asin, value) / _DEGREE


def arccosine(value: float) -> float:
    return _number("Acos", math.acos, value) / _DEGREE


def arctangent(value: float) -> float:
    return math.atan(value) / _DEGREE


# ---------------------------------------------------------------------------------------------------- text


def length(text: str) -> int:
    return len(text)


def code(text: str) -> int:
    """Return the code of the first character, 0 for an empty text."""
    return ord(text[0]) if text else 0


def character(number: float) -> str:
    value = integer(number)
    if not 0 <= value <= 255:
        raise Rejected("argument", f"there is no character {value}", "characters have codes from 0 to 255")
    return chr(value)


def shown(value: float) -> str:
    return show_integer(value) if isinstance(value, int) else show_float(value)


def shown_by(machine: Machine) -> Callable[[float], str]:
    """Return the function `shown` for a machine that prints Floats differently."""
    show = shows_float(machine)
    return lambda value: show_integer(value) if isinstance(value, int) else show(value)


def value(text: str) -> float:
    """Return the number at the beginning of a text, 0 if there is none."""
    return leading_number(text)[0]


def leading_number(text: str) -> tuple[float, str]:
    """Return the number at the beginning of a text, 0 if there is none, and the text behind it."""
    text = text.strip()
    for end in range(len(text), 0, -1):
        head = text[:end]
        if head.isascii() and (head[-1].isdigit() or head[-1] == "."):
            try:
                return float(head.replace("_", "x")), text[end:]
            except ValueError:
                continue
    return 0.0, text


def left(text: str, count: float) -> str:
    return text[: _count(count)]


def right(text: str, count: float) -> str:
    number = _count(count)
    return text[-number:] if number else ""


def middle(text: str, first: float, count: float = INT_HIGH) -> str:
    start = _count(first)
    if start < 1:
        raise Rejected("argument", "the first character of a text has position 1", "")
    return text[start - 1 : start - 1 + _count(count)]


def _count(count: float) -> int:
    number = integer(count)
    if number < 0:
        raise Rejected("argument", f"a number of characters cannot be {number}", "")
    return number


class Random:
    """The random numbers of `Rnd`, the same in every run (Lehmer generator, 31 bits)."""

    def __init__(self) -> None:
        self._state = 1

    def __call__(self) -> float:
        self._state = self._state * 48271 % 2147483647
        return self._state / 2147483647
