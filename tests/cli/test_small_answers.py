"""What commands answer at the edges of their input."""

from __future__ import annotations

import io
import sys

import pytest

import motionlang
from tests.cli.programs import STROKE, Cell


def test_one_side_of_a_comparison_is_standard_input(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    cell.write("a.mnt", STROKE)
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(STROKE.encode())))
    ran = cell("diff", "-", "a.mnt", "--lang", "mint")
    assert (ran.status, ran.out) == (0, "no difference\n")


def test_a_move_of_which_only_the_slew_is_seen(cell: Cell) -> None:
    ran = cell("plan", "--distance", "100", "--speed", "1e-9", "--accel", "100")
    assert ran.status == 0
    assert "slew time    100000000000  s" in ran.out


def test_a_whole_circle_has_no_distance_of_rounding() -> None:
    circle = "CIRCLER(0, 1) = 10.1, 3.7, 1080 : GO(0, 1)"
    start = "POS(0, 1) = 3.3, 7.7 : SPEED(0) = 50 : ACCEL(0) = 500 : DECEL(0) = 500"
    ran = motionlang.run(motionlang.Source("a.mnt", f"{start}\n{circle}\nPAUSE IDLE(0) And IDLE(1)\n"))
    assert [each.distance for each in ran.moves] == [0.0, 0.0]


def test_a_hint_lists_the_limits_of_an_axis(cell: Cell) -> None:
    cell.write("a.mnt", STROKE)
    cell.write("a.machine.toml", "axis.0.limits.accel = 5\n")
    ran = cell("run", "a.mnt")
    for name in ("position", "speed", "acceleration", "torque", "following_error"):
        assert f"axis.N.limits.{name}" in ran.err


def test_a_long_trace_says_how_large_it_becomes(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("motionlang.commands.trace.command.LARGE", 1000.0)
    cell.write("a.mnt", STROKE)
    assert cell("trace", "a.mnt", "a.csv", "-q", "--rate", "100").err == "note: 72 rows, some 0 MB\n"


def test_a_machine_of_nested_tables() -> None:
    source = motionlang.Source("a.mnt", STROKE)
    nested = {"controller": {"instruction_time": 1e-3}, "axis": {0: {"limits": {"speed": 100.0}}}}
    plain = {"controller.instruction_time": 1e-3, "axis.0.limits.speed": 100.0}
    assert motionlang.run(source, machine=nested).report == motionlang.run(source, machine=plain).report
