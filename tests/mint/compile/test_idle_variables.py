"""The variables that decide nothing are not part of the state of a polling loop.

Iterations that differ only in them are skipped; the others run one by one.
"""

from __future__ import annotations

import re

import pytest

from motionlang.execution import accelerators
from motionlang.mint import DIALECT
from motionlang.source import Source

HEAD = "Dim x As Float, y As Float, n As Integer\n"


def state_and_counters(body: str) -> tuple[str, str]:
    """Return the variables by which a loop compares its iterations, and its counters."""
    source = Source("a.mnt", f"{HEAD}While INX(0) = 0\n  {body}\nEnd While\n")
    listing = DIALECT.listing(source, {}, {}, accelerators(False).ranges)
    text = " ".join(code for _, code, _ in listing.lines)
    (found,) = re.findall(r"\(E\.acts,([^)]*)\), \(([^)]*)\)", text)
    state, counters = (" ".join(re.findall(r"v_(\w)", each)) for each in found)
    return state, counters


@pytest.mark.parametrize(
    ("body", "state", "counters"),
    [
        # Copies and extrema of a reading, alone and together.
        ("x = POS(0)", "", ""),
        ("x = POS(0) : x = VEL(0)", "", ""),
        ("If POS(0) > x Then x = POS(0)", "", ""),
        ("If x > POS(0) Then x = POS(0)", "", ""),
        ("x = POS(0)\n  If POS(0) > y Then y = POS(0)", "", ""),
        # A variable that another statement reads decides something, and so does one of another test.
        ("x = POS(0) : y = x", "x y", ""),
        ("x = x + POS(0)", "x", ""),
        ("If POS(0) > x Then x = VEL(0)", "x", ""),
        ("If POS(0) = x Then x = POS(0)", "x", ""),
        ("x = POS(0)\n  If x > 3 Then OUTX(0) = 1", "x", ""),
        # Counters, with a constant that one of them is compared with.
        ("n = n + 1", "", "n"),
        ("n = n - 2", "", "n"),
        ("n = n + 1 : n = n + 2", "", "n"),
        ("n = n + 1\n  If n > 1000 Then STOP(0)", "", "n"),
        ("n = n + 1 : n = n + 2\n  If n > 1000 Then STOP(0)", "n", ""),
        ("n = n * 2", "n", ""),
        ("n = n + 1 : x = n", "n x", ""),
    ],
)
def test_a_loop_is_compared_by_the_variables_that_decide_something(
    body: str, state: str, counters: str
) -> None:
    assert state_and_counters(body) == (state, counters)
