"""`motionlang diff`: comparison of programs, values, machines and scenarios."""

from __future__ import annotations

import json
import os

import pytest

from tests.cases import cases
from tests.cli.programs import Cell

PICK = """\
Const rate = 1000
SPEED(0) = 200 : ACCEL(0) = rate : DECEL(0) = rate
MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)
OUTX(1) = 1
PRINT "a"
"""


def test_both_runs_lie_over_one_another_in_a_page(cell: Cell) -> None:
    cell.write("pick.mnt", PICK)
    ran = cell("diff", "pick.mnt", "--set-b", "rate=2000", "--plot", "both.html")
    assert (ran.status, ran.err) == (1, "")
    assert '"against":{"program":"pick.mnt"' in (cell.folder / "both.html").read_text(encoding="utf-8")
    assert "--plot writes .html, not .png files" in cell("diff", "pick.mnt", "--plot", "both.png").err


def test_what_cannot_be_compared_is_reported(cell: Cell) -> None:
    cell.write("pick.mnt", PICK)
    cell.write("odd.txt", "x")
    cell.write("wrong.machine.toml", "axes = 3\n")
    for words, status, message in (
        (("pick.mnt",), 2, "motionlang verify pick.mnt compares a program with its golden files"),
        (("pick.mnt", "pick.json"), 2, "give two programs"),
        (("pick.mnt", "drive.csv"), 2, "motionlang compare pick.mnt drive.csv"),
        (("drive.csv",), 2, "motionlang compare drive.csv RECORDING"),
        (("pick.mnt", "none.mnt"), 1, "none.mnt cannot be read"),
        (("pick.mnt", "odd.txt"), 2, "unknown language of odd.txt"),
        (("pick.mnt", "--machine-b", "wrong.machine.toml"), 1, "there is no key axes"),
        (("pick.mnt", "--set-b", "rat=1"), 1, "did you mean rate"),
        (("pick.mnt", "pick.mnt", "--tolerance", "time=1h"), 2, "is not a tolerance such as"),
        (("pick.mnt", "pick.mnt", "--input-b", "2=1@0"), 2, "motionlang diff A B --scenarios"),
        (("pick.mnt", "pick.mnt", "--keep", "time"), 2, "motionlang sweep FILE --keep"),
    ):
        ran = cell("diff", *words)
        assert ran.status == status, (words, ran)
        assert message in ran.err, (words, ran)


# What one run does differently: a program, what is changed in it, and the lines that say so.
CHANGES = [
    ("= 1000", "= 1100", ["time 0.70007 → 0.681888 s, -0.0182 s: line 3 -0.0182 s",
                          "axis 0 to 100 at 200 takes 0.018 s shorter in B (line 3 of A)"]),
    ('"a"', '"b"', ["A 'a' after 0.70 s, B 'b' after 0.70 s (line 5 of A, line 5 of B)"]),
    ("OUTX(1)", "OUTX(2)", ["A output 1 on after 0.70 s, B output 2 on after 0.70 s (line 4 of A, line 4 of B)"]),
    ("OUTX(1) = 1", "DAC(1) = 50", ["A output 1 on after 0.70 s, B analogue output 1 to 50 after 0.70 s"]),
    ("OUTX(1) = 1", "WAIT(0.5) : OUTX(1) = 1", ["output 1 on comes 0.00051 s later in B (line 4 of A)"]),
    ("= 100 :", "= 100.0001 :", ["A axis 0 to 100 at 200 after 0.00 s, B axis 0 to 100 at 200 after 0.00 s",
                                 "the positions differ from"]),
    ("GO(0)", "GO(0) : WAIT(300) : STOP(0)", ["B axis 0 MOVEA, cut off at "]),
    ("= 200 :", "= 200 : MAXSPEED(0) = 50 :", ["B axis 0 to 100 at 50, then axis 0 clamp after"]),
    ("GO(0)", "GO(0) : SETPOS(0) = 1", ["A: none, B: "]),
    ("GO(0)", "GO(0) : END", ["A output 1 on, then 'a' after 0.70 s, B does not"]),
]  # fmt: skip


@cases("change", CHANGES)
def test_what_one_run_does_differently(change: tuple[str, str, list[str]], cell: Cell) -> None:
    old, new, said = change
    assert old in PICK
    cell.write("a.mnt", PICK)
    cell.write("b.mnt", PICK.replace(old, new, 1))
    ran = cell("diff", "a.mnt", "b.mnt")
    assert ran.status == 1
    for each in said:
        assert each in ran.out


@cases("tolerance", [["time=1ms"], ["time=0.1%", "position=0.2uu"], ["position=0.2uu"]])
def test_smaller_differences_are_none(tolerance: list[str], cell: Cell) -> None:
    """The move takes 0.69996 s for 0.7 s, and what is printed is as much earlier."""
    cell.write("a.mnt", PICK.replace('"a"', "TIME / 1000"))
    options = [word for each in (*tolerance, "position=0.1uu") for word in ("--tolerance", each)]
    ran = cell("diff", "a.mnt", "--set-b", "rate=1000.2", *options)
    assert (ran.status, "no difference" in ran.out) == (
        (1, False) if "time" not in tolerance[0] else (0, True)
    )


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
        f"old.mnt: no difference\n{scenario}:\n"
        "A 'two' after 0.50 s, B '2' after 0.50 s (line 2 of A, line 2 of B)\n",
    )
    assert cell("diff", "old.mnt", "old.mnt", "--scenarios").status == 0
    rows = json.loads(cell("diff", "old.mnt", "new.mnt", "--scenarios", "--format", "json").out)["worlds"]
    assert [(row["world"], row["same"]) for row in rows] == [("old.mnt", True), (scenario, False)]


@cases("options", [["old.mnt"], ["old.mnt", "old.mnt", "--plot", "a.html"], ["old.mnt", "old.json"]])
def test_scenarios_need_two_programs_and_their_differences_only(options: list[str], cell: Cell) -> None:
    cell.write("old.mnt", "PRINT 1\n")
    assert cell("diff", *options, "--scenarios").status == 2


def test_a_wrong_scenario_is_reported(cell: Cell) -> None:
    cell.write("old.mnt", "PRINT 1\n")
    (cell.folder / "old.scenarios").mkdir()
    cell.write("old.scenarios/wrong.toml", "nothing = 1\n")
    ran = cell("diff", "old.mnt", "old.mnt", "--scenarios")
    assert ran.status == 1
    assert "error[machine-file]" in ran.err


def test_the_document_has_the_cycle_of_both_programs(cell: Cell) -> None:
    """There and back at 200 and 1000 per s² take 0.7 s each; the rests are 0.3 and 0.5 s."""
    strokes = "MOVEA(0) = 100 : GO(0) : PAUSE IDLE(0)\nMOVEA(0) = 0 : GO(0) : PAUSE IDLE(0)\n"
    for name, rest in (("old", 300), ("new", 500)):
        cell.write(
            f"{name}.mnt",
            f"SPEED(0) = 200 : ACCEL(0) = 1000 : DECEL(0) = 1000\nLoop\n{strokes}WAIT({rest})\nEnd Loop\n",
        )
    found = json.loads(cell("diff", "old.mnt", "new.mnt", "--until", "20", "--format", "json").out)
    assert (found["old_cycle"], found["new_cycle"]) == (
        pytest.approx(1.7, abs=1e-3),
        pytest.approx(1.9, abs=1e-3),
    )
