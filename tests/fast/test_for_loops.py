"""Counted loops run in chunks, without a visible difference."""

from __future__ import annotations

from random import Random

import pytest

from motionlang import run
from motionlang.fast.ranges import ranges
from motionlang.lang import scheduler
from motionlang.mint.compile import for_loops
from motionlang.mint.compile.compiler import compile_module
from motionlang.mint.syntax.parser import parse
from motionlang.source import Source
from tests.cases import cases, examples
from tests.mint.programs import Writer

TICKS = """
End
Event TIMER
  PRINT "tick ", TIME
End Event
"""
LOOPS = {
    "a branch": "For i = 1 To 500\n  If i Mod 3 = 0 Then x = x + 1\nNext",
    "downward": "For i = 500 To 1 Step -3\n  If i > 100 Then\n    x = i\n    y = i\n  End If\nNext",
    "nothing": "For i = 1 To 700\nNext",
    "no iteration": "For i = 5 To 1\nNext",
    "one iteration": "For i = 5 To 5\n  x = 1\nNext",
    "two levels": "For i = 1 To 20\n  For j = 1 To i\n    x = x + 1\n  Next\nNext",
    "a limit that is worked out": "n = 400\nFor i = 1 To n \\ 2 + 3\n  n = 5\nNext",
    "a choice": "For i = 1 To 400\n  Select Case i Mod 4\n  Case 0\n    x = 1\n  Case 1\n    x = 2 : y = 3\n"
    "  End Select\nNext",
}


# A duration without a period that is its multiple: at a tie, rounding decides the first statement.
COST = 0.7310585e-3


def timeline(text: str) -> tuple[list[str], float]:
    result = run(Source("a.mnt", text), machine={"controller.instruction_time": COST}, cache=False)
    assert not result.diagnostics
    return result.output, result.time


@pytest.mark.parametrize("loop", LOOPS.values(), ids=LOOPS.keys())
@pytest.mark.parametrize("period", [0, 7, 50, 333])
def test_loop_in_chunks_yields_at_the_same_times(
    loop: str, period: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = f"TIMEREVENT = {period}\n{loop}\nPRINT i, x, y, TIME{TICKS}"
    text = text.replace("TIMEREVENT", "x = 0 : y = 0\nTIMEREVENT")
    in_chunks = timeline(text)
    monkeypatch.setattr(for_loops, "_can_be_cut", lambda *_: False)
    stepwise = timeline(text)
    assert in_chunks[0] == stepwise[0]
    assert in_chunks[1] == pytest.approx(stepwise[1], abs=1e-9)


def test_such_loops_are_cut() -> None:
    text = compile_module(parse(Source("a.mnt", LOOPS["a branch"])), None, ranges).code.text
    assert "for v_i in range(" in text


@cases(
    "loop",
    [
        "For i = 1 To 9\n  PRINT i\nNext",
        "For i = 1 To 9\n  If i = 5 Then Exit For\nNext",
        "For i = 1 To 9\n  i = i + 1\nNext",
        "For i = 0 To 9 Step 0.5\nNext",
        "For i = 1 To 9\n  WAIT = 1\nNext",
        "For i = 1 To 2147483647\nNext\nDim i As Integer",
    ],
)
def test_others_are_not(loop: str) -> None:
    assert "for v_i in range(" not in compile_module(parse(Source("a.mnt", loop)), None, ranges).code.text


@cases("seed", range(examples(60)))
def test_random_programs_take_the_same_time(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    source = Source("a.mnt", Writer(Random(seed)).program())
    in_chunks = run(source, cache=False)
    monkeypatch.setattr(for_loops, "_can_be_cut", lambda *_: False)
    stepwise = run(source, cache=False)
    assert in_chunks.output == stepwise.output
    assert in_chunks.time == pytest.approx(stepwise.time, abs=1e-9)


WORK = "For i = 1 To 3000\n  x = x + i\n  If x > 500 Then x = 0\nNext\n"
TWO = f"""Dim done As Integer
Run A : Run B
PAUSE done = 2
PRINT "all at ", TIME
End
Task A
  Dim i As Integer, x As Integer
  {WORK}
  done = done + 1
  PRINT "A at ", TIME
End Task
Task B
  Dim i As Integer, x As Integer
  {WORK}
  {WORK}
  done = done + 1
  PRINT "B at ", TIME
End Task
"""


def test_computing_tasks_take_long_slices_and_end_at_the_same_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """End times agree to the duration of an iteration, since slices end with one."""
    long_turns = timeline(TWO)
    monkeypatch.setattr(scheduler.Scheduler, "_slice_length", lambda *_: 1e-3)
    short_turns = timeline(TWO)
    assert [line.split()[0] for line in long_turns[0]] == ["A", "B", "all"]
    assert long_turns[1] == pytest.approx(short_turns[1], rel=0.01)
    for one, other in zip(long_turns[0], short_turns[0], strict=True):
        assert int(one.split()[-1]) == pytest.approx(int(other.split()[-1]), rel=0.01)
