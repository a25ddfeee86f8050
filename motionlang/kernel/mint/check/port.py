"""Differences of a Mint v4 program on MintMT that remain once it is in the notation of MintMT.

PRINT "part ", n        MintMT prints 12.0000, v4 12: PRINT "part ", n USING 1, 0
PRINT POS(0)            MintMT prints 12.5000, v4 12.5: reported, since the number of decimals is open
PRINT MODE(0)           AXISMODE in MintMT
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from motionlang.kernel.errors import Diagnostic
from motionlang.kernel.lang.step_graph import StepGraph
from motionlang.kernel.mint.resolve.diagnostics import Diagnostics
from motionlang.kernel.mint.resolve.handlers import handled
from motionlang.kernel.mint.resolve.names import Symbols
from motionlang.kernel.mint.resolve.symbols import FLOAT, Symbol
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.nodes import Module
from motionlang.kernel.mint.syntax.tokens import Tokens
from motionlang.kernel.mint.syntax.traversal import meant, walk
from motionlang.kernel.source import Source
from motionlang.kernel.tools import as_hint

# A format without decimals, which prints as many digits as a number has.
_WHOLE = " USING 1, 0"
# The operators whose result is whole if both operands are.
_KEEPS_WHOLE = frozenset(("+", "-", "*", "\\", "mod", "%"))


def port_differences(module: Module, names: Symbols, graph: StepGraph) -> list[Diagnostic]:
    """Return a warning for each difference of a checked program, with its fix if that is certain."""
    diagnostics = Diagnostics(module)
    everything = list(walk(statement for each in names.functions for statement in each.body))
    _prints(module, everything, diagnostics)
    _words(module.source, set(map(id, _of_error_handlers(names, graph))), everything, diagnostics)
    return sorted(diagnostics.found.values(), key=lambda each: (each.line, each.column))


def _prints(module: nodes.Module, everything: Iterable[nodes.Node], diagnostics: Diagnostics) -> None:
    """Report what is printed as a Float without a format."""
    items = [
        item
        for node in everything
        if isinstance(node, nodes.Print)
        for item in node.items
        if not item.using and item.value.type == FLOAT
    ]
    whole = _whole_variables(everything) if items else set()
    text, tokens = module.source.text, Tokens(module.source.text, module.tokens if items else ())
    for item in items:
        end = item.value.end
        k = tokens.starts.index(item.value.start)
        while tokens.kinds[k - 1] == "LPAR":
            k -= 1
        first = start = tokens.starts[k]
        while tokens.starts[k] < end or tokens.kinds[k] == "RPAR":
            # A fix is in one line, the last one of a continued expression.
            start = tokens.starts[k] if "\n" in text[start : tokens.ends[k]] else start
            end = max(end, tokens.ends[k])
            k += 1
        shown = " ".join(text[first:end].split())
        if _is_whole(item.value, whole):
            message = f"MintMT prints {shown} with four decimals, Mint v4 without"
            fix = text[start:end] + _WHOLE
            diagnostics.add("model", message, start, f"write {shown}{_WHOLE}", "warning", fix, end=end)
        else:
            message = f"MintMT prints {shown} with four decimals, Mint v4 with as many as it needs"
            diagnostics.add("model", message, start, f"choose the decimals: {shown} USING 1, 2", "warning")


def _whole_variables(everything: Iterable[nodes.Node]) -> set[Symbol]:
    """Return the variables to which the program assigns only whole numbers."""
    written: dict[Symbol, list[nodes.Expr]] = {}
    open_ones: set[Symbol | None] = set()
    for node in everything:
        match node:
            case nodes.Assign(target=nodes.Name(symbol=Symbol() as symbol)):
                written.setdefault(symbol, []).extend(node.values)
            case nodes.For(variable=nodes.Name(symbol=Symbol() as symbol)):
                written.setdefault(symbol, []).extend(
                    [node.first, *([node.step] if node.step is not None else [])]
                )
            case nodes.Input(target=nodes.Name(symbol=symbol)):
                open_ones.add(symbol)
            case nodes.Variable(symbol=Symbol() as symbol):
                written.setdefault(symbol, []).extend(node.values)
            case nodes.Name(symbol=Symbol(kind="sub")) if node.args:
                open_ones |= {each.symbol for each in node.args if isinstance(each, nodes.Name)}
    found = {each for each in written if each not in open_ones and each.kind == "variable"}
    size = -1
    while len(found) != size:
        size = len(found)
        found = {each for each in found if all(_is_whole(value, found) for value in written[each])}
    return found


def _is_whole(node: nodes.Expr, variables: set[Symbol]) -> bool:
    """True if an expression has a whole value, provided that these variables have."""
    node = meant(node)
    if node.type != FLOAT:
        return True
    match node:
        case nodes.Number():
            return float(node.value).is_integer()
        case nodes.Name(symbol=Symbol() as symbol):
            return symbol in variables
        case nodes.Unary():
            return _is_whole(node.operand, variables)
        case nodes.Binary():
            sides = _is_whole(node.left, variables) and _is_whole(node.right, variables)
            return sides and node.op.lower() in _KEEPS_WHOLE
        case nodes.Chain():
            values = [node.first, *(each.value for each in node.links)]
            return all(_is_whole(each, variables) for each in values) and all(
                each.op.lower() in _KEEPS_WHOLE for each in node.links
            )
    return False


def _words(
    source: Source, in_handler: set[int], everything: Iterable[nodes.Node], diagnostics: Diagnostics
) -> None:
    """Report keywords that have another name in MintMT, or none."""
    for node in everything:
        row = node.row if isinstance(node, nodes.Name) and node.symbol is None else None
        if row is None or not isinstance(node, nodes.Name) or not (row.renamed or row.group == "v4"):
            continue
        message = f"{row.name} is a word of Mint v4"
        name, equals, value = row.renamed.partition(" = ")
        if not name:
            hint = as_hint(row.help)
            diagnostics.add("model", f"{message}; MintMT has none for it", node.start, hint, "warning")
        elif row.index == "none" and id(node) not in in_handler:
            hint = f"{name} has a value only in ONERROR, and after ERRORREADNEXT"
            diagnostics.add("model", message, node.start, hint, "warning")
        else:
            rest = "" if len(node.args or ()) == 1 or not value else ";"
            fix = f"{name}{source.text[node.start + len(node.name) : node.end]}{equals}{value}{rest}"
            diagnostics.add("model", message, node.start, f"write {fix}", "warning", fix, end=node.end)


def _of_error_handlers(names: Symbols, graph: StepGraph) -> Iterator[nodes.Node]:
    """Yield the nodes that run after a statement has failed."""
    for each in names.functions:
        if each.kind == "event" and each.name.lower() == "onerror":
            yield from walk(each.body)
    yield from handled(names.main, graph, "onerror")
