"""`motionlang diff`: comparison of programs, reports, golden files and variants."""

from __future__ import annotations

import json
import os

from tests.cases import cases
from tests.cli.programs import Cell

PICK = "Const rate = 1000\nSPEED(0) = 200 : ACCEL(0) = rate : DECEL(0) = rate\nMOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)\n"


def test_a_program_against_its_golden_files_another_one_and_itself(cell: Cell) -> None:
    cell.write("pick.mnt", PICK)
    cell.write("fast.mnt", PICK.replace("= 1000", "= 2000"))
    cell("verify", "pick.mnt", "--update")
    assert cell("diff", "pick.mnt").out == "no difference\n"
    ran = cell("diff", "pick.mnt", "fast.mnt")
    assert (ran.status, ran.err) == (1, "")
    assert ran.out.startswith(
        "time: 0.700050 → 0.600050 s (-0.100000 s, -14 %)\nby line: line 3 -0.100000 s\n"
        "line 3: MOVEA of axis 0, 1 move: "
    )
    assert "the motion diverges at 0.000" in ran.out
    assert cell("diff", "pick.mnt", "--set-b", "rate=2000").out == ran.out
    cell.write("pick.mnt", PICK.replace("= 1000", "= 2000"))
    assert cell("diff", "pick.mnt").out.startswith("time: 0.700050 → 0.600050 s")  # the old one comes first
    document = json.loads(cell("diff", "pick.mnt", "--format", "json").out)
    assert (document["schema"], document["equal"]) == ("motionlang/1", False)
    assert document["lines"][0]["command"] == "MOVEA"
    assert cell("diff", "pick.mnt", "--tolerance", "time=1s", "--tolerance", "speed=50%").status == 1


def test_both_runs_lie_over_one_another_in_a_page(cell: Cell) -> None:
    cell.write("pick.mnt", PICK)
    ran = cell("diff", "pick.mnt", "--set-b", "rate=2000", "--plot", "both.html")
    assert (ran.status, ran.err) == (1, "")
    assert '"against":{"program":"pick.mnt"' in (cell.folder / "both.html").read_text(encoding="utf-8")
    assert "--plot writes .html, not .png files" in cell("diff", "pick.mnt", "--plot", "both.png").err
    cell("verify", "pick.mnt", "--update")
    assert "but one side is a report" in cell("diff", "pick.mnt", "--plot", "both.html").err


def test_what_cannot_be_compared_is_reported(cell: Cell) -> None:
    cell.write("pick.mnt", PICK)
    cell.write("cut.json", '{"schema": "motionlang.report/2", "moves": [')
    cell.write("other.json", "[1]")
    cell.write("odd.txt", "x")
    move = {"axis": 0, "command": "MOVEA", "line": 1, "duration": 1.0, "distance": 2.0}
    cell.write("lost.json", json.dumps({"schema": "motionlang.report/2", "moves": [move]}))
    cell.write("wrong.machine.toml", "axes = 3\n")
    for words, status, message in (
        (("pick.mnt",), 1, "no pick.golden.json next to it"),
        (("pick.mnt", "none.mnt"), 1, "none.mnt cannot be read"),
        (("pick.mnt", "cut.json"), 1, "cut.json is not JSON"),
        (("pick.mnt", "other.json"), 1, "other.json cannot be compared with: it is not a report of a run"),
        (
            ("lost.json", "lost.json"),
            1,
            "lost.json cannot be compared with: its move 0 lacks start_time, phases",
        ),
        (("cut.json",), 2, "give B"),
        (("pick.mnt", "odd.txt"), 2, "unknown language of odd.txt"),
        (("pick.mnt", "--machine-b", "wrong.machine.toml"), 1, "there is no key axes"),
        (("pick.mnt", "--set-b", "rat=1"), 1, "did you mean rate"),
        (("pick.mnt", "pick.mnt", "--tolerance", "time=1h"), 2, "is not a tolerance such as"),
    ):
        ran = cell("diff", *words)
        assert ran.status == status, (words, ran)
        assert message in ran.err, (words, ran)


def test_a_run_against_a_recording(cell: Cell) -> None:
    cell.write(
        "pick.mnt",
        "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\nMOVEA(0) = 20 : GO(0) : PAUSE IDLE(0)\n",
    )
    assert cell("trace", "pick.mnt", "drive.csv").status == 0
    ran = cell("diff", "pick.mnt", "drive.csv", "--tolerance", "position=0.01uu")
    assert (ran.status, ran.out.splitlines()[-1]) == (0, "every residual is within its tolerance")
    ran = cell(
        "diff",
        "pick.mnt",
        "drive.csv",
        "--tolerance",
        "position=0.01uu",
        "--set-a",
        "controller.instruction_time=0.1",
    )
    assert ran.status == 0  # a common shift, which is detected
    assert cell("diff", "pick.mnt", "none.csv").status == 1
    assert cell("diff", "pick.json", "drive.csv").status == 2
    assert cell("diff", "pick.mnt", "pick.mnt", "--map", "position.0=1").status == 2


