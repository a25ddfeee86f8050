"""Endless loops: statements that can end a loop, and some that only seem to."""

from __future__ import annotations

import pytest

from motionlang.mint.lint import check
from motionlang.source import Source


def codes(text: str) -> list[tuple[int, str]]:
    return [(each.line, each.code) for each in check(Source("a.mnt", text), {})]


@pytest.mark.parametrize(
    ("value", "is_busy"), [("3", True), ("x", True), ("POS(0)", False), ("clock", False)]
)
def test_an_endless_loop_that_prints_is_busy_unless_the_value_changes_by_itself(
    value: str, is_busy: bool
) -> None:
    found = codes(f"Dim x, clock As Time\nx = 3\nLoop\n  Print {value}\nEnd Loop\n")
    assert ((3, "busy-loop") in found) == is_busy


@pytest.mark.parametrize(("declared", "is_endless"), [("inside", True), ("outside", False)])
def test_a_sub_that_is_called_may_end_a_loop_by_a_variable_of_the_module(
    declared: str, is_endless: bool
) -> None:
    """A Dim in the sub itself makes its x local, so `other` does not see it."""
    outside, inside = ("", "Dim x\n") if declared == "inside" else ("Dim x\n", "\n")
    text = f"{outside}f\nSub f\n{inside}x = 1\nWhile x < 2\nother\nEnd While\nEnd Sub\nSub other\nx = 2\nEnd Sub\n"
    found = [code for _, code in codes(text)]
    assert ("endless-loop" in found) == is_endless
