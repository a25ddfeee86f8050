"""Programs with TIMER handlers run equally with no iteration skipped: a sample."""

from __future__ import annotations

import pytest

from tests.cases import covering
from tests.generated.compared import counting_skips
from tests.generated.handlers import PARTS, document, is_equal, program

# Seeds of the normal run, and of a long one in batches.
SLICE, BATCHES, BATCH = 60, 30, 100


@pytest.mark.slow
def test_a_slice_of_programs_is_the_same_without_skipping() -> None:
    """The sample has every step, condition, action, task and line of the main program.

    Iterations are skipped in a third of the programs. Without that, the comparison would prove nothing.
    """
    found: set[int] = set()
    for seed in (seeds := covering(PARTS, SLICE, lambda seed: program(seed)[0])):
        skips: list[int] = []
        with counting_skips(skips):
            document(*program(seed))
        found |= {seed} if skips else set()
        assert is_equal(seed), seed
    assert len(found) >= len(seeds) // 3


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_are_the_same_without_skipping(batch: int) -> None:
    first = SLICE + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []
