"""The Python of single statements, as short as the possible operands allow.

A check of 32 bits, a conversion or a call is written only where a value may need it.
"""

from __future__ import annotations

import re

from motionlang.execution import accelerators
from motionlang.mint import DIALECT
from motionlang.source import Source
from tests.cases import cases

DECLARED = (
    "Dim a As Integer, b As Integer, i As Integer, x As Float, y As Float, s As String, v(9) As Integer\n"
)
BOUNDS = "(z if -2147483648 <= (z := {}) <= 2147483647 else overflow(z))"


def python(statements: str) -> list[str]:
    """Return the lines of the statements, with named operations.

    Names of functions and keywords replace `k0` and so on. The count of statements and the end of the program are
    left out.
    """
    listing = DIALECT.listing(Source("a.mnt", DECLARED + statements), {}, {}, accelerators(True).ranges)
    found = []
    for line, code, note in listing.lines:
        text = code.strip()
        if line < 2 or text in ("return", "yield") or re.match(r"t \+= [\d.]+$|l\d+ = |if t - l\d+", text):
            continue
        for each in note.split(", k") if note else ():
            key, _, name = each.removeprefix("k").partition(" ")
            name = (
                name.removeprefix("functions.").removeprefix("Environment.").replace(" ", "_").split("(")[0]
            )
            text = re.sub(rf"\bk{key}\b", name, text)
        found.append(text)
    return found


@cases(
    "expression, text",
    [
        # The quotient and the remainder of numbers that are not negative are those of Python.
        ("IIf(b, 0, 7) \\ 2", "((0 if v_b else 7) // 2)"),
        ("IIf(b, 0, 7) \\ 0", "divide((0 if v_b else 7), 0)"),
        ("b \\ 2", "divide(v_b, 2)"),
        ("IIf(b, 0, 7) \\ -2", "divide((0 if v_b else 7), (-2))"),
        ("IIf(b, 0, 7) Mod 3", "((0 if v_b else 7) % 3)"),
        ("b Mod 3", "modulo(v_b, 3)"),
        ("IIf(b, 0, 7) Mod i", "modulo((0 if v_b else 7), v_i)"),
        ("x \\ 2", "divide(v_x, 2)"),
        # A sum that may leave 32 bits is checked.
        ("b + 1", BOUNDS.format("v_b + 1")),
        ("IIf(b, 0, 7) + 1", "(0 if v_b else 7) + 1"),
        ("IIf(b, 0, 7) * 1000 - 8", "(0 if v_b else 7) * 1000 - 8"),
        ("IIf(b, 0, 2147483647) + 0", "(0 if v_b else 2147483647) + 0"),
        ("IIf(b, 0, 2147483647) + 1", BOUNDS.format("(0 if v_b else 2147483647) + 1")),
        ("0 - IIf(b, 0, 2147483647)", "0 - (0 if v_b else 2147483647)"),
        ("-2 - IIf(b, 0, 2147483647)", BOUNDS.format("(-2) - (0 if v_b else 2147483647)")),
        ("-b", BOUNDS.format("0 - v_b")),
        ("8 - IIf(b, 0, 7)", "8 - (0 if v_b else 7)"),
        ("8 - (IIf(b, 0, 7) - 1)", "8 - ((0 if v_b else 7) - 1)"),
        ("8 - IIf(b, 0, 7) * 2", "8 - (0 if v_b else 7) * 2"),
        ("(8 - IIf(b, 0, 7)) * 2", "(8 - (0 if v_b else 7)) * 2"),
        ("Abs(IIf(b, 0, 7)) + 1", "absolute((0 if v_b else 7)) + 1"),
        ("Abs(IIf(b, -9, 7)) + 2147483638", "absolute(((-9) if v_b else 7)) + 2147483638"),
        ("Abs(IIf(b, -9, 7)) + 2147483639", BOUNDS.format("absolute(((-9) if v_b else 7)) + 2147483639")),
        ("IIf(b, 0, 7) \\ 1 + IIf(b, 0, 7) Mod 1", "((0 if v_b else 7) // 1) + ((0 if v_b else 7) % 1)"),
        ("(IIf(b, 0, 7) & 3) + 2147483644", "((0 if v_b else 7) & 3) + 2147483644"),
        ("(IIf(b, 0, 7) & 3) + 2147483645", BOUNDS.format("((0 if v_b else 7) & 3) + 2147483645")),
        ("(IIf(b, 0, 7) | 3) + 1", BOUNDS.format("((0 if v_b else 7) | 3) + 1")),
        ("IIf(b, 0, 7) Mod IIf(b, 0, 3)", "modulo((0 if v_b else 7), (0 if v_b else 3))"),
        ("Min(b, 9) + 1", "least(v_b, 9) + 1"),
        ("Max(b, 9) + 1", BOUNDS.format("greatest(v_b, 9) + 1")),
        ("Max(IIf(b, 0, 7), 9) + 1", "greatest((0 if v_b else 7), 9) + 1"),
        ("IIf(b, 1, 5) + 1", "(1 if v_b else 5) + 1"),
        ("IDLE(0) + 1", "read_IDLE() + 1"),
        # A number with a fraction becomes an Integer by a call.
        ("x", "integer(v_x)"),
        ("x + 1", "integer(v_x + 1)"),
        ("b & x", "(v_b & integer(v_x))"),
        ("b ^ 2", "integer(power(v_b, 2))"),
        ("IIf(b, 1, 2.5)", "integer((1 if v_b else 2.5))"),
        ("~b", "(~v_b)"),
        ("b | 8", "(v_b | 8)"),
        ("b Xor 8", "(v_b ^ 8)"),
        ("b << 2", "shift_left(v_b, 2)"),
        ("b >> 2", "shift_right(v_b, 2)"),
        # A condition is 1 or 0; constants are computed before.
        ("(b = 1)", "(1 if v_b == 1 else 0)"),
        ("Not b", "(1 if not v_b else 0)"),
        ("(b = 1) + 2", "(1 if v_b == 1 else 0) + 2"),
        ("3 + 4 * 5", "23"),
        ("7 \\ 2", "3"),
        ("-7 Mod 4", "(-3)"),
        ("1 << 4", "16"),
        ("v(3)", "v_v[3]"),
        ("v(b)", "v_v[subscript(v_b, 9)]"),
        ("v(IIf(b, 0, 7) + 1)", "v_v[((0 if v_b else 7) + 1)]"),
        ("v(IIf(b, 0, 7))", "v_v[subscript((0 if v_b else 7), 9)]"),
        ("v(IIf(b, 0, 7) + 3)", "v_v[subscript((0 if v_b else 7) + 3, 9)]"),
    ],
)
def test_the_value_of_an_integer(expression: str, text: str) -> None:
    assert [each for each in python(f"a = {expression}") if "v_a" in each] == [f"v_a = {text}"]


