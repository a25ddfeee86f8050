"""Check PRINT, LINE and INPUT."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.mint.check.unknown_words import hint_at_type, unknown_name
from motionlang.kernel.mint.check.values import article, typed
from motionlang.kernel.mint.resolve.symbols import FLOAT, NUMERIC, STRING
from motionlang.kernel.mint.steps import expressions
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


def print_(b: UnitWriter, node: nodes.Print) -> None:
    """Check `PRINT items`, and a LINE with formats or a `;`."""
    if node.word and (node.row is None or node.row.function != "line"):
        message = f"USING and ; belong among the values of PRINT and LINE, not of {node.word}"
        b.problem("syntax", message, node, hint_at_type(node.word))
        return
    if node.word:
        _print_on_row(b, node, node.line, node.items)
        return
    _terminal(b, node.terminal)
    for item in node.items:
        _item(b, item)


def _terminal(b: UnitWriter, node: nodes.Expr | None) -> None:
    if node is not None:
        b.number(node, "the number of a terminal")


def _item(b: UnitWriter, item: nodes.PrintItem) -> None:
    found = b.value(item.value)
    for index, each in enumerate(item.using):
        width = b.value(each)
        if not width.is_number:
            what = "decimals are" if index else "a width is"
            hint = "decimals follow the width after a comma; a semicolon ends the item" if index else ""
            b.problem("type", f"{what} needed here, not {article(width.type)}", each, hint)
    if len(item.using) > 2:
        b.problem("values", f"USING takes a width and decimals, {len(item.using)} values given", item)
    elif not item.using and found.type != STRING and found.type not in NUMERIC:
        b.problem("type", f"{article(found.type)} cannot be printed", item.value, "print its members")


def line(b: UnitWriter, node: nodes.Call) -> None:
    """Check `LINE row, values`: print from the beginning of a row of the screen."""
    args = node.target.args or []
    items = [nodes.PrintItem(each.start, each.end, each, [], "") for each in args[1:]]
    _print_on_row(b, node, args[0] if args else None, items)


def _print_on_row(
    b: UnitWriter, node: nodes.Stmt, row: nodes.Expr | None, items: list[nodes.PrintItem]
) -> None:
    if row is None:
        b.problem("values", "LINE needs the number of a row", node, 'LINE 2, "text" prints on the second row')
        return
    b.number(row, "the number of a row")
    for item in items:
        _item(b, item)


def input_(b: UnitWriter, node: nodes.Input) -> None:
    """Check `INPUT "prompt", variable`."""
    target: nodes.Expr = node.target
    symbol = target.symbol if type(target) is nodes.Name else None
    if type(target) is nodes.Name and symbol is None:
        unknown_name(b, target)
        return
    kind = expressions.place(b, node.target)[2]
    if symbol is not None and symbol.kind not in ("variable", "parameter"):
        b.problem("type", f"INPUT needs a variable, and {symbol.name} is a {symbol.kind}", target)
        return
    _terminal(b, node.terminal)
    if node.prompt is not None:
        b.value(node.prompt)
    b.convert(typed(STRING if kind.name == STRING else FLOAT), kind, node)
