"""TIME and Time variables count whole milliseconds below 0, too."""

from __future__ import annotations

import pytest

from motionlang import run
from motionlang.source import Source

COUNTS = ("", "TIME"), ("Dim t As Time\n", "t")


@pytest.mark.parametrize(("head", "count"), COUNTS)
def test_each_millisecond_below_zero_has_its_own_count(head: str, count: str) -> None:
    text = f"{head}{count} = -3\nPRINT {count}\nFor n = 1 To 4\nWAIT(1)\nPRINT {count}\nNext"
    assert printed(text) == ["-3", "-2", "-1", "0", "1"]


@pytest.mark.parametrize(("head", "count"), COUNTS)
def test_loop_sees_a_count_below_zero(head: str, count: str) -> None:
    text = f"{head}{count} = -5\nWhile done = 0\nIf {count} = -2 Then done = 1\nEnd While\nPRINT {count}"
    assert printed(text) == ["-2"]


def printed(text: str) -> list[str]:
    result = run(Source("a.mnt", text), cache=False, until=1.0)
    assert [each.message for each in result.diagnostics] == []
    return result.output
