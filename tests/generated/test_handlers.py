"""Programs with TIMER handlers run equally without accelerators: a sample."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang.fast.polled_ticks import PolledTicks
from motionlang.fast.timer_ticks import _Search
from tests.cases import covering
from tests.generated.handlers import PARTS, is_equal, program

# Seeds of the normal run, and of a long one in batches.
SLICE, BATCHES, BATCH = 60, 30, 100


@pytest.mark.slow
def test_a_slice_of_programs_is_the_same_without_accelerators(monkeypatch: pytest.MonkeyPatch) -> None:
    """The sample has every step, condition, action, task and line of the main program.

    Ticks are skipped in a third of the programs. Without that, the comparison would prove nothing.
    """
    seeds = covering(PARTS, SLICE, lambda seed: program(seed)[0])
    found: set[int] = set()

    def counting(skip: Callable[..., None]) -> Callable[..., None]:
        def counted(*given: object) -> None:
            found.add(seed)
            skip(*given)

        return counted

    monkeypatch.setattr(_Search, "skip", counting(_Search.skip))
    monkeypatch.setattr(PolledTicks, "_pass", counting(PolledTicks._pass))
    for seed in seeds:
        assert is_equal(seed), seed
    assert len(found) >= len(seeds) // 3


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_are_the_same_without_accelerators(batch: int) -> None:
    first = SLICE + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []
