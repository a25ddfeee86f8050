"""Programs of several tasks have the same result with loops skipped: a sample."""

from __future__ import annotations

import pytest

from tests.cases import examples
from tests.generated.compared import counting_skips
from tests.generated.tasks import document, is_equal, program

# Seeds of the normal run, and of a long one in batches.
SLICE, BATCHES, BATCH = 60, 20, 100


@pytest.mark.slow
def test_a_slice_of_programs_does_the_same_with_loops_skipped() -> None:
    """Iterations are skipped in a fifth of the programs.

    Without that, the comparison would prove nothing.
    """
    found: set[int] = set()
    for seed in range(examples(SLICE)):
        skips: list[int] = []
        with counting_skips(skips):
            document(*program(seed))
        found |= {seed} if skips else set()
        assert is_equal(seed), seed
    assert len(found) >= examples(SLICE) // 5


def test_a_statement_at_the_end_of_a_wait_comes_after_it_with_loops_skipped() -> None:
    """The program polls up to the end of a WAIT at 0.95015 s.

    Its statement there has the computed time 0.9501499999999999.
    """
    assert is_equal(52495)


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_do_the_same_with_loops_skipped(batch: int) -> None:
    first = 1000 + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []
