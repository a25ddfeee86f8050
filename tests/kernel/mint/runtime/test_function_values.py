"""Functions and operators at their bounds, of constants and of variables.

The compiler computes an expression of constants before the run, and the run computes one of variables.
"""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

LOW = -2147483648

# An expression of `a`, `b` and `c`, their values, and what PRINT shows.
VALUES: list[tuple[str, tuple[object, ...], str]] = [
    ("Left(a, b)", ("Mint", 0), ""),
    ("Left(a, b)", ("Mint", 3), "Min"),
    ("Left(a, b)", ("Mint", 9), "Mint"),
    ("Right(a, b)", ("Mint", 0), ""),
    ("Right(a, b)", ("Mint", 1), "t"),
    ("Right(a, b)", ("Mint", 9), "Mint"),
    ("Mid(a, b)", ("Mint", 1), "Mint"),
    ("Mid(a, b)", ("Mint", 4), "t"),
    ("Mid(a, b)", ("Mint", 5), ""),
    ("Mid(a, b, c)", ("Mint", 2, 2), "in"),
    ("Mid(a, b, c)", ("Mint", 1, 0), ""),
    ("Mid(a, b, c)", ("Mint", 4, 5), "t"),
    ("Len(a)", ("",), "0"),
    ("Len(a)", ("Mint",), "4"),
    ("Asc(a)", ("",), "0"),
    ("Asc(a)", ("At",), "65"),
    ("Asc(Chr(a))", (255,), "255"),
    ("Asc(Chr(a))", (1,), "1"),
    ("Val(a)", ("",), "0.0000"),
    ("Val(a)", ("mm",), "0.0000"),
    ("Val(a)", ("  12abc",), "12.0000"),
    ("Val(a)", ("-3.5e2x",), "-350.0000"),
    ("Val(a)", (".5",), "0.5000"),
    ("Val(a)", ("5.",), "5.0000"),
    ("Val(a)", ("1_000",), "1.0000"),
    ("Val(a)", ("1.5e",), "1.5000"),
    ("a \\ b", (7, 2), "3"),
    ("a \\ b", (-7, 2), "-3"),
    ("a \\ b", (7, -2), "-3"),
    ("a \\ b", (-7, -2), "3"),
    ("a \\ b", (0, -5), "0"),
    ("a \\ b", (5, -1), "-5"),
    ("a Mod b", (7, 2), "1"),
    ("a Mod b", (-7, 2), "-1"),
    ("a Mod b", (7, -2), "1"),
    ("a Mod b", (-7, -7), "0"),
    ("a Mod b", (-7.5, 2.0), "-1.5000"),
    ("a Mod b", (7.5, -2.0), "1.5000"),
    ("a << b", (1, 31), str(LOW)),
    ("a << b", (1, 30), "1073741824"),
    ("a << b", (3, 31), str(LOW)),
    ("a << b", (1, 32), "0"),
    ("a << b", (-1, 31), str(LOW)),
    ("a << b", (5, 0), "5"),
    ("a >> b", (-8, 1), "-4"),
    ("a >> b", (-1, 40), "-1"),
    ("a >> b", (2147483647, 30), "1"),
    ("a >> b", (2147483647, 32), "0"),
    ("a ^ b", (2, 10), "1024.0000"),
    ("a ^ b", (2.0, -1.0), "0.5000"),
    ("a ^ b", (0.0, 0.0), "1.0000"),
    ("Abs(a)", (-2147483647,), "2147483647"),
    ("Abs(a)", (-0.5,), "0.5000"),
    ("Sgn(a)", (-3,), "-1"),
    ("Int(a)", (3.99,), "3"),
    ("Int(a)", (-3.99,), "-3"),
    ("Int(a)", (2147483647.5,), "2147483647"),
    ("Int(a)", (-2147483648.5,), str(LOW)),
    ("Min(a, b)", (3, -4), "-4"),
    ("Max(a, b)", (3.5, -4.5), "3.5000"),
    ("Sqrt(a)", (6.25,), "2.5000"),
    ("Sqrt(a)", (0.0,), "0.0000"),
    ("Exp(a)", (0.0,), "1.0000"),
    ("Log(a)", (1.0,), "0.0000"),
    ("Sin(a)", (30.0,), "0.5000"),
    ("Sin(a)", (390.0,), "0.5000"),
    ("Sin(a)", (-30.0,), "-0.5000"),
    ("Sin(a) = 0.5", (150.0,), "1"),
    ("Sin(a) = -1", (270.0,), "1"),
    ("Sin(a) = -0.5", (210.0,), "1"),
    ("Sin(a) = -0.5", (330.0,), "1"),
    ("Sin(a) = 0", (180.0,), "1"),
    ("Sin(a) = 1", (-270.0,), "1"),
    ("Sin(a)", (45.0,), "0.7071"),
    ("Cos(a) = 0", (90.0,), "1"),
    ("Cos(a) = 0.5", (60.0,), "1"),
    ("Cos(a)", (120.0,), "-0.5000"),
    ("Cos(a)", (45.0,), "0.7071"),
    ("Tan(a) = 1", (45.0,), "1"),
    ("Tan(a) = 1", (225.0,), "1"),
    ("Tan(a) = -1", (135.0,), "1"),
    ("Tan(a) = -1", (-45.0,), "1"),
    ("Tan(a) = 0", (180.0,), "1"),
    ("Tan(a)", (60.0,), "1.7321"),
    ("Asin(a)", (1.0,), "90.0000"),
    ("Acos(a)", (-1.0,), "180.0000"),
    ("Atan(a)", (-1.0,), "-45.0000"),
    ("Str(a)", (1.5,), "1.5000"),
    ("Str(a)", (-15,), "-15"),
    # Comparisons, of numbers of both kinds and of texts, give 1 or 0.
    *(
        (f"a {operator} b", values, str(int(truth)))
        for values, less, equal in (
            ((1, 2), True, False),
            ((2, 2), False, True),
            ((3, 2), False, False),
            ((1.5, 2), True, False),
            ((2.0, 2), False, True),
            ((-1.5, -2.5), False, False),
            (("A", "B"), True, False),
            (("B", "B"), False, True),
            (("AB", "A"), False, False),
        )
        for operator, truth in (
            ("<", less),
            ("<=", less or equal),
            (">", not (less or equal)),
            (">=", not less),
            ("=", equal),
            ("<>", not equal),
        )
    ),
    ("a And b", (6, 3), "1"),
    ("a And b", (6, 0), "0"),
    ("a Or b", (0, 0), "0"),
    ("a Or b", (0, 4), "1"),
    ("Not a", (0,), "1"),
    ("Not a", (5,), "0"),
    ("Not a", (0.5,), "0"),
    ("a & b", (6, 3), "2"),
    ("a | b", (6, 3), "7"),
    ("a Xor b", (6, 3), "5"),
    ("~a", (0,), "-1"),
    ("~a", (5,), "-6"),
    ("a & b", (-1, 255), "255"),
    ("a & b", ("ab", "cd"), "abcd"),
    ("a + b", ("ab", "cd"), "abcd"),
    ("a + b * c", (1, 2, 3), "7"),
    ("(a + b) * c", (1, 2, 3), "9"),
    ("a - b - c", (9, 3, 2), "4"),
    ("a / b / c", (9, 3, 2), "1.5000"),
    ("a / b", (7, 2), "3.5000"),
    ("a / b", (6, 2), "3.0000"),
    ("-a ^ b", (2, 2), "4.0000"),
    ("a ^ b ^ c", (2, 3, 2), "64.0000"),
    ("a * b + c", (1.5, 2, 0.25), "3.2500"),
    ("a + b > c And c > b", (2, 2, 3), "1"),
    ("a < b Or b < c And c < a", (1, 2, 0), "1"),
    ("a = b = c", (2, 2, 1), "1"),
    ("a Mod b * c", (7, 4, 2), "6"),
    ("a \\ b * c", (7, 2, 3), "9"),
    ("a << b + c", (1, 2, 1), "8"),
    ("a - -b", (1, 2), "3"),
    ("-a", (LOW + 1,), "2147483647"),
    ("a + b", (2147483646, 1), "2147483647"),
    ("a * b", (65536, -32768), str(LOW)),
    # Floats: four decimals from 1e-4 up to 1e9, and an exponent outside.
    ("a", (999999999.0,), "999999999.0000"),
    ("a", (-999999999.0,), "-999999999.0000"),
    ("a", (1e9,), "1.000000e+09"),
    ("a", (-1e9,), "-1.000000e+09"),
    ("a", (0.0001,), "0.0001"),
    ("a", (-0.0001,), "-0.0001"),
    ("a", (0.00009,), "9.000000e-05"),
    ("a", (-0.00009,), "-9.000000e-05"),
    ("a", (0.0,), "0.0000"),
    ("a * b", (-1.0, 0.0), "0.0000"),
    # USING: a negative width shows a sign, negative decimals an exponent, and no number is cut.
    ("a USING b", (5, 4), "   5"),
    ("a USING b", (5, -4), "  +5"),
    ("a USING b", (-5, -4), "  -5"),
    ("a USING b", (12345, 2), "12345"),
    ("a USING b, c", (3, 6, 2), "  3.00"),
    ("a USING b, c", (1.5, -7, 1), "   +1.5"),
    ("a USING b, c", (1.5, 8, -2), "1.50e+00"),
    ("a USING b, c", (1.5, 6, 0), "     2"),
    ("a USING b", (2.6, 3), "  3"),
    ("a USING b, c", (-0.001, 5, 1), "  0.0"),
    ("a USING b", ("ab", 4), "ab  "),
    ("a USING b", ("ab", -4), "  ab"),
    ("a USING b", ("abc", 2), "abc"),
]
# Expressions of values for which there is none, and the message.
REFUSED: list[tuple[str, tuple[object, ...], str]] = [
    ("Left(a, b)", ("Mint", -1), "a number of characters cannot be -1"),
    ("Right(a, b)", ("Mint", -1), "a number of characters cannot be -1"),
    ("Mid(a, b)", ("Mint", 0), "the first character of a text has position 1"),
    ("Mid(a, b, c)", ("Mint", 1, -1), "a number of characters cannot be -1"),
    ("Chr(a)", (256,), "there is no character 256"),
    ("Chr(a)", (-1,), "there is no character -1"),
    ("a \\ b", (LOW, -1), "2147483648 does not fit an Integer"),
    ("a \\ b", (1, 0), "division by zero"),
    ("a Mod b", (1, 0), "division by zero"),
    ("a ^ b", (0.0, -1.0), "division by zero"),
    ("a ^ b", (-2.0, 0.5), "^ has no value for -2, 0.5"),
    ("a << b", (1, -1), "bits cannot be shifted by -1 positions"),
    ("a >> b", (1, -1), "bits cannot be shifted by -1 positions"),
    ("a + b", (2147483647, 1), "2147483648 does not fit an Integer"),
    ("a - b", (LOW, 1), "-2147483649 does not fit an Integer"),
    ("a * b", (65536, 32768), "2147483648 does not fit an Integer"),
    ("-a", (LOW,), "2147483648 does not fit an Integer"),
    ("a / b", (1, 0), "division by zero"),
    ("Abs(a)", (LOW,), "2147483648 does not fit an Integer"),
    ("Int(a)", (2147483648.0,), "2147483648 does not fit an Integer"),
    ("Int(a)", (-2147483649.0,), "-2147483649 does not fit an Integer"),
    ("Sqrt(a)", (-1.0,), "Sqrt has no value for -1"),
    ("Log(a)", (0.0,), "Log has no value for 0"),
    ("Asin(a)", (2.0,), "Asin has no value for 2"),
    ("Asin(a)", (1.0000001,), "Asin has no value for 1.0000001"),
    ("Acos(a)", (-2.0,), "Acos has no value for -2"),
    ("Tan(a)", (90.0,), "Tan has no value at 90 degrees"),
    ("Tan(a)", (270.0,), "Tan has no value at 270 degrees"),
    ("a USING b", (1, 256), "USING cannot be 256 wide"),
    ("a USING b", (1, -256), "USING cannot be -256 wide"),
    ("a USING b, c", (1.0, 1, 256), "USING cannot have 256 decimals"),
]
NAMES = "abc"


def literal(value: object) -> str:
    if isinstance(value, str):
        return f'"{value}"'
    return "(-2147483647 - 1)" if value == LOW else f"({value!r})"


def put(expression: str, texts: dict[str, str]) -> str:
    """Return PRINT with texts in place of `a`, `b` and `c`."""
    return "PRINT " + re.sub(r"\b[abc]\b", lambda found: texts[found[0]], expression)


def of_constants(expression: str, values: tuple[object, ...]) -> str:
    return put(expression, dict(zip(NAMES, map(literal, values), strict=False)))


def of_variables(expression: str, values: tuple[object, ...]) -> str:
    kinds = {str: "t", int: "n", float: "x"}
    names = {name: kinds[type(value)] + name for name, value in zip(NAMES, values, strict=False)}
    sets = [f"{names[name]} = {literal(value)}" for name, value in zip(NAMES, values, strict=False)]
    return "\n".join([*sets, put(expression, names)])


DIM = "\n".join(f"Dim t{name} As String * 30, n{name} As Integer, x{name} As Float" for name in NAMES) + "\n"


def ran(text: str) -> Run:
    return run(Source("a.mnt", DIM + text), until=10.0)


@pytest.mark.parametrize("spelt", [of_constants, of_variables])
def test_values_of_functions_and_operators(spelt: Callable[[str, tuple[object, ...]], str]) -> None:
    result = ran("\n".join(spelt(expression, values) for expression, values, _ in VALUES))
    assert [each.message for each in result.diagnostics] == []
    shown = [
        f"{expression} of {values}: {line}"
        for (expression, values, _), line in zip(VALUES, result.output, strict=True)
    ]
    assert shown == [f"{expression} of {values}: {line}" for expression, values, line in VALUES]


@pytest.mark.parametrize(("expression", "values", "message"), REFUSED, ids=lambda each: str(each)[:40])
def test_what_has_no_value_is_reported(expression: str, values: tuple[object, ...], message: str) -> None:
    result = ran(of_variables(expression, values))
    assert [each.message for each in result.diagnostics] == [message]
    assert result.output == []


def test_random_numbers_are_those_of_a_lehmer_generator() -> None:
    """The states from 1 on are 48271, 182605794 and 1291394886, of 2^31 - 1."""
    expected = [state / 2147483647 for state in (48271, 182605794, 1291394886)]
    result = ran("Dim n As Integer\nFor n = 1 To 3\n  PRINT Rnd USING 1, 12\nNext")
    assert [float(line) for line in result.output] == pytest.approx(expected, abs=1e-12)