@cases(
    "expression, text",
    [
        ("5", "5.0"),
        ("0", "0.0"),
        ("-5", "(-5.0)"),
        ("2147483647", "2147483647.0"),
        ("2147483648", "2147483648.0"),
        ("1.5", "1.5"),
        ("y", "v_y"),
        ("y + 1", "v_y + 1"),
        ("a", "(v_a + 0.0)"),
        ("a + 1.5", "v_a + 1.5"),
        ("a / b", "v_a / v_b"),
        ("a / 2 * 3", "v_a / 2 * 3"),
        ("(y + 1) / 2", "(v_y + 1) / 2"),
        ("y * 2 / 3", "v_y * 2 / 3"),
        ("a / (2 * y)", "v_a / (2 * v_y)"),
        ("y - (y - 1)", "v_y - (v_y - 1)"),
        ("(y - y) - 1", "v_y - v_y - 1"),
        ("(y - y) * 2", "(v_y - v_y) * 2"),
        ("y * (y * 2)", "v_y * (v_y * 2)"),
        ("y ^ 2", "power(v_y, 2)"),
        ("Abs(y)", "absolute(v_y)"),
        ("Abs(a)", "(absolute(v_a) + 0.0)"),
        ("Max(1, 2.5)", "(greatest(1, 2.5) + 0.0)"),
        ("Max(y, 2.5)", "greatest(v_y, 2.5)"),
        ("Sqrt(a)", "root(v_a)"),
        ("POS(0)", "read_POS()"),
        ("IIf(a, y, 2.5)", "(v_y if v_a else 2.5)"),
        ("(y > a)", "((1 if v_y > v_a else 0) + 0.0)"),
        ("IIf(a, 0, 7) Mod 3", "(((0 if v_a else 7) % 3) + 0.0)"),
        ("y Mod 3", "modulo(v_y, 3)"),
        ("1e300 * 10", "1e+301"),
    ],
)
def test_the_value_of_a_float(expression: str, text: str) -> None:
    assert [each for each in python(f"x = {expression}") if "v_x" in each] == [f"v_x = {text}"]


@cases(
    "head, text",
    [
        ("For i = 1 To 5", "while v_i <= 5:"),
        ("For i = 5 To 1 Step -1", "while v_i >= 1:"),
        ("For i = 1 To a", "while v_i <= w1:"),
        ("For i = 1 To 5 Step b", "while (v_i <= 5 if w1 >= 0 else v_i >= 5):"),
        ("For i = 1 To 5 Step IIf(b, 1, 7)", "while v_i <= 5:"),
        ("For i = 5 To 1 Step IIf(b, -1, -7)", "while v_i >= 1:"),
        ("For x = 0 To 1 Step 0.25", "while v_x <= 1:"),
    ],
)
def test_the_condition_of_a_loop(head: str, text: str) -> None:
    """The sign of a step decides the direction; it is tested only if it is unknown."""
    assert text in python(f"{head}\n  y = 2\nNext")


