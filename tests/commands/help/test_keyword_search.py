"""`motionlang help` finds keywords by words of their descriptions."""

from __future__ import annotations

import re

import pytest

from motionlang.kernel import dialect, dialects
from tests.cases import cases
from tests.cli.programs import Cell


def found(cell: Cell, *question: str) -> list[str]:
    """Return the keywords that a question finds."""
    return re.findall(r"^  ([A-Z_]\w*)", cell("help", *question).out, re.MULTILINE)


@cases(
    "question, language, word",
    [
        ("how do I stop at an input", "mint", "STOPINPUT"),
        ("following error", "mint", "FOLERROR"),
        ("parabolic profile", "mccl", "PP"),
        ("wait for a time", "mccl", "WA"),
        # An ending does not count.
        ("the jerking", "mint", "ACCELJERK"),
        ("a stopping input", "mint", "STOPINPUT"),
        ("parabolics for profiles", "mccl", "PP"),
        # One word begins with the other, and is two letters shorter at most.
        ("a parabol", "mccl", "PP"),
        ("a parabolicxy", "mccl", "PP"),
    ],
)
def test_a_question_finds_its_keyword(question: str, language: str, word: str, cell: Cell) -> None:
    assert word in found(cell, question, "--lang", language)


@cases("question", ["a parabo", "a parabolicxyz", "a pax", "what is the"])
def test_what_no_word_is_like_finds_nothing(question: str, cell: Cell) -> None:
    ran = cell("help", question, "--lang", "mccl")
    assert (ran.status, f"there is no keyword {question}" in ran.err) == (1, True)


def test_names_come_first(cell: Cell) -> None:
    assert found(cell, "how do I stop at an input", "--lang", "mint")[0] == "STOPINPUT"


@pytest.mark.parametrize("language", dialects())
def test_a_language_shows_twelve_keywords_at_most(language: str, cell: Cell) -> None:
    """Those whose name has the stem "axi", or whose description has the word, and how many more there are."""
    out = cell("help", "the axis", "--lang", language).out
    (counts,) = re.findall(r"(\d+) simulated, (\d+) known", out)
    assert sum(map(int, counts)) == 12
    rows = dialect(language).table()
    texts = [f"{row.help} {row.group} {row.meant}".lower() for row in rows]
    matching = sum(
        "AXI" in row.name.upper() or re.search(r"\baxis\b", text) is not None
        for row, text in zip(rows, texts, strict=True)
    )
    assert out.endswith(f"\n{matching - 12} more match; add a word\n")


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


@pytest.mark.parametrize(
    ("word", "opener"), [("ENDW", "While"), ("end if", "If"), ("ENDL", "Loop"), ("EndTask", "Task")]
)
def test_a_word_that_closes_a_block_is_that_of_the_block(word: str, opener: str, cell: Cell) -> None:
    assert cell("help", word).out.startswith(f"{opener} · Mint statement\n")


def test_what_nothing_describes_is_unknown(cell: Cell) -> None:
    ran = cell("help", "xyzzy frobnicate")
    assert ran.status == 1
    assert "there is no command, keyword or diagnostic xyzzy frobnicate" in ran.err


@cases("language, first", [("mint", ["MOVER", "MOVEA", "GO"]), ("mccl", ["MR", "MA", "GO"])])
def test_the_list_begins_with_what_people_use_first(language: str, first: list[str], cell: Cell) -> None:
    listed = [
        line.split()[0] for line in cell("help", "keywords", "--lang", language).out.splitlines() if line
    ]
    assert listed[2:5] == first
