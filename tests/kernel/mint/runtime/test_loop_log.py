"""The loops and subs in the log: from when to when each took, and who called it."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT
from tests.cases import cases

COUNT = "For n = 1 To {}\nk = k + 1\nNext\n"
# Program, and for each loop or sub its line, its start and end in ms, and the lines of the calls around it. A statement
# takes 10 us, and so does each Next.
LOOPS: list[tuple[str, list[tuple[int, float, float, tuple[int, ...]]]]] = [
    # A record needs more than a hundred statements, or a wait.
    (COUNT.format(50), []),
    (COUNT.format(51), [(2, 0.0, 1.02, ())]),
    ("WAIT 50\n" + COUNT.format(50), []),
    ("WAIT 50\n" + COUNT.format(51), [(3, 50.0, 51.02, ())]),
    ("WAIT 50\nWhile k < 3\nWAIT 20\nk = k + 1\nEnd While", [(3, 50.0, 110.0, ())]),
    ("WAIT 50\nRepeat\nWAIT 20\nk = k + 1\nIf k = 3 Then Exit Repeat\nUntil k > 9", [(3, 50.0, 110.0, ())]),
    # The loop in a sub has its call. So has the sub, if it computes for more than a hundred statements.
    (
        "WAIT 50\nTwice\nWAIT 30\nTwice\nEnd\nSub Twice\nFor n = 1 To 2\nWAIT 10\nNext\nEnd Sub",
        [(8, 50.0, 70.0, (3,)), (8, 100.0, 120.0, (5,))],
    ),
    (
        "Outer\nEnd\nSub Outer\nWAIT 20\nInner\nEnd Sub\nSub Inner\n" + COUNT.format(60) + "End Sub",
        [(9, 20.0, 21.2, (2, 6)), (8, 20.0, 21.2, (2, 6))],
    ),
    ("WAIT 50\nFor n = 1 To 3\nIf n = 2 Then Goto done\nNext\ndone:\nWAIT 3", []),
    # A jump ends the loops that it leaves, the inner one first.
    (
        "WAIT 50\nFor n = 1 To 3\nLoop\nWAIT 10\nk = k + 1\nIf k = 4 Then Goto done\nEnd Loop\nNext\ndone:\nWAIT 3",
        [(4, 50.0, 90.0, ()), (3, 50.0, 90.0, ())],
    ),
]  # fmt: skip


@cases("text, expected", LOOPS)
def test_the_loops_of_a_program(text: str, expected: list[tuple[int, float, float, tuple[int, ...]]]) -> None:
    source = Source("a.mnt", f"Dim k As Integer, n As Integer\n{text}")
    found = list(run(source).machine.log.loops)
    lines = [(DIALECT.locate(source, each.at)[0], each.callers) for each in found]
    assert [(line, tuple(DIALECT.locate(source, at)[0] for at in callers)) for line, callers in lines] == [
        (line, callers) for line, _, _, callers in expected
    ]
    for each, (_, since, until, _) in zip(found, expected, strict=True):
        assert (1e3 * each.since, 1e3 * each.until) == pytest.approx((since, until), abs=0.3)
        assert each.task == "ParentTask"


def test_a_task_that_ends_itself_ends_its_loops() -> None:
    text = "Run Side\nWAIT 500\nEnd\nTask Side\nDeep\nEnd Task\nSub Deep\nLoop\nWAIT 100\nEnd Side\nEnd Loop\nEnd Sub"
    source = Source("a.mnt", text)
    found = list(run(source).machine.log.loops)
    assert [(each.task, DIALECT.locate(source, each.at)[0], len(each.callers)) for each in found] == [
        ("side", 8, 1)
    ]
    for each in found:
        assert (each.since, each.until) == pytest.approx((0.0, 0.1), abs=3e-4)
