"""The range of a variable where it is printed, worked out by hand.

`i` goes from 2 to 5 in a For loop, in which a value is assigned to `y` or a condition is tested.
"""

from __future__ import annotations

from math import inf
from typing import Any

import pytest

from motionlang.fast.ranges import ranges
from motionlang.mint.compile.compiler import compile_module
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.parser import parse
from motionlang.mint.syntax.traversal import walk
from motionlang.source import Source

INTEGER, FLOAT, ANY, BOOL = (-(2**31), 2**31 - 1, "i"), (-inf, inf, "f"), (-inf, inf, "a"), (0, 1, "i")
HEAD = "Dim i As Integer, y As Float, f As Float, a(9) As Integer, b(9) As Float\nConst c = 12\n"


def printed(text: str, name: str = "y") -> Any:
    """Return the range of a variable where it is printed; None if it has none."""
    seen: list[Any] = []

    def observed(function: Any) -> Any:
        found = ranges(function)
        prints = [each for each in walk(function.body) if type(each) is nodes.Print]
        names = [each for each in walk(prints) if type(each) is nodes.Name and each.name.lower() == name]
        seen.extend(found[1].get(id(each)) for each in names)
        return found

    compile_module(parse(Source("a.mnt", HEAD + text)), None, observed)
    (known,) = seen
    return known


@pytest.mark.parametrize(
    ("value", "known"),
    [
        ("i + 3", (5, 8, "i")),
        ("i - 3", (-1, 2, "i")),
        ("3 - i", (-2, 1, "i")),
        ("i * -2", (-10, -4, "i")),
        ("i * (i - 3)", (-5, 10, "i")),
        ("i + i - 1", (3, 9, "i")),
        ("i / 2", FLOAT),
        ("i ^ 2", FLOAT),
        ("i \\ 2", (1, 2, "i")),
        ("i Mod 3", (0, 2, "i")),
        ("i Mod 2.5", ANY),
        ("i & 7", (0, 5, "i")),
        ("i & 3", (0, 3, "i")),
        ("i & -1", INTEGER),
        ("(i - 3) & 7", INTEGER),
        ("i & (i - 3)", INTEGER),
        ("i | 8", INTEGER),
        ("i = 3", BOOL),
        ("i > 1 And i < 4", BOOL),
        ("i > 1 Or i < 4", BOOL),
        ("-i", (-5, -2, "i")),
        ("+i", (2, 5, "i")),
        ("~i", INTEGER),
        ("Not i", BOOL),
        ("2.5", FLOAT),
        ("-2.5", FLOAT),
        ("7", (7, 7, "i")),
        ("c", (12, 12, "i")),
        ("a(i)", INTEGER),
        ("b(i)", ANY),
        ("POS(0)", ANY),
        ("IDLE(0)", BOOL),
        ("_true", (1, 1, "i")),
        ("(i - 2) & 7", (0, 3, "i")),
        # An Integer is checked for overflow; 3 000 000 000 is none, so a product with it is exact.
        ("i * 1000000000", (2 * 10**9, 2**31 - 1, "i")),
        ("-i * 1000000000", (-(2**31), -2 * 10**9, "i")),
        ("i * 3000000000", (6 * 10**9, 15 * 10**9, "i")),
        ("3000000000 * i", (6 * 10**9, 15 * 10**9, "i")),
        ("_true * 1000000000 * i", (2 * 10**9, 2**31 - 1, "i")),
        ("-a(i)", (1 - 2**31, 2**31 - 1, "i")),
    ],
)
def test_the_range_of_a_value(value: str, known: object) -> None:
    assert printed(f"For i = 2 To 5\n  y = {value}\n  PRINT y\nNext") == known


