"""PRINT and LINE.

`USING width` and `USING width, decimals`: a negative width prints the sign of positive numbers, too. Negative decimals
select the exponent form. A number that is too long for its width is printed in full.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.steps import DO, NOW, Values
from motionlang.kernel.mint.check.unknown_words import hint_at_type
from motionlang.kernel.mint.resolve.symbols import FLOAT, INTEGER, NUMERIC, STRING, Type
from motionlang.kernel.mint.runtime import binding
from motionlang.kernel.mint.runtime.printing import show_integer
from motionlang.kernel.mint.steps import expressions, words
from motionlang.kernel.mint.steps.unit import UnitWriter
from motionlang.kernel.mint.steps.values import NOTHING, Get, Value, article
from motionlang.kernel.mint.syntax import nodes

# Wider than any terminal: a wild width is an error, not a request for a gigabyte of blanks.
WIDEST = 255
_KINDS: dict[str, str] = {STRING: "text", FLOAT: "float"}


def print_(w: UnitWriter, node: nodes.Print) -> None:
    """Write `PRINT items`, and a LINE with formats or a `;`."""
    if node.word and (node.row is None or node.row.function != "line"):
        message = f"USING and ; belong among the values of PRINT and LINE, not of {node.word}"
        w.error("syntax", message, node, hint_at_type(node.word))
        return
    if node.word:
        _print_on_row(w, node, node.line, node.items)
        return
    w.settle_before_calls(node)
    number = number_of(w, node.terminal)
    text = _text(w, node.items, "" if node.items and node.items[-1].separator else "\n")
    if w.checks:
        return
    write = printer(w, number)
    w.add(NOW)
    w.add(DO, lambda values: write(values, text(values)), cost=1.0, name="PRINT")


def line(w: UnitWriter, node: nodes.Call) -> None:
    """Write `LINE row, values`: print from the beginning of a row of the screen."""
    args = node.target.args or []
    items = [nodes.PrintItem(each.start, each.end, each, [], "") for each in args[1:]]
    _print_on_row(w, node, args[0] if args else None, items)


def _print_on_row(
    w: UnitWriter, node: nodes.Stmt, where: nodes.Expr | None, items: list[nodes.PrintItem]
) -> None:
    if where is None:
        w.error("values", "LINE needs the number of a row", node, 'LINE 2, "text" prints on the second row')
        return
    w.settle_before_calls(where, *items)
    row = expressions.converted(w, expressions.number(w, where, "the number of a row"), Type(INTEGER))
    text = _text(w, items, "")
    if w.checks:
        return
    say = hidden(w, "row") if w.program.names.uses_terminal else w.program.environment.say_on_row
    w.add(NOW)
    w.add(DO, lambda values: say(row(values), text(values)), cost=1.0, name="LINE")


def number_of(w: UnitWriter, node: nodes.Expr | None) -> Get | None:
    """Return the function for the number of a terminal after `#`, None if there is none."""
    if node is None:
        return None
    return expressions.converted(w, expressions.number(w, node, "the number of a terminal"), Type(INTEGER))


def printer(w: UnitWriter, number: Get | None) -> Callable[[Values, str], None]:
    """Return the function that prints a text; a program that uses no terminals prints to the console only."""
    if number is None and not w.program.names.uses_terminal:
        print_text = w.program.environment.print_text
        return lambda values, text: print_text(text)
    write = hidden(w, "printer")
    if number is None:
        return lambda values, text: write(text)
    return lambda values, text: write(text, number(values))


def hidden(w: UnitWriter, name: str) -> Callable[..., Any]:
    """Return the operation of a keyword that no program can name."""
    return binding.bind(w.program.environment, "read", binding.row_of(f"({name})"))


def _text(w: UnitWriter, items: list[nodes.PrintItem], end: str) -> Get:
    if w.checks:  # in the order of the text
        for each in items:
            _shown(w, each, expressions.value(w, each.value))
        return NOTHING.get
    found = expressions.values(w, [each.value for each in items])
    shown = [_shown(w, item, value) for item, value in zip(items, found, strict=True)]
    if len(shown) == 1:
        (only,) = shown
        return lambda values: only(values) + end
    return lambda values: "".join([each(values) for each in shown]) + end


def _shown(w: UnitWriter, item: nodes.PrintItem, found: Value) -> Get:
    if w.program.names.typed and not w.checks:
        found = _in_whole_counts(w, item.value, found)
    get = found.get
    if item.using:
        widths = [_width_of(w, each, index) for index, each in enumerate(item.using)]
        if len(item.using) > 2:
            w.error("values", f"USING takes a width and decimals, {len(item.using)} values given", item)
        using: Any = USING[_KINDS.get(found.type, "integer")]
        return lambda values: using(get(values), *[each(values) for each in widths])
    if found.type == STRING:
        return get
    if found.type not in NUMERIC:
        w.error("type", f"{article(found.type)} cannot be printed", item.value, "print its members")
    show = w.program.show_float if found.type == FLOAT else show_integer
    return lambda values: show(get(values))


def _width_of(w: UnitWriter, node: nodes.Expr, index: int) -> Get:
    found = expressions.value(w, node)
    if not found.is_number:
        what = "decimals are" if index else "a width is"
        hint = "decimals follow the width after a comma; a semicolon ends the item" if index else ""
        w.error("type", f"{what} needed here, not {article(found.type)}", node, hint)
        return NOTHING.get
    return expressions.converted(w, found, Type(INTEGER))


def _in_whole_counts(w: UnitWriter, node: nodes.Expr, found: Value) -> Value:
    """Round a printed position to whole counts, as a controller's prompt shows it.

    The value that a program reads keeps its fraction.
    """
    row = node.row if isinstance(node, nodes.Name) and node.symbol is None else None
    if not isinstance(node, nodes.Name) or row is None or row.changes != "motion" or row.unit != "uu":
        return found
    (where,) = words.indices(w, node, row, single=True)
    environment, get, axis = w.program.environment, found.get, where.get
    return Value(lambda values: environment.in_whole_counts(get(values), axis(values)), FLOAT)


def _using_float(value: float, width: int, decimals: int = 0) -> str:
    """Format a Float as `%w.df` or, with negative decimals, `%w.de`; -0 prints as 0."""
    sign, width = _width(width)
    kind = "f" if decimals >= 0 else "e"
    return f"{value:{sign}z{width}.{_decimals(decimals)}{kind}}"


def _using_integer(value: float, width: int, decimals: int | None = None) -> str:
    if decimals is not None:
        return _using_float(value, width, decimals)
    sign, width = _width(width)
    return f"{int(value):{sign}{width}d}"


def _using_text(value: str, width: int, decimals: int = 0) -> str:
    """Format a string padded on the right, or on the left for a negative width."""
    _, size = _width(width)
    return value.rjust(size) if width < 0 else value.ljust(size)


def _width(width: int) -> tuple[str, int]:
    if abs(width) > WIDEST:
        raise Rejected("range", f"USING cannot be {width} wide", f"a width is at most {WIDEST}")
    return ("+" if width < 0 else ""), abs(width)


def _decimals(decimals: int) -> int:
    if abs(decimals) > WIDEST:
        raise Rejected("range", f"USING cannot have {decimals} decimals", f"there are at most {WIDEST}")
    return abs(decimals)


USING = {"float": _using_float, "integer": _using_integer, "text": _using_text}
