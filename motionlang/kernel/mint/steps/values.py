"""Values of expressions: functions of the variables of the running call, and the operators that combine them.

A `Value` knows its type, so conversions are chosen before the program runs. A reading of the machine also has `solved`,
a function that takes the level with which the program compares it: then the machine knows when the comparison turns,
and neither a PAUSE nor a loop has to poll.

What a value is made of counts for the rule of loops (`kernel/lang/loops.py`): `sum_of` are the variables of which it is
a sum, and each comparison of numbers reports its margin.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from dataclasses import dataclass
from math import isfinite
from typing import Any

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.steps import Values
from motionlang.kernel.mint.resolve.symbols import FLOAT, INTEGER, NUMERIC, STRING, TIME
from motionlang.kernel.mint.runtime import functions
from motionlang.kernel.mint.runtime.functions import INT_HIGH, INT_LOW

Get = Callable[[Values], Any]
# What a reading is compared with: a level, or (distance, centre) for the absolute value of a difference.
Level = float | tuple[float, float]
Solved = Callable[[Values, Any], Any]
# What a debug build calls with both sides of a comparison.
Report = Callable[[Any, Any], object]

COMPARISONS: dict[str, Callable[[Any, Any], bool]] = {
    "=": operator.eq,
    "<>": operator.ne,
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
}
ARITHMETIC: dict[str, Callable[[Any, Any], Any]] = {"+": operator.add, "-": operator.sub, "*": operator.mul}
_BITS: dict[str, Callable[[int, int], int]] = {"&": operator.and_, "|": operator.or_, "Xor": operator.xor}
_FUNCTIONS: dict[str, tuple[Callable[[float, float], float], str]] = {
    "^": (functions.power, FLOAT),
    "\\": (functions.divide, INTEGER),
    "<<": (functions.shift_left, INTEGER),
    ">>": (functions.shift_right, INTEGER),
}
# The largest int that every float equals.
_EXACT = 2**53


@dataclass(eq=False, slots=True)
class Value:
    """An expression: the function that works it out, its type, and its value if that is known before the run.

    A check asks for type and value only; the functions that it makes are never called.
    """

    get: Get
    type: str
    const: float | str | None = None
    # For a reading: works it out for a comparison with a level.
    solved: Solved | None = None
    # For a condition: the bare truth value.
    truth: Get | None = None
    # The variables of which it is a sum.
    sum_of: frozenset[int] = frozenset()

    @property
    def holds(self) -> Get:
        """The function for use where only the truth value counts."""
        return self.truth or self.get

    @property
    def is_number(self) -> bool:
        return self.type in NUMERIC


def typed(kind: str) -> Value:
    """Return a value of which the check knows the type."""
    return Value(_none, kind)


def _none(values: Values) -> Any:
    raise AssertionError("the check calls nothing")


# Replaces a wrong value, which has been reported, so that other errors are found. Its type is no error.
NOTHING = typed(FLOAT)


def literal(known: float | str) -> Value:
    """Return the value of a constant; an integer of more than 32 bits is a Float."""
    if isinstance(known, str):
        return Value(lambda values: known, STRING, known)
    if type(known) is int and INT_LOW <= known <= INT_HIGH:
        return Value(lambda values: known, INTEGER, known)
    if type(known) is int and abs(known) > _EXACT:
        known = float(known)
    return Value(lambda values: known, FLOAT, known if isfinite(known) else None)


def type_of(row: Keyword) -> str:
    """Return the Mint type of a keyword's value."""
    return INTEGER if row.is_whole else STRING if row.unit == "text" else FLOAT


def article(type: str) -> str:
    """Return the name of a type with its indefinite article."""
    return f"an {type}" if type[:1] in "AEIOaeio" else f"a {type}"


def answer(truth: Get) -> Value:
    """Return the value of a condition: the Integer 1 or 0."""
    return Value(lambda values: 1 if truth(values) else 0, INTEGER, truth=truth)


def as_float(found: Value) -> Get:
    """Return the function for a number as a Float."""
    get = found.get
    if found.const is not None:
        known = float(found.const)
        return lambda values: known
    return get if found.type == FLOAT else lambda values: get(values) + 0.0


def as_integer(found: Value) -> Get:
    """Return the function for a number as an Integer, with the fraction cut off."""
    get, const = found.get, found.const
    if isinstance(const, (int, float)) and INT_LOW <= const <= INT_HIGH:
        known = int(const)
        return lambda values: known
    return get if found.type in (INTEGER, TIME) else lambda values: functions.integer(get(values))


