"""SUSPEND and STOP of a spline near the end of a cycle.

The playback slows down across the seam to the next cycle.
"""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.result import Run
from motionlang.source import Source

TABLE = "Dim c(5) As Float = 3, 10, 20, 5\nSPLINETABLE(0, c)\nSPLINETIME(0) = 200\n"
TABLE += "SPLINESUSPENDTIME(0) = {}\nSPLINE(0) = {}\nGO(0)\n"


def ran(text: str) -> Run:
    result = run(Source("a.mnt", text), cache=False, until=10.0)
    assert [each.message for each in result.diagnostics] == []
    return result


def undisturbed(mode: int, time: float) -> float:
    """Return the spline's position `time` seconds after its start, with no suspend."""
    a = ran(TABLE.format(100, mode) + "WAIT = 6000\nCANCEL(0)").controller.axes[0]
    return a.position(a.starts[1] + time)


@pytest.mark.parametrize("mode", [4, 12])
@pytest.mark.parametrize("wait", [300, 540, 555, 580, 599, 600, 640, 1190])
@pytest.mark.parametrize("slowing", [100, 1500])
def test_axis_rests_at_the_position_of_half_the_suspend_time(mode: int, wait: int, slowing: int) -> None:
    """While the playback slows down, the spline's own time advances at half the rate."""
    for word in ("SUSPEND(0) = 1", "STOP(0)"):
        result = ran(
            TABLE.format(slowing, mode) + f"WAIT = {wait}\n{word}\nWAIT = 2000\nPRINT VEL(0)\nCANCEL(0)"
        )
        a = result.controller.axes[0]
        begun = next(
            start for start, profile in zip(a.starts, a.profiles, strict=True) if profile.shape != "hold"
        )
        slowed = next(
            start
            for start, profile in zip(a.starts, a.profiles, strict=True)
            if profile.shape == "suspend"
            or (start > begun and "stop" in [each.name for each in profile.phases])
        )
        time = slowed - begun + slowing / 2000.0
        assert result.controller.position(0) == pytest.approx(undisturbed(mode, time), abs=1e-6)
        assert result.output == ["0.0000"]


@pytest.mark.parametrize(("wait", "rest"), [(540, 10), (580, 170), (599, 151), (600, 150)])
def test_spline_continues_in_the_cycle_in_which_it_was_suspended(wait: int, rest: int) -> None:
    """In the ramp of 100 ms, the spline's own time advances 50 ms.

    After SUSPEND = 0, the remaining `rest` ms of the segment take 100 ms.
    """
    text = f"WAIT = {wait}\nSUSPEND(0) = 1\nWAIT = 300\nPRINT SPLINEINDEX(0)\nSUSPEND(0) = 0\nWAIT = 1000\n"
    result = ran(TABLE.format(100, 4) + text + "CANCEL(0)")
    a = result.controller.axes[0]
    suspended = next(k for k, profile in enumerate(a.profiles) if profile.shape == "suspend")
    since = a.starts[-1] - a.starts[suspended + 1]
    time = (wait + 50 + rest) / 1000.0 + since - 0.1
    assert result.controller.position(0) == pytest.approx(undisturbed(4, time), abs=1e-6)
    assert result.output == ["3" if wait < 550 else "1"]


def test_a_spline_that_ends_while_it_slows_down_has_ended() -> None:
    text = "WAIT = 560\nSUSPEND(0) = 1\nPAUSE IDLE(0)\nPRINT POS(0)\nSUSPEND(0) = 0\n"
    text += "MOVER(0) = 1\nGO(0)\nPAUSE IDLE(0)\n"
    assert ran(TABLE.format(100, 0) + text + "PRINT POS(0)").output == ["35.0000", "36.0000"]


@pytest.mark.parametrize("stop_at", [500, 900])
def test_the_rest_of_the_segment_takes_the_suspend_time(stop_at: int) -> None:
    """MN1270 p. 128: a suspended segment ends SPLINESUSPENDTIME after it is resumed.

    The segment takes 1000 ms, SPLINESUSPENDTIME is 400 ms.
    """
    text = f"""Dim c(3) As Float = 2, 10, 30
SPLINETABLE(0, c)
SPLINETIME(0) = 1000 : SPLINESUSPENDTIME(0) = 400
SPLINE(0) = 0
GO(0)
WAIT = {stop_at}
SUSPEND(0) = 1
WAIT = 1000
Dim began As Time = 0
SUSPEND(0) = 0
PAUSE POS(0) >= {10 if stop_at == 500 else 40}
PRINT began, SPLINEINDEX(0)
PAUSE IDLE(0)
PRINT began, POS(0)
"""
    # At 900 the ramp runs 100 ms of the spline's time into the second segment, which ends the spline.
    expected = ["4002", "140040.0000"] if stop_at == 500 else ["4000", "40040.0000"]
    assert ran(text).output == expected
