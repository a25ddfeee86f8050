"""The evidence of keyword facts: none claims more than its source prints."""

from __future__ import annotations

import pytest

from motionlang.assumptions.facts import facts_of, listed, of_word
from motionlang.execution import dialect, dialects
from motionlang.lang.keyword import Keyword

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


def test_the_row_of_a_word_says_nothing_of_its_evidence() -> None:
    assert not {"source", "trust", "strength", "evidence"} & set(Keyword.__slots__)


def test_a_default_and_a_range_are_choices_unless_a_source_has_them() -> None:
    """A source may print the keyword, but not its value at power-up."""
    row = dialect("mint").table().get("ACCEL")
    assert row is not None
    found = of_word("mint", row)
    assert (found["meaning"].strength, found["meaning"].source) == ("manual", "ABB AN00115")
    assert found["default"].strength == found["range"].strength == "choice"
    assert (found["index"].strength, found["short"].strength) == ("code", "memory low")
