"""Compile keywords with several values per axis: paths, and tables in arrays."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword
from motionlang.mint.compile import keyword_use
from motionlang.mint.compile.body import Body
from motionlang.mint.resolve.symbols import NUMERIC
from motionlang.mint.syntax import nodes


def write_path(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Compile `VECTORA(0, 1) = 10, 20` and `CIRCLER(0, 1) = 10, 0, 90` as one move.

    The row's unit lists the units of the values, "uu" once for each axis. A single unit applies to every
    axis.
    """
    values = [keyword_use._value(b, each, row) for each in node.values]
    if keyword_use.by_default(b, target, row):
        operation, axes = b.whole.called("load", row, [f"{b.whole.use('env', 'default_axes')}()"])
    else:
        found = keyword_use.indices(b, target, row, single=False)
        _check(b, node, target, row, len(found))
        operation, axes = b.whole.called_together("load", row, found)
    line = str(b.whole.line(node.start))
    b.operate([(operation, [*axes, f"({', '.join(values)},)", line])])


def _check(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword, axes: int) -> None:
    """Check the number of axes and of values, if the axes are literals."""
    units = row.unit.split(", ")
    wanted = units.count("uu") if len(units) > 1 else 0
    if (wanted and axes != wanted) or axes < 2:
        needed = f"{wanted} axes" if wanted else "2 axes or more"
        b.problem("values", f"{row.name} needs {needed} in brackets, {axes} given", target, _form(row))
        return
    count = len(units) if wanted else axes
    if len(node.values) != count:
        b.problem(
            "values", f"{row.name} needs {count} values here, {len(node.values)} given", node, _form(row)
        )


def _form(row: Keyword) -> str:
    return row.example.split("\n")[0]


def with_arrays(b: Body, node: nodes.Name, row: Keyword, names: list[str]) -> list[str]:
    """Return the index texts of a keyword that takes arrays; an omitted one is NULL."""
    args = list(node.args or [])
    least = len(names) - names.count("array") + 1
    if not least <= len(args) <= len(names):
        b.problem("values", f"{row.name} takes {row.index} in brackets, {len(args)} given", node, _form(row))
        return ["0"] * (len(names) - names.count("array")) + ["None"] * names.count("array")
    found = []
    for kind, arg in zip(names, args, strict=False):
        found.append(_array(b, arg, row) if kind == "array" else keyword_use._index(b, arg, kind))
    return found + ["None"] * (len(names) - len(args))


def _array(b: Body, node: nodes.Expr, row: Keyword) -> str:
    """Return an array as a whole, or None for NULL and 0."""
    if type(node) is nodes.Number and node.value == 0:
        return "None"
    symbol = node.symbol if type(node) is nodes.Name and node.args is None else None
    if symbol is None and type(node) is nodes.Name and node.name.lower() == "null":
        return "None"
    if symbol is None or len(symbol.dimensions) != 1 or symbol.type.name not in NUMERIC:
        b.problem("type", f"{row.name} needs an array of numbers with one subscript here", node,
                  "NULL stands for a table that is not given")  # fmt: skip
        return "None"
    return b.spelt(symbol)
