"""`motionlang plan`: the missing figures of a move, and a program that makes it."""

from __future__ import annotations

import json

import pytest

from motionlang.execution import run
from motionlang.source import Source
from tests.cli.programs import Cell

THIRD = """\
figure      value
───────────────────────────────
distance       20  uu     given
time          0.6  s      given
accel time    0.2  s
slew time     0.2  s
decel time    0.2  s
speed          50  uu/s
accel         250  uu/s²
decel         250  uu/s²

Mint
  SPEED(0) = 50
  ACCEL(0) = 250
  DECEL(0) = 250
  MOVER(0) = 20
  GO(0)

MCCL
  1MN,1PM,1PT
  1SV50,1SA250,1DS250
  1MR20,1WS0
"""

LINES = [
    ("--distance", "20", "--time", "0.6", "--rule", "third"),
    ("--distance", "20", "--time", "0.6", "--rule", "quarter", "--scale", "1200"),
    ("--distance", "200", "--speed", "250", "--accel", "1250", "--scale", "1200"),
    ("--distance", "12", "--speed", "8", "--accel-time", "0.5"),
    ("--distance", "-40", "--speed", "50", "--accel", "250", "--decel", "125"),
    ("--distance", "0.0001", "--time", "0.6", "--rule", "third", "--scale", "4e6"),
]


def test_the_third_rule(cell: Cell) -> None:
    assert cell("plan", "--distance", "20", "--time", "0.6", "--rule", "third").out == THIRD


@pytest.mark.parametrize("line", LINES, ids=" ".join)
@pytest.mark.parametrize("by_times", [False, True])
def test_the_programs_make_the_move_that_was_planned(
    cell: Cell, line: tuple[str, ...], by_times: bool
) -> None:
    document = json.loads(cell("plan", *line, "--json", *(["--by-times"] if by_times else [])).out)
    plan = document["move"]
    assert document["programs"].keys() == {"mint", "mccl"}
    for name, program in document["programs"].items():
        ran = run(Source(f"plan.{name}", program), dialect=name, cache=False)
        assert not ran.diagnostics
        moves = ran.report["moves"]
        assert isinstance(moves, list)
        (move,) = moves
        assert move["distance"] == pytest.approx(plan["distance"], rel=1e-9)
        assert move["duration"] == pytest.approx(plan["time"], rel=1e-8)
        assert move["peak_speed"] == pytest.approx(plan["speed"], rel=1e-8)
        durations = [phase["duration"] for phase in move["phases"]]
        assert durations == pytest.approx(
            [plan["accel_time"], plan["slew_time"], plan["decel_time"]], rel=1e-8
        )


def test_mccl_without_a_scale_knows_whole_counts_only(cell: Cell) -> None:
    note = "  note: without a scale MCCL takes whole counts only; give --scale\n"
    quarter = ("plan", "--distance", "20", "--time", "0.6", "--rule", "quarter")
    assert cell(*quarter).out.endswith(note)
    assert note not in cell(*quarter, "--scale", "1200").out
    assert note not in cell("plan", "--distance", "20", "--time", "0.6", "--rule", "third").out


def test_what_was_assumed_is_said(cell: Cell) -> None:
    out = cell("plan", "--distance", "20", "--speed", "50", "--accel", "250").out
    assert "decel         250  uu/s²  assumed\n" in out
    assert "accel         250  uu/s²  given\n" in out


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (("--distance", "3"), "not enough is known"),
        (("--distance", "20", "--time", "0.6", "--speed", "5", "--rule", "equal"), "contradiction"),
        (("--distance", "1", "--scale", "0"), "--scale must be a number of counts from 1e-06 to 1e+12"),
        (("--distance", "nan", "--time", "1"), "distance is not a number"),
        (("--distance", "1e308", "--time", "1"), "distance must be less than 1e+300"),
        (
            ("--distance", "1e299", "--time", "1e-299", "--rule", "third"),
            "no number is large enough for the speed",
        ),
        (("--distance", "1", "--slew-time", "-1"), "slew time must be zero or more"),
        (("--distance", "1", "--axis", "0", "--dialect", "mccl"), "there is no such axis"),
        (("--distance", "far"), "argument --distance: invalid float value: 'far'"),
    ],
)
def test_figures_that_make_no_move(cell: Cell, line: tuple[str, ...], message: str) -> None:
    ran = cell("plan", *line)
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.startswith(f"motionlang plan: error: {message}")
