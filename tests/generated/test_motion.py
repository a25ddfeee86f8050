"""A sample of generated motion programs is proved, consistent and reproducible."""

from __future__ import annotations

import pytest

from motionlang import Run, run
from motionlang.kernel import Source
from tests.cases import examples
from tests.generated.checks import findings
from tests.generated.motion import UNTIL, generate

# Seeds of the sample in CI, and of a long run in batches.
FIRST, SLICE, BATCHES, BATCH = 1, 200, 20, 1000


@pytest.mark.slow
def test_programs_of_a_slice_of_seeds_have_no_finding() -> None:
    for seed in range(FIRST, FIRST + examples(SLICE)):
        assert findings(generate(seed)) == [], f"python -m tests.generated --show {seed}"


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_of_many_seeds_have_no_finding(batch: int) -> None:
    first = 10_000 + batch * BATCH
    found = {seed: messages for seed in range(first, first + BATCH) if (messages := findings(generate(seed)))}
    assert found == {}


def test_a_seed_always_gives_the_same_program_and_others_differ() -> None:
    once = [generate(seed) for seed in range(40)]
    assert once == [generate(seed) for seed in range(40)]
    assert len({program.text for program in once}) == 40
    assert {program.language for program in once} == {"mint", "mccl"}


@pytest.mark.slow
def test_programs_are_grammatical_and_most_of_them_move() -> None:
    """None is rejected before it runs, and nine in ten start a move."""
    moved = 0
    for seed in range(60):
        program = generate(seed)
        result: Run = run(Source(program.name, program.text), machine=program.machine, until=UNTIL)
        assert not [
            each for each in result.diagnostics if each.code in ("syntax", "unknown-word", "values", "type")
        ]
        moved += any(True for _ in result.controller.log.moves)
    assert moved >= 54
