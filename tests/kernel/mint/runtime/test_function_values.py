"""Functions and operators at their bounds, of constants and of variables.

The compiler computes an expression of constants before the run, and the run computes one of variables.
"""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang import run
from motionlang.kernel import Run, Source

LOW = -2147483648
ROWS = [
    (expression, ast.literal_eval(f"({values},)"), shown)
    for line in Path(__file__).with_name("function_values.txt").read_text(encoding="utf-8").splitlines()
    if not line.startswith("#")
    for expression, values, shown in [line.split("; ")]
]
VALUES = [(expression, values, json.loads(shown)) for expression, values, shown in ROWS if shown[0] == '"']
REFUSED = [(expression, values, shown[2:]) for expression, values, shown in ROWS if shown[0] == "!"]
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
