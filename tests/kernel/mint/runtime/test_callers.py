"""The calls that led to a wait or a loop, in deep recursions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from motionlang import run
from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT as MINT

if TYPE_CHECKING:
    from collections.abc import Iterator

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
    waits = run(source).machine.log.waits
    found = [tuple(MINT.locate(source, at)[0] for at in wait.callers) for wait in waits]
    assert found == [*waits_of(50, 0, (2,)), *waits_of(50, 1, (4,))]


MANY = "n = n + TIME\n" * 400
# Programs with labels, and for each wait its line and those of the calls that led there. A GoSub is a call, and what
# follows a label is not.
LABELS: dict[str, tuple[str, list[tuple[int, ...]]]] = {
    "a loop of Gotos": ("WAIT 5\n#a\nWAIT 10\nn = n + 1\nIf n < 2 Then Goto a\nDim n", [(1,), (3,), (3,)]),
    "a sub": ("#a\nS()\nn = n + 1\nIf n < 2 Then Goto a\nDim n\nSub S()\nWAIT 10\nEnd Sub", [(2, 7), (2, 7)]),
    "GoSubs": ("GoSub a\nWAIT 1\nGoSub a\nEnd\n#a\nGoSub b\nWAIT 10\nReturn\n#b\nWAIT 20\nReturn",
               [(1, 6, 10), (1, 7), (2,), (3, 6, 10), (3, 7)]),
    "a label in a sub": ("WAIT 1\nS()\nSub S()\nGoSub a\nExit Sub\n#a\nWAIT 10\nReturn\nEnd Sub", [(1,), (2, 4, 7)]),
    "a task": ("Run t\nWAIT 10\nTask t\nWAIT 1\n#a\nWAIT 2\nn = n + 1\nIf n < 2 Then Goto a\nEnd Task\nDim n",
               [(4,), (6,), (6,), (2,)]),
    # Its code is split: the wait is in a part of the dispatcher.
    "a long sub": ("S()\nSub S()\n#a\n" + MANY + "WAIT 1\n" + MANY + "End Sub\nDim n", [(1, 404)]),
}  # fmt: skip


@pytest.mark.parametrize("name", LABELS)
def test_the_calls_in_a_program_with_labels(name: str) -> None:
    text, expected = LABELS[name]
    source = Source("a.mnt", text)
    log = run(source).machine.log
    found = [tuple(MINT.locate(source, at)[0] for at in (*wait.callers, wait.at)) for wait in log.waits]
    assert found == expected


def test_the_loops_of_gotos_that_an_end_leaves() -> None:
    """The inner one is in a sub, which line 4 calls at 15 ms.

    The outer one begins at label a, at 5 ms.
    """
    text = "WAIT 5\n#a\nWAIT 10\nS()\nGoto a\nSub S()\n#b\nWAIT 20\nIf TIME > 50 Then End\nGoto b\nEnd Sub\n"
    source = Source("a.mnt", text)
    loops = run(source).machine.log.loops
    found = [
        (*(MINT.locate(source, at)[0] for at in (*each.callers, each.at)), round(each.since, 3))
        for each in loops
    ]
    assert (found[0], found[-1]) == ((4, 7, 0.015), (2, 0.005))
