"""Programs that poll with a TIMER have the same result with no iteration skipped."""

from __future__ import annotations

import pytest

from tests.cases import examples
from tests.generated.compared import counting_skips
from tests.generated.handlers import document
from tests.generated.polls import is_equal, program

# Seeds of the normal run, and of a long one in batches.
SLICE, BATCHES, BATCH = 40, 30, 100


@pytest.mark.slow
def test_a_slice_of_programs_is_the_same_without_skipping() -> None:
    """Iterations are skipped in a quarter of the programs.

    Without that, the comparison would prove nothing.
    """
    found: set[int] = set()
    for seed in range(examples(SLICE)):
        skips: list[int] = []
        with counting_skips(skips):
            document(*program(seed))
        found |= {seed} if skips else set()
        assert is_equal(seed), seed
    assert len(found) >= examples(SLICE) // 4


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_are_the_same_without_skipping(batch: int) -> None:
    first = SLICE + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []
