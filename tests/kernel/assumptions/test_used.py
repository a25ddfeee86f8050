"""The open assumptions of a program, listed in its report and before a run."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from motionlang import run
from motionlang.cli import main
from motionlang.kernel import Source, depended_on, dialect
from tools import assumption_index


def used(text: str, language: str = "mint", **settings: object) -> list[str]:
    return depended_on(dialect(language), text, settings)


@pytest.mark.parametrize(("words", "text"), [("x" * 69, '"{}"'), ("x" * 70, '"""\n{}\n"""')])
def test_a_long_text_has_lines_of_its_own(words: str, text: str) -> None:
    assert assumption_index._text([words]) == text.format(words)


def test_keywords_bring_their_assumptions_in_every_spelling_and_not_in_texts() -> None:
    for text in ("FOLLOWMODE(0) = 1", "x = 1 : followmode.0 = 1"):
        assert "mint.followmode" in used(text)
    assert "mint.followmode" not in used('PRINT "FOLLOWMODE"  \' FOLLOWMODE')
    assert "mint.remainder-sign" in used("PRINT a \\ 2")
    assert "mccl.hex-letters" in used("HM,1TP\n", "mccl")
    assert "mccl.hex-letters" not in used("1TP ; HM\n", "mccl")
    assert "mint.statement-time" in used("")


def test_a_default_counts_for_a_program_that_never_writes_it() -> None:
    assert "mint.homespeed-default" in used("PRINT HOMESPEED(0)")
    assert "mint.homespeed-default" not in used("HOMESPEED(0) = 5 : PRINT HOMESPEED(0)")
    assert "mint.maxspeed-default" not in used("MOVER(0) = 5 : GO(0)")
    assert "mint.profilemode-default" in used("MOVER(0) = 5 : GO(0)")
    assert "mint.profilemode-default" not in used("PROFILEMODE(0) = 1 : MOVER(0) = 5 : GO(0)")


def test_what_the_machine_file_sets_is_open_no_more() -> None:
    settings = {"assumptions.mint.float-zeros": "dropped"}
    assert set(used("PRINT 1.5")) - set(depended_on(dialect("mint"), "PRINT 1.5", settings)) == {
        "mint.float-zeros"
    }


def test_a_motor_brings_those_of_the_servo() -> None:
    assert not any(name.startswith("servo.") for name in used("PRINT POS(0)"))
    with_motor = depended_on(dialect("mint"), "PRINT POS(0)", {"axis.0.plant.inertia": 1e-4})
    assert "servo.encoder" in with_motor


def test_a_report_names_them() -> None:
    report = run(Source("a.mnt", "PRINT HOMESPEED(0)\n")).report
    assert report["assumptions"] == used("PRINT HOMESPEED(0)")


def test_check_lists_them_with_their_strength(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "a.mnt"
    path.write_text("PRINT HOMESPEED(0)\n", encoding="utf-8")
    assert main(["check", "--evidence", str(path)]) == 0
    shown = capsys.readouterr().out
    assert "mint.homespeed-default  choice\n" in shown
    assert "What HOMESPEED is until a program writes it: 4000" in shown
    assert main(["check", "--evidence", "--format", "json", str(path)]) == 0
    found = json.loads(capsys.readouterr().out)["assumptions"]
    assert [each["name"] for each in found] == used("PRINT HOMESPEED(0)")
    assert {each["strength"] for each in found} >= {"choice", "memory medium"}
