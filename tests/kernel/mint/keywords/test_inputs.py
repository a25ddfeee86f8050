"""Debounced inputs of Mint, compared with a model that samples the level."""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.kernel import Source
from tests.cases import examples

edges = st.lists(st.integers(1, 200), min_size=1, max_size=12, unique=True).map(sorted)


def sampled(times: list[int], samples: int) -> list[str]:
    """Return the debounced states and their times, ms, with level changes at times in half milliseconds.

    The state changes after `samples` equal samples of the level, one each millisecond.
    """
    found, state, level, count = [], False, False, 0
    for now in range(300):
        level = level is not (now in times)
        if samples == 1 or now % 2 == 0:
            count = count + 1 if level is not state else 0
            if count == samples:
                state, count = level, 0
                found.append(f"{state:d} {now // 2}")
    return found


@settings(max_examples=examples(200))
@given(edges, st.integers(1, 10))
def test_debouncing_is_what_sampling_would_see(times: list[int], samples: int) -> None:
    text = f"""\
INPUTDEBOUNCE(0) = {samples}
Loop
  PAUSE INX(3) : PRINT "1 "; TIME
  PAUSE INX(3) = 0 : PRINT "0 "; TIME
End Loop
"""
    entries = [{"channel": 3, "at": time / 2000, "value": (k + 1) % 2} for k, time in enumerate(times)]
    machine = {"controller.instruction_time": 1e-9, "input": entries}
    assert run(Source("a.mnt", text), machine=machine, until=0.15).output == sampled(times, samples)
