"""Operators and comparisons take every kind of number, with correct results.

The expected results come from a small model of the operators: an Integer is a Python int that must fit 32 bits, and a
Float is a Python float.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from itertools import product

import pytest

from motionlang import run
from motionlang.kernel import ProgramError, Source
from tests.cases import one_in

VARIABLES = """\
Dim n As Integer, m As Integer, k As Integer, x As Float, y As Float, a(3) As Integer
n = 2 : m = -7 : x = 1.5 : u = 3 : a(2) = 5
"""
# Operands with their values: an Integer, or a Float.
COMPARISONS = {
    "(n > 1)": 1, "(n > 2)": 0, "(x < n)": 1, "(Not n)": 0, "(Not x > n)": 1, "(n > 1 And x > 1)": 1, "+(n > 1)": 1,
}  # fmt: skip
OPERANDS: dict[str, float] = {
    **COMPARISONS, "n": 2, "m": -7, "x": 1.5, "u": 3.0, "a(2)": 5, "3": 3, "0": 0, "2.5": 2.5, "-(n > 1)": -1,
    "~(n > 1)": -2, "Abs(n > 1)": 1, "Min(n > 1, n > 0)": 1,
}  # fmt: skip
PROGRAM = """\
PRINT {whole}
k = {whole}
PRINT k
y = {whole}
PRINT y
PRINT Str({whole})
"""


def quotient(a: int, b: int) -> int:
    """Return the quotient toward zero."""
    return abs(a) // abs(b) * (1 if (a < 0) is (b < 0) else -1)


def remainder(a: float, b: float) -> float:
    """Return the remainder, which has the sign of the dividend."""
    return math.copysign(abs(a) % abs(b), a) if isinstance(a, float) else abs(a) % abs(b) * (-1) ** (a < 0)


def shifted(a: int, b: int) -> int:
    """Return the lowest 32 bits of a number that is shifted left, as a signed number."""
    return ((a << min(b, 32)) + 2**31) % 2**32 - 2**31


# Of numbers of the same kind: the result has the kind of the operands, or is a Float.
ARITHMETIC: dict[str, Callable[[float, float], float]] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "Mod": remainder,
}  # fmt: skip
TO_FLOAT: dict[str, Callable[[float, float], float]] = {"^": math.pow, "/": operator.truediv}
# Of Integers; a Float loses its fraction.
WHOLE: dict[str, Callable[[int, int], int]] = {
    "\\": quotient, "<<": shifted, ">>": lambda a, b: a >> min(b, 32), "&": operator.and_, "|": operator.or_,
    "Xor": operator.xor,
}  # fmt: skip
TRUTH: dict[str, Callable[[float, float], bool]] = {
    "=": operator.eq, "<>": operator.ne, "<": operator.lt, ">": operator.gt, "<=": operator.le, ">=": operator.ge,
    "And": lambda a, b: bool(a) and bool(b), "Or": lambda a, b: bool(a) or bool(b),
}  # fmt: skip
OPERATORS = (*ARITHMETIC, *TO_FLOAT, *WHOLE, *TRUTH)


def result_of(op: str, a: float, b: float) -> float:
    """Return the result of an operation; ArithmeticError or ValueError if it has none."""
    if op in TRUTH:
        return int(TRUTH[op](a, b))
    if op in TO_FLOAT:
        if op == "^" and a == 0 and b < 0:
            raise ZeroDivisionError
        return TO_FLOAT[op](a, b)
    if op in WHOLE:
        return WHOLE[op](int(a), int(b))
    if isinstance(a, int) and isinstance(b, int):
        return ARITHMETIC[op](a, b)
    return float(ARITHMETIC[op](float(a), float(b)))


def shown(value: float) -> str:
    if isinstance(value, int):
        return str(value)
    return f"{value:e}" if 0.0 < abs(value) < 1e-4 else f"{value or 0.0:.4f}"


def expected(op: str, a: float, b: float) -> tuple[list[str], bool]:
    """Return the lines of the program, and True if it completes."""
    try:
        found = result_of(op, a, b)
    except (ArithmeticError, ValueError):
        return [], False
    return [shown(found), shown(int(found)), shown(float(found)), shown(found)], True


def outcome(text: str) -> tuple[list[str], bool] | None:
    """Return a program's output and whether it completed; None if it is rejected."""
    try:
        result = run(Source("a.mnt", text))
    except ProgramError:
        return None
    return result.output, not result.diagnostics


