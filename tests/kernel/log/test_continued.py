"""A move that is changed very often continues as another entry of the log."""

from __future__ import annotations

from itertools import pairwise

import pytest

from motionlang import run
from motionlang.kernel import Source

PROGRAM = """Dim k As Integer
SPEED(0) = 20 : ACCEL(0) = 100 : DECEL(0) = 100
VECTORR(0, 1) = 30, 40 : GO(0)
WAIT = 300
While Not IDLE(0)
  k = k + 1
  MAXSPEED(0) = 100 + k Mod 2
  WAIT = 1
End While
"""


@pytest.mark.slow
def test_a_path_that_is_changed_often_is_several_entries_on_each_axis() -> None:
    """50 at speed 20 with rates of 100 takes 50/20 + 20/100 s, without a gap between the entries."""
    log = run(Source("found.mnt", PROGRAM)).controller.log.moves
    for axis in (0, 1):
        entries = [each for each in log if each.axis == axis]
        assert [each.ended for each in entries] == ["continued"] * (len(entries) - 1) + [""]
        ends = [each.start_time + each.profile.duration for each in entries if each.profile is not None]
        for end, (_, following) in zip(ends, pairwise(entries), strict=False):
            assert following.start_time == pytest.approx(end)
        assert ends[-1] == pytest.approx(2.7, abs=1e-3)
