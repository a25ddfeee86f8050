"""Programs of each family do the same with identical iterations skipped and with none skipped."""

from __future__ import annotations

from typing import Any

import pytest

from tests.cases import covering, examples
from tests.generated import clocks, handlers, nested_loops, never, polls, tasks
from tests.generated.compared import counting_skips

# The family, the seeds of a normal run, and of a long one in batches of 100.
FAMILIES: dict[str, tuple[Any, int, int]] = {
    "clocks": (clocks, 20, 20),
    "handlers": (handlers, 60, 30),
    "loops in loops": (nested_loops, 40, 20),
    "scans": (never, 20, 20),
    "polls": (polls, 40, 30),
    "tasks": (tasks, 60, 20),
}
BATCHES = [
    (name, 1000 + 100 * batch) for name, (_, _, batches) in FAMILIES.items() for batch in range(batches)
]
# Seeds of programs that an earlier rule skipped too far, gave up too early, or ran a statement of before its wait.
FOUND = [("scans", 5285), ("scans", 5681), ("scans", 6582), ("tasks", 52495)]
SLOWLY_FOUND = [pytest.param("clocks", seed, marks=pytest.mark.slow) for seed in (20157, 20574)]


@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=() if name == "loops in loops" else pytest.mark.slow) for name in FAMILIES],
)
def test_a_slice_of_programs_does_the_same(name: str) -> None:
    family, count, _ = FAMILIES[name]
    assert [seed for seed in range(examples(count)) if not family.is_equal(seed)] == []


@pytest.mark.slow
@pytest.mark.parametrize(("family", "share"), [(handlers, 3), (polls, 4), (tasks, 5)])
def test_iterations_are_skipped_in_a_share_of_the_programs(family: Any, share: int) -> None:
    """The comparison would prove nothing without that."""
    found = 0
    for seed in range(examples(40)):
        skips: list[int] = []
        with counting_skips(skips):
            getattr(family, "document", handlers.document)(*family.program(seed))
        found += bool(skips)
    assert found >= examples(40) // share


def test_the_handlers_have_every_part() -> None:
    assert covering(handlers.PARTS, 60, lambda seed: handlers.program(seed)[0])


@pytest.mark.parametrize(("name", "seed"), [*FOUND, *SLOWLY_FOUND])
def test_a_program_that_once_differed(name: str, seed: int) -> None:
    assert FAMILIES[name][0].is_equal(seed)


@pytest.mark.long
@pytest.mark.parametrize(("name", "first"), BATCHES)
def test_programs_do_the_same(name: str, first: int) -> None:
    assert [seed for seed in range(first, first + 100) if not FAMILIES[name][0].is_equal(seed)] == []
