"""Compile `Pause condition`, tested only when a dependency changes: no polling."""

from __future__ import annotations

from motionlang.mint.compile.body import Body
from motionlang.mint.compile.expressions import condition
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.traversal import meant, walk
from motionlang.mint.syntax.unparse import shown


def pause(b: Body, node: nodes.Pause) -> None:
    """Write the wait: test once, then yield until the condition is true."""
    b.begin()
    test = condition(b, node.condition)
    calls = b.calls
    b.observes = True
    b.calls = False
    b.flush()
    b.settle()
    b.note_yield()
    if calls:  # a condition that calls a sub is tested at every tick
        b.emit(f"while not ({test}): t, H = yield {b.whole.use('env', 'tick')}(t)")
    else:
        why = f"until {shown(node.condition)}"
        axes = _at_rest(node.condition)
        ignores_data = bool(axes) or _ignores_data(node.condition)
        arguments = f"t, lambda: {test}, {why!r}, {b.at}"
        if ignores_data:
            arguments += f", {(*axes,)}" + ("" if axes else ", True")
        pause = f"{b.whole.use('env', 'pause')}({arguments})"
        b.emit(f"if not ({test}): t, H = {pause} or (yield E.wait)")
    b.pending += 1


def _ignores_data(node: nodes.Expr) -> bool:
    """True if a condition reads only axes, inputs and the like.

    It reads no variable, setting or memory of the program.
    """
    names = [each for each in walk([node]) if isinstance(each, nodes.Name)]
    return all(
        each.row is not None and each.symbol is None and each.definition is None
        and each.row.kind == "reading" and each.row.access == "R" and each.row.group in ("io", "state")
        for each in names
    )  # fmt: skip


def _at_rest(node: nodes.Expr) -> list[int]:
    """Return the axes of a condition that only tests whether given axes are at rest.

    Returns [] for any other condition.
    """
    node = meant(node)
    if type(node) is nodes.Binary and node.op == "And":
        left, right = _at_rest(node.left), _at_rest(node.right)
        return left + right if left and right else []
    if type(node) is not nodes.Name or node.row is None or node.row.verb != "is_idle":
        return []
    args = node.args or ()
    axes = [each.value for each in args if type(each) is nodes.Number and isinstance(each.value, int)]
    return axes if len(axes) == len(args) else []
