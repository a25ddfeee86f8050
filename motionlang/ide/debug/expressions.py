r"""Expressions over the state at a stop: conditions, log points, watches.

They have no side effects. There are numbers, texts, variables and the operators of Mint, with Mint's precedence, from
lowest to highest:

    Or   And   Not   = <> < > <= >=   + -   * / \ Mod   -x   ^

Registers of MCCL are R10 or @10. `position(0)`, `velocity(0)`, `target(0)`, `idle(0)`, `input(5)`, `output(5)` and
`time` read the machine at the time of the stop; POS, VEL, IDLE, IN, INX, OUT and OUTX are synonyms. Other keywords are
rejected, because reading some of them has an effect.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Protocol

from motionlang.kernel.tools import nearest

Value = float | str


class ExpressionState(Protocol):
    """The state that an expression reads."""

    def variable(self, name: str, subscripts: list[float]) -> Value | None:
        """Return the value of a variable or an element; None if there is no such variable."""

    def reading(self, what: str, number: int) -> float:
        """Return a reading of an axis or a channel; ValueError if that does not exist."""


Expression = Callable[[ExpressionState], Value]

READINGS = {
    "position": "position", "pos": "position", "velocity": "velocity", "vel": "velocity", "target": "target",
    "idle": "idle", "input": "input", "in": "input", "inx": "input", "output": "output", "out": "output",
    "outx": "output",
}  # fmt: skip
# Longer expressions, and deeper ones, are mistakes.
MAX_LENGTH, MAX_DEPTH = 1000, 50
_TOKEN = re.compile(
    r"\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|\"([^\"]*)\"|(@?[A-Za-z_]\w*|@\d+)|(<=|>=|<>|==|!=|[-+*/\\^()<>=,.\[\]]))"
)
# The dot of POS.1, where .1 is no number.
_DOT = re.compile(r"\.\d")
_LEVELS: tuple[tuple[str, ...], ...] = (
    ("or",), ("and",), ("=", "==", "<>", "!=", "<", ">", "<=", ">="), ("+", "-"), ("*", "/", "\\", "mod"),
)  # fmt: skip


# A variable, a register or an element, and its new value; == compares.
_ASSIGNMENT = re.compile(r"\s*(@?\w+(?:\([\d, ]+\))?)\s*=(?!=)\s*(.+)")


class WrongExpression(ValueError):
    """An invalid expression, or one that cannot be evaluated."""


def assignment(text: str) -> tuple[str, str] | None:
    """Return the name and the expression of a typed assignment, None if it is none."""
    match = _ASSIGNMENT.fullmatch(text)
    return None if match is None else (match[1], match[2])


def parse(text: str) -> Expression:
    """Parse an expression; raise WrongExpression if it is invalid."""
    if len(text) > MAX_LENGTH:
        raise WrongExpression(f"the expression has {len(text)} characters; {MAX_LENGTH} are allowed")
    parser = _Parser(_tokens(text))
    found = parser.level(0)
    parser.end()
    return found


def _tokens(text: str) -> list[tuple[str, str]]:
    found, at = list[tuple[str, str]](), 0
    while text[at:].strip():
        if found and found[-1][0] == "name" and _DOT.match(text, at):
            found.append(("sign", "."))
            at += 1
        match = _TOKEN.match(text, at)
        if match is None:
            raise WrongExpression(f"{text[at:].strip()[:1]!r} has no meaning in an expression")
        number, string, name, sign = match.groups()
        kind = "number" if number else "text" if string is not None else "name" if name else "sign"
        found.append((kind, number or string or name or sign or ""))
        at = match.end()
    return found


class _Parser:
    """A precedence parser that compiles an expression to functions of the state."""

    def __init__(self, tokens: list[tuple[str, str]]) -> None:
        self._tokens, self._at, self._depth = tokens, 0, 0

    def end(self) -> None:
        if self._at < len(self._tokens):
            raise WrongExpression(f'"{self._tokens[self._at][1]}" is one word too many')

    def _peek(self) -> str:
        if self._at >= len(self._tokens):
            return ""
        kind, text = self._tokens[self._at]
        return "" if kind in ("number", "text") else text.lower()

    def _take(self, *wanted: str) -> str:
        found = self._peek()
        if found and found in wanted:
            self._at += 1
            return found
        return ""

    def level(self, level: int) -> Expression:
        if level == len(_LEVELS):
            return self._sign()
        if level == 2 and self._take("not"):
            inner = self.level(2)
            return lambda names: float(not _number(inner(names)))
        left = self.level(level + 1)
        while operator := self._take(*_LEVELS[level]):
            left = _binary(operator, left, self.level(level + 1))
        return left

    def _sign(self) -> Expression:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise WrongExpression(f"the expression is nested more than {MAX_DEPTH} deep")
        if self._take("-"):
            inner = self._sign()
            found: Expression = lambda names: -_number(inner(names))  # noqa: E731
        elif self._take("+"):
            found = self._sign()
        else:
            found = self._atom()
            if self._take("^"):
                base, exponent = found, self._sign()
                found = lambda names: _power(_number(base(names)), _number(exponent(names)))  # noqa: E731
        self._depth -= 1
        return found

    def _atom(self) -> Expression:
        if self._at >= len(self._tokens):
            raise WrongExpression("the expression ends too early")
        kind, text = self._tokens[self._at]
        self._at += 1
        if kind == "number":
            value = float(text)
            return lambda names: value
        if kind == "text":
            return lambda names: text
        if kind == "name":
            return self._name(text)
        if text != "(":
            raise WrongExpression(f"a value is expected, not {text}")
        inner = self.level(0)
        self._close(")")
        return inner

    def _close(self, sign: str) -> None:
        if not self._take(sign):
            raise WrongExpression(f"{sign} is missing")

    def _name(self, text: str) -> Expression:
        name = f"R{text[1:]}" if text[0] == "@" else text
        arguments: list[Expression] = []
        bracket = self._take("(", "[")
        if bracket:
            arguments.append(self.level(0))
            while self._take(","):
                arguments.append(self.level(0))
            self._close(")" if bracket == "(" else "]")
        elif self._take("."):
            arguments.append(self._atom())
        return lambda names: _named(names, name, [_number(each(names)) for each in arguments])


def _named(names: ExpressionState, name: str, arguments: list[float]) -> Value:
    found = names.variable(name, arguments)
    if found is not None:
        return found
    reading = READINGS.get(name.lower())
    if reading is not None and len(arguments) == 1:
        return names.reading(reading, int(arguments[0]))
    if name.lower() == "time" and not arguments:
        return names.reading("time", 0)
    if reading is not None:
        raise WrongExpression(f"{name} needs one number in brackets")
    near = nearest(name, READINGS)
    hint = f"; did you mean {near}?" if near else ""
    raise WrongExpression(f"{name} is neither a variable here nor a reading that a condition may use{hint}")


def _number(value: Value) -> float:
    if isinstance(value, str):
        raise WrongExpression(f'a number is expected, not "{value}"')
    return value


def _binary(operator: str, left: Expression, right: Expression) -> Expression:
    if operator == "and":
        return lambda names: float(bool(_number(left(names))) and bool(_number(right(names))))
    if operator == "or":
        return lambda names: float(bool(_number(left(names))) or bool(_number(right(names))))
    work = _WORK[operator]

    def value(names: ExpressionState) -> Value:
        one, other = left(names), right(names)
        if isinstance(one, str) is not isinstance(other, str):
            raise WrongExpression(f"{operator} cannot take a text and a number")
        if isinstance(one, str) and operator not in _FOR_TEXTS:
            raise WrongExpression(f"{operator} needs numbers, not texts")
        try:
            return work(one, other)
        except ZeroDivisionError:
            raise WrongExpression("division by zero") from None
        except OverflowError:
            raise WrongExpression("the result is too large") from None

    return value


def _power(base: float, exponent: float) -> float:
    try:
        found = base**exponent
    except (ZeroDivisionError, OverflowError) as error:
        raise WrongExpression("the power has no value" if base == 0 else "the result is too large") from error
    if isinstance(found, complex):
        raise WrongExpression("the power has no value")
    return float(found)


_FOR_TEXTS = frozenset(("=", "==", "<>", "!=", "<", ">", "<=", ">=", "+"))
_WORK: dict[str, Callable[..., Value]] = {
    "=": lambda a, b: float(a == b),
    "==": lambda a, b: float(a == b),
    "<>": lambda a, b: float(a != b),
    "!=": lambda a, b: float(a != b),
    "<": lambda a, b: float(a < b),
    ">": lambda a, b: float(a > b),
    "<=": lambda a, b: float(a <= b),
    ">=": lambda a, b: float(a >= b),
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "\\": lambda a, b: float(int(a / b)),
    "mod": lambda a, b: a - b * int(a / b),
}
