"""SUSPEND and STOP of a spline near the end of a cycle."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

TABLE = "Dim c(5) As Float = 3, 10, 20, 5\nSPLINETABLE(0, c)\nSPLINETIME(0) = 200\n"
TABLE += "SPLINESUSPENDTIME(0) = {}\nSPLINE(0) = {}\nGO(0)\n"


def ran(text: str) -> Run:
    result = run(Source("a.mnt", text), until=10.0)
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