# ---------------------------------------------------------------------------------------------------- operators


def combined(
    op: str, left: Value, right: Value, compare: Callable[[float], None], report: Report | None = None
) -> Value:
    """Return `left op right`; `compare` is told the margin of each comparison of numbers, `report` both sides."""
    if op in COMPARISONS:
        return _compared(comparison(op, report), left, right, compare)
    if STRING in (left.type, right.type):
        first, second = left.get, right.get
        return Value(lambda values: first(values) + second(values), STRING)
    if op in ("+", "-") and (left.solved is None) is not (right.solved is None):
        return _sum_with_reading(op, left, right)
    if op in ARITHMETIC:
        return arithmetic(op, left, right)
    return _operation(op, left, right)


def comparison(op: str, report: Report | None) -> Callable[[Any, Any], bool]:
    """Return the function of a comparison; a debug build reports its sides."""
    compare = COMPARISONS[op]
    if report is None:
        return compare

    def reported(left: Any, right: Any) -> bool:
        report(left, right)
        return compare(left, right)

    return reported


def _compared(
    op: Callable[[Any, Any], bool], left: Value, right: Value, compare: Callable[[float], None]
) -> Value:
    first, second = left.get, right.get
    if left.solved is not None and right.solved is None:
        read = left.solved

        def truth(values: Values) -> bool:
            level = second(values)
            return op(read(values, level), level)

    elif right.solved is not None and left.solved is None:
        read = right.solved

        def truth(values: Values) -> bool:
            level = first(values)
            return op(level, read(values, level))

    elif STRING in (left.type, right.type) or not (left.sum_of or right.sum_of):

        def truth(values: Values) -> bool:
            return op(first(values), second(values))

    else:

        def truth(values: Values) -> bool:
            one, other = first(values), second(values)
            compare(one - other)
            return op(one, other)

    return answer(truth)


def _sum_with_reading(op: str, left: Value, right: Value) -> Value:
    """Return a reading plus or minus a value; a level of the sum is one of the reading, shifted."""
    made = arithmetic(op, left, right)
    reading, other = (left, right) if left.solved is not None else (right, left)
    read, get, combine = reading.solved, other.get, ARITHMETIC[op]
    assert read is not None

    def solved(values: Values, level: Level) -> Any:
        by = get(values)
        if op == "+":
            return combine(read(values, _shifted(level, -by)), by)
        if reading is left:
            return combine(read(values, _shifted(level, by)), by)
        return combine(by, read(values, _mirrored(level, by)))

    made.solved = solved
    return made


def _shifted(level: Level, by: float) -> Level:
    return (level[0], level[1] + by) if isinstance(level, tuple) else level + by


def _mirrored(level: Level, at: float) -> Level:
    return (level[0], at - level[1]) if isinstance(level, tuple) else at - level


def arithmetic(op: str, left: Value, right: Value) -> Value:
    combine, first, second = ARITHMETIC[op], left.get, right.get
    sum_of = left.sum_of | right.sum_of
    if FLOAT in (left.type, right.type):
        return Value(lambda values: combine(first(values), second(values)), FLOAT, sum_of=sum_of)

    def whole(values: Values) -> int:
        found: int = combine(first(values), second(values))
        return found if INT_LOW <= found <= INT_HIGH else functions.overflow(found)

    return Value(whole, INTEGER, sum_of=sum_of)


def _operation(op: str, left: Value, right: Value) -> Value:
    first, second = left.get, right.get
    if op == "/":
        return Value(lambda values: first(values) / second(values), FLOAT)
    if op == "Mod":
        kind = FLOAT if FLOAT in (left.type, right.type) else INTEGER
        return Value(lambda values: functions.modulo(first(values), second(values)), kind)
    if op in _BITS:
        combine, first, second = _BITS[op], as_integer(left), as_integer(right)
        return Value(lambda values: combine(first(values), second(values)), INTEGER)
    function, kind = _FUNCTIONS[op]
    return Value(lambda values: function(first(values), second(values)), kind)


def negated(found: Value) -> Value:
    """Return minus a number."""
    if found.type != FLOAT:
        return arithmetic("-", literal(0), found)
    get = found.get
    return Value(lambda values: -get(values), FLOAT, sum_of=found.sum_of)
