"""The text of a function as ranges of the text, numbered within the function."""

from __future__ import annotations

import pytest

from motionlang.kernel.mint.resolve.recall import OwnText


@pytest.mark.parametrize(
    ("at", "number"),
    [(1, None), (2, 0), (4, 2), (5, None), (6, None), (7, 3), (8, 4), (9, None), (20, 5), (21, None)],
)
def test_an_offset_has_a_number_if_it_is_in_a_range(at: int, number: int | None) -> None:
    """Offsets 2 to 4, 7, 8 and 20; an empty range has none."""
    own = OwnText([(2, 5), (6, 6), (7, 9), (20, 21)])
    assert own.ranges == [(2, 5), (7, 9), (20, 21)]
    assert own.number(at) == number
    if number is not None:
        assert own.at(number) == at
