"""A loop that takes the time is skipped up to the event that ends it."""

from __future__ import annotations

import pytest

from motionlang.kernel.execution import run
from motionlang.kernel.source import Source
from tests.generated.compared import counting_skips

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
