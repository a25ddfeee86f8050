"""CSV text by tables of digits, compared with Python's own formatting."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.views.csv import BLOCK, DECIMALS, LONG_REST, Formatter, decimals_for
from tests.cases import examples


def lines(columns: list[list[float]], decimals: list[int]) -> list[str]:
    arrays = [np.array(column) for column in columns]
    return b"".join(Formatter(decimals).lines(arrays)).decode("ascii").splitlines()


def test_numbers_of_every_length() -> None:
    numbers = [
        0.0,
        1.0,
        12.5,
        -7.25,
        9999.999999,
        10_000.0,
        99_999_999.0,
        1e8,
        -123_456_789.0625,
        1e-6,
        -1e-6,
    ]
    assert lines([numbers], [6]) == [f"{x:.6f}" for x in numbers]


def test_columns_have_their_own_decimals() -> None:
    assert lines([[1.0, -2.0], [0.5, 1 / 3], [2 / 3, 1e-9]], [6, 9, 12]) == [
        "1.000000,0.500000000,0.666666666667",
        "-2.000000,0.333333333,0.000000001000",
    ]


def test_rounding_carries_into_the_integer() -> None:
    assert lines([[9999.9999996, 0.9999996, -0.9999996]], [6]) == ["10000.000000", "1.000000", "-1.000000"]


def test_there_is_no_negative_zero() -> None:
    assert lines([[-0.0, -1e-9]], [6]) == ["0.000000", "0.000000"]


def test_what_fixed_point_cannot_represent_takes_the_slow_path() -> None:
    assert lines([[float("nan"), float("inf"), 1e300, -1.5]], [6]) == [f"{x:.6f}" for x in (
        float("nan"), float("inf"), 1e300, -1.5)]  # fmt: skip


def test_blocks_join_without_a_seam() -> None:
    count = 2 * BLOCK + 17
    numbers = [k / 8 for k in range(count)]
    assert lines([numbers], [6]) == [f"{x:.6f}" for x in numbers]


def rows(columns: list[list[float]], decimals: list[int]) -> list[str]:
    return [
        ",".join(f"{x:.{each}f}" for x, each in zip(row, decimals, strict=True))
        for row in zip(*columns, strict=True)
    ]


# The contents of two columns after the time, by stretches: rows, and if the first and the second change.
STRETCHES = {
    "a rest at the start and at the end": [(500, 0, 0), (300, 1, 1), (500, 0, 0)],
    "a rest and nothing else": [(700, 0, 0)],
    "one column changes at a time": [(400, 1, 0), (400, 0, 0), (400, 0, 1)],
    "a rest over a seam": [(BLOCK - 400, 1, 1), (900, 0, 0), (200, 1, 1)],
    "a seam between rests": [(BLOCK, 0, 0), (1, 1, 1), (BLOCK, 0, 0)],
    "rests one behind the other": [row for _ in range(9) for row in ((LONG_REST + 1, 0, 0), (1, 1, 0))],
    "rests around the shortest": [
        row for n in range(LONG_REST - 2, LONG_REST + 3) for row in ((n, 0, 0), (2, 1, 1))
    ],
}


@pytest.mark.parametrize("largest", [1.0, 1e4, 1e20])
@pytest.mark.parametrize("stretches", STRETCHES.values(), ids=STRETCHES)
def test_rows_that_stand_still_are_like_any_others(
    stretches: list[tuple[int, int, int]], largest: float
) -> None:
    time: list[float] = []
    first, second = [-0.3 * largest], [1.7]
    for count, one, two in stretches:
        for _ in range(count):
            time.append(len(time) / 8)
            first.append(first[-1] + one * 0.01 * largest)
            second.append(second[-1] - two / 3)
    columns = [time, first[1:], second[1:]]
    assert lines(columns, [9, 6, 9]) == rows(columns, [9, 6, 9])


@pytest.mark.parametrize(
    ("resolution", "decimals"), [(1.0, 6), (1 / 1200, 9), (1e-6, 9), (1e-9, 12), (1e-15, 12)]
)
def test_a_thousandth_of_a_count_is_shown(resolution: float, decimals: int) -> None:
    assert decimals_for(resolution) == decimals


@settings(max_examples=examples(300))
@given(
    st.lists(st.floats(-9e5, 9e5).map(lambda x: round(x, 9)), min_size=1, max_size=30),
    st.sampled_from(DECIMALS),
)
def test_every_number_reads_back_within_half_a_digit(numbers: list[float], decimals: int) -> None:
    for text, number in zip(lines([numbers, numbers[::-1]], [decimals, 6]), numbers, strict=True):
        first = text.split(",")[0]
        assert len(first.partition(".")[2]) == decimals
        assert abs(float(first) - number) <= 0.5000001 * 10.0**-decimals + 1e-10


@pytest.mark.parametrize("decimals", [6, 9, 12])
def test_digits_are_those_of_savetxt(decimals: int) -> None:
    """This includes large numbers whose product with 10^decimals is near a half."""
    draw = np.random.default_rng(16)
    for size in (1e-9, 1e-3, 1.0, 999.9999999999, 1e3, 3e4, 9_999_999.5):
        if size * 10.0**decimals >= 9e15:
            continue
        values = draw.uniform(-size, size, 6000)
        values[:2000] = np.round(values[:2000], decimals) + draw.choice([0.0, 0.5 * 10.0**-decimals], 2000)
        values[:4] = size, -size, np.nextafter(size, 0.0), 0.0
        shown = b"".join(Formatter([decimals]).lines([values])).decode().split()
        plain = [f"{each + 0.0:.{decimals}f}" for each in values.tolist()]
        minus = f"-{0.0:.{decimals}f}"
        assert shown == [each.replace("-", "") if each == minus else each for each in plain], size


@pytest.mark.parametrize("sign", ["", "-"])
@pytest.mark.parametrize(
    ("before", "behind"), [("999", "1000"), ("9999999", "10000000"), ("99999999", "100000000")]
)
def test_digits_that_are_rounded_up_get_one_more_digit_before_the_point(
    before: str, behind: str, sign: str
) -> None:
    """With six decimals, .9999996 is rounded up to 1, .9999993 is not."""
    values = np.array([float(f"{sign}{before}.{part}") for part in ("9999996", "9999993", "5")])
    text = b"".join(Formatter([6]).lines([values])).decode()
    shown = [f"{behind}.000000", f"{before}.999999", f"{before}.500000"]
    assert text.splitlines() == [sign + each for each in shown]
