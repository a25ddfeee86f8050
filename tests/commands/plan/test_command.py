"""`motionlang plan`: the missing figures of a move, and a program for it."""

from __future__ import annotations

import json
from typing import Any

import pytest

from motionlang.kernel import Source, run
from motionlang.kernel.report import moves
from tests.cli.programs import Cell

LINES = [
    ("--distance", "20", "--time", "0.6", "--rule", "third"),
    ("--distance", "20", "--time", "0.6", "--rule", "quarter", "--scale", "1200"),
    ("--distance", "200", "--speed", "250", "--accel", "1250", "--scale", "1200"),
    ("--distance", "12", "--speed", "8", "--accel-time", "0.5"),
    ("--distance", "-40", "--speed", "50", "--accel", "250", "--decel", "125"),
    ("--distance", "0.0001", "--time", "0.6", "--rule", "third", "--scale", "4e6"),
]


def figures(document: dict[str, Any]) -> dict[str, float]:
    """Return the figures of the move, by name."""
    return {row["figure"]: row["value"] for row in document["move"]}


def programs(document: dict[str, Any]) -> dict[str, str]:
    return {row["dialect"]: row["program"] for row in document["programs"]}


@pytest.mark.parametrize("line", LINES, ids=" ".join)
@pytest.mark.parametrize("by_times", [False, True])
def test_the_programs_make_the_move_that_was_planned(
    cell: Cell, line: tuple[str, ...], by_times: bool
) -> None:
    document = json.loads(cell("plan", *line, "--format", "json", *(["--use-times"] if by_times else [])).out)
    plan = figures(document)
    assert programs(document).keys() == {"mint", "mccl"}
    for name, program in programs(document).items():
        ran = run(Source(f"plan.{name}", program), dialect=name)
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
    note = "  note: without a scale MCCL accepts only whole counts; give --scale\n"
    quarter = ("plan", "--distance", "20", "--time", "0.6", "--rule", "quarter")
    assert cell(*quarter).out.endswith(note)
    assert note not in cell(*quarter, "--scale", "1200").out
    assert note not in cell("plan", "--distance", "20", "--time", "0.6", "--rule", "third").out


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
        (("--distance", "1", "--axis", "0", "--lang", "mccl"), "no such axis"),
        (("--distance", "far"), "argument --distance: 'far' is not a number"),
    ],
)
def test_figures_that_make_no_move(cell: Cell, line: tuple[str, ...], message: str) -> None:
    ran = cell("plan", *line)
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.startswith(f"motionlang plan: error: {message}")


def test_ramp_times_of_a_move_too_short_are_those_to_the_commanded_speed(cell: Cell) -> None:
    line = (
        "--distance -10 --speed 300 --accel-time 0.15 --decel-time 0.3 --use-times --lang mint --format json"
    )
    document = json.loads(cell("plan", *line.split()).out)
    assert "ACCELTIME(0) = 150\nDECELTIME(0) = 300\nMOVER(0) = -10" in programs(document)["mint"]
    ran = run(Source("plan.mnt", programs(document)["mint"]))
    (move,) = moves(ran)
    assert move["peak_speed"] == pytest.approx(figures(document)["speed"])
    assert float(str(move["peak_speed"])) < 300


@pytest.mark.parametrize(
    ("machine", "scale", "how"),
    [
        ("--encoder-lines 1000 --degrees", 4000 / 360, "1000 lines · 4 / 360 = 11.11111111 counts/uu"),
        ("--resolution 0.001", 1000, "1/0.001 = 1000 counts/uu"),
        ("--encoder-lines 1000 --gear 3:1 --pitch 10", 1200, "1000 lines · 4 · 3 / 10 = 1200 counts/uu"),
        ("--encoder-lines 500 --quadrature 1 --pitch 2", 250, "500 lines · 1 / 2 = 250 counts/uu"),
    ],
)
def test_counts_per_unit_from_what_the_machine_is_built_of(
    cell: Cell, machine: str, scale: float, how: str
) -> None:
    line = ("plan", *machine.split(), "--distance", "200", "--time", "1", "--rule", "third")
    document = json.loads(cell(*line, "--format", "json").out)
    assert document["scale"] == pytest.approx(scale, rel=1e-12)
    assert document["notes"] == [f"scale: {how}"]
    assert f"SCALE(0) = {scale:.10g}\n" in cell(*line).out


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("--encoder-lines 1000", "--encoder-lines needs either --pitch or --degrees"),
        ("--encoder-lines 1000 --pitch 10 --degrees", "--encoder-lines needs either --pitch or --degrees"),
        ("--gear 3", "--gear needs --encoder-lines"),
        ("--degrees", "--degrees needs --encoder-lines"),
        ("--scale 3 --resolution 1", "--scale and --resolution both set the scale"),
        ("--resolution 0", "resolution must be greater than zero"),
        ("--encoder-lines 1000 --pitch nan", "per turn must be greater than zero"),
        (
            "--encoder-lines 1000 --pitch 1 --gear 3:0",
            "argument --gear: '3:0' is not a ratio such as 3 or 7:2",
        ),
        ("--encoder-lines 1000 --pitch 1 --quadrature 3", "a line gives 1, 2 or 4 counts, not 3"),
    ],
)
def test_a_machine_that_gives_no_scale(cell: Cell, line: str, message: str) -> None:
    ran = cell("plan", "--distance", "1", "--time", "1", *line.split())
    assert (ran.status, ran.out) == (2, "")
    assert ran.err.startswith(f"motionlang plan: error: {message}")


def test_too_few_figures_have_a_hint_that_works(cell: Cell) -> None:
    hint = "  hint: give distance, speed and accel, or distance and time with a --rule\n"
    assert hint in cell("plan", "--distance", "3").err
    assert cell("plan", "--distance", "3", "--speed", "1", "--accel", "2").status == 0
    assert cell("plan", "--distance", "3", "--time", "1", "--rule", "third").status == 0
