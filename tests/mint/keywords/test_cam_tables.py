"""Cams: where the follower is at the end of each segment of the table, by hand."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.controller.faults import Rejected
from motionlang.mint.keywords.table_motion_cams import elements, span
from motionlang.result import Run
from motionlang.source import Source

PROGRAM = """\
Dim rise(9) As Float = {table}
Dim few(3) As Float = 2, 7, 9
Dim i As Integer
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000
CAMTABLE(1, rise) : MASTERDISTANCE(1) = 10
{setup}
CAM(1) = {mode} : GO(1)
For i = 1 To {count}
  MOVER(0) = 5 : GO(0) : PAUSE IDLE(0)
  MOVER(0) = 5 : GO(0) : PAUSE IDLE(0) : PRINT POS(1) USING 1, 3
Next
CANCEL(1)
"""


def ran(setup: str, mode: int, count: int, table: str) -> Run:
    text = PROGRAM.format(setup=setup, mode=mode, count=count, table=table)
    return run(Source("a.mnt", text), machine={"controller.instruction_time": 1e-9}, cache=False, until=60.0)


# What is set before the cam, its mode, and the positions of the follower after each 10 of the master. The table is
# 1, 2, 2, 1. Mode 0 adds these up, mode 1 counts them from the start of the cycle, and mode 2 from the zero of the
# axis; 4 repeats them.
CAMS: list[tuple[str, int, list[float]]] = [
    ("", 0, [1, 3, 5, 6, 6]),
    ("", 1, [1, 2, 2, 1, 1]),
    ("", 2, [1, 2, 2, 1, 1]),
    ("", 4, [1, 3, 5, 6, 7, 9, 11, 12, 13]),
    ("", 5, [1, 2, 2, 1, 2, 3, 3, 2, 3]),
    ("", 6, [1, 2, 2, 1, 1, 2, 2, 1, 1]),
    ("POS(1) = 100", 0, [101, 103, 105, 106, 106]),
    ("POS(1) = 100", 1, [101, 102, 102, 101, 101]),
    ("POS(1) = 100", 2, [1, 2, 2, 1, 1]),
    # In mode 1 the position before the first segment is that of the start.
    ("CAMSTART(1) = 2", 0, [2, 4, 5, 5]),
    ("CAMSTART(1) = 2", 1, [1, 1, 0, 0]),
    ("CAMSTART(1) = 2", 2, [2, 2, 1, 1]),
    ("CAMEND(1) = 2", 0, [1, 3, 3, 3]),
    ("CAMSTART(1) = 4", 0, [1, 1]),
    ("CAMSTART(1) = 3 : CAMEND(1) = 3", 4, [2, 4, 6, 8]),
    # The amplitude is not for positions of the axis.
    ("CAMAMPLITUDE(1) = -2", 0, [-2, -6, -10, -12, -12]),
    ("CAMAMPLITUDE(1) = -2", 1, [-2, -4, -4, -2, -2]),
    ("CAMAMPLITUDE(1) = -2", 2, [1, 2, 2, 1, 1]),
    ("SCALEFACTOR(1) = 4", 0, [1, 3, 5, 6, 6]),
    ("SCALEFACTOR(0) = 4", 0, [1, 3, 5, 6, 6]),
    ("CAMSEGMENT(1, 0, 1, few)", 0, [7, 16, 18, 19]),
    ("CAMSEGMENT(1, 0, 3, few)", 0, [1, 3, 10, 19]),
    # 10 more for the master in the first cycle: 5 more in each of segments 2 and 3. At 20 it is at 10 of 15, and at
    # 30 at 5 of 15.
    ("CAMPHASE(1, 2, 2, 10)", 4, [1, 1 + 2 * 10 / 15, 3 + 2 * 5 / 15, 5, 6, 7]),
    # 20 more in segment 4: it takes 30.
    ("CAMPHASE(1, 4, 1, 20)", 0, [1, 3, 5, 5 + 1 / 3, 5 + 2 / 3, 6]),
]


@pytest.mark.parametrize(("setup", "mode", "positions"), CAMS)
def test_the_positions_of_the_follower(setup: str, mode: int, positions: list[float]) -> None:
    result = ran(setup, mode, len(positions), "4, 1, 2, 2, 1")
    assert [each.message for each in result.diagnostics] == []
    assert [float(line) for line in result.output] == pytest.approx(positions, abs=6e-4)


NO_CAMS = [
    ("CAMSTART(1) = 5", "CAM: the table has segments 1 to 4, not 5 to 4"),
    ("CAMSTART(1) = 3 : CAMEND(1) = 2", "CAM: the table has segments 1 to 4, not 3 to 2"),
    ("CAMEND(1) = 5", "CAM: the table has segments 1 to 4, not 1 to 5"),
    ("CAMSEGMENT(1, 0, 8, few)", "CAMSEGMENT: segments 8 to 9 do not lie in the table of 8"),
    ("CAMSEGMENT(1, 0, 0, few)", "CAMSEGMENT: segments 0 to 1 do not lie in the table of 8"),
    ("CAMSEGMENT(1, 1, 1, few)", "CAMSEGMENT: axis 1 has no table 1"),
    ("CAMSEGMENT(1, 2, 1, few)", "CAMSEGMENT: axis 1 has no table 2"),
    ("CAMSEGMENT(0, 0, 1, few)", "CAMSEGMENT: axis 0 has no table 0"),
    ("CAMPHASE(1, 4, 2, 5)", "CAM: the table has segments 1 to 4, not 4 to 5"),
    ("CAMPHASE(1, 2, 2, -20)", "CAMPHASE cannot take 20 from segments 2 to 3"),
    ("CAMTABLE(1, few, few) : CAMSTART(1) = 1 : CAMTABLE(1, rise, few)", "the table of axis 1 has 4 positions and 2"),
]  # fmt: skip


@pytest.mark.parametrize(("setup", "message"), NO_CAMS)
def test_a_cam_that_is_rejected(setup: str, message: str) -> None:
    (found,) = ran(setup, 0, 1, "4, 1, 2, 2, 1").diagnostics
    assert found.message.startswith(message)


@pytest.mark.parametrize(
    ("array", "values"),
    [
        ([0, 1, 7], [7]),
        ([0, 2, 7, 8], [7, 8]),
        ([0, 1, 7, 8], [7]),
        ([0, 2.9, 7, 8], [7, 8]),
        ([0, 0, 7], "0 segments, and the array has room for 1"),
        ([0, -1, 7], "-1 segments, and the array has room for 1"),
        ([0, 2, 7], "2 segments, and the array has room for 1"),
        ([0, 3], "3 segments, and the array has room for 0"),
        ([0], "0 segments, and the array has room for 0"),
    ],
)
def test_the_elements_of_a_table_follow_their_count(array: list[float], values: list[float] | str) -> None:
    """Arrays of Mint begin at 1: element 0 is not used."""
    if isinstance(values, list):
        assert elements(array, "CAM") == values
    else:
        with pytest.raises(Rejected) as caught:
            elements(array, "CAM")
        assert str(caught.value) == f"CAM: element 1 of the table says that it has {values}"


@pytest.mark.parametrize(
    ("first", "last", "segments"),
    [
        (1, 0, (0, 3)),
        (1, 3, (0, 3)),
        (1, 1, (0, 1)),
        (2, 2, (1, 2)),
        (3, 0, (2, 3)),
        (0, 0, None),
        (4, 0, None),
        (2, 1, None),
        (1, 4, None),
    ],
)
def test_the_segments_of_three_in_use(first: int, last: int, segments: tuple[int, int] | None) -> None:
    if segments is not None:
        assert span(first, last, 3, "CAM") == segments
    else:
        with pytest.raises(Rejected, match="the table has segments 1 to 3"):
            span(first, last, 3, "CAM")
