"""Check subscripts, and what a For counts: a step of 0, and elements outside their arrays."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from motionlang.kernel.mint.resolve.handlers import label_handlers
from motionlang.kernel.mint.resolve.symbols import Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant, walk

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


def check_subscript(w: UnitWriter, node: nodes.Node, value: float, size: int) -> None:
    """Report a subscript outside 1 … size, if the size is known."""
    if size and not 1 <= value <= size:
        hint = "the first element of an array has the subscript 1"
        w.error("index", f"there is no element {value}: the subscript must be 1 to {size}", node, hint)


def check_step(w: UnitWriter, node: nodes.For, symbol: Symbol, by: float | str | None) -> None:
    """Report a For that never ends, since its step is 0, or is only known when the program starts."""
    may_be_0 = by == 0 or (by is None and node.step is not None and _is_known_at_start(node.step))
    if node.step is not None and may_be_0 and not _may_end(node, symbol):
        w.error("range", "a For that counts by 0 never ends", node.step, "leave it with Exit For")


def check_elements(w: UnitWriter, node: nodes.For, symbol: Symbol) -> None:
    """Report the elements outside their arrays that a For comes to by its first or its last value, each time."""
    others = symbol.shared and any(each.kind in ("task", "event") for each in w.program.names.functions)
    if others or _may_end(node, symbol) or label_handlers(w.function):
        return
    loops = nodes.While | nodes.Repeat | nodes.Loop
    if any(isinstance(each, loops) or _is_function(each) for each in walk(node.body)):
        return
    for statement in _every_time(node.body):
        for name in walk([statement]):
            if type(name) is not nodes.Name or name.symbol is None:
                continue
            for arg, size in zip(name.args or (), name.symbol.dimensions, strict=False):
                for value in _ends(node) if _is_variable(arg, symbol) else ():
                    check_subscript(w, arg, value, size)


def _ends(node: nodes.For) -> tuple[int, ...]:
    """Return the first and the last value of a For that is carried out, () if they are not known before the run."""
    first, stop, step = node.first.const, node.stop.const, 1 if node.step is None else node.step.const
    if not (isinstance(first, int) and isinstance(stop, int) and isinstance(step, int) and step):
        return ()
    return (first, stop - (stop - first) % step) if (stop - first) * step >= 0 else ()


def _every_time(body: list[nodes.Stmt]) -> Iterator[nodes.Stmt]:
    """Yield the assignments and prints of a body that are carried out whole whenever it is."""
    for each in body:
        if type(each) is nodes.For and _ends(each):
            yield from _every_time(each.body)
        elif isinstance(each, nodes.Assign | nodes.Print) and not any(
            type(part) is nodes.Binary and part.op in ("And", "Or") for part in walk([each])
        ):
            yield each


def _is_function(node: nodes.Node) -> bool:
    return isinstance(node, nodes.Name) and node.symbol is not None and node.symbol.kind == "sub"


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
        if isinstance(each, nodes.Assign | nodes.Input) and _is_variable(each.target, symbol):
            return True
        if isinstance(each, nodes.For) and _is_variable(each.variable, symbol):
            return True
    return False


def _is_variable(node: nodes.Expr, symbol: Symbol) -> bool:
    return type(node) is nodes.Name and node.args is None and node.symbol is symbol
