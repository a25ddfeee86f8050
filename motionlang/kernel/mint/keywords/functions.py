"""Functions of numbers and strings.

`index` lists the arguments, `function` names a function in `runtime/functions.py`.
"""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.models import STRINGS


def _function(name: str, index: str, unit: str, function: str, help: str, example: str, changes: str = "",
              optional: int = 0, meant: str = "", family: str = "") -> Keyword:  # fmt: skip
    return Keyword(name, "", "function", "R", index, unit, function, help, f"PRINT {example}",
                   group="functions", changes=changes, optional=optional, meant=meant, family=family)  # fmt: skip


ROWS = (
    _function("Abs", "number", "same", "absolute", "The number without its sign.", "Abs(-3)"),
    _function("Sgn", "number", "integer", "sign", "-1, 0 or 1 as the number is negative, zero or positive.",
              "Sgn(-3)", meant="SIGN"),
    _function("Int", "number", "integer", "whole", "The whole part of a number, the fraction cut off.",
              "Int(3.7)", meant="ROUND TRUNC FIX FLOOR"),
    _function("Min", "number, number", "same", "least", "The smaller of two numbers.", "Min(3, 4)"),
    _function("Max", "number, number", "same", "greatest", "The larger of two numbers.", "Max(3, 4)"),
    _function("Sqrt", "number", "number", "root", "The square root.", "Sqrt(2)"),
    _function("Sqr", "number", "number", "root", "The square root.", "Sqr(2)"),
    _function("Exp", "number", "number", "exponential", "e to a power.", "Exp(1)"),
    _function("Log", "number", "number", "logarithm", "The natural logarithm.", "Log(10)", meant="LN"),
    _function("Sin", "number", "number", "sine", "The sine of an angle in degrees.", "Sin(30)"),
    _function("Cos", "number", "number", "cosine", "The cosine of an angle in degrees.", "Cos(60)"),
    _function("Tan", "number", "number", "tangent", "The tangent of an angle in degrees.", "Tan(45)"),
    _function("Asin", "number", "number", "arcsine", "The angle in degrees that has a sine.", "Asin(0.5)"),
    _function("Acos", "number", "number", "arccosine", "The angle in degrees that has a cosine.", "Acos(0.5)"),
    _function("Atan", "number", "number", "arctangent", "The angle in degrees that has a tangent.", "Atan(1)",
              meant="ATN ARCTAN"),
    _function("Rnd", "", "number", "random", "The next number of a fixed sequence between 0 and 1.",
              "Rnd < 1", changes="always"),
    _function("Len", "text", "integer", "length", "The number of characters of a text.", 'Len("Mint")', family=STRINGS),
    _function("Asc", "text", "integer", "code", "The code of the first character of a text.", 'Asc("A")',
              family=STRINGS),
    _function("Chr", "integer", "text", "character", "The character that has a code.", "Chr(65)"),
    _function("Str", "number", "text", "shown", "A number as PRINT shows it.", "Str(1.5)", family=STRINGS),
    _function("Val", "text", "number", "value", "The number that a text begins with, 0 where there is none.",
              'Val("1.5 mm")', family=STRINGS),
    _function("Left", "text, integer", "text", "left", "The first characters of a text.", 'Left("Mint", 2)',
              family=STRINGS),
    _function("Right", "text, integer", "text", "right", "The last characters of a text.", 'Right("Mint", 2)',
              family=STRINGS),
    _function("Mid", "text, integer, integer", "text", "middle",
              "Characters of a text from a place on (the first is 1), and how many.", 'Mid("Mint", 2, 2)',
              optional=1, family=STRINGS),
    _function("IIf", "bool, any, any", "same", "choice", "One of two values, as a condition is true or false.",
              "IIf(1 > 0, 10, 20)"),
)  # fmt: skip
