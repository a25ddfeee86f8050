"""Paths end at their coordinates, in user units, after positions were set.

Axis 0 is at 5, axis 1 at -7 and axis 2 at 2 when a path begins; a unit of axis 0 has 4 counts.
"""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source

SET = """\
SCALEFACTOR(0) = 4 : SCALEFACTOR(1) = 4
SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000 : SPEED(2) = 1000 : ACCEL(2) = 10000 : DECEL(2) = 10000
POS(0) = 5 : POS(1) = -7 : POS(2) = 2
"""


@pytest.mark.parametrize(
    ("path", "ends"),
    [
        ("VECTORR(0, 1) = 30, 40", (35.0, 33.0, 2.0)),
        ("VECTORA(0, 1) = 30, 40", (30.0, 40.0, 2.0)),
        ("VECTORA(0, 1, 2) = 30, 40, 10", (30.0, 40.0, 10.0)),
        ("CIRCLER(0, 1) = 10, 0, 180", (25.0, -7.0, 2.0)),  # round (15, -7)
        ("CIRCLEA(0, 1) = 5, 3, 90", (15.0, 3.0, 2.0)),  # from 10 below (5, 3), counter-clockwise
        ("CIRCLEA(0, 1) = 5, 3, -90", (-5.0, 3.0, 2.0)),
        ("HELIXR(0, 1, 2) = 10, 0, 180, 30", (25.0, -7.0, 32.0)),
        ("HELIXA(0, 1, 2) = 5, 3, 90, 30", (15.0, 3.0, 30.0)),
        # The second path begins where the first one ends.
        ("VECTORR(0, 1) = 30, 40 : GO(0) : PAUSE IDLE(0)\nVECTORA(0, 1) = 30, 40", (30.0, 40.0, 2.0)),
        ("VECTORR(0, 1) = 30, 40 : GO(0) : PAUSE IDLE(0)\nVECTORR(0, 1) = -5, 7", (30.0, 40.0, 2.0)),
    ],
)
def test_a_path_ends_at_its_coordinates(path: str, ends: tuple[float, ...]) -> None:
    text = f'{SET}{path}\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0), " ", POS(1), " ", POS(2)\n'
    result = run(Source("paths.mnt", text), cache=False)
    assert [each.message for each in result.diagnostics] == []
    found = [float(each) for each in result.output[0].split()]
    assert found == pytest.approx(ends, abs=1e-4)


@pytest.mark.parametrize(
    ("path", "end"),
    [
        ("VECTORA(0, 1) = 100, 0", 820.0),  # in the wrap from 720 on
        ("VECTORA(0, 1) = 0, 10", 720.0),
        ("VECTORR(0, 1) = 100, 0", 900.0),
        ("MOVEA(0) = 100", 820.0),
        ("CIRCLEA(0, 1) = 80, 10, 90", 810.0),  # the centre is 10 above the axis, at 800
        ("CIRCLEA(0, 1) = 70, 0, 180", 780.0),  # 10 below it, at 790
        ("CIRCLER(0, 1) = -10, 0, 180", 780.0),
        ("HELIXA(0, 1, 2) = 80, 10, 90, 5", 810.0),
    ],
)
def test_an_absolute_path_of_an_axis_that_wraps_stays_in_the_wrap_where_it_begins(
    path: str, end: float
) -> None:
    """Axis 0 wraps at 360 and is at 800, which it shows as 80."""
    set_up = (
        "SPEED(0) = 1000 : ACCEL(0) = 10000 : DECEL(0) = 10000\nPOSWRAP(0) = 360\nMOVER(0) = 800 : GO(0)\n"
    )
    text = f"{set_up}PAUSE IDLE(0)\nPRINT POS(0)\n{path}\nGO(0)\nPAUSE IDLE(0)\n"
    result = run(Source("wraps.mnt", text), cache=False)
    assert [each.message for each in result.diagnostics] == []
    assert result.output == ["80.0000"]
    assert result.controller.axes[0].position(result.time) == pytest.approx(end)


def test_arcs_turn_clockwise_where_the_machine_file_says_so() -> None:
    """From 10 below (5, 3), by 90° to the left of the centre."""
    text = f'{SET}CIRCLEA(0, 1) = 5, 3, 90\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0), " ", POS(1)\n'
    machine = {"assumptions.mint.circle-sense": "clockwise"}
    assert run(Source("paths.mnt", text), machine=machine, cache=False).output == ["-5.0000 3.0000"]
