"""Values that are known before a program runs."""

from __future__ import annotations

from motionlang.kernel import Source
from motionlang.kernel.mint.resolve.folding import fold, given
from motionlang.kernel.mint.resolve.symbols import INTEGER, Function, Symbol, Type
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nesting import LINKS
from motionlang.kernel.mint.syntax.parser import parse
from tests.cases import cases

MAIN = Function("main", "main", [], None)


def value_of(text: str) -> nodes.Expr:
    (statement,) = parse(Source("a.mnt", f"x = {text}")).body
    assert isinstance(statement, nodes.Assign)
    return statement.values[0]


def constants(name: nodes.Name) -> tuple[Symbol | None, None]:
    """Return a symbol: `a` is given at the start, `c` is 5, `v` is a variable."""
    if name.name not in ("a", "c", "v"):
        return None, None
    found = Symbol(name.name, "variable" if name.name == "v" else "const", Type(INTEGER), 0, MAIN)
    found.const = 5 if name.name == "c" else None
    found.given = name.name == "a"
    found.node = nodes.Given(0, 0, "a", False) if found.given else None
    return found, None


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
        # Names of constants, and sums with more terms than are nested.
        ("c + 1", 6),
        ("v + 1", None),
        ("a + 1", None),
        ("1" + " + 1" * 2 * LINKS, 2 * LINKS + 1),
        ("y" + " + 1" * 2 * LINKS, None),
        ("1" + " + 1" * 2 * LINKS + " + y", None),
    ],
)
def test_the_value_of_an_expression(text: str, value: float | str | None) -> None:
    """The type counts, too: 3 and 3.0 differ."""
    found = fold(value_of(text), constants)
    assert (type(found), found) == (type(value), value)


@cases(
    "text, known",
    [
        ("a", "Given(False, 'a')"),
        ("c", "Number(5)"),
        ("2 + 3", "Number(5)"),
        ('"x" & "y"', "String('xy')"),
        ("a + c", "Binary(Given(False, 'a'), '+', Number(5))"),
        ("c + 1 - a", "Binary(Number(6), '-', Given(False, 'a'))"),
        ("-a", "Unary('-', Given(False, 'a'))"),
        ("Not a", "Unary('Not', Given(False, 'a'))"),
        ("v", "None"),
        ("y", "None"),
        ("-v", "None"),
        ("a + v", "None"),
        ("v + a", "None"),
        ("a(1)", "None"),
        ("POS(0)", "None"),
        ("v" + " + 1" * 2 * LINKS, "None"),
        ("a" + " + 1" * 2 * LINKS + " + v", "None"),
    ],
)
def test_an_expression_that_is_known_at_the_start(text: str, known: str) -> None:
    assert repr(given(value_of(text), constants)) == known


def test_a_long_sum_that_is_known_at_the_start_has_all_its_terms() -> None:
    found = given(value_of("a" + " + 1 - c" * LINKS), constants)
    assert isinstance(found, nodes.Chain)
    assert (repr(found.first), len(found.links)) == ("Given(False, 'a')", 2 * LINKS)
    assert [(each.op, repr(each.value)) for each in found.links[:2]] == [
        ("+", "Number(1)"),
        ("-", "Number(5)"),
    ]
