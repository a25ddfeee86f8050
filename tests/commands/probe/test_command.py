"""`motionlang probe`: its programs, its evaluation of answers, and usage errors."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from motionlang import run
from motionlang.cli import main


def probe(tmp_path: Path, capsys: pytest.CaptureFixture[str], *options: str) -> tuple[int, str, str]:
    status = main(["probe", *options])
    captured = capsys.readouterr()
    return status, captured.out, captured.err


def test_from_the_probe_to_the_settings(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A controller that differs runs the probe; its answers yield the settings."""
    status, text, _ = probe(tmp_path, capsys, "mint", "--axis", "2")
    assert status == 0
    assert "HOMESPEED(2)" in text
    program = tmp_path / "probe.mnt"
    program.write_text(text, encoding="utf-8")
    machine = {"assumptions.mint.homespeed-default": 12.5, "assumptions.mint.float-zeros": "dropped"}
    log = tmp_path / "log.txt"
    log.write_text("\r\n".join(run(str(program), machine=machine).output), encoding="utf-8")
    status, found, err = probe(tmp_path, capsys, "--answers", str(log))
    assert status == 0
    assert tomllib.loads(found) == {
        "assumptions": {"mint.homespeed-default": 12.5, "mint.float-zeros": "dropped"},
    }
    assert "mint.homespeed-default: What HOMESPEED is until a program writes it: 12.5, not 4000" in err
    assert "assumptions confirmed:\n  mint.float-precision, mint.float-to-integer" in err


def test_answers_of_which_some_are_missing_are_read_and_reported(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    log = tmp_path / "log.txt"
    log.write_text("<probe|mint 9>\n<mint.homespeed-default|5>\n<mint.truth|1 ", encoding="utf-8")
    status, found, err = probe(tmp_path, capsys, "mint", "--answers", str(log))
    assert status == 1
    assert '"mint.homespeed-default" = 5' in found
    assert "the answer to mint.truth is cut off" in err
    assert "log.txt:3" in err


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ((), "give the language of the controller"),
        (("basic",), "'basic' is neither mint, mccl nor a question"),
        (("zzzzzz",), "nor a question; motionlang probe --list shows the questions"),
        (("mint.numberof", "--answers", "log"), "--answers reports every question in the log"),
        (("mint.truht",), "did you mean mint.truth?"),
        (("HOMESPEED",), "motionlang probe HOMESPEED --list"),
        (("mint.second-offset",), "needs motion: give the distance, such as --motion 20"),
        (("NOTHING", "--list"), "NOTHING is not a keyword, or has no open question"),
        (("mint", "--motion", "none"), "'none' is not a distance above 0"),
        (("mint", "--axis", "-1"), "no such axis"),
        (("mint", "--skip", "mint.trut"), "did you mean mint.truth?"),
        (("--answers", "log.txt", "--axis", "1"), "--answers reads answers"),
    ],
)
def test_what_is_wrong_with_a_command_line(
    options: tuple[str, ...], message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["probe", *options])
    assert ended.value.code == 2
    assert message in capsys.readouterr().err


def test_answers_that_cannot_be_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, found, err = probe(tmp_path, capsys, "--answers", str(tmp_path / "none.txt"))
    assert (status, found) == (1, "")
    assert "cannot be read" in err


def test_one_question_has_a_program_whose_remarks_say_what_each_answer_means(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status, text, _ = probe(tmp_path, capsys, "mint.homespeed-scale", "--axis", "2")
    assert status == 0
    assert text.splitlines()[:5] == [
        "' mint.homespeed-scale: Whether HOMESPEED follows SCALEFACTOR",
        "' First: switch the drive off, and restart the controller afterwards.",
        "' What it shows, and what that says of the controller:",
        "'   2.5  yes: user units, stored in counts (chosen here)",
        "'   5    no, or it is stored as written",
    ]
    assert "HOMESPEED(2) = 5" in text
    program = tmp_path / "probe.mnt"
    program.write_text(text, encoding="utf-8")
    log = tmp_path / "log.txt"
    log.write_text("\n".join(run(str(program)).output), encoding="utf-8")
    status, _, err = probe(tmp_path, capsys, "--answers", str(log))
    assert (status, err) == (0, "1 assumption confirmed:\n  mint.homespeed-scale\n")


def test_a_question_that_moves_says_how_far(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, text, _ = probe(tmp_path, capsys, "mint.second-offset", "--motion", "20")
    assert status == 0
    assert "It moves axis 0 within 20 user units of its position" in text
    status, text, _ = probe(tmp_path, capsys, "mint.follow-0", "--motion", "20")
    assert "the axes do not come" in text
    assert "It moves axes 0 and 1 within 20 user units of their positions" in text
    assert "puts back" not in text


def test_the_questions_about_a_word_are_listed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, text, _ = probe(tmp_path, capsys, "homespeed", "--list")
    assert status == 0
    assert text.splitlines()[0].split("  ") == [
        "mint.homespeed-default",
        "",
        " What HOMESPEED is until a program writes it",
        "(can be set)",
    ]
    assert "mint.homespeed-scale" in text
    for language, one, other in (
        ("mint", "mint.truth", "mccl.quotient"),
        ("mccl", "mccl.quotient", "mint.truth"),
    ):
        _, text, _ = probe(tmp_path, capsys, language, "--list")
        assert one in text
        assert other not in text


def test_a_question_that_no_program_settles_is_listed_with_its_answers(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["probe", "motion.contourmode"])
    assert ended.value.code == 2
    assert "no program can settle motion.contourmode" in capsys.readouterr().err
