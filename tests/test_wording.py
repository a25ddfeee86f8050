"""The wording of docstrings, comments, messages and docs.

`wording.py` has the rules: forbidden first words, the length of first lines, and banned words with their
replacements. Printed titles, quotations, code and keywords are exempt by rule. The other exceptions are
listed here with a reason. Their number may only fall: an exception that no text needs fails, so remove it
together with its cause.
"""

from __future__ import annotations

from collections import Counter
from functools import cache
from typing import NamedTuple

import pytest

from tests import wording
from tests.cases import cases
from tests.wording import FIRST_WORDS, MAX_FIRST_LINE, Text, instead, texts

MAX_EXCEPTIONS = 50


class Exempt(NamedTuple):
    """An exception: a file, how many banned words it may have, and the reason."""

    file: str
    number: int
    reason: str


EXCEPTIONS: tuple[Exempt, ...] = ()
# Banned words in messages, which may only become fewer.
MAX_IN_MESSAGES = 0


@cache
def every() -> tuple[Text, ...]:
    """Return every text of the project."""
    return tuple(texts(quick=True))


def found(*kinds: str) -> Counter[str]:
    """Return the number of banned words of each file in texts of the given kinds."""
    counts: Counter[str] = Counter()
    for each in every():
        if each.kind in kinds:
            counts[each.file] += len(each.found())
    return +counts


def test_docstrings_begin_with_what_they_describe() -> None:
    assert [
        f"{each.file}:{each.line} {each.text[:60]}"
        for each in every()
        if each.kind == "docstring" and FIRST_WORDS.match(each.text)
    ] == []


def test_first_lines_are_short() -> None:
    assert [
        f"{each.file}:{each.line} {each.text.partition(chr(10))[0]}"
        for each in every()
        if each.kind == "docstring" and len(each.text.partition("\n")[0]) > MAX_FIRST_LINE
    ] == []


def test_docstrings_comments_and_docs_have_no_banned_words() -> None:
    allowed = {each.file for each in EXCEPTIONS}
    assert [
        f"{each.file}:{each.line} {word!r}: {instead(word)}"
        for each in every()
        if each.kind != "message" and each.file not in allowed
        for word in each.found()
    ] == []


def test_exceptions_only_shrink() -> None:
    counts = found("docstring", "comment", "passage")
    assert {each.file: each.number for each in EXCEPTIONS} == {
        each.file: counts[each.file] for each in EXCEPTIONS
    }
    assert all(each.number and each.reason for each in EXCEPTIONS)
    assert len(EXCEPTIONS) <= MAX_EXCEPTIONS


def test_messages_have_fewer_and_fewer_banned_words() -> None:
    assert sum(found("message").values()) <= MAX_IN_MESSAGES


@cases(
    ("text", "banned"),
    [
        ("nobody waits", ["nobody"]),
        ("the axis stands at 0", ["stands"]),
        ("`name` stands for an expression", []),
        ('the manual says "the axis stands"', []),
        ("each turn of the loop", ["each turn"]),
        ("each turn on of a drive", []),
        ("BESIDE is a keyword", []),
        ("by `kept` values", []),
        ("see [the page](docs/kept.md)", []),
    ],
)
def test_a_banned_word_is_found_outside_of_quotations(text: str, banned: list[str]) -> None:
    assert Text("comment", "a.py", 1, text).found() == banned
    assert all(instead(word) for word in banned)


def test_a_sample_is_reproducible(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(wording, "texts", lambda: iter(every()))
    first, again, other = (list(wording.drawn(date)) for date in ("2026-11-21", "2026-11-21", "2026-11-22"))
    assert first == again != other
    assert [line for line in first if line.startswith(("30 of", "20 of", "10 of"))] == [
        line for line in other if line.startswith(("30 of", "20 of", "10 of"))
    ]
