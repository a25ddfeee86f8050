"""A run gives up only where nothing would follow."""

from __future__ import annotations

import pytest

from tests.cases import examples
from tests.generated.never import is_equal

# Seeds of the normal run, of a long one in batches, and of programs that were given up too early.
SLICE, BATCHES, BATCH = 20, 20, 100
FOUND = (5285, 5681, 6582)


@pytest.mark.parametrize("seed", FOUND)
def test_a_program_that_was_given_up_too_early(seed: int) -> None:
    assert is_equal(seed)


@pytest.mark.slow
def test_a_slice_of_programs_does_no_more_when_it_is_run_on() -> None:
    assert [seed for seed in range(examples(SLICE)) if not is_equal(seed)] == []


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_do_no_more_when_they_are_run_on(batch: int) -> None:
    first = SLICE + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []
