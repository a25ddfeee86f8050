"""The elements of a cam table and its segments in use."""

from __future__ import annotations

import pytest

from motionlang.kernel import Rejected
from motionlang.kernel.mint.keywords.table_motion_cams import elements, span


@pytest.mark.parametrize(
    ("array", "values"),
    [
        ([0, 1, 7], [7]),
        ([0, 2, 7, 8], [7, 8]),
        ([0, 1, 7, 8], [7]),
        ([0, 2.9, 7, 8], [7, 8]),
        ([0, 0, 7], "0 segments, and the array has room for 1"),
        ([0, -1, 7], "-1 segments, and the array has room for 1"),
        ([0, 2, 7], "2 segments, and the array has room for 1"),
        ([0, 3], "3 segments, and the array has room for 0"),
        ([0], "0 segments, and the array has room for 0"),
    ],
)
def test_the_elements_of_a_table_follow_their_count(array: list[float], values: list[float] | str) -> None:
    """Arrays of Mint begin at 1: element 0 is not used."""
    if isinstance(values, list):
        assert elements(array, "CAM") == values
    else:
        with pytest.raises(Rejected) as caught:
            elements(array, "CAM")
        assert str(caught.value) == f"CAM: element 1 of the table says that it has {values}"


@pytest.mark.parametrize(
    ("first", "last", "segments"),
    [
        (1, 0, (0, 3)),
        (1, 3, (0, 3)),
        (1, 1, (0, 1)),
        (2, 2, (1, 2)),
        (3, 0, (2, 3)),
        (0, 0, None),
        (4, 0, None),
        (2, 1, None),
        (1, 4, None),
    ],
)
def test_the_segments_of_three_in_use(first: int, last: int, segments: tuple[int, int] | None) -> None:
    if segments is not None:
        assert span(first, last, 3, "CAM") == segments
    else:
        with pytest.raises(Rejected, match="the table has segments 1 to 3"):
            span(first, last, 3, "CAM")
