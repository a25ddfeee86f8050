"""A loop that takes the time does the same with identical iterations skipped and with none skipped."""

from __future__ import annotations

import pytest

from motionlang.kernel.execution import run
from motionlang.kernel.source import Source
from tests.cases import examples
from tests.generated.clocks import is_equal
from tests.generated.compared import counting_skips

# Seeds of the normal run, of a long one in batches, and of programs that an earlier rule skipped too far.
SLICE, BATCHES, BATCH = 20, 20, 100
FOUND = (20157, 20574)
IDLE = """\
tt = TIME
REPEAT
  IF NOT INX.0 AND NOT INX.1 THEN tt = TIME
UNTIL (INX.0 AND INX.1) OR TIME - tt > 500
? TIME
"""
IN_A_SUB = """\
s = 1
LOOP
  IF s = 1 THEN GOSUB HANDS
  IF s = 2 THEN ? TIME : END
ENDL
#HANDS
  IF NOT INX.0 AND NOT INX.1 THEN tt = TIME : RETURN
  IF INX.0 AND INX.1 THEN s = 2 : RETURN
  IF TIME - tt > 500 THEN s = 2
  WHILE INX.3
  ENDW
RETURN
"""


@pytest.mark.parametrize("program", [IDLE, IN_A_SUB])
@pytest.mark.parametrize(("inputs", "end"), [(((0, 29), (1, 29.2)), 29.2), (((0, 29), (1, 30)), 29.501)])
def test_a_loop_that_takes_the_time_is_skipped(
    program: str, inputs: tuple[tuple[int, float], ...], end: float
) -> None:
    entries = [{"channel": channel, "at": at} for channel, at in inputs]
    skips: list[int] = []
    with counting_skips(skips):
        made = run(Source("a.prg", program), machine={"input": entries})
    assert (made.status, len(made.machine.log.prints)) == ("ended", 1)
    assert made.time == pytest.approx(end, abs=0.001)
    assert sum(skips) > 280_000


@pytest.mark.slow
@pytest.mark.parametrize("seed", FOUND)
def test_a_program_that_was_skipped_too_far(seed: int) -> None:
    assert is_equal(seed)


@pytest.mark.slow
def test_a_slice_of_programs_does_the_same() -> None:
    assert [seed for seed in range(examples(SLICE)) if not is_equal(seed)] == []


@pytest.mark.long
@pytest.mark.parametrize("batch", range(BATCHES))
def test_programs_do_the_same(batch: int) -> None:
    first = SLICE + batch * BATCH
    assert [seed for seed in range(first, first + BATCH) if not is_equal(seed)] == []
