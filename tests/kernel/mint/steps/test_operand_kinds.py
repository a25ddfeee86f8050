"""Operators and comparisons take every kind of number, with correct results."""

from __future__ import annotations

from itertools import product

import pytest

from motionlang import run
from motionlang.kernel import ProgramError, Source
from motionlang.kernel.mint.syntax.parser import parse
from tests.kernel.mint.reference import Reference

OPERATORS = (
    "^",
    "*",
    "/",
    "\\",
    "Mod",
    "+",
    "-",
    "<<",
    ">>",
    "&",
    "|",
    "Xor",
    "=",
    "<>",
    "<",
    ">",
    "<=",
    ">=",
    "And",
    "Or",
)
COMPARISONS = ("(n > 1)", "(n > 2)", "(x < n)", "(Not n)", "(Not x > n)", "(n > 1 And x > 1)", "+(n > 1)")
OTHERS = (
    "n",
    "m",
    "x",
    "u",
    "a(2)",
    "3",
    "0",
    "2.5",
    "-(n > 1)",
    "~(n > 1)",
    "Abs(n > 1)",
    "Min(n > 1, n > 0)",
)
VARIABLES = """\
Dim n As Integer, m As Integer, k As Integer, x As Float, y As Float, a(3) As Integer
n = 2 : m = -7 : x = 1.5 : u = 3 : a(2) = 5
"""
PROGRAM = """\
PRINT {whole}
k = {whole}
PRINT k
y = {whole}
PRINT y
"""
TEXT = "PRINT Str({whole})\n"


def outcome(text: str) -> tuple[list[str], bool] | None:
    """Return a program's output and whether it completed; None if it is rejected."""
    try:
        result = run(Source("a.mnt", text))
    except ProgramError:
        return None
    return result.output, not result.diagnostics


def agreeing(expected: dict[str, tuple[list[str], bool]]) -> int:
    """Compare expressions in one program; return how many are not rejected.

    If the program is rejected, its halves are compared.
    """
    text = "".join((PROGRAM + TEXT).format(whole=whole) for whole in expected)
    found = outcome(VARIABLES + text)
    if found is None and len(expected) > 1:
        items = list(expected.items())
        return agreeing(dict(items[::2])) + agreeing(dict(items[1::2]))
    if found is None:
        return 0
    output = [line for printed, _ in expected.values() for line in printed]
    assert found == (output, all(ended for _, ended in expected.values())), list(expected)
    return len(expected)


@pytest.mark.parametrize("half", [0, pytest.param(1, marks=pytest.mark.long)])
@pytest.mark.parametrize("op", OPERATORS)
def test_operators_and_operands(op: str, half: int) -> None:
    """Each half has every left and every right operand.

    A pair of operands is in the same half for every second operator.
    """
    kinds = COMPARISONS + OTHERS
    ran = tried = 0
    for number, left in enumerate(kinds):
        together: dict[str, tuple[list[str], bool]] = {}
        for right in kinds[(number + OPERATORS.index(op) + half) % 2 :: 2]:
            tried += 1
            whole = f"{left} {op} {right}"
            slow = Reference(parse(Source("a.mnt", VARIABLES + PROGRAM.format(whole=whole))))
            if slow.trouble:
                ran += agreeing({whole: (slow.printed, False)})
            else:
                together[whole] = [*slow.printed, slow.printed[0]], True
        ran += agreeing(together) if together else 0
    assert ran > 0.9 * tried - len(kinds)


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
