"""The report as data: what programs that read it can rely on."""

from __future__ import annotations

import json
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.kernel import Diagnostic, Run, Source, report, run
from motionlang.kernel.log import Event
from motionlang.kernel.report import SCHEMA, _axis, build, failure, moves, text
from tests.views.runs import ballscrew, ended, new_run, pick, shift


def test_the_ballscrew_exercise_field_by_field() -> None:
    assert build(ballscrew()) == {
        "schema": "motionlang.report/3",
        "program": "ballscrew.mnt",
        "dialect": "mint",
        "status": "ended",
        "time": 1.00005,
        "output": [],
        "moves": [
            {
                "axis": 0,
                "command": "MOVER",
                "line": 5,
                "profile": "trapezoid",
                "start_time": 5e-05,
                "duration": 1.0,
                "start": 0.0,
                "end": 200.0,
                "distance": 200.0,
                "peak_speed": 250.0,
                "commanded_speed": 250.0,
                "phases": [
                    {"name": "accel", "duration": 0.2, "distance": 25.0},
                    {"name": "slew", "duration": pytest.approx(0.6, rel=1e-15), "distance": 150.0},
                    {"name": "decel", "duration": 0.2, "distance": 25.0},
                ],
            }
        ],
        "printed": [],
        "switched": [],
        "analogue_outputs": [],
        "written": [],
        "events": [],
        "axes": [
            {
                "axis": 0,
                "position": 200.0,
                "counts": 240000.0,
                "scale": 1200.0,
                "enabled": True,
                "error": 0,
                "feedback": "demand",
            }
        ],
        "diagnostics": [],
        "notes": [],
        "cycle": None,
        "assumptions": ["mint.statement-time"],
    }


@pytest.mark.parametrize("make", [ballscrew, pick, shift])
def test_the_text_reads_back_as_the_same_data(make: Callable[[], Run]) -> None:
    run = make()
    assert json.loads(text(run)) == build(run)


def test_a_move_is_a_line() -> None:
    assert [line[:11] for line in text(shift(7)).splitlines() if line.startswith("  ")] == [
        '  {"axis": 0'[:11]
    ] * 7


def test_what_was_cut_short_says_so() -> None:
    moves = build(pick())["moves"]
    assert isinstance(moves, list)
    assert [(m["command"], m["axis"], m.get("ended")) for m in moves] == [
        ("MOVER", 0, None),
        ("MOVER", 1, None),
        ("MOVER", 2, "stop"),
        ("MOVEA", 0, None),
        ("JOG", 1, "end-of-run"),
    ]
    stopped, jog = moves[2], moves[4]
    assert [phase["name"] for phase in stopped["phases"]] == ["accel", "slew", "stop"]
    assert jog["duration"] == pytest.approx(1.4)
    assert jog["end"] == pytest.approx(jog["start"] + jog["distance"])
    assert jog["peak_speed"] == pytest.approx(50_000 / 1200)


def test_a_phase_that_does_not_occur_is_left_out() -> None:
    run, controller = new_run()
    controller.move_by(0, 100.0, "MOVER", 1)  # too short for a slew
    controller.clock.advance(1.0)
    controller.move_by(0, 0.0, "MOVER", 2)  # without any distance
    controller.clock.advance(2.0)
    moves = build(ended(run))["moves"]
    assert isinstance(moves, list)
    assert [[phase["name"] for phase in move["phases"]] for move in moves] == [["accel", "decel"], []]
    assert moves[1]["duration"] == 0.0


def test_a_move_keeps_the_scale_it_was_made_in() -> None:
    run, controller = new_run()
    controller.set_scale(0, 10.0, zero=50.0)
    controller.move_by(0, 1000.0, "MR", 1)
    controller.clock.advance(5.0)
    controller.set_scale(0, -2.0)
    report = build(ended(run))
    moves, axes = report["moves"], report["axes"]
    assert isinstance(moves, list)
    assert isinstance(axes, list)
    assert (moves[0]["start"], moves[0]["end"], moves[0]["distance"]) == (-5.0, 95.0, 100.0)
    assert axes[0]["position"] == -500.0


