"""Integers overflow in loops as if no iteration were skipped."""

from __future__ import annotations

import pytest

from tests.cases import cases, examples
from tests.generated.loops import Draw, is_equal, outcome


def test_an_overflow_in_a_loop_with_a_hole_is_found() -> None:
    """The loop skips i = 2 but not i = 3.

    3 * 900 000 000 is 2 700 000 000, more than 2 147 483 647.
    """
    head = "Dim i As Integer, y As Integer\n"
    found = outcome(f"{head}For i = 0 To 3\n  If i <> 2 Then y = i * 900000000\nNext\nPRINT y\n")
    assert found["status"] == "fault"
    assert found["diagnostics"][0][1:3] == ("2700000000 does not fit an Integer", 3)
    found = outcome(f"{head}For i = 0 To 2\n  If i <> 2 Then y = i * 900000000\nNext\nPRINT y\n")
    assert found["output"] == ["900000000"]


# Loops whose y overflows, if i has its full range: the value that does not fit, and a wrong bound that is too
# tight.
OVERFLOWS: dict[str, tuple[str, int]] = {
    "a whole number above 2147483647 is a Float": ("x = 3000000000 + i : y = x", 3_000_000_000 - 3),
    "-1 & n is n": ("m = i & 2147483647 : y = m * 2", (2**31 - 3) * 2),
    "n & -1 is n": ("m = 2147483647 & i : y = m * 2", (2**31 - 3) * 2),
}


@pytest.mark.parametrize("name", OVERFLOWS)
def test_an_overflow_is_found_whatever_the_range_of_a_counter(name: str) -> None:
    statement, value = OVERFLOWS[name]
    head = "Dim i As Integer, m As Integer, y As Integer, x As Float\n"
    found = outcome(f"{head}For i = -3 To 0\n  {statement}\nNext\nPRINT y\n")
    assert [each[1] for each in found["diagnostics"]] == [f"{value} does not fit an Integer"]


@pytest.mark.slow
@cases("seed", range(examples(100)))
def test_loops_end_alike_without_skipping(seed: int) -> None:
    assert is_equal(seed), Draw(seed).program()


@pytest.mark.long
@cases("seed", range(1000, 11_000))
def test_ten_thousand_loops_end_alike_without_skipping(seed: int) -> None:
    assert is_equal(seed), Draw(seed).program()
