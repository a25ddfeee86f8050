"""Check loops, and the statements that leave them."""

from __future__ import annotations

from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.unknown_words import another_name
from motionlang.kernel.mint.check.variables import location
from motionlang.kernel.mint.resolve.symbols import NUMERIC, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk


def count(b: Body, node: nodes.For) -> None:
    """Check `For variable = first To stop Step step … Next`."""
    symbol = node.variable.symbol
    if symbol is None or symbol.kind not in ("variable", "parameter") or symbol.type.name not in NUMERIC:
        name, row = node.variable.name, node.variable.row
        hint = another_name(name, row) if row else ""
        b.problem("type", f"{name} cannot count: it is not a numeric variable", node.variable, hint)
        return
    location(b, node.variable)
    b.number(node.first)
    b.number(node.stop)
    if node.step is not None and _may_be_0(b, node.step) and not _may_end(node, symbol):
        b.problem("range", "a For that counts by 0 never ends", node.step, "leave it with Exit For")
    _body(b, "for", node.body)


def _may_be_0(b: Body, step: nodes.Expr) -> bool:
    """True if a step is 0, or if its value is only known when the program starts."""
    known = b.number(step).const
    return known == 0 or (known is None and _is_known_at_start(step))


def _is_known_at_start(node: nodes.Expr) -> bool:
    match meant(node):
        case nodes.Given():
            return True
        case nodes.Cast(value=value) | nodes.Unary(operand=value):
            return _is_known_at_start(value)
        case nodes.Binary(left=left, right=right):
            return _is_known_at_start(left) and _is_known_at_start(right)
        case other:
            return other.const is not None


def _may_end(node: nodes.For, symbol: Symbol) -> bool:
    """True if the body may leave the loop, or assigns to its variable."""
    for each in walk(node.body):
        if isinstance(each, (nodes.Exit, nodes.Jump, nodes.Return, nodes.End)):
            return True
        if isinstance(each, nodes.Call) and each.target.row is None:
            return True
        if isinstance(each, nodes.Assign) and _is_variable(each.target, symbol):
            return True
        if isinstance(each, nodes.For) and _is_variable(each.variable, symbol):
            return True
    return False


def _is_variable(node: nodes.Expr, symbol: Symbol) -> bool:
    return type(node) is nodes.Name and node.args is None and node.symbol is symbol


def while_(b: Body, node: nodes.While) -> None:
    """Check `While condition … End While`."""
    b.condition(node.condition)
    _body(b, "while", node.body)


def repeat(b: Body, node: nodes.Repeat) -> None:
    """Check `Repeat … Until condition`."""
    _body(b, "repeat", node.body)
    b.condition(node.condition)


def endless(b: Body, node: nodes.Loop) -> None:
    """Check `Loop … End Loop`."""
    _body(b, "loop", node.body)


def _body(b: Body, kind: str, body: list[nodes.Stmt]) -> None:
    b.loops.append(kind)
    b.statements(body)
    b.loops.pop()


def exit_(b: Body, node: nodes.Exit) -> None:
    """Check `Exit` and `Exit For …`, which leave a loop, a Select or the function."""
    kind, function = node.kind, b.function
    if kind in ("sub", "function", "task", "event"):
        wanted = "sub" if kind == "function" else kind
        inside = function.kind == wanted and (kind == "function") is (function.result is not None)
        outside = f"Exit {kind.capitalize()} outside a {kind.capitalize()}"
    elif kind:
        inside, outside = kind in b.loops, f"Exit {kind.capitalize()} outside a {kind.capitalize()}"
    else:
        inside, outside = any(each != "select" for each in b.loops), "Exit outside a loop"
    if not inside:
        hint = "" if kind else "Exit Sub leaves a sub, Exit Function a function"
        b.problem("stray-end", outside, node, hint)
