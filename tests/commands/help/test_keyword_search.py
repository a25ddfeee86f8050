"""`motionlang help` finds keywords by words of their descriptions."""

from __future__ import annotations

import pytest

from motionlang.commands.help.keyword_search import MAX_FOUND, _are_similar, search
from motionlang.commands.help.view import FIRST
from motionlang.kernel import dialect, dialects
from tests.cli.programs import Cell

TABLES = {name: list(dialect(name).table()) for name in dialects()}


@pytest.mark.parametrize(
    ("question", "language", "word"),
    [
        ("how do I stop at an input", "mint", "STOPINPUT"),
        ("following error", "mint", "FOLERROR"),
        ("parabolic profile", "mccl", "PP"),
        ("wait for a time", "mccl", "WA"),
    ],
)
def test_a_question_finds_its_keyword(question: str, language: str, word: str) -> None:
    found, _ = search(question, TABLES)
    assert word in [row.name for row in found[language]]


def test_names_come_first() -> None:
    found, _ = search("how do I stop at an input", TABLES)
    assert found["mint"][0].name == "STOPINPUT"


def test_a_long_list_says_what_it_omits() -> None:
    found, omitted = search("axis", TABLES)
    assert max(map(len, found.values())) == MAX_FOUND
    assert omitted > 0


def test_the_words_need_no_quotes(cell: Cell) -> None:
    assert cell("help", "following", "error").out == cell("help", "following error").out
    assert cell("help", "SPEED").out.startswith("SPEED · Mint setting")


def test_a_misspelt_keyword_is_no_question(cell: Cell) -> None:
    ran = cell("help", "SPED")
    assert (ran.status, ran.out) == (1, "")
    assert "did you mean SPEED?" in ran.err


def test_a_part_of_a_name_is_no_misspelt_keyword(cell: Cell) -> None:
    """JERK is near RK, the short form of READKEY, but part of ACCELJERK."""
    ran = cell("help", "jerk", "--lang", "mint")
    assert ran.status == 0
    assert {"ACCELJERK", "DECELJERK"} <= {line.split()[0] for line in ran.out.splitlines() if line.strip()}


def test_a_part_of_the_nearest_keyword_is_a_misspelt_one(cell: Cell) -> None:
    ran = cell("help", "spee")
    assert (ran.status, ran.out) == (1, "")
    assert "did you mean SPEED?" in ran.err


def test_what_nothing_describes_is_unknown(cell: Cell) -> None:
    ran = cell("help", "xyzzy frobnicate")
    assert ran.status == 1
    assert "there is no command, keyword or diagnostic xyzzy frobnicate" in ran.err


@pytest.mark.parametrize(
    ("one", "other", "similar"),
    [
        ("mov", "mov", True),
        ("mov", "move", True),
        ("mover", "mov", True),  # two letters more
        ("mov", "movers", False),
        ("mo", "mov", False),  # fewer than three letters
        ("mo", "mo", True),
        ("mov", "dmov", False),
    ],
)
def test_stems_that_begin_alike_are_similar(one: str, other: str, similar: bool) -> None:
    assert _are_similar(one, other) is similar


@pytest.mark.parametrize("language", dialects())
def test_the_list_begins_with_what_people_use_first(language: str, cell: Cell) -> None:
    first = FIRST[language].split()
    listed = [
        line.split()[0] for line in cell("help", "keywords", "--lang", language).out.splitlines() if line
    ]
    assert set(first) <= {each.upper() for each in listed}
    assert listed[2:4] == first[:2]
