"""Check the indices of a keyword: axes, channels, tasks, arrays, or none."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.check.unknown_words import task_named
from motionlang.kernel.mint.check.values import article
from motionlang.kernel.mint.resolve.symbols import NUMERIC
from motionlang.kernel.mint.runtime.task import PARENT
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.tools import count_of

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


def axes_by_default(b: UnitWriter, target: nodes.Name, row: Keyword) -> bool:
    """True if a keyword without brackets means the axes of AXES."""
    return target.args is None and row.index in ("axis", "axes") and b.program.names.uses_axes


def check_indices(b: UnitWriter, node: nodes.Name, row: Keyword, single: bool) -> int:
    """Check the indices of a keyword, and return how many it has.

    Several axes are accepted unless the keyword is read for a `single` one.
    """
    args = node.args or []
    if row.index == "none":
        if args:
            b.problem("values", f"{row.word} takes no brackets", node)
        return 0
    kinds = row.index.split(", ")
    if kinds[-1] == "array":
        _with_arrays(b, node, row, kinds)
    elif not args:
        if len(kinds) > 1 or row.index == "task":
            needed = row.index if len(kinds) > 1 else article(row.index)
            b.problem("values", f"{row.word} needs {needed} in brackets", node)
    elif len(args) == len(kinds) or (len(args) > len(kinds) and kinds[-1] in ("axis", "axes") and not single):
        kinds += kinds[-1:] * (len(args) - len(kinds))
        for arg, kind in zip(args, kinds, strict=True):
            _index(b, arg, kind)
    else:
        wanted = many(1, kinds[0]) if len(kinds) == 1 else f"{many(len(kinds), 'value')} ({row.index})"
        b.problem("values", f"{row.word} takes {wanted} in brackets, {len(args)} given", node)
    return len(kinds)


def _index(b: UnitWriter, node: nodes.Expr, kind: str) -> None:
    if kind == "task":
        _task(b, node)
        return
    if kind == "distance":
        b.number(node, "a distance")
        return
    what = f"the number of {article('axis' if kind == 'axes' else kind)}"
    known = b.number(node, what).const
    if known is None:
        return
    if known != int(known):
        b.problem("range", f"{known} is not {what}", node)
    elif kind in ("axis", "axes") and known not in b.program.axes:
        hint = f"this controller has axes 0 to {b.program.axes[-1]}; controller.axes sets their number"
        b.problem("axis", f"there is no axis {known}", node, hint)


def _task(b: UnitWriter, node: nodes.Expr) -> None:
    """Check the name of a task, which is no expression: its node has the symbol, none for the parent task."""
    word = node.name if type(node) is nodes.Name else Word("")
    if type(node) is not nodes.Name or node.args is not None:
        node = nodes.Name(node.start, node.end, word).resolve(None)
    elif node.symbol is None and word.lower() == PARENT.lower():
        return
    task_named(b, node, word)


def _with_arrays(b: UnitWriter, node: nodes.Name, row: Keyword, kinds: list[str]) -> None:
    """Check the indices of a keyword whose last ones are arrays, which may be omitted."""
    args = node.args or []
    least = len(kinds) - kinds.count("array") + 1
    if not least <= len(args) <= len(kinds):
        message = f"{row.word} takes {row.index} in brackets, {len(args)} given"
        b.problem("values", message, node, row.example.split("\n")[0])
        return
    for kind, arg in zip(kinds, args, strict=False):
        if kind == "array":
            _array(b, arg, row)
        else:
            _index(b, arg, kind)


def _array(b: UnitWriter, node: nodes.Expr, row: Keyword) -> None:
    """Check an array as a whole; NULL and 0 stand for none."""
    if type(node) is nodes.Number and node.value == 0:
        return
    symbol = node.symbol if type(node) is nodes.Name and node.args is None else None
    if symbol is None and type(node) is nodes.Name and node.name.lower() == "null":
        return
    if symbol is None or len(symbol.dimensions) != 1 or symbol.type.name not in NUMERIC:
        message = f"{row.word} needs an array of numbers with one subscript here"
        b.problem("type", message, node, "NULL stands for a table that is not given")
    else:
        node.type = str(symbol.type)


def many(count: int, what: str) -> str:
    """Return a count with a noun of the table of keywords: 2 axes, 1 value."""
    return count_of(count, what, {"axis": "axes", "index": "indices"}.get(what, ""))
