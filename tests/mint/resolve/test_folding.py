"""Values that are known before a program runs."""

from __future__ import annotations

from motionlang.mint.resolve.folding import fold
from motionlang.mint.resolve.symbols import Symbol
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.parser import parse
from motionlang.source import Source
from tests.cases import cases


def folded(text: str) -> float | str | None:
    """Return the value of an expression, in which every name is unknown."""
    (statement,) = parse(Source("a.mnt", f"x = {text}")).body
    assert isinstance(statement, nodes.Assign)

    def means(name: nodes.Name) -> tuple[Symbol | None, None]:
        return None, None

    return fold(statement.values[0], means)


@cases(
    "text, value",
    [
        ("5", 5),
        ('"a"', "a"),
        ('"a" + "b" & "c"', "abc"),
        ('"a" - "b"', None),
        ('"a" + 1', None),
        ('-"a"', None),
        ("y", None),
        ("1 + y", None),
        ("1 + 2 * 3 - y", None),
        ("1 + 2 * 3 - 4", 3),
        ("-5 + +3", -2),
        ("Not 5", 0),
        ("Not 0", 1),
        ("~5", -6),
        ("~2.5", None),
        ("7 / 2", 3.5),
        ("7 / 0", None),
        ("-7 \\ 2", -3),
        ("-7 Mod 4", -3),
        ("7 Mod 0", None),
        ("2 ^ 10", 1024.0),
        ("1 << 4 | 3", 19),
        ("-8 >> 1", -4),
        ("12 & 10", 8),
        ("12 Xor 10", 6),
        ("2.9 & 3", 2),
        ("3 = 3.0", 1),
        ("3 <> 3", 0),
        ("2 < 3", 1),
        ("3 < 3", 0),
        ("3 > 3", 0),
        ("4 > 3", 1),
        ("3 <= 3", 1),
        ("4 <= 3", 0),
        ("3 >= 3", 1),
        ("3 >= 4", 0),
        ("2 And 3", 1),
        ("2 And 0", 0),
        ("0 Or 3", 1),
        ("0 Or 0", 0),
        # An Integer that overflows is reported at run time; a Float is exact.
        ("2147483646 + 1", 2147483647),
        ("2147483647 + 1", None),
        ("-2147483647 - 1", -2147483648),
        ("-2147483647 - 2", None),
        ("2147483647 * 2.0", 4294967294.0),
        ("0.5 + 2147483647", 2147483647.5),
    ],
)
def test_the_value_of_an_expression(text: str, value: float | str | None) -> None:
    """The type counts, too: 3 and 3.0 differ."""
    found = folded(text)
    assert (type(found), found) == (type(value), value)