@pytest.mark.parametrize(
    ("condition", "then", "otherwise"),
    [
        ("i > 3", (4, 5), (2, 3)),
        ("i >= 3", (3, 5), (2, 2)),
        ("i < 3", (2, 2), (3, 5)),
        ("i <= 3", (2, 3), (4, 5)),
        ("i = 3", (3, 3), (2, 5)),
        ("i <> 3", (2, 5), (3, 3)),
        ("i <> 2", (3, 5), (2, 2)),
        ("3 < i", (4, 5), (2, 3)),
        ("3 >= i", (2, 3), (4, 5)),
        ("Not i > 3", (2, 3), (4, 5)),
        ("Not Not i > 3", (4, 5), (2, 3)),
        ("i > 2 And i < 5", (3, 4), (2, 5)),
        ("i < 3 Or i < 4", (2, 3), (4, 5)),
        ("Not (i > 2 And i > 3)", (2, 3), (4, 5)),
        ("Not (i < 3 Or i > 4)", (3, 4), (2, 5)),
        ("i > 5", None, (2, 5)),
        ("i > 1", (2, 5), None),
        ("i > 4 And i < 3", None, (2, 5)),
        ("i > 5 Or i > 4", (5, 5), (2, 4)),
        ("i > 4 Or i > 5", (5, 5), (2, 4)),
        ("i + 1 > 3", (2, 5), (2, 5)),
        ("INX(1)", (2, 5), (2, 5)),
    ],
)
def test_a_condition_narrows_a_range(
    condition: str, then: tuple[int, int] | None, otherwise: tuple[int, int] | None
) -> None:
    """None where the condition cannot have this value."""
    text = f"For i = 2 To 5\n  If {condition} Then\n    {{}}\n  Else\n    {{}}\n  End If\nNext"
    for shown, expected in ((("PRINT i", "OUT = 0"), then), (("OUT = 0", "PRINT i"), otherwise)):
        known = printed(text.format(*shown) + "\n", "i")
        assert known == (None if expected is None else (*expected, "i")), shown


@pytest.mark.parametrize(
    ("loop", "known"),
    [
        ("For i = 2 To 5", (2, 5)),
        ("For i = 9 To 3 Step -2", (3, 9)),
        ("For i = 2 To 5 Step 3", (2, 5)),
        ("For i = 2 To a(1)", (2, 2**31 - 1)),
        ("For i = a(1) To 5", (-(2**31), 5)),
        ("For i = 2 To 5 Step a(1)", (-(2**31), 2**31 - 1)),
        ("For i = 2 To 5 Step IDLE(0)", (2, 2**31 - 1)),  # it may be 0
        ("For i = 5 To 2 Step -IDLE(0)", (-(2**31), 5)),
    ],
)
def test_the_range_of_a_counter(loop: str, known: tuple[int, int]) -> None:
    assert printed(f"{loop}\n  PRINT i\nNext", "i") == (*known, "i")


@pytest.mark.parametrize(
    ("loop", "known"),
    [
        ("For i = 2 To 5", (2, 6)),
        ("For i = 9 To 3 Step -2", (1, 9)),
        ("For i = 2 To 5 Step 3", (2, 8)),
    ],
)
def test_the_range_of_a_counter_after_its_loop(loop: str, known: tuple[int, int]) -> None:
    """The last value in the loop plus the step, or the first if there is none."""
    assert printed(f"{loop}\nNext\nPRINT i", "i") == (*known, "i")


def test_a_float_may_count_beyond_the_largest_integer() -> None:
    assert printed("For f = 1 To 2147483647\nNext\nPRINT f", "f") == (1, 2**31, "i")


@pytest.mark.parametrize(
    ("text", "known"),
    [
        ("While y < 3\n  PRINT y\n  y = y + 1\nEnd While", (0, 2, "i")),
        ("#here\ny = y + 1\nIf y < 4 Then Goto here\nPRINT y", (4, 4, "i")),
        ("y = 1\nWhile y < 10\n  PRINT y\n  y = y + 2\nEnd While", (1, 9, "i")),
        ("y = 1\nWhile y < 10\n  y = y + 2\nEnd While\nPRINT y", (10, 11, "i")),
        ("y = 9\nRepeat\n  y = y - 1\n  PRINT y\nUntil y < 4", (3, 8, "i")),
        ("y = 1\nLoop\n  y = 3 - y\n  PRINT y\nEnd Loop", (1, 2, "i")),
        ("For i = 2 To 5\n  y = 3\n  If INX(1) Then y = 7\n  PRINT y\nNext", (3, 7, "i")),
        ("For i = 2 To 5\n  y = 3\n  If INX(1) Then y = 7.5\n  PRINT y\nNext", ANY),
        ("For i = 2 To 5\n  y = 3.5\n  If INX(1) Then y = 7.5\n  PRINT y\nNext", FLOAT),
        ("For i = 2 To 5\n  INPUT y\n  PRINT y\nNext", ANY),
        ("For i = 2 To 5\n  Dim k As Integer = i + 1\n  y = k\n  PRINT y\nNext", (3, 6, "i")),
        ("#here\ny = y + 1\nPRINT y\nIf y < 4 Then Goto here", (1, 4, "i")),
        ("y = 5\nPRINT y", None),
    ],
)
def test_the_range_of_a_variable_of_a_loop(text: str, known: object) -> None:
    assert printed(text) == known