def test_only_axes_that_the_program_touched_are_listed() -> None:
    run, controller = new_run(axes=8)
    controller.set_scale(3, 100.0)
    controller.define_position(5, 70.0)
    axes = build(ended(run))["axes"]
    assert isinstance(axes, list)
    assert [axis["axis"] for axis in axes] == [3, 5]


def test_no_figure_is_ever_nan_or_infinite() -> None:
    run, controller = new_run()
    controller.set_scale(0, 1e-306)
    controller.move_by(0, 1e6, "MOVER", 1)
    controller.clock.advance(100.0)
    document = text(ended(run))
    assert json.loads(document, parse_constant=pytest.fail)["moves"][0]["distance"] is None


def test_a_run_that_never_began() -> None:
    document = json.loads(
        failure("pick.mnt", "", [Diagnostic("file", "pick.mnt cannot be read: no such file")])
    )
    assert (document["schema"], document["status"], document["moves"]) == (SCHEMA, "fault", [])
    assert document["diagnostics"][0]["code"] == "file"
    assert (document["program"], document["dialect"], document["time"]) == ("pick.mnt", "", 0.0)
    assert [document[name] for name in ("output", "events", "axes", "notes", "assumptions")] == [[]] * 5
    assert document.keys() == build(ballscrew()).keys()


def test_the_document_is_plain_ascii() -> None:
    run, _ = new_run("Grüße.mnt")
    run.machine.terminal.write("µ\ud800\x1b\n")
    assert text(ended(run)).isascii()
    assert json.loads(text(run))["output"] == ["µ\ud800\x1b"]


CUT = "MOVER(0) = 1 : GO(0)\nMOVER(0) = 2 : MOVER(0) = 3 : CANCEL(0)\nWAIT = 5\n"


def test_a_report_has_dropped_moves_and_events() -> None:
    """CANCEL comes 30 µs after GO: at 100 000 uu/s² the axis has 3 uu/s then."""
    report = build(run(Source("a.mnt", CUT)))
    assert report["dropped"] == [{"axis": 0, "command": "MOVER", "line": 2, "reason": "cancel"}] * 2
    peak = {"time": pytest.approx(4e-5), "axis": 0, "value": pytest.approx(3.0), "line": 2, "commanded_by": 1}
    dropped = {
        "time": peak["time"],
        "kind": "dropped",
        "axis": 0,
        "line": 2,
        "commanded_by": 2,
        "text": "MOVER",
    }
    assert report["events"] == [
        peak | {"kind": "cancel"},
        dropped,
        dropped,
        peak | {"kind": "velocity jump", "limit": 0.0, "text": "cancel, an infinite acceleration"},
    ]


def test_an_empty_list_is_one_line() -> None:
    document = text(run(Source("a.mnt", "PRINT 1\n")))
    for name in ("moves", "switched", "analogue_outputs", "written", "events", "axes"):
        assert f'\n "{name}": [],\n' in document


def test_an_event_has_the_line_of_its_offset() -> None:
    """The second PRINT is behind a line of 8 characters."""
    result = run(Source("a.mnt", "PRINT 1\nPRINT 2\n"))
    for at in (0, 8, -1):
        result.machine.log.events.add(Event(0.5, "wait", None, None, None, at, 0, ""))
    result.machine.log.events.add(Event(0.5, "wait", 0, 0.0, 0.0, 8, 2, "why"))
    rows = [{"time": 0.5, "kind": "wait", "line": line} for line in (1, 2, 0)]
    more: dict[str, object] = {"axis": 0, "value": 0.0, "limit": 0.0, "commanded_by": 2, "text": "why"}
    assert build(result)["events"] == [*rows, rows[1] | more]


