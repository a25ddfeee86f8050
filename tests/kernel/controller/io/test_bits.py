"""Words of 32 bits in two's complement."""

import pytest

from motionlang.kernel.controller.io.bits import signed


@pytest.mark.parametrize(
    ("word", "number"),
    [
        (0, 0),
        (0x7FFFFFFF, 2147483647),
        (0x80000000, -2147483648),
        (0xFFFFFFFF, -1),
        (0x1_0000_0005, 5),
        (-1, -1),
        (-0x80000001, 2147483647),
    ],
)
def test_the_highest_of_32_bits_is_the_sign(word: int, number: int) -> None:
    assert signed(word) == number
