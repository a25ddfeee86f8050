"""The calls that led to a wait or a loop, in deep recursions."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from motionlang import run
from motionlang.lang import task
from motionlang.mint import DIALECT as MINT
from motionlang.source import Source

if TYPE_CHECKING:
    from collections.abc import Iterator
    from types import FrameType

# Each call waits, calls itself in line 9 or 11, at 20 once more in line 13, and waits again.
DOWN = """\
Dim side As Integer
Down(50)
side = 1
Down(50)
End
Sub Down(ByVal n As Integer)
  WAIT = 1
  If n = 0 Then Exit Sub
  If n Mod 2 = side Then Down(n - 1)
  If n Mod 2 <> side Then
    Down(n - 1)
  End If
  If n = 20 Then Down(n - 1)
  WAIT = 1
End Sub
"""


def waits_of(n: int, side: int, calls: tuple[int, ...]) -> Iterator[tuple[int, ...]]:
    """Yield the lines of the calls that lead to each wait of `Down(n)`."""
    yield calls
    if n:
        yield from waits_of(n - 1, side, (*calls, 9 if n % 2 == side else 11))
        if n == 20:
            yield from waits_of(n - 1, side, (*calls, 13))
        yield calls


def test_each_wait_of_a_recursion_has_the_calls_that_led_to_it() -> None:
    """Calls from another line replace the cached ones."""
    source = Source("a.mnt", DOWN)
    waits = run(source, cache=False).machine.log.waits
    found = [tuple(MINT.locate(source, at)[0] for at in wait.callers) for wait in waits]
    assert found == [*waits_of(50, 0, (2,)), *waits_of(50, 1, (4,))]


# The deepest call waits, so that every loop around it is logged.
LOOPS = """\
Down({})
End
Sub Down(ByVal n As Integer)
  If n = 0 Then WAIT = 5 : Exit Sub
  Repeat
    Down(n - 1)
  Until 1
End Sub
"""


def lines_to_find_calls(depth: int) -> int:
    """Return how many lines of `task.py` a run executes.

    The run leaves `depth` loops, each in a call of its own.
    """
    lines = 0

    def line(_frame: FrameType, _event: str, _argument: object) -> Any:
        nonlocal lines
        lines += 1
        return line

    def call(frame: FrameType, _event: str, _argument: object) -> Any:
        return line if frame.f_code.co_filename == task.__file__ else None

    before = sys.gettrace()
    sys.settrace(call)
    try:
        result = run(Source("a.mnt", LOOPS.format(depth)), cache=False)
    finally:
        sys.settrace(before)
    assert [len(loop.callers) for loop in result.machine.log.loops] == list(range(depth, 0, -1))
    return lines


def test_to_leave_twice_the_calls_takes_twice_the_work() -> None:
    once, twice = lines_to_find_calls(100), lines_to_find_calls(200)
    assert twice < 2.2 * once
