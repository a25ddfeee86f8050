"""A sample of random debugger walks: no result changes, every state is replayed."""

from __future__ import annotations

import pytest

from motionlang.kernel import Source, settings_next_to
from tests.cases import examples
from tests.golden.test_gallery import PROGRAMS
from tests.ide.debug.walks import differences, of_gallery, of_generated

# Generated programs of the normal run; the long one is in batches.
SLICE, BATCHES, BATCH = 24, 10, 50


@pytest.mark.parametrize("path", PROGRAMS[::14], ids=lambda path: path.stem)
def test_a_walk_through_the_gallery_changes_nothing(path: str) -> None:
    assert list(differences(Source.read(path), settings_next_to(path), 7)) == []


@pytest.mark.slow
def test_walks_through_generated_programs_change_nothing() -> None:
    assert {seed: found for seed in range(examples(SLICE)) if (found := of_generated(seed))} == {}


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_many_walks_change_nothing(batch: int) -> None:
    first = 1000 + batch * BATCH
    assert {seed: found for seed in range(first, first + BATCH) if (found := of_generated(seed))} == {}


@pytest.mark.long
def test_walks_through_the_whole_gallery_change_nothing() -> None:
    assert list(of_gallery(1000)) == []
