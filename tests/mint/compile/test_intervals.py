"""The range of an operation is that of its results for all pairs of operands.

The expected ranges are found by trying all operands.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from math import inf

import pytest

from motionlang.mint.compile import intervals
from motionlang.mint.compile.intervals import (
    ANY,
    CHECKED,
    COERCED,
    EXACT,
    FLOAT,
    INT_HIGH,
    INT_LOW,
    INTEGER,
    PLAIN,
    Range,
    arithmetic,
    constant,
    fits_integer,
    join,
    narrow,
    quotient,
    remainder,
    to_integer,
    widen,
)

# All ranges between -3 and 3.
SMALL = [(low, high, "i") for low in range(-3, 4) for high in range(low, 4)]


def every(a: Range) -> range:
    return range(int(a[0]), int(a[1]) + 1)


def toward_zero(x: int, y: int) -> int:
    return int(x / y)


def sign_of_dividend(x: int, y: int) -> int:
    return x - y * toward_zero(x, y)


@pytest.mark.parametrize(
    ("op", "work"),
    [("+", lambda x, y: x + y), ("-", lambda x, y: x - y), ("*", lambda x, y: x * y)],
)
def test_the_bounds_of_an_operation_are_reached(op: str, work: Callable[[int, int], int]) -> None:
    for a, b in product(SMALL, SMALL):
        results = [work(x, y) for x in every(a) for y in every(b)]
        assert arithmetic(op, True, a, b) == ((min(results), max(results), "i"), PLAIN), (a, b)


def test_a_quotient_by_a_positive_number_has_its_exact_bounds() -> None:
    """Division by a range with negative numbers or 0 is bounded by the dividend alone."""
    for a, b in product(SMALL, SMALL):
        results = [toward_zero(x, y) for x in every(a) for y in every(b) if y]
        low, high, _ = quotient(a, b)
        if b[0] > 0:
            assert (low, high) == (min(results), max(results)), (a, b)
        else:
            bound = max(map(abs, every(a)))
            assert (low, high) == (-bound, bound), (a, b)
    assert quotient(INTEGER, (-1, 1, "i")) == INTEGER


def test_a_remainder_has_the_sign_of_its_dividend() -> None:
    """Its range is that of all dividends from 0 on, divided by the largest divisor."""
    for a, b in product(SMALL, SMALL):
        low, high, _ = remainder(a, b)
        assert all(low <= sign_of_dividend(x, y) <= high for x in every(a) for y in every(b) if y), (a, b)
        largest = max(*map(abs, every(b)), 1, 1)
        results = [sign_of_dividend(x, largest) for x in range(int(min(a[0], 0)), int(max(a[1], 0)) + 1)]
        assert (low, high) == (min(results), max(results)), (a, b)
    assert remainder((-20, 30, "i"), (-4, 7, "i")) == (-6, 6, "i")
    assert remainder((-2, 3, "i"), (-9, 7, "i")) == (-2, 3, "i")


@pytest.mark.parametrize("op", ["<", "<=", ">", ">=", "=", "<>"])
def test_a_comparison_leaves_the_numbers_for_which_it_can_be_true(op: str) -> None:
    """`<>` narrows by a constant alone, and then at an end."""
    compare: dict[str, Callable[[int, int], bool]] = {
        "<": lambda x, y: x < y,
        "<=": lambda x, y: x <= y,
        ">": lambda x, y: x > y,
        ">=": lambda x, y: x >= y,
        "=": lambda x, y: x == y,
        "<>": lambda x, y: x != y,
    }
    for a, b in product(SMALL, SMALL):
        left = [x for x in every(a) if any(compare[op](x, y) for y in every(b))]
        assert narrow(a, op, b) == ((left[0], left[-1], "i") if left else None), (a, b)
        for x, y in product(every(a), every(b)):
            assert compare[op](x, y) is compare[intervals.swapped(op)](y, x)
            assert compare[op](x, y) is not compare[intervals.opposite(op)](x, y)
    for other in (FLOAT, ANY):
        assert narrow((1, 2, "i"), op, other) == (1, 2, "i")
        assert narrow(other, op, (1, 2, "i")) == other


NEAR: Range = (INT_LOW + 1, INT_HIGH - 1, "i")
ONE: Range = (-1, 1, "i")
TWO: Range = (-2, 2, "i")
# Half of the exact numbers on either side, and one more.
HALF: Range = (-(EXACT // 2), EXACT // 2, "i")
MORE: Range = (-(EXACT // 2) - 1, EXACT // 2, "i")
OVER: Range = (-(EXACT // 2), EXACT // 2 + 1, "i")


@pytest.mark.parametrize(
    ("integer", "a", "b", "expected"),
    [
        (True, NEAR, ONE, (INTEGER, PLAIN)),  # just fits
        (True, NEAR, TWO, (INTEGER, CHECKED)),
        (True, (0, INT_HIGH, "i"), (0, 1, "i"), ((0, INT_HIGH, "i"), CHECKED)),
        (True, (INT_LOW, 0, "i"), (-1, 0, "i"), ((INT_LOW, 0, "i"), CHECKED)),
        (False, HALF, HALF, ((-EXACT, EXACT, "i"), PLAIN)),  # as exact as a double
        (False, HALF, MORE, (FLOAT, COERCED)),
        (False, HALF, OVER, (FLOAT, COERCED)),
        (False, FLOAT, ONE, (FLOAT, PLAIN)),
        (False, ONE, FLOAT, (FLOAT, PLAIN)),
        (False, ANY, ONE, (FLOAT, COERCED)),
        (False, ONE, ANY, (FLOAT, COERCED)),
        (False, ANY, FLOAT, (FLOAT, PLAIN)),
    ],
)
def test_a_sum_is_checked_or_made_a_float_if_it_may_not_fit(
    integer: bool, a: Range, b: Range, expected: tuple[Range, str]
) -> None:
    assert arithmetic("+", integer, a, b) == expected


def test_ranges_are_joined_and_stored() -> None:
    assert join((1, 3, "i"), (2, 5, "i")) == (1, 5, "i")
    assert join((1, 3, "i"), (-2, 2, "i")) == (-2, 3, "i")
    assert join(FLOAT, FLOAT) == FLOAT
    assert join((-inf, 5.0, "f"), (0.0, inf, "f")) == FLOAT
    assert join(FLOAT, (1, 1, "i")) == join(ANY, FLOAT) == ANY
    assert to_integer((-5, 7, "i")) == (-5, 7, "i")
    assert to_integer((-EXACT, EXACT, "i")) == to_integer(FLOAT) == INTEGER
    assert constant(EXACT) == (EXACT, EXACT, "i")
    assert constant(-EXACT) == (-EXACT, -EXACT, "i")
    assert constant(EXACT + 1) == constant(2.0) == FLOAT
    fits = (INTEGER, True), ((INT_LOW - 1, 0, "i"), False), ((0, INT_HIGH + 1, "i"), False), (FLOAT, False)
    for a, expected in fits:
        assert fits_integer(a) is expected, a


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ((0, 3, "i"), (1, 2, "i"), (0, 3, "i")),  # nothing moves
        ((0, 3, "i"), (1, 4, "i"), (0, 10, "i")),  # to the next threshold
        ((0, 3, "i"), (1, 10, "i"), (0, 10, "i")),
        ((0, 3, "i"), (1, 11, "i"), (0, EXACT, "i")),  # beyond the last one
        ((0, 3, "i"), (-1, 3, "i"), (-5, 3, "i")),
        ((0, 3, "i"), (-5, 3, "i"), (-5, 3, "i")),
        ((0, 3, "i"), (-6, 3, "i"), (-EXACT, 3, "i")),
        ((0, 3, "i"), (-2, 4, "i"), (-5, 10, "i")),
        ((0, 3, "i"), FLOAT, ANY),
    ],
)
def test_a_growing_range_moves_in_steps(old: Range, new: Range, expected: Range) -> None:
    assert widen(old, new, [-5, 10]) == expected
