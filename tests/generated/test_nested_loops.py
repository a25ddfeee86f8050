"""Loops in loops that poll and copy have the same report if no iteration is skipped."""

from __future__ import annotations

import pytest

from tests.cases import examples
from tests.generated.nested_loops import is_equal

# Seeds of the normal run, and of a long one in batches.
SLICE, BATCHES, BATCH = 40, 20, 100


def test_a_slice_of_programs_is_the_same_without_skipping() -> None:
    assert [seed for seed in range(examples(SLICE)) if not is_equal(seed)] == []


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_are_the_same_without_skipping(batch: int) -> None:
    first = SLICE + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []
