"""A loop that reads any keyword is skipped with an equal result."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Keyword, Source
from motionlang.kernel.mint import table
from tests.generated.compared import every_iteration
from tests.kernel.mint.polling_programs import COST

MACHINE: dict[str, object] = {
    "controller.instruction_time": COST, "axis.0.index_every": 1.0, "axis.0.travel": [-100.0, 100.0],
    "axis.0.home_switch": [0.5, 1.5], "axis.0.home_input": 3,
}  # fmt: skip
_SINGLE = ("axis", "axes", "channel", "bank", "auxchannel", "none")
WORDS = [
    row
    for row in table()
    if row.simulated and "R" in row.access and row.kind in ("reading", "setting") and row.unit != "text"
    and row.index in _SINGLE
]  # fmt: skip
MOTIONS = {
    "a move": "MOVER(0) = 2 : GO(0)",
    "a jog": "JOG(0) = 20",
    "a slave": "JOG(1) = 20 : MASTERSOURCE(0) = _msPOS : MASTERCHANNEL(0) = 1 : FOLLOW(0) = 1",
}
PROGRAM = """\
Dim n As Integer, k As Integer, x As Integer, y As Integer
SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500 : SPEED(1) = 30
TIME = 0
{motion}
Loop
  x = 0
  For k = 0 To 4
    If {word} > k * k * k / 2 Then x = x + 1
  Next
  If {word} > 1.5 Then x = x + 10
  If x <> y Then n = n + 1
  y = x
  If TIME > {until} Then Exit Loop
End Loop
PRINT n, " ", x, " ", TIME
"""


def outcome(row: Keyword, motion: str, until: int) -> list[object]:
    word = row.name if row.index == "none" else f"{row.name}(0)"
    text = PROGRAM.format(word=word, motion=motion, until=until)
    result = run(Source("a.mnt", text), machine=MACHINE, until=1.0)
    return [result.output, [each.message for each in result.diagnostics], result.time]


def compare(motion: str, until: int) -> None:
    skipped = {row.name: outcome(row, motion, until) for row in WORDS}
    with every_iteration():
        assert {row.name: outcome(row, motion, until) for row in WORDS} == skipped


@pytest.mark.slow
def test_while_an_axis_moves() -> None:
    compare(MOTIONS["a move"], 15)


@pytest.mark.long
@pytest.mark.parametrize("motion", MOTIONS.values(), ids=MOTIONS.keys())
def test_to_the_end_of_a_motion(motion: str) -> None:
    compare(motion, 180)
