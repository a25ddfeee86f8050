"""Objects of other nodes and points of captures at the limits of their ranges."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source


@pytest.mark.parametrize("address", ["0, 0", "0xFFFF, 255", "0, 255", "0xFFFF, 0"])
def test_an_object_within_the_ranges_is_stored(address: str) -> None:
    text = f"REMOTEOBJECTFLOAT(1, 2, {address}) = 2.5\nPRINT REMOTEOBJECTFLOAT(1, 2, {address})"
    assert run(Source("a.mnt", text), cache=False).output == ["2.5000"]


@pytest.mark.parametrize(("index", "sub"), [(0x10000, 0), (0, 256), (-1, 0), (0, -1)])
def test_there_is_no_object_beyond_them(index: int, sub: int) -> None:
    text = f"Dim i As Integer = {index}\nDim s As Integer = {sub}\nREMOTEOBJECTFLOAT(1, 2, i, s) = 1"
    found = run(Source("a.mnt", text), cache=False).diagnostics
    assert [each.message for each in found] == [f"there is no object {index}, {sub}"]


def test_the_points_of_a_capture_are_a_period_apart() -> None:
    """At 100 uu/s the axis covers 1 uu in 10 ms and 4 uu in 40 ms."""
    text = """\
SPEED(0) = 1000 : ACCEL(0) = 1000000 : DECEL(0) = 1000000
CAPTUREMODE(0) = 1 : CAPTUREPERIOD = 10000 : CAPTURENUMPOINTS = 5
JOG(0) = 100 : WAIT(500)
CAPTURE = 1 : PAUSE CAPTURESTATUS = 3
PRINT CAPTUREPOINT(0, 1) - CAPTUREPOINT(0, 0), " ", CAPTUREPOINT(0, 4) - CAPTUREPOINT(0, 0)
End
"""
    assert run(Source("a.mnt", text), cache=False, until=2.0).output == ["1.0000 4.0000"]
