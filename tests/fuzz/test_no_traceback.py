"""No program ends in a traceback or runs for ever: a sample by seed.

The long runs use all keywords and more programs.
"""

from __future__ import annotations

from random import Random

import pytest

from motionlang.kernel import dialects
from tests.cases import cases, examples
from tests.fuzz.guard import trouble
from tests.fuzz.inputs import WORDS, inputs, mint_forms, mutated

# The sample sizes in CI, of keywords and of mutations; and of the long run for each language.
SLICE, LONG = 300, 100_000


@pytest.mark.slow
@cases("name", dialects())
def test_words_in_every_form_in_every_loop(name: str) -> None:
    words = list(WORDS[name]())
    for text in Random(f"words of {name}").sample(words, examples(SLICE)):
        assert trouble(name, text) == "", text


@pytest.mark.slow
@cases("name", dialects())
def test_programs_of_the_gallery_with_pieces_changed(name: str) -> None:
    for text in inputs(name, examples(SLICE), 0):
        assert trouble(name, text) == "", text


@pytest.mark.long
@pytest.mark.parametrize("name", dialects())
def test_all_words(name: str) -> None:
    assert [text for text in WORDS[name]() if trouble(name, text)] == []


@pytest.mark.long
@pytest.mark.parametrize("name", dialects())
@pytest.mark.parametrize("seed", range(10))
def test_a_million_inputs_a_language(name: str, seed: int) -> None:
    for text in inputs(name, LONG, seed):
        assert trouble(name, text) == "", text


def test_a_traceback_is_reported_with_its_location(monkeypatch: pytest.MonkeyPatch) -> None:
    def settle(*_: object) -> None:
        raise AssertionError("it cannot be")

    monkeypatch.setattr("motionlang.kernel.lang.scheduler.Scheduler.settle", settle)
    finding = trouble("mint", "MOVER(0) = 5\nGO(0)\nPAUSE IDLE(0)\n")
    assert finding.startswith("AssertionError: it cannot be at ")


def test_inputs_are_the_same_again_and_differ() -> None:
    for name in dialects():
        once = list(inputs(name, 50, 3))
        assert once == list(inputs(name, 50, 3))
        assert len(set(once)) > 40
    assert mutated("mint", Random(1)) != mutated("mint", Random(2))


def test_every_word_has_its_forms() -> None:
    from motionlang.kernel.mint import table

    assert len(list(WORDS["mint"]())) == 16 * len(list(table())) > 18_000
    assert all(len(set(mint_forms(row))) > 1 for row in table())


def test_what_takes_too_long_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tests.fuzz.guard.MAX_SECONDS", 0.05)

    def endless(*_: object, **__: object) -> None:
        while True:
            pass

    monkeypatch.setattr("tests.fuzz.guard.run", endless)
    assert trouble("mint", "PRINT 1\n").startswith("TooLong: more than 0.05 s")
