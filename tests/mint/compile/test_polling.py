"""How loops that poll are compiled: what may be repeated, and what certainly acts."""

from __future__ import annotations

from motionlang.mint.compile.polling import is_repeated
from motionlang.mint.keywords import table
from tests.cases import cases


@cases(
    "word, repeated",
    [
        ("SPEED", True),
        ("OUTX", True),
        ("JOG", True),
        ("STOP", True),
        ("CANCEL", True),
        ("RESET", True),
        ("GO", False),
        ("PAUSE", False),
        ("INCR", False),
        ("PULSEOUTX", False),
        ("MOVER", False),
        ("OFFSET", False),
        ("CAM", False),
        ("SPLINE", False),
    ],
)
def test_keywords_that_may_be_a_no_op_when_a_loop_repeats_them(word: str, repeated: bool) -> None:
    """Settings that can be read back, and stops.

    A move acts each time, even if it can be read like CAM.
    """
    row = table().get(word)
    assert row is not None
    assert is_repeated(row) is repeated