@pytest.mark.parametrize("at_once", [1, 3, 7, 1000])
@pytest.mark.parametrize("make", [lambda: shift(7), lambda: run(Source("a.mnt", CUT))])
def test_a_document_is_the_same_in_any_chunks(
    make: Callable[[], Run], at_once: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each move is the line of its row."""
    document = text(make())
    monkeypatch.setattr(report, "AT_ONCE", at_once)
    assert text(make()) == document
    assert ",\n  ".join(map(json.dumps, build(make())["moves"])) in document
    assert "assumptions" not in json.loads(text(make(), whole=False))


SIMILAR_MOVES = """
Dim n As Integer
SCALEFACTOR(1) = 3 : SPEED(0, 1) = 20, 35
For n = 1 To 6
  MOVER(0) = 2 : MOVEA(1) = -1 * n * (n Mod 2) : GO(0, 1)
  If n = 3 Then PRINT POS(0)
  If n = 4 Then PROFILEMODE(0) = 1
  If n = 5 Then WAIT(40) : STOP(0)
  PAUSE IDLE(0) And IDLE(1)
  MOVEA(0) = 0 : GO(0)
  PAUSE IDLE(0)
Next
MOVEA(1) = -0.0 : GO(1)
PAUSE IDLE(1)
MOVER(1) = 5 : JOG(0) = 3 : GO(1)
WAIT(20)
End
"""


def test_lines_of_similar_moves_are_those_of_each() -> None:
    result = run(Source("a.mnt", SIMILAR_MOVES), until=30.0)
    lines = [json.dumps(row) for row in build(result)["moves"]]
    assert len(lines) > 12
    written = text(result)
    assert all(line in written for line in lines)
    assert written.count('"start_time"') == len(lines)
    assert json.loads(written)["moves"] == [json.loads(line) for line in lines]


MOTOR = "SERVOC(0) = 1\n"


@pytest.mark.parametrize("in_full", [0, 3, 1000])
def test_a_brief_row_is_a_subset_of_the_full_one(in_full: int) -> None:
    result = run(Source("a.mnt", SIMILAR_MOVES), until=30.0)
    whole, brief = list(moves(result)), list(moves(result, in_full))
    assert [len(row) == 6 for row in brief] == [number >= in_full for number in range(len(whole))]
    assert all(row.items() >= short.items() for row, short in zip(whole, brief, strict=True))


def test_rows_of_moves_of_a_motor_are_whole() -> None:
    text = "SCALEFACTOR(0, 1) = 100, 100\nMOVER(0, 1) = 5, 7 : GO(0, 1)\nPAUSE IDLE(0) And IDLE(1)\nEnd"
    result = run(Source("a.mnt", text), machine={"axis.0.plant.load_inertia": 4e-5})
    of_motor, other = moves(result, 0)
    assert (of_motor, "motor" in of_motor) == (next(moves(result)), True)
    assert set(other) == {"axis", "command", "line", "duration", "distance", "peak_speed"}


@pytest.mark.parametrize(
    ("counts", "output", "chosen", "row"),
    [
        (200.0, 1.5, None, {"following_error": 0.25, "output": 1.5, "gains": "not needed"}),
        (-200.0, -1.5, "suggested", {"following_error": 0.25, "output": -1.5, "gains": "suggested"}),
        (0.0, -0.0, "program", {"following_error": 50.0, "output": 0.0, "gains": "program"}),
    ],
)
def test_an_axis_with_a_motor_has_its_error_in_user_units(
    counts: float, output: float, chosen: str | None, row: dict[str, object]
) -> None:
    """The error is 50 counts; without a scale they are user units."""
    motor = SimpleNamespace(
        position=600.0,
        error=50.0,
        output=output,
        chosen=None if chosen is None else SimpleNamespace(gains=chosen),
    )
    scale = SimpleNamespace(counts=counts, wrap=0.0, position_to_user=lambda position: position / 200.0)
    axis: Any = SimpleNamespace(index=3, scale=scale, enabled=True, faults=4, feedback=motor)
    assert json.dumps(_axis(axis, 0.0)["motor"]) == json.dumps(row)
    assert [_axis(axis, 0.0)[name] for name in ("axis", "position", "counts", "error", "feedback")] == [
        3, 3.0, 600.0, 4, "simulated motor"]  # fmt: skip
