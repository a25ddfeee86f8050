r"""Expressions that a user types: conditions of a debugger, objectives of a sweep. They have no side effects.

There are numbers, texts, names and the operators of Mint or of Python, with the precedence that both share, from lowest
to highest:

    Or   And   Not   = <> < > <= >=   + -   * / \ Mod   -x   ^

`==`, `!=`, `%` and `**` are synonyms. Names and texts become identifiers of Python, whose parser makes the tree; who
evaluates it says what a name means.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable

Value = float | str
# Returns the value of a name with its subscripts or arguments.
Reader = Callable[[str, list[Value]], Value]

# Longer expressions are mistakes.
MAX_LENGTH, MAX_NODES = 1000, 500
_TOKEN = r"""\s*(?:((?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|("[^"]*"|'[^']*')|({}@?[A-Za-z_]\w*(?:\.\w+)*|@\d+)
    |(<=|>=|<>|==|!=|\*\*|[-+*/\\%^()<>=,\[\]]))\s*"""
# Operators as Python writes them.
_PYTHON = {
    "=": "==", "<>": "!=", "^": "**", "\\": "//", "[": "(", "]": ")",
    "mod": "%", "and": "and", "or": "or", "not": "not",
}  # fmt: skip
_COMPARE: dict[type, Callable[[Value, Value], bool]] = {
    ast.Eq: operator.eq, ast.NotEq: operator.ne, ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}  # fmt: skip
_WORK: dict[type, Callable[[float, float], float]] = {
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: lambda a, b: float(int(a / b)),
    ast.Mod: lambda a, b: a - b * int(a / b),
    ast.Pow: lambda a, b: float(a) ** float(b),
}


class WrongExpression(ValueError):
    """An invalid expression, or one that cannot be evaluated."""


class Expression:
    """An expression; raises WrongExpression if it is invalid. `names` are those without arguments, `called` the others.

    `whole` is a pattern of names with signs in them, such as cycle(12).
    """

    def __init__(self, text: str, example: str, whole: str = "") -> None:
        self.text = text
        self._names: dict[str, str] = {}
        self._texts: dict[str, str] = {}
        try:
            if len(text) > MAX_LENGTH:
                raise WrongExpression(f"the expression has {len(text)} characters; {MAX_LENGTH} are allowed")
            self._tree = ast.parse(
                self._python(text, re.compile(_TOKEN.format(whole), re.VERBOSE)), mode="eval"
            ).body
            nodes = list(ast.walk(self._tree))
        except (SyntaxError, RecursionError, MemoryError):
            raise WrongExpression(f"{text!r} is not an expression such as {example}") from None
        calls = [node for node in nodes if isinstance(node, ast.Call)]
        if len(nodes) > MAX_NODES or not all(isinstance(each.func, ast.Name) for each in calls):
            raise WrongExpression(f"{text!r} is not an expression such as {example}")
        functions = {each.func for each in calls}
        named = [node for node in nodes if isinstance(node, ast.Name) and node.id in self._names]
        self.called = {self._names[node.id] for node in named if node in functions}
        self.names = tuple(dict.fromkeys(self._names[node.id] for node in named if node not in functions))

    def _python(self, text: str, token: re.Pattern[str]) -> str:
        found, at, text = list[str](), 0, text.strip()
        while at < len(text):
            match = token.match(text, at)
            if match is None:
                raise WrongExpression(f"{text[at]!r} has no meaning in an expression")
            number, string, name, sign = match.groups()
            if string or (name and name.lower() not in _PYTHON):
                found.append(f"n{at}_")
                (self._texts if string else self._names)[found[-1]] = string[1:-1] if string else name
            else:
                found.append(number or _PYTHON.get((name or sign).lower(), sign))
            at = match.end()
        return " ".join(found)

    def value(self, read: Reader) -> Value:
        """Return the value; raise WrongExpression if there is none."""
        try:
            return self._value(self._tree, read)
        except ZeroDivisionError:
            raise WrongExpression("division by zero") from None
        except OverflowError:
            raise WrongExpression("the result is too large") from None

    def _value(self, node: ast.expr, read: Reader) -> Value:
        match node:
            case ast.Constant(value=int() | float() as number):
                return float(number)
            case ast.Name(id=name):
                return self._texts[name] if name in self._texts else read(self._names[name], [])
            case ast.Call(func=ast.Name(id=name), args=arguments) if name in self._names:
                return read(self._names[name], [self._value(each, read) for each in arguments])
            case ast.UnaryOp(op=op, operand=operand):
                value = _number(self._value(operand, read))
                return (
                    float(not value)
                    if isinstance(op, ast.Not)
                    else -value
                    if isinstance(op, ast.USub)
                    else value
                )
            case ast.BoolOp(op=op, values=values):
                each_one = (bool(_number(self._value(each, read))) for each in values)
                return float(all(each_one) if isinstance(op, ast.And) else any(each_one))
            case ast.Compare(left=first, ops=ops, comparators=others):
                left = self._value(first, read)
                for sign, other in zip(ops, others, strict=True):
                    right = self._value(other, read)
                    if not _COMPARE[type(sign)](*_alike(left, right)):
                        return 0.0
                    left = right
                return 1.0
            case ast.BinOp(left=one, op=op, right=other):
                left, right = _alike(self._value(one, read), self._value(other, read))
                if isinstance(op, ast.Add):
                    return left + right  # type: ignore[operator]
                found = _WORK[type(op)](_number(left), _number(right))
                if isinstance(found, complex):
                    raise WrongExpression("the power has no value")
                return found
        raise WrongExpression(f"{self.text!r} is not an expression")


def _number(value: Value) -> float:
    if isinstance(value, str):
        raise WrongExpression(f'a number is expected, not "{value}"')
    return value


def _alike(left: Value, right: Value) -> tuple[Value, Value]:
    if isinstance(left, str) is not isinstance(right, str):
        raise WrongExpression("a text and a number cannot be combined")
    return left, right
