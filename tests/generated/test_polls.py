"""Programs that poll with a TIMER have the same result without accelerators."""

from __future__ import annotations

from typing import Any

import pytest

from motionlang.fast.polled_ticks import PolledTicks
from tests.cases import examples
from tests.generated.polls import is_equal

# Seeds of the normal run, and of a long one in batches.
SLICE, BATCHES, BATCH = 40, 30, 100


@pytest.mark.slow
def test_a_slice_of_programs_is_the_same_without_accelerators(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ticks are skipped in a quarter of the programs.

    Without that, the comparison would prove nothing.
    """
    found: set[int] = set()
    passed = PolledTicks._pass

    def counted(self: PolledTicks, walk: Any, *given: Any) -> None:
        found.add(seed)
        passed(self, walk, *given)

    monkeypatch.setattr(PolledTicks, "_pass", counted)
    for seed in range(examples(SLICE)):
        assert is_equal(seed), seed
    assert len(found) >= examples(SLICE) // 4


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_are_the_same_without_accelerators(batch: int) -> None:
    first = SLICE + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []
