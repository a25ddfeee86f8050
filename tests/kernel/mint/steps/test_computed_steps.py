"""A For with a computed step, whose sign is the direction."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Source

# The iterations of `For i = start To stop Step step`, by step. A step of 0 counts up to the limit and never ends: the
# sixth iteration leaves the loop.
UP = {-3: 0, -2: 0, -1: 0, 0: 6, 1: 5, 2: 3, 3: 2}
DOWN = {-3: 2, -2: 3, -1: 5, 0: 0, 1: 0, 2: 0, 3: 0}
SAME = {-3: 1, -2: 1, -1: 1, 0: 6, 1: 1, 2: 1, 3: 1}
LOOPS = [(1, 5, UP), (5, 1, DOWN), (4, 4, SAME)]


@pytest.mark.parametrize("counter", ["Integer", "Float"])
@pytest.mark.parametrize(("least", "most"), [(-3, 3), (-3, -1), (1, 3)])
@pytest.mark.parametrize(("start", "stop", "iterations"), LOOPS)
@pytest.mark.parametrize("step", ["s", "s * one"])
def test_a_step_of_either_sign(
    counter: str, least: int, most: int, start: int, stop: int, iterations: dict[int, int], step: str
) -> None:
    """The compiler knows that a step of a range without 0 has one direction."""
    text = f"""\
Dim s As Integer, n As Integer, i As {counter}, one As Float
one = 1
For s = {least} To {most}
  n = 0
  For i = {start} To {stop} Step {step}
    n = n + 1
    If n = 6 Then Exit For
  Next
  PRINT n
Next
"""
    expected = [str(iterations[s]) for s in range(least, most + 1)]
    assert run(Source("a.mnt", text), until=1.0).output == expected
