"""Compile operators: combine the values of both sides, with the checks they need."""

from __future__ import annotations

from motionlang.mint.compile import intervals
from motionlang.mint.compile.body import PRODUCT, SUM, Answer, Body, Value
from motionlang.mint.compile.conversions import NOTHING, article, as_float, as_integer, literal
from motionlang.mint.resolve.symbols import FLOAT, INTEGER, STRING
from motionlang.mint.syntax import nodes

COMPARISONS = {"=": "==", "<>": "!=", "<": "<", ">": ">", "<=": "<=", ">=": ">="}
ARITHMETIC = {"+": SUM, "-": SUM, "*": PRODUCT}
_BITS = {"&": "&", "|": "|", "Xor": "^"}


def operate(b: Body, op: str, left: Value, right: Value) -> Value:
    """Return `left op right` for two numbers and an operator not in `ARITHMETIC`."""
    if op in COMPARISONS:
        return Answer(f"{left.bare} {COMPARISONS[op]} {right.bare}")
    if op == "/":
        first = left.bare if left.binds == PRODUCT else left.text
        b.whole.checks = True
        return Value(f"({first} / {right.text})", FLOAT, intervals.FLOAT, None, PRODUCT)
    if op == "^":
        return Value(f"{b.whole.use('fn', 'power')}({left.bare}, {right.bare})", FLOAT, intervals.FLOAT)
    if op == "\\":
        return _quotient(b, left, right)
    if op == "Mod":
        return _remainder(b, left, right)
    if op in _BITS:
        known = intervals.INTEGER
        if op == "&" and min(left.range[0], right.range[0]) >= 0:
            known = (0, min(left.range[1], right.range[1], intervals.INT_HIGH), "i")
        return Value(f"({as_integer(b, left)} {_BITS[op]} {as_integer(b, right)})", INTEGER, known)
    shift = b.whole.use("fn", "shift_left" if op == "<<" else "shift_right")
    return Value(f"{shift}({left.bare}, {right.bare})", INTEGER, intervals.INTEGER)


def arithmetic(b: Body, op: str, left: Value, right: Value) -> Value:
    """Return `left op right` for + - *, with a check if the result may not fit."""
    binds = ARITHMETIC[op]
    first = left.text[1:-1] if left.binds >= binds else left.text  # Python also groups from the left
    second = right.text[1:-1] if right.binds > binds else right.text
    if left.range[2] == "f" or right.range[2] == "f":
        return Value(f"({first} {op} {second})", FLOAT, intervals.FLOAT, None, binds)
    kind = FLOAT if FLOAT in (left.type, right.type) else INTEGER
    known, how = intervals.arithmetic(op, kind == INTEGER, left.range, right.range)
    if how == intervals.COERCED:
        if right.const is not None:
            return Value(f"({left.text} {op} {as_float(right)})", kind, known)
        return Value(f"({as_float(left)} {op} {right.text})", kind, known)
    text = f"{first} {op} {second}"
    if how == intervals.CHECKED:
        over = b.whole.use("fn", "overflow")
        return Value(
            f"(z if {intervals.INT_LOW} <= (z := {text}) <= {intervals.INT_HIGH} else {over}(z))", kind, known
        )
    return Value(f"({text})", kind, known, None, binds)


def _quotient(b: Body, left: Value, right: Value) -> Value:
    a, c = left.range, right.range
    if intervals.fits_integer(a) and intervals.fits_integer(c):
        if a[0] >= 0 and c[0] > 0:
            return Value(f"({left.text} // {right.text})", INTEGER, intervals.quotient(a, c))
        known = intervals.quotient(a, c)
    else:
        known = intervals.INTEGER
    return Value(f"{b.whole.use('fn', 'divide')}({left.bare}, {right.bare})", INTEGER, known)


def _remainder(b: Body, left: Value, right: Value) -> Value:
    a, c = left.range, right.range
    kind = INTEGER if FLOAT not in (left.type, right.type) else FLOAT
    if a[2] == "i" and c[2] == "i":
        known = intervals.remainder(a, c)
        if a[0] >= 0 and c[0] > 0:
            return Value(f"({left.text} % {right.text})", kind, known)
    else:
        known = intervals.FLOAT if "f" in (a[2], c[2]) else intervals.ANY
    return Value(f"{b.whole.use('fn', 'modulo')}({left.bare}, {right.bare})", kind, known)


def text(b: Body, node: nodes.Binary, left: Value, right: Value) -> Value:
    """Return `left op right` for two strings; report an error if one is not a string."""
    if left is NOTHING or right is NOTHING:
        return NOTHING
    if left.type != STRING or right.type != STRING:
        hint = "convert the number with Str" if node.op in ("+", "&") else ""
        b.problem("type", f"{node.op} cannot take {article(left.type)} and {article(right.type)}", node, hint)
        return NOTHING
    if node.op in ("+", "&"):
        if isinstance(left.const, str) and isinstance(right.const, str):
            return literal(left.const + right.const)
        return Value(f"({left.text} + {right.text})", STRING, intervals.ANY)
    if node.op in COMPARISONS:
        return Answer(f"{left.text} {COMPARISONS[node.op]} {right.text}")
    b.problem("type", f"{node.op} needs numbers, not texts", node)
    return NOTHING
