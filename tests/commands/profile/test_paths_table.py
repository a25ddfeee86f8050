"""The table of paths: lengths and speeds by hand, corners, and transitions."""

from __future__ import annotations

from math import pi

import pytest

from motionlang.commands.profile.paths import PathRow, paths
from motionlang.commands.profile.paths_view import at_its_end, paths_table
from motionlang.kernel import Source, run

SETUP = "SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500 : MOVEBUFFERSIZE(0) = 10 : MOVEBUFFERSIZE(1) = 10\n"


def rows_of(text: str) -> list[PathRow]:
    made = run(Source("paths.mnt", SETUP + text))
    assert made.diagnostics == []
    return paths(made.trace)


def test_a_line_and_an_arc_that_are_run_through() -> None:
    """A line of 30 and an arc of 5 pi at 50 uu/s with 500 uu/s²: two ramps of 0.1 s.

    Each ramp is 2.5 long.
    """
    line, arc = rows_of(
        "CONTOURMODE(0) = 1\nVECTORR(0, 1) = 30, 0\nCIRCLER(0, 1) = 0, 10, 90\nGO(0)\nPAUSE IDLE(0)\n"
    )
    assert (line.line, line.command, line.axes) == (3, "VECTORR", (0, 1))
    assert (line.length, line.entry_speed, line.peak_speed, line.exit_speed) == pytest.approx(
        (30.0, 0.0, 50.0, 50.0)
    )
    assert line.duration == pytest.approx(0.1 + 27.5 / 50)
    assert line.corner == pytest.approx(0.0, abs=0.01)
    assert at_its_end(line) == "continues"
    assert arc.length == pytest.approx(5 * pi, rel=1e-6)
    assert (arc.entry_speed, arc.exit_speed) == pytest.approx((50.0, 0.0))
    assert (arc.corner, at_its_end(arc)) == (None, "stops: no next path")


@pytest.mark.parametrize(
    ("mode", "second", "corner", "end"),
    [
        ("", "0, 40", 90.0, "stops: corner of 90.0°"),
        ("CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 10\n", "30, 30", 45.0, "stops: corner of 45.0°"),
        ("CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 60\n", "30, 30", 45.0, "continues"),
        ("", "20, 0", 0.0, "stops: the paths are not joined"),
        ("", "-20, 0", 180.0, "stops: corner of 180.0°"),
    ],
)
def test_a_corner_and_why_the_path_stops_there(mode: str, second: str, corner: float, end: str) -> None:
    first, _ = rows_of(f"{mode}VECTORR(0, 1) = 30, 0\nVECTORR(0, 1) = {second}\nGO(0)\nPAUSE IDLE(0)\n")
    assert first.corner == pytest.approx(corner, abs=0.05)
    assert at_its_end(first) == end


def test_the_corner_behind_an_arc_that_stops_is_that_of_its_tangent() -> None:
    for second, corner in (("0, 20", 0.0), ("20, 0", 90.0), ("-20, 20", 45.0)):
        arc, _ = rows_of(f"CIRCLER(0, 1) = 0, 10, 90\nVECTORR(0, 1) = {second}\nGO(0)\nPAUSE IDLE(0)\n")
        assert arc.corner == pytest.approx(corner, abs=0.1)


def test_what_cut_a_path_short_is_reported() -> None:
    (only,) = rows_of("VECTORR(0, 1) = 30, 40\nGO(0)\nWAIT(500)\nSTOP(0)\nPAUSE IDLE(0)\n")
    assert at_its_end(only) == "ended by stop"
    assert only.length < 50.0


def test_moves_of_single_axes_are_no_paths() -> None:
    assert rows_of("MOVER(0) = 10 : GO(0)\nPAUSE IDLE(0)\n") == []
    assert "no path was run" in paths_table([]).lines(100)[0]


def test_the_table() -> None:
    table = paths_table(rows_of("VECTORR(0, 1) = 30, 40\nGO(0)\nPAUSE IDLE(0)\n"))
    cells = [
        "2",
        "VECTORR",
        "0,",
        "1",
        "0.000060",
        "1.1",
        "50",
        "0.000",
        "50.000",
        "0.000",
        "stops:",
        "no",
        "next",
    ]
    assert table.lines(160)[-1].split()[: len(cells)] == cells
