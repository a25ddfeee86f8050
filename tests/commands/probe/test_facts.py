"""The evidence of keyword facts: none claims more than its source prints."""

from __future__ import annotations

import pytest

from motionlang.commands.probe import questions
from motionlang.commands.probe.facts import facts_of, listed, of_word
from motionlang.commands.probe.keyword_facts import facts
from motionlang.kernel import Keyword, dialect, dialects

LARGEST = 8388607.0
# The printed default and range, copied from the pages; None if a page has none.
PRINTED: dict[str, tuple[float | None, tuple[float, float] | None]] = {
    "INPUTDEBOUNCE": (1, (1, 10)),
    "REMOTEMODE": (None, (0, 1)),
    "SPEED": (40000, (0, LARGEST)),
    "FEEDRATE": (40000, (0, LARGEST)),
    "FEEDRATEMODE": (0, (0, 3)),
    "GEARING": (100, (-LARGEST, LARGEST)),
    "GEARINGMODE": (0, (0, 1)),
    "HTA": (0, (-100, 100)),
    "HTADAMPING": (0, (-LARGEST, LARGEST)),
    "HTADEADBAND": (0, (0, 100)),
    "HTAKINT": (0, (-LARGEST, LARGEST)),
    "HTAKPROP": (0, (-LARGEST, LARGEST)),
    "AUXENCODERSPEED": (0, (-LARGEST, LARGEST)),
    "BACKLASH": (0, (-LARGEST, LARGEST)),
    "BACKLASHMODE": (0, (0, 1)),
    "MOVEBUFFERSIZE": (2, (2, 100)),
    "MOVEBUFFERSTATUS": (8, (0, 119)),
    "OFFSETMODE": (0, (0, 3)),
    "PRECISIONOFFSET": (0, (-LARGEST, LARGEST)),
    "LOOPTIME": (1000, None),
    "KINTMODE": (0, (0, 3)),
    "HOMEPOS": (None, (-LARGEST, LARGEST)),
    "SPLINETIME": (None, (4, 60000)),
    "UR": (1, None),
    "PS": (None, (0, 0.5)),
}


def test_what_is_marked_as_printed_is_what_the_pages_print() -> None:
    claimed = {}
    for language in dialects():
        for row in dialect(language).table():
            evidence = of_word(language, row)
            default = (
                row.default if "default" in evidence and evidence["default"].strength == "manual" else None
            )
            printed = "range" in evidence and evidence["range"].strength == "manual"
            span = (row.low, row.high) if printed else None
            if default is not None or span is not None:
                claimed[row.name] = (default, span)
    assert claimed == PRINTED


@pytest.mark.parametrize("language", dialects())
def test_a_fact_that_is_listed_is_one_of_its_word(language: str) -> None:
    table = dialect(language).table()
    for word, fact in listed(language):
        row = table.get(word)
        assert row is not None, word
        assert row.name == word
        assert fact in facts_of(row), (word, fact)


@pytest.mark.parametrize("language", dialects())
def test_every_fact_of_every_word_has_its_evidence(language: str) -> None:
    """Even an arbitrary choice needs evidence; no other facts exist."""
    known = listed(language)
    expected = {(row.name, fact) for row in dialect(language).table() for fact in facts_of(row)}
    assert sorted(expected - known.keys()) == []


# A keyword, and its facts: those of another source than its meaning name it.
PAGES = (
    (
        "mint", "BACKLASHMODE",
        {
            "form": "",
            "short form": "BLM (manual, Baldor MN1270 p. 40)",
            "use": "read and write",
            "for": "an axis (code, Mint type library)",
            "unit": "integer (code, Mint type library)",
            "default": "0 (manual, Baldor MN1270 p. 40)",
            "range": "0 to 1 (manual, Baldor MN1270 p. 40)",
            "group": "compensation",
            "known from": "Baldor MN1270 p. 39 (printed in a manual)",
        },
    ),
    # Its short form is remembered, too, without a source of its own.
    (
        "mint", "JOG",
        {
            "form": "",
            "short form": "JG",
            "use": "read and write",
            "for": "an axis (code, Mint type library)",
            "unit": "user units/s",
            "default": "0 (choice)",
            "range": "-8388607 to 8388607 (choice)",
            "group": "motion",
            "known from": "Mint type library (from memory with low confidence, not checked against a manual)",
        },
    ),
    (
        "mccl", "UR",
        {
            "form": "aURn",
            "short form": "",
            "use": "write",
            "for": "one axis or several",
            "unit": "number",
            "default": "1 (manual, PMC MultiFlex user's manual, p. 163)",
            "range": "1e-09 to 1000000000 (choice)",
            "group": "user units",
            "known from": "MultiFlex user's manual (printed in a manual)",
        },
    ),
)  # fmt: skip


@pytest.mark.parametrize(("language", "name", "page"), PAGES)
def test_the_facts_of_a_keyword(language: str, name: str, page: dict[str, str]) -> None:
    row = dialect(language).table().get(name)
    assert row is not None
    assert dict(facts(row, language)) == page


def test_a_made_up_keyword_has_no_source() -> None:
    row = Keyword("MADEUP", "NW", "setting", "RW", "none", "text", "new", "Help.", default="a")
    assert dict(facts(row, "mint")) == {
        "form": "", "short form": "NW", "use": "read and write", "for": "", "unit": "text", "default": "a",
        "range": "", "group": "", "known from": "a choice: no source",
    }  # fmt: skip
    assert facts_of(row) == ["meaning", "short", "unit", "default"]
    assert [str(each) for each in of_word("mint", row).values()] == ["choice"] * 4


@pytest.mark.parametrize(
    ("language", "name", "found"),
    [
        ("mint", "FEEDRATEMODE", ["motion.override-of-a-move"]),  # its default is printed
        ("mint", "SPEED", ["mint.speed-short"]),  # a fact without an entry
        ("mint", "GO", []),  # an entry of MCCL names it
        ("mccl", "GO", ["mccl.new-target"]),
        ("mint", "HTADEADBAND", ["mint.htadeadband"]),
    ],
)
def test_the_open_questions_about_a_keyword(language: str, name: str, found: list[str]) -> None:
    row = dialect(language).table().get(name)
    assert row is not None
    assert [each.name for each in questions.of_word(language, row)] == found


def test_the_row_of_a_word_says_nothing_of_its_evidence() -> None:
    assert not {"source", "trust", "strength", "evidence"} & vars(dialect("mint").table().get("ACCEL")).keys()


def test_a_default_and_a_range_are_choices_unless_a_source_has_them() -> None:
    """A source may print the keyword, but not its value at power-up."""
    row = dialect("mint").table().get("ACCEL")
    assert row is not None
    found = of_word("mint", row)
    assert (found["meaning"].strength, found["meaning"].source) == ("manual", "ABB AN00115")
    assert found["default"].strength == found["range"].strength == "choice"
    assert (found["index"].strength, found["short"].strength) == ("code", "memory low")
