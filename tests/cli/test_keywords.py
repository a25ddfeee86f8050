"""`motionlang help`: the vocabulary, and the page of a keyword."""

from __future__ import annotations

import json
import re
import shlex

import pytest

from motionlang.cli import main
from motionlang.commands.help.view import listing, page
from motionlang.kernel import Keyword, dialect, dialects
from tests.cases import cases
from tests.cli.programs import Cell

SPEED = Keyword(
    "SPEED", "SP", "setting", "RW", "axis", "uu/s", "speed",
    "Slew speed of moves; a change acts at once on the move in progress.",
    "SPEED(0) = 250\nPRINT SPEED(0)",
    default=40000.0, low=0.0, group="axis",
)  # fmt: skip
CAM = Keyword("CAM", "", "move", "W", "axis", "", "", "Start a cam.", simulated=False)

PAGE = """\
SPEED · Mint setting

  Slew speed of moves; a change acts at once on the move in progress.

  short form  SP (memory low)
  use         read and write
  for         an axis (code, Mint type library)
  unit        user units/s
  default     40000
  range       0 or more
  group       axis
  known from  Baldor MN1270 p. 79 (printed in a manual)

    SPEED(0) = 250
    PRINT SPEED(0)
"""

LISTING = """\
Mint · 1 simulated, 1 known

axis
  SPEED  SP  uu/s    Slew speed of moves; a change acts a…

known, not simulated
  CAM
"""


def test_the_page_of_a_word() -> None:
    assert page([SPEED], "mint") == PAGE


def test_the_page_of_a_word_that_is_not_simulated_says_so() -> None:
    text = page([CAM], "mint")
    assert (
        "  known, not simulated: a program that uses it gets a message. Reason: no document that\n"
        "  could be read says what it does.\n" in text
    )
    assert (
        "  known from  Mint type library (from memory with low confidence, not checked against a manual)\n"
        in text
    )


def test_the_list() -> None:
    assert listing([SPEED, CAM], "mint", width=58) == LISTING


def test_every_word_has_its_page_and_its_line(cell: Cell) -> None:
    for name in dialects():
        table = dialect(name).table()
        out = cell("help", "--lang", name).out
        for row in table:
            assert row.name in out
            assert page([row], name).startswith(f"{row.name} · ")
        for row in table.rows[::25]:
            assert cell("help", row.name.lower(), "--lang", name).out.startswith(f"{row.name} · ")


def test_json_has_every_field_of_the_table(cell: Cell) -> None:
    document = json.loads(cell("help", "SV", "--lang", "mccl", "--format", "json").out)
    (row,) = document["keywords"]
    assert (row["dialect"], row["name"], row["unit"], row["simulated"]) == ("mccl", "SV", "uu/s", True)
    assert row["strength"] == "code"


def test_a_group_can_be_named(cell: Cell) -> None:
    ran = cell("help", "homing", "--lang", "mint")
    assert ran.out.startswith("Mint · ")
    assert "\nhoming\n" in ran.out
    assert "HOMETYPE" in ran.out
    assert "\n  SPEED " not in ran.out
    groups = {row["group"] for row in json.loads(cell("help", "Homing", "--format", "json").out)["keywords"]}
    assert groups == {"homing"}
    assert "did you mean homing?" in cell("help", "homming").err


def test_nothing_is_cut_away_from_a_terminal(cell: Cell, monkeypatch: pytest.MonkeyPatch) -> None:
    longest = max(
        (row["help"] for row in json.loads(cell("help", "--format", "json").out)["keywords"]), key=len
    )
    assert len(longest) > 160
    assert longest in cell("help", "keywords").out
    monkeypatch.setenv("COLUMNS", "80")
    assert longest not in cell("help", "keywords").out


def test_a_command_has_its_own_page(cell: Cell) -> None:
    assert cell("help").out == cell("--help").out
    assert cell("help", "check").out == cell("check", "--help").out
    assert (
        cell("help", "pvt", "plot").out == cell("help", "pvt plot").out == cell("pvt", "plot", "--help").out
    )
    ran = cell("help", "chekc")
    assert (ran.status, "did you mean check?" in ran.err) == (1, True)


@cases(
    "words, first, note",
    [
        (["run"], "usage: motionlang run", "run is a keyword of Mint, too: motionlang help run --lang mint"),
        (["RUN"], "Run · Mint", None),
        (["run", "--lang", "mint"], "Run · Mint", None),
        (["servo"], "usage: motionlang servo", "a group of keywords, too: motionlang help servo --lang mint"),
        (["error[limit]"], "limit\n", None),
        (["Limit"], "LIMIT · Mint", 'the code of a diagnostic, too: motionlang help "error[limit]"'),
        (
            ["axis"],
            "axis\n\n  There is no such axis",
            "a group of keywords, too: motionlang help axis --lang mint",
        ),
        (["SPEED"], "SPEED · Mint", None),
    ],
)
def test_what_else_a_word_means_is_named(words: list[str], first: str, note: str | None, cell: Cell) -> None:
    shown = cell("help", *words).out
    assert shown.startswith(first)
    assert shown.count("note: ") == (note is not None)
    assert note is None or shown.endswith(f"{note}\n")
    for command in re.findall(r"motionlang help (.*)", shown) if note else ():
        assert not cell("help", *shlex.split(command)).out.startswith(first)


@cases("word, near", [("chekc", "check"), ("never-startd", "never-started"), ("SPEEED", "SPEED")])
def test_the_nearest_of_all_names_is_meant(word: str, near: str, cell: Cell) -> None:
    ran = cell("help", word)
    assert (ran.status, ran.out) == (1, "")
    assert ran.err == (
        f"error[unknown-word]: there is no command, keyword or diagnostic {word}\n  hint: did you mean {near}?\n"
    )


def test_a_language_has_keywords_only(cell: Cell) -> None:
    assert "there is no keyword chekc\n" in cell("help", "chekc", "--lang", "mint").err


def test_the_page_of_a_word_says_what_is_left_open(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["help", "TIMEREVENT"]) == 0
    text = capsys.readouterr().out
    assert "its meaning is unconfirmed, too" in text
    assert "  not settled by the sources\n\n  mint.timerevent\n" in text


def test_what_no_program_settles_names_its_alternatives(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["help", "CONTOURMODE"]) == 0
    text = " ".join(capsys.readouterr().out.split())
    assert "or: it is an error, and the axes stop at ERRORDECEL" in text


def test_the_document_of_a_word_has_its_open_questions(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["help", "HOMESPEED", "--format", "json"]) == 0
    found = {each["name"]: each for each in json.loads(capsys.readouterr().out)["assumptions"]}
    assert found["mint.homespeed-default"]["alternatives"] == ["any other number"]
    assert found["mint.homespeed-default"]["key"] == "assumptions.mint.homespeed-default"
