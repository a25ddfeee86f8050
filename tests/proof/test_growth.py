"""The work of a proof grows linearly with its run: counted, not timed."""

from __future__ import annotations

from motionlang.kernel import Source
from tests.cases import cases
from tests.counted_calls import all_calls
from tests.proof import prove, run
from tests.proof.checker import Proof

CONTOUR = """SPEED(0) = 40 : ACCEL(0) = 1000 : DECEL(0) = 1000
CONTOURMODE(0) = 1 : MOVEBUFFERSIZE(0) = 100 : MOVEBUFFERSIZE(1) = 100
{}GO(0)
PAUSE IDLE(0)
"""
OFFSETS = """SPEED(1) = 80 : ACCEL(1) = 300 : DECEL(1) = 400 : MASTERSOURCE(1) = _msPOS : MASTERCHANNEL(1) = 0
FOLLOW(1) = 0.5
JOG(0) = 30
{}CANCEL(0)
"""


def calls(text: str) -> int:
    """Return how many functions the proof of a program calls."""
    result = run(Source("long.mnt", text))
    proofs: list[Proof] = []
    count = all_calls(lambda: proofs.append(prove(result)))
    assert proofs[0].holds
    return count


@cases(
    "program, line",
    [
        (CONTOUR, "VECTORR(0, 1) = 0.3, 0.4\n"),
        (OFFSETS, "OFFSET(1) = 0.1 : GO(1)\nWAIT 60\n"),
    ],
)
def test_twice_as_much_motion_is_twice_the_work(program: str, line: str) -> None:
    few, many = (calls(program.format(line * count)) for count in (30, 60))
    assert many <= 2.2 * few
