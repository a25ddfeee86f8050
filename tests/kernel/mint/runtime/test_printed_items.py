"""PRINT: items of texts and numbers, in their order."""

from __future__ import annotations

from motionlang import run
from motionlang.kernel import Source
from tests.cases import cases


@cases(
    "items, line",
    [
        ('"x"; "y"', "xy"),
        ('"x"; s; "y"', "xqy"),
        ('"x"; s + "z"; "y"', "xqzy"),
        ('"x"; "z" + s; "y"', "xzqy"),
        ('"z" + s; "y"; "x" + s', "zqyxq"),
        ('s; "z" + s; s + "y"; "x"', "qzqqyx"),
        ('IIf(n, s, "b"); "y"', "qy"),
        ('"x"; IIf(n = 0, s, "b"); "y"', "xby"),
        ('"x"; n; "y"; n + 1', "x2y3"),
    ],
)  # fmt: skip
def test_items_are_printed_one_after_the_other(items: str, line: str) -> None:
    """A semicolon adds nothing between two items."""
    text = f'Dim s As String, n As Integer\ns = "q" : n = 2\nPRINT {items}'
    assert run(Source("a.mnt", text)).output == [line]
