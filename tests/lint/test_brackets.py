"""The two ways to read `&` or `|` next to comparisons: the first one applies."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from motionlang.commands.check import check
from motionlang.kernel import Diagnostic, Source, dialect

OPERANDS = (
    "a",
    "(a)",
    "-b",
    "f(a, 1)",
    "INX.0",
    "POS(a & 1)",
    "(a & 2)",
    "((b = 1))",
    "a + b * 2",
    "r.c(1)",
    "0x10",
    "INX[0]",
    "POS[(a & 1)]",
    "g()",
    "r.n",
    "-(r.n)",
)
BITS, COMPARISONS = ("&", "|"), ("=", "<>", "<", ">=")
BEFORE = """\
Type pair
  c(2) As Integer
  n As Integer
End Type
Function g() As Integer
  g = 7
End Function
Dim a As Integer, b As Integer, f(3, 3) As Integer, r As pair
a = 1 : b = 2 : f(1, 1) = 3 : r.c(1) = 4 : r.n = 5
"""


def mixed(line: str) -> list[Diagnostic]:
    found = check(dialect("mint").program(Source("a.mnt", BEFORE + line), {}))
    assert not [each for each in found if each.severity == "error"], line
    return [each for each in found if each.code == "mixed-operators"]


def tree(line: str) -> str:
    module: Any = dialect("mint").program(Source("a.mnt", BEFORE + line)).tree
    return repr(module.body)


def bracketed(operands: list[str], ops: list[str], tight: tuple[str, ...]) -> str:
    """Return the operands with brackets around each run joined by `tight` operators."""
    runs, loose = [[operands[0]]], []
    for op, operand in zip(ops, operands[1:], strict=True):
        if op in tight:
            runs[-1] += [op, operand]
        else:
            loose.append(op)
            runs.append([operand])
    texts = [f"({' '.join(run)})" if len(run) > 1 else run[0] for run in runs]
    return texts[0] + "".join(f" {op} {text}" for op, text in zip(loose, texts[1:], strict=True))


@pytest.mark.parametrize("seed", range(90))
def test_both_interpretations(seed: int) -> None:
    random = Random(seed)
    count = random.randint(3, 6)
    operands = [random.choice(OPERANDS) for _ in range(count)]
    ops = [random.choice(BITS), random.choice(COMPARISONS)]
    ops = random.sample(ops + random.choices(BITS + COMPARISONS, k=count - 3), k=count - 1)
    frame = random.choice(
        ("If {} Then PRINT 1", "a = {}", "PRINT f(1, 2), {}; 7", "If Not {} And a Then PRINT 2")
    )
    line = frame.format(bracketed(operands, ops, ()))
    here, there = (frame.format(bracketed(operands, ops, tight)) for tight in (BITS, COMPARISONS))
    found = mixed(line)
    assert [each.hint for each in found] == [f"add brackets: {here}, as it is read here, or {there}"]
    assert mixed(here) == mixed(there) == []
    assert tree(here) == tree(line) != tree(there)