def test_two_variants_of_a_sweep(cell: Cell) -> None:
    cell.write("pick.mnt", "Const rate = 1000\nACCEL(0) = rate : MOVEA(0) = 20 : GO(0) : PAUSE IDLE(0)\n")
    cell.write("pick.sweep.toml", "[vary]\nrate = [1000, 2000, 1000]\n")
    assert cell("diff", "pick.mnt", "--variant-a", "0", "--variant-b", "2").out == "no difference\n"
    ran = cell("diff", "pick.mnt", "--variant-b", "1")
    assert (ran.status, "line 2: MOVEA of axis 0, 1 move: duration " in ran.out) == (1, True)
    ran = cell("diff", "pick.mnt", "--variant-b", "3")
    assert ran.status == 1
    assert "pick.mnt: no variant 3: pick.sweep.toml has 0 to 2\n" in ran.err
    cell.write("other.mnt", "WAIT(1)\n")
    assert "there is no other.sweep.toml next to it" in cell("diff", "other.mnt", "--variant-b", "1").err


def test_a_changed_literal_is_named(cell: Cell) -> None:
    """A line was inserted, so the literals are one line further down."""
    cell.write("old.mnt", "SPEED(0) = 100\nMOVEA(0) = 90 : GO(0)\nPAUSE POS(0) > 30\nOUT(1) = 1\n")
    cell.write("new.mnt", "' new\nSPEED(0) = 120\nMOVEA(0) = 90 : GO(0)\nPAUSE POS(0) > 40\nOUT(1) = 1\n")
    shown = cell("diff", "old.mnt", "new.mnt").out.splitlines()
    assert shown[:2] == [
        "SPEED[0]@2: 100 → 120, was SPEED[0]@1",
        "POS[0]@4: 30 → 40, was POS[0]@3",
    ]
    document = json.loads(cell("diff", "old.mnt", "--set-b", "SPEED[0]@1=50", "--format", "json").out)
    (literal,) = document["literals"]
    assert literal == {"address": "SPEED[0]@1", "old_address": None, "old": "100", "new": "50"}
    assert json.loads(cell("diff", "old.mnt", "old.mnt", "--format", "json").out)["literals"] == []


def test_programs_are_compared_in_each_scenario_of_the_first(cell: Cell) -> None:
    cell.write("old.mnt", 'PAUSE INX(1)\nIf INX(2) Then PRINT "two"\n')
    cell.write("new.mnt", 'PAUSE INX(1)\nIf INX(2) Then PRINT "2"\n')
    for folder in ("old", "new"):
        cell.write(f"{folder}.machine.toml", "[[input]]\nchannel = 1\nat = 0.5\n")
    (cell.folder / "old.scenarios").mkdir()
    cell.write("old.scenarios/second.toml", "[[input]]\nchannel = 2\nat = 0.0\n[[expect]]\nprints = 'two'\n")
    ran = cell("diff", "old.mnt", "new.mnt", "--scenarios")
    scenario = os.path.join("old.scenarios", "second.toml")
    assert (ran.status, ran.out) == (
        1,
        f"old.mnt: no difference\n{scenario}:\nmissing: printed line 1, 'two'\nnew: printed line 1, '2'\n",
    )
    assert cell("diff", "old.mnt", "old.mnt", "--scenarios").status == 0
    rows = json.loads(cell("diff", "old.mnt", "new.mnt", "--scenarios", "--format", "json").out)["worlds"]
    assert [(row["world"], row["same"]) for row in rows] == [("old.mnt", True), (scenario, False)]


@cases("options", [["old.mnt"], ["old.mnt", "old.mnt", "--plot", "a.html"], ["old.mnt", "old.json"]])
def test_scenarios_need_two_programs_and_their_differences_only(options: list[str], cell: Cell) -> None:
    cell.write("old.mnt", "PRINT 1\n")
    ran = cell("diff", *options, "--scenarios")
    assert (ran.status, "--scenarios" in ran.err) == (2, True)


def test_a_wrong_scenario_is_reported(cell: Cell) -> None:
    cell.write("old.mnt", "PRINT 1\n")
    (cell.folder / "old.scenarios").mkdir()
    cell.write("old.scenarios/wrong.toml", "nothing = 1\n")
    ran = cell("diff", "old.mnt", "old.mnt", "--scenarios")
    assert ran.status == 1
    assert "error[machine-file]" in ran.err
