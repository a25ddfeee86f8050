"""PRINT, LINE and INPUT."""

from __future__ import annotations

from motionlang.mint import nodes
from motionlang.mint.body import Value
from motionlang.mint.expressions import article, converted, number, place, unknown, value
from motionlang.mint.symbols import FLOAT, INTEGER, NUMERIC, STRING, Type

TYPE_CHECKING = False
if TYPE_CHECKING:
    from motionlang.mint.body import Body


def print_(b: Body, node: nodes.Print) -> None:
    """`PRINT items`."""
    texts = [_shown(b, item) for item in node.items]
    if node.terminal is not None:
        number(b, node.terminal, "the number of a terminal")
    if not node.items or not node.items[-1].separator:
        texts.append("'\\n'")
    b.observes = True
    b.act(f"P({' + '.join(_joined(texts))})")


def _joined(texts: list[str]) -> list[str]:
    """Literal texts that stand side by side as one."""
    out: list[str] = []
    for text in texts:
        if out and out[-1][0] in "'\"" and text[0] in "'\"":
            out[-1] = repr(_unquoted(out[-1]) + _unquoted(text))
        else:
            out.append(text)
    return out


def _unquoted(text: str) -> str:
    from ast import literal_eval

    return str(literal_eval(text))


def _shown(b: Body, item: nodes.PrintItem) -> str:
    found = value(b, item.value)
    if item.using:
        return _using(b, item, found)
    if found.type == STRING:
        return found.text if found.const is not None else f"({found.text})"
    if found.type not in NUMERIC:
        b.problem("type", f"{article(found.type)} cannot be printed", item.value, "print its members")
        return "''"
    return f"{b.whole.use('show', 'float' if found.type == FLOAT else 'integer')}({found.text})"


def _using(b: Body, item: nodes.PrintItem, found: Value) -> str:
    kind = {STRING: "text", FLOAT: "float"}.get(found.type, "integer")
    widths = [converted(b, number(b, each, "a width"), Type(INTEGER), each) for each in item.using]
    if len(widths) > 2:
        b.problem("values", f"USING takes a width and decimals, {len(widths)} values given", item)
        return "''"
    return f"{b.whole.use('using', kind)}({', '.join([found.text, *widths])})"


def line(b: Body, node: nodes.Call) -> None:
    """`LINE row, values`: print from the begin of a row of the screen on."""
    args = node.target.args or []
    if not args:
        b.problem("values", "LINE needs the number of a row", node, 'LINE 2, "text" prints on the second row')
        return
    row = converted(b, number(b, args[0], "the number of a row"), Type(INTEGER), args[0])
    texts = [_shown(b, nodes.PrintItem(each.at, each, [], "")) for each in args[1:]]
    b.observes = True
    start = f"{b.whole.use('env', 'row')}({row})"
    b.act(f"P({' + '.join([start, *_joined(texts)])})")


def input_(b: Body, node: nodes.Input) -> None:
    """`INPUT "prompt", variable`."""
    target: nodes.Expr = node.target
    if type(target) is nodes.Name and (b.scope.find(target.name) is None):
        unknown(b, target)
        return
    text, kind, _ = place(b, node.target)
    if type(target) is nodes.Name and (symbol := b.scope.find(target.name)) is not None:
        if symbol.kind not in ("variable", "parameter"):
            b.problem("type", f"INPUT needs a variable, and {symbol.name} is a {symbol.kind}", target)
            return
        if not (symbol.is_array or symbol.boxed or symbol.by_ref):
            b.use_outside(symbol)
    if node.terminal is not None:
        number(b, node.terminal, "the number of a terminal")
    b.observes = True
    b.flush()
    b.settle()
    if node.prompt is not None:
        b.emit(f"P({value(b, node.prompt).text})")
    b.wait(f"{b.whole.use('env', 'input')}(t)")
    typed = f"{b.whole.use('env', 'typed')}({kind.name == STRING})"
    found = Value(typed, STRING if kind.name == STRING else FLOAT)
    b.emit(f"{text} = {converted(b, found, kind, node)}")
    b.pending += 1
