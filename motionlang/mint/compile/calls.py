"""Calls of subs and functions: arguments by value and by reference."""

from __future__ import annotations

from motionlang.mint.compile import intervals
from motionlang.mint.compile.body import Body, Value
from motionlang.mint.compile.conversions import NOTHING, converted
from motionlang.mint.compile.expressions import counted, member, reference, unknown, value
from motionlang.mint.compile.lines import DEPTH
from motionlang.mint.resolve.symbols import INTEGER, RECORD, Function, Symbol, Type
from motionlang.mint.syntax import nodes


def call(b: Body, node: nodes.Name, symbol: Symbol, wanted: bool) -> Value:
    """Return the call of a sub: a value if `wanted`, otherwise a statement."""
    callee = symbol.home
    if wanted and callee.result is None:
        b.problem("type", f"{symbol.name} is a sub and has no value", node, "a Function has a value")
        return NOTHING
    args = node.args or []
    if len(args) != len(callee.parameters):
        count = len(callee.parameters)
        b.problem("values", f"{symbol.name} takes {count} value{'s' * (count != 1)}, {len(args)} given", node)
        return NOTHING
    texts = [_argument(b, arg, parameter) for arg, parameter in zip(args, callee.parameters, strict=True)]
    if callee.counted:
        texts.append(depth_below(b))
    text = f"{symbol.python}({', '.join(texts)})"
    b.calls = True
    b.callee = callee
    if not callee.plain:
        b.note_yield()
        text = f"(yield from {text})"
    known = intervals.INTEGER if symbol.type.name == INTEGER else intervals.FLOAT
    return Value(text, str(symbol.type), known)


def depth_below(b: Body) -> str:
    """Return the stack depth that a call leaves; at 0 it raises a recursion error."""
    if not gets_depth(b.function):
        return f"{whole_stack(b)}[0]"
    b.names.append(DEPTH)
    return f"{DEPTH}[0] or {b.whole.use('env', 'too_deep')}()"


def whole_stack(b: Body) -> str:
    """Return the stack depth available to a task when it begins."""
    return b.whole.use("env", "stack")


def gets_depth(function: Function) -> bool:
    """True if a function receives the remaining stack depth as a parameter.

    Other functions begin with the whole stack.
    """
    return function.counted and (function.kind == "sub" or function.jumps)


def _argument(b: Body, node: nodes.Expr, parameter: Symbol) -> str:
    if parameter.is_array:
        return _array(b, node, parameter)
    if parameter.by_ref:
        return _reference(b, node, parameter)
    found = value(b, node)
    if parameter.type.name == RECORD:
        if found.type != str(parameter.type):
            b.problem("type", f"{parameter.name} must be a {parameter.type}", node)
        return f"{b.whole.use('env', 'copy')}({found.text})"
    text = converted(b, found, parameter.type, node)
    return f"[{text}]" if parameter.boxed else text


def _array(b: Body, node: nodes.Expr, parameter: Symbol) -> str:
    """Return an array argument: a list, and the sizes if it has several subscripts."""
    wanted = len(parameter.dimensions)
    found = array(b, node)
    if found is None or len(found[2]) != wanted:
        many = "one subscript" if wanted == 1 else f"{wanted} subscripts"
        b.problem("type", f"{parameter.name} must be given an array with {many}", node)
        return "[0]"
    text, kind, sizes = found
    if str(kind) != str(parameter.type):
        given = node.field if type(node) is nodes.Member else getattr(node, "name", "")
        b.problem("type", f"{parameter.name} is an array of {parameter.type}, {given} one of {kind}", node)
    return text if wanted == 1 else ", ".join([text, *counted(text, sizes)])


def array(b: Body, node: nodes.Expr) -> tuple[str, Type, tuple[int, ...]] | None:
    """Return text, type and sizes of a whole array, which may be a member of a record."""
    if type(node) is nodes.Name and node.args is None:
        symbol = node.symbol
        if symbol is not None and symbol.is_array:
            return b.spelt(symbol), symbol.type, symbol.dimensions
    if type(node) is nodes.Member and node.args is None:
        owner = member(b, node)
        if owner is not None and owner[2]:
            return owner
    return None


def _reference(b: Body, node: nodes.Expr, parameter: Symbol) -> str:
    """Return a ByRef argument: a list and an index, which the sub reads and writes."""
    if type(node) is nodes.Name or type(node) is nodes.Member:
        symbol = node.symbol if type(node) is nodes.Name else None
        if (symbol is not None and symbol.kind in ("variable", "parameter")) or type(node) is nodes.Member:
            text, kind, _ = reference(b, node)
            if str(kind) != str(parameter.type):
                b.problem("type", f"{parameter.name} is by reference and needs a variable of type {parameter.type}, "
                          f"not {kind}", node)  # fmt: skip
            return _pair(text)
        if symbol is None and type(node) is nodes.Name and node.row is None:
            unknown(b, node)
            return "[0], 0"
    found = value(b, node)  # any other expression is a temporary value, which the sub may change
    return f"[{converted(b, found, parameter.type, node)}], 0"


def _pair(text: str) -> str:
    """Split `name[place]` into the two arguments `name, place`."""
    if not text.endswith("]"):
        return f"[{text}], 0"
    depth = 0
    for at in range(len(text) - 1, 0, -1):
        depth += (text[at] == "]") - (text[at] == "[")
        if depth == 0:
            break
    return f"{text[:at]}, {text[at + 1 : -1]}"
