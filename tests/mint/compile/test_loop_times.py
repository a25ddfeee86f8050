"""When loops of Gotos begin and end, as the log of a run has it.

A statement takes 10 µs, and so does a Goto.
"""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source

# Inner and outer loop, and one that begins at a later label.
NESTED = """\
WAIT(100)
n = 1
#top
m = 0
#inner
m = m + 1
WAIT(10)
If m < 3 Then Goto inner
n = n + 1
If n < 4 Then Goto top
WAIT(50)
#last
WAIT(7)
If n < 6 Then n = n + 1 : Goto last
"""
LEFT = """\
WAIT(20)
#top
n = n + 1
WAIT(10)
If n = 3 Then Goto out
Goto top
#other
WAIT(30)
#out
WAIT(5)
"""
RETURNED = """\
WAIT(20)
Walk()
WAIT(5)
Sub Walk()
  Dim n
#top
  n = n + 1
  WAIT(10)
  If n = 2 Then Exit Sub
  Goto top
End Sub
"""


@pytest.mark.parametrize("fast", [True, False])
@pytest.mark.parametrize(
    ("text", "loops"),
    [
        (
            # An inner iteration takes 10.03 ms, and a Goto 10 µs: three of them take 30.11 ms. Between two inner loops
            # there are four statements, and two behind the last one. The last loop takes twice 7.04 ms, and 7.02 ms.
            NESTED,
            [
                (0.10003, 0.13014),
                (0.13018, 0.16029),
                (0.16033, 0.19044),
                (0.10002, 0.19046),
                (0.24047, 0.26157),
            ],
        ),
        # Two iterations of 10.04 ms, and one whose Goto leaves the loop.
        (LEFT, [(0.02001, 0.05013)]),
        # One iteration of 10.04 ms, and another one of 10.03 ms, which has an Exit Sub but no Goto.
        (RETURNED, [(0.02001, 0.04008)]),
    ],
    ids=["nested", "left by a Goto", "left by a return"],
)
def test_a_loop_of_gotos_lasts_from_its_label_to_its_last_jump(
    text: str, loops: list[tuple[float, float]], fast: bool
) -> None:
    found = run(Source("a.mnt", text), cache=False, fast=fast).machine.log.loops
    assert [(each.since, each.until) for each in found] == [pytest.approx(loop, abs=1e-9) for loop in loops]
