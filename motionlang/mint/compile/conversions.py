"""Conversions: literals, and the text of a value as another type."""

from __future__ import annotations

from math import inf, isnan

from motionlang.mint.compile import intervals
from motionlang.mint.compile.body import Body, Value
from motionlang.mint.resolve.symbols import FLOAT, INTEGER, NUMERIC, STRING, TIME, Type
from motionlang.mint.runtime.functions import MAX_TEXT
from motionlang.mint.syntax import nodes

# Replaces a wrong value, which has been reported, so that other errors are found. Its type is no error.
NOTHING = Value("0", FLOAT, intervals.ANY)


def literal(known: float | str) -> Value:
    """Return the value of a known constant."""
    if isinstance(known, str):
        return Value(repr(known), STRING, intervals.ANY, known)
    kind = INTEGER if type(known) is int and intervals.INT_LOW <= known <= intervals.INT_HIGH else FLOAT
    if isnan(known) or known in (inf, -inf):
        return Value(f"float('{known}')", FLOAT)
    if type(known) is int and abs(known) > intervals.EXACT:
        known = float(known)
    text = repr(known) if known >= 0 else f"({known!r})"
    return Value(text, kind, intervals.constant(known), known)


def as_float(found: Value) -> str:
    """Return the text of a number that must be a Python float."""
    known = found.const
    if known.__class__ is int:
        return f"{found.text}.0" if 0 <= known <= intervals.INT_HIGH else literal(float(known)).text
    return found.text if found.range[2] == "f" else f"({found.text} + 0.0)"


def as_integer(b: Body, found: Value) -> str:
    """Return the text of a number as a 32-bit Python int, with the fraction cut off."""
    const = found.const
    if const is not None and found.type != STRING and intervals.INT_LOW <= const <= intervals.INT_HIGH:  # type: ignore[operator]
        return literal(int(const)).text
    if found.type in (INTEGER, TIME) or intervals.fits_integer(found.range):
        return found.text
    return f"{b.whole.use('fn', 'integer')}({found.bare})"


def converted(b: Body, found: Value, type: Type, node: nodes.Node, exact: bool = True) -> str:
    """Return the text of a value converted for a variable of a type.

    With `exact` a Float must be a Python float, not an int.
    """
    if type.name == FLOAT and found.type in NUMERIC:
        return as_float(found) if exact else found.text
    if type.name == INTEGER and found.type in NUMERIC:
        return as_integer(b, found)
    if type.name == STRING and found.type == STRING:
        size = MAX_TEXT if type.size is None else type.size
        if isinstance(found.const, str) and len(found.const) <= size:
            return found.text
        return f"{b.whole.use('fn', 'fit')}({found.text}, {size})"
    if type.name == TIME and found.is_number:
        return f"{b.whole.use('env', 'since')}({found.text})"
    if found is NOTHING:
        return "0"
    hint = ""
    if type.name == STRING and found.is_number:
        hint = "convert the number with Str"
    elif found.type == STRING:
        hint = "convert the text with Val"
    b.problem("type", f"cannot assign {article(found.type)} to {article(str(type))}", node, hint)
    return "0"


def article(type: str) -> str:
    """Return the name of a type with its indefinite article."""
    return f"an {type}" if type[:1] in "AEIOaeio" else f"a {type}"
