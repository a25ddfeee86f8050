"""Compile PRINT, LINE and INPUT."""

from __future__ import annotations

from motionlang.mint.compile import keyword_use
from motionlang.mint.compile.body import Body, Value
from motionlang.mint.compile.conversions import article, converted
from motionlang.mint.compile.expressions import number, reference, unknown, value
from motionlang.mint.resolve.symbols import FLOAT, INTEGER, NUMERIC, STRING, Type
from motionlang.mint.syntax import nodes
from motionlang.mint.syntax.nesting import LINKS


def print_(b: Body, node: nodes.Print) -> None:
    """Compile `PRINT items`, and a LINE with formats or a `;`."""
    if node.word:
        _line_of_items(b, node)
        return
    where = _terminal(b, node.terminal)
    texts = [_shown(b, item) for item in node.items]
    if not node.items or not node.items[-1].separator:
        texts.append("'\\n'")
    b.observes = True
    b.act(_printed(b, _together(texts), where))


def _terminal(b: Body, node: nodes.Expr | None) -> str:
    """Return the text of the terminal number after a `#`, "" if there is none."""
    if node is None:
        return ""
    return converted(b, number(b, node, "the number of a terminal"), Type(INTEGER), node)


def _use(b: Body, name: str) -> str:
    """Return the name of a terminal operation, a keyword internal to the compiler."""
    return b.whole.use("read", f"({name})")


def _printed(b: Body, text: str, where: str = "") -> str:
    """Return the call that prints a text.

    A program that uses no terminals prints to the console only.
    """
    if not where and not b.whole.names.uses_terminal:
        return f"P({text})"
    return f"{_use(b, 'printer')}({', '.join(filter(None, (text, where)))})"


def _together(texts: list[str]) -> str:
    """Return the concatenation of texts; a long sum would nest too deeply for Python."""
    joined = _joined(texts)
    return " + ".join(joined) if len(joined) <= LINKS else f"''.join(({', '.join(joined)}))"


def _joined(texts: list[str]) -> list[str]:
    """Join adjacent literal texts, which Python concatenates."""
    out: list[str] = []
    for text in texts:
        if out and out[-1][0] in "'\"" and text[0] in "'\"":
            out[-1] += f" {text}"
        else:
            out.append(text)
    return out


def _shown(b: Body, item: nodes.PrintItem) -> str:
    found = value(b, item.value)
    if b.whole.typed:
        found = _in_whole_counts(b, item.value, found)
    if item.using:
        return _using(b, item, found)
    if found.type == STRING:
        return found.text
    if found.type not in NUMERIC:
        b.problem("type", f"{article(found.type)} cannot be printed", item.value, "print its members")
        return "''"
    return f"{b.whole.use('show', 'float' if found.type == FLOAT else 'integer')}({found.bare})"


def _in_whole_counts(b: Body, node: nodes.Expr, found: Value) -> Value:
    """Round a printed position to whole counts, as a controller's prompt shows it.

    The value that a program reads keeps its fraction.
    """
    row = node.row if type(node) is nodes.Name and node.symbol is None else None
    if type(node) is not nodes.Name or row is None or row.changes != "motion" or row.unit != "uu":
        return found
    if node.args and type(node.args[0]) is not nodes.Number:
        return found  # the index is evaluated once
    (axis,) = keyword_use.read_at(b, node, row)
    return Value(f"{b.whole.use('env', 'in_whole_counts')}({found.bare}, {axis})", FLOAT)


def _using(b: Body, item: nodes.PrintItem, found: Value) -> str:
    kind = {STRING: "text", FLOAT: "float"}.get(found.type, "integer")
    widths = [_width(b, each, first=index == 0) for index, each in enumerate(item.using)]
    if len(widths) > 2:
        b.problem("values", f"USING takes a width and decimals, {len(widths)} values given", item)
        return "''"
    return f"{b.whole.use('using', kind)}({', '.join([found.text, *widths])})"


def _width(b: Body, node: nodes.Expr, first: bool) -> str:
    found = value(b, node)
    if found.type in NUMERIC:
        return converted(b, found, Type(INTEGER), node)
    what = "a width is" if first else "decimals are"
    hint = "" if first else "decimals follow the width after a comma; a semicolon ends the item"
    b.problem("type", f"{what} needed here, not {article(found.type)}", node, hint)
    return "0"


def line(b: Body, node: nodes.Call) -> None:
    """Compile `LINE row, values`: print from the beginning of a row of the screen."""
    args = node.target.args or []
    _print_on_row(
        b,
        node,
        args[0] if args else None,
        [nodes.PrintItem(each.start, each.end, each, [], "") for each in args[1:]],
    )


def _line_of_items(b: Body, node: nodes.Print) -> None:
    if node.row is None or node.row.verb != "line":
        b.problem(
            "syntax", f"USING and ; belong among the values of PRINT and LINE, not of {node.word}", node
        )
        return
    _print_on_row(b, node, node.line, node.items)


def _print_on_row(b: Body, node: nodes.Stmt, where: nodes.Expr | None, items: list[nodes.PrintItem]) -> None:
    if where is None:
        b.problem("values", "LINE needs the number of a row", node, 'LINE 2, "text" prints on the second row')
        return
    row = converted(b, number(b, where, "the number of a row"), Type(INTEGER), where)
    text = _together([_shown(b, item) for item in items] or ["''"])
    b.observes = True
    say = _use(b, "row") if b.whole.names.uses_terminal else b.whole.use("env", "say_on_row")
    b.act(f"{say}({row}, {text})")


def input_(b: Body, node: nodes.Input) -> None:
    """Compile `INPUT "prompt", variable`."""
    target: nodes.Expr = node.target
    if type(target) is nodes.Name and target.symbol is None:
        unknown(b, target)
        return
    text, kind, _ = reference(b, node.target)
    if type(target) is nodes.Name and (symbol := target.symbol) is not None:
        if symbol.kind not in ("variable", "parameter"):
            b.problem("type", f"INPUT needs a variable, and {symbol.name} is a {symbol.kind}", target)
            return
        if not (symbol.is_array or symbol.boxed or symbol.by_ref):
            b.use_outside(symbol)
    where = _terminal(b, node.terminal)
    b.observes = True
    b.flush()
    b.settle()
    ask, typed, arguments = b.whole.use("env", "input"), b.whole.use("env", "typed"), ""
    if where or b.whole.names.uses_terminal:
        one = b.temp()
        b.emit(f"{one} = {_use(b, 'terminal')}({where or -1})")
        ask, typed, arguments, where = _use(b, "question"), _use(b, "answer"), f", {one}", one
    if node.prompt is not None:
        b.emit(_printed(b, value(b, node.prompt).text, where))
    b.wait(f"{ask}(t{arguments})")
    found = Value(f"{typed}({kind.name == STRING}{arguments})", STRING if kind.name == STRING else FLOAT)
    b.emit(f"{text} = {converted(b, found, kind, node)}")
    b.pending += 1
