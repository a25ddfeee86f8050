"""Waits see that CAMINDEX, CAMPHASESTATUS and SPLINEINDEX change without an event."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source

# The master reaches 10 uu/s in 0.01 s and 0.05 uu: it is at 10 uu after 1.005 s, and at 20 uu after 2.005 s.
CAM = """Dim s(4) = 3, 20, 20, -40
Dim m(4) = 3, 10, 10, 10
SPEED(0) = 10 : ACCEL(0) = 1000 : DECEL(0) = 1000
CAMTABLE(1, s, m)
CAM(1) = {}
GO(1)
JOG(0) = 10
TIME = 0
"""
SPLINE = """Dim p(4) = 3, 10, 20, 5
SPLINETABLE(0, p)
SPLINETIME(0) = 1000
SPLINE(0) = {}
GO(0)
TIME = 0
"""
WAITS = (
    "PAUSE {0}(1) = 2\nPRINT TIME\nPAUSE {0}(1) = 3\nPRINT TIME\n",
    "While {0}(1) <> 2\nEnd While\nPRINT TIME\nWhile {0}(1) < 3\nEnd While\nPRINT TIME\n",
    "While {0}(1) = 1\nWAIT(1)\nEnd While\nPRINT TIME\nWhile {0}(1) = 2\nWAIT(1)\nEnd While\nPRINT TIME\n",
)


@pytest.mark.parametrize("wait", WAITS)
@pytest.mark.parametrize("mode", [0, 4])
def test_waits_see_the_segment_of_a_cam(wait: str, mode: int) -> None:
    text = CAM.format(mode) + wait.format("CAMINDEX") + "CANCELALL"
    assert seen(text) == pytest.approx([1005, 2005], abs=2)


@pytest.mark.parametrize("wait", WAITS)
@pytest.mark.parametrize("mode", [0, 4])
def test_waits_see_the_segment_of_a_spline(wait: str, mode: int) -> None:
    text = SPLINE.format(mode) + wait.format("SPLINEINDEX").replace("(1) ", "(0) ") + "CANCELALL"
    assert seen(text) == pytest.approx([1000, 2000], abs=2)


def test_wait_for_a_segment_that_a_master_at_rest_never_reaches() -> None:
    """The master rests exactly at the boundary of two segments."""
    text = CAM.format(0).replace("JOG(0) = 10", "MOVER(0) = 10 : GO(0)") + "PAUSE CAMINDEX(1) = 3"
    result = run(Source("a.mnt", text), cache=False)
    assert [each.code for each in result.diagnostics] == ["never"]


def test_pause_sees_the_end_of_a_phase_in_its_cycle() -> None:
    """The phase spans two of the three segments of the second cycle, 30 to 50 uu."""
    text = CAM.format(4) + "CAMPHASE(1, 1, 2, 0)\nPAUSE CAMPHASESTATUS(1) = 0\nPRINT TIME\nCANCELALL"
    assert seen(text) == pytest.approx([5005], abs=2)


def seen(text: str) -> list[int]:
    result = run(Source("a.mnt", text), cache=False, until=20.0)
    assert [each.message for each in result.diagnostics] == []
    return [int(line) for line in result.output]