@cases(
    "head, body, chunk",
    [
        ("For i = 1 To 5", "y = 2", "for v_i in range(v_i, v_i + m1):"),
        ("For i = 1 To 9 Step 2", "y = 2", "for v_i in range(v_i, v_i + m1 * 2, 2):"),
        ("For i = 5 To 1 Step -1", "y = 2", "for v_i in range(v_i, v_i + m1 * -1, -1):"),
        ("For i = 1 To 5", "v(i) = i", "for v_i in range(v_i, v_i + m1):"),
        ("For i = 1 To 5", "i = i + 1", ""),
        ("For i = 1 To 5 Step b", "y = 2", ""),
        ("For x = 1 To 5", "y = 2", "for v_x in range(v_x, v_x + m1):"),
        ("For x = 1 To 5.5", "y = 2", ""),
        ("For i = 1 To 5", "SPEED(0) = i", ""),
        ("For i = 1 To 2147483647", "y = 2", ""),
        ("For i = 1 To 2147483646", "y = 2", "for v_i in range(v_i, v_i + m1):"),
    ],
)
def test_a_loop_that_only_counts_runs_in_chunks(head: str, body: str, chunk: str) -> None:
    """Its variable changes in no other way, and the count cannot overflow.

    Its body does not wait.
    """
    lines = python(f"{head}\n{body}\nNext")
    assert [each for each in lines if each.startswith("for ")] == ([chunk] if chunk else [])


@cases(
    "condition, test, subscribed",
    [
        ("IDLE(0)", "read_IDLE()", "(0,)"),
        ("IDLE(0, 1)", "read_IDLE() and read_IDLE()", "(0, 1)"),
        ("IDLE(0) And IDLE(1)", "read_IDLE() and read_IDLE()", "(0, 1)"),
        ("IDLE(0) Or IDLE(1)", "read_IDLE() or read_IDLE()", "(), True"),
        ("IDLE(0) And INX(1)", "read_IDLE() and read_INX(1)", "(), True"),
        ("INX(1) And IDLE(0)", "read_INX(1) and read_IDLE()", "(), True"),
        ("IDLE(0) = 1", "read_IDLE() == 1", "(), True"),
        ("IDLE(a)", "read_IDLE[v_a]()", ""),
        ("Not INX(1)", "not read_INX(1)", "(), True"),
        ("INX(1) And a", "read_INX(1) and v_a", ""),
        ("INX(a)", "read_INX(v_a)", ""),
        ("ADC(1) > 5", "read_ADC(1, 5) > 5", "(), True"),
        ("VEL(0) < 5", "read_VEL(5) < 5", "(), True"),
        ("OUTX(1)", "read_OUTX(1)", ""),
        ("SPEED(0) > 5", "read_SPEED() > 5", ""),
        ("a = 1", "v_a == 1", ""),
        ("TIME > 5", "read_TIME(5) > 5", ""),
        ("POS(0) > 5", "read_POS(5) > 5", ""),
        ("5 < POS(0)", "5 < read_POS(5)", ""),
        ("POS(0) > a", "read_POS(v_a) > v_a", ""),
        ("POS(0) + 1 > 5", "(read_POS(5 - 1) + 1) > 5", ""),
        ("Abs(POS(0)) > 5", "absolute(read_POS((5, 0.0))) > 5", ""),
        ("-POS(0) > 5", "(-read_POS()) > 5", ""),
        ("POS(0) > 5 And POS(0) < 9", "read_POS(5) > 5 and read_POS(9) < 9", ""),
    ],
)
def test_a_pause_subscribes_to_what_its_condition_reads(condition: str, test: str, subscribed: str) -> None:
    """A reading that is compared gets the level, so that its crossing is solved.

    The wait gets the axes if it is only for their standstill, and True if variables and settings cannot change
    its condition. `POS` can be written, so it is a setting.
    """
    (line,) = (each for each in python(f"PAUSE {condition}") if each.startswith("if not"))
    found = re.fullmatch(
        r"if not \((.*)\): t, H = pause\(t, lambda: (.*), '.*', \d+(?:, (.*))?\) or \(yield E.wait\)", line
    )
    assert found is not None
    assert (found[1], found[2], found[3] or "") == (test, test, subscribed)


@cases(
    "head, left",
    [
        ("For i = 1 To 5", "(5 - v_i)"),
        ("For i = 1 To 9 Step 2", "((9 - v_i) // 2)"),
        ("For i = 5 To 1 Step -1", "((1 - v_i) // -1)"),
    ],
)
def test_a_chunk_reports_how_many_iterations_follow(head: str, left: str) -> None:
    """Two statements each: the body and the Next."""
    assert f"if t >= H: yield (t, {left} * 2.0)" in python(f"{head}\ny = 2\nNext")