def agreeing(expressions: dict[str, tuple[list[str], bool]]) -> int:
    """Compare expressions in one program; return how many are not rejected.

    If the program is rejected, its halves are compared.
    """
    text = "".join(PROGRAM.format(whole=whole) for whole in expressions)
    found = outcome(VARIABLES + text)
    if found is None and len(expressions) > 1:
        items = list(expressions.items())
        return agreeing(dict(items[::2])) + agreeing(dict(items[1::2]))
    if found is None:
        return 0
    output = [line for printed, _ in expressions.values() for line in printed]
    assert found == (output, all(ended for _, ended in expressions.values())), list(expressions)
    return len(expressions)


@pytest.mark.parametrize("part", one_in(4, range(4)))
@pytest.mark.parametrize("op", OPERATORS)
def test_operators_and_operands(op: str, part: int) -> None:
    """Each of four parts has every left and every right operand.

    A pair of operands is in the same part for every fourth operator.
    """
    ran = tried = 0
    for number, left in enumerate(OPERANDS):
        together: dict[str, tuple[list[str], bool]] = {}
        for right in list(OPERANDS)[(number + OPERATORS.index(op) + part) % 4 :: 4]:
            tried += 1
            made = expected(op, OPERANDS[left], OPERANDS[right])
            if made[1]:
                together[f"{left} {op} {right}"] = made
            else:
                ran += agreeing({f"{left} {op} {right}": made})
        ran += agreeing(together) if together else 0
    assert ran > 0.9 * tried - len(OPERANDS)


@pytest.mark.parametrize("whole", ["n > 1", "Not n", '"a" = "b"', "s", "(n > 1)", "IIf(n > 0, n > 1, n > 2)"])
def test_a_truth_is_the_integer_1_or_0(whole: str) -> None:
    """A truth value is printed, converted to text, and divided like a number."""
    text = (
        f"Dim n As Integer, s As Semaphore\nn = 2\nPRINT {whole}\nPRINT Str({whole})\nPRINT ({whole}) Mod n"
    )
    output, ended = outcome(text) or ([], False)
    assert ended
    assert output[0] in ("0", "1")
    assert output == output[:1] * 3


# Equal conditions in Mint and in Python, whose And, Or and Not bind equally.
GROUPED = {
    "a And (b Or c)": "a and (b or c)",
    "(a Or b) And c": "(a or b) and c",
    "a Or b And c": "a or b and c",
    "Not (a And b) Or c": "not (a and b) or c",
    "Not (a Or b) And Not c": "not (a or b) and not c",
    "a And (b And Not (c Or a))": "a and b and not (c or a)",
    "either And c": "(a or b) and c",
    "Not either": "not (a or b)",
    "Not both Or either And c": "not (a and b) or (a or b) and c",
    "neither And c": "not (a or b) and c",
}


@pytest.mark.parametrize("mint", GROUPED)
def test_conditions_are_grouped_as_they_are_written(mint: str) -> None:
    text = f"""Dim a, b, c, turns As Integer
Define either = a Or b
Define both = a And b
Define neither = Not either
For a = 0 To 1 : For b = 0 To 1 : For c = 0 To 1
  If {mint} Then Print "yes" Else Print "no"
  turns = 1
  While Not ({mint}) And turns < 2 : turns = turns + 1 : End While
  Print turns; " "; ({mint}) + 0
Next c : Next b : Next a
"""
    expected = []
    for a, b, c in product((0, 1), repeat=3):
        true = bool(eval(GROUPED[mint], {"a": a, "b": b, "c": c}))
        expected += ["yes" if true else "no", f"{2 - true} {int(true)}"]
    assert run(Source("t.mnt", text), until=1.0).output == expected
