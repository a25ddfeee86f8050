"""The files of evidence: each fact and each question once, and the entries of a keyword found without reading all."""

from __future__ import annotations

import pytest

from motionlang.commands.evidence.entries import assumptions, chapters, entries_naming
from motionlang.commands.evidence.fact_evidence import facts_of, listed
from motionlang.kernel import dialect, dialects


def test_no_question_is_asked_twice_in_a_chapter() -> None:
    for chapter in chapters():
        questions = [each.question for section in chapter.sections for each in section.assumptions]
        assert sorted(questions) == sorted(set(questions)), chapter.title


def test_the_entries_of_a_keyword_are_those_that_name_it() -> None:
    """`help WORD` parses only the entries that name the keyword."""
    for language in ("mint", "mccl"):
        for row in dialect(language).table():
            names = [each.name for each in assumptions().values() if row.name in each.words]
            assert [each.name for each in entries_naming(row.name)] == names, row.name


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
