"""The literals of a program, and the names that it declares, read from its tree.

    SPEED(0, 1) = 100, 50      SPEED[0] and SPEED[1]
    If n + 2 > 5 And k = 3     n (2 and 5) and k
    For i = 1 To 10            i (1 and 10)
    WAIT(7)                    WAIT

The tree is as the parser has built it. Numbers in the brackets of a name are not found: they are channels and indices.
"""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.kernel.lang.literals import Literal, addressed
from motionlang.kernel.lang.syntax.grammar import lex
from motionlang.kernel.mint.keywords import table
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.tokens import PARSER, token_at
from motionlang.kernel.mint.syntax.traversal import walk

_COMPARISONS = frozenset(("=", "<>", "<", ">", "<=", ">="))
_JOINS = frozenset(("And", "Or", "Xor", "Not", "&", "|"))
# A base, an expression whose numbers it has, and True if these may be the whole value.
Rows = Iterator[tuple[str, nodes.Node, bool]]


def literals(module: nodes.Module) -> list[Literal]:
    """Return the literals that have an address, in the order of the text."""
    found: list[Literal] = []
    for node in walk(module.everything):
        rows, writes, at = _rows(module, node)
        for base, value, may_be_whole in rows:
            found += _numbers(module, value, base, at, may_be_whole, writes)
    return addressed(found)


def constants(module: nodes.Module) -> list[Literal]:
    """Return the numbers that Const and Dim give to names; the address is the name."""
    found: list[Literal] = []
    for each in _declarations(module):
        values = each.values if type(each) is nodes.Variable and not each.dimensions else []
        values = [each.value] if type(each) is nodes.Const else values
        if len(values) == 1 and type(values[0]) is nodes.Number:
            numbers = _numbers(module, values[0], each.name, each.start, True, True)
            found += [number for number in numbers if number.is_whole]
    for number in found:
        number.address = number.base
    return sorted(found, key=lambda number: number.offset)


def declared(module: nodes.Module) -> frozenset[str]:
    """Return the names that Const, Define and Dim declare, in lower case; a keyword may be among them."""
    return frozenset(each.name.lower() for each in _declarations(module))


def _declarations(module: nodes.Module) -> Iterator[nodes.Const | nodes.Define | nodes.Variable]:
    for node in walk(module.everything):
        if type(node) in (nodes.Const, nodes.Define, nodes.Variable):
            yield node  # type: ignore[misc]


# ------------------------------------------------------------------------------------------------ statements


def _rows(module: nodes.Module, node: nodes.Node) -> tuple[Rows, bool, int]:
    """Return what has numbers in a statement, whether it writes them, and the offset of its line."""
    match node:
        case nodes.Assign(target=nodes.Name()):
            return _assigned(module, node), True, node.start
        case nodes.Call():
            return _called(module, node.target), True, node.start
        case nodes.Define():
            return iter([(_word(node), node.value, True)]), True, node.start
        case nodes.If() | nodes.While() | nodes.Pause():
            return _compared(module, node.condition), False, node.start
        case nodes.Repeat():
            return _compared(module, node.condition), False, node.condition.start
        case nodes.For():
            bounds = (each for each in (node.first, node.stop, node.step) if each is not None)
            return ((_word(node.variable), each, True) for each in bounds), False, node.start
    return iter(()), False, node.start


def _assigned(module: nodes.Module, node: nodes.Assign) -> Rows:
    """Yield the values of an assignment, each for its own axis if there is one for each."""
    assert isinstance(node.target, nodes.Name)
    indices, last = _indices(module, node.target), len(node.values) - 1
    for number, value in enumerate(node.values):
        if last + 1 == len(indices):
            where = indices[number : number + 1]
        elif node.repeat:
            where = indices[number:] if number == last else indices[number : number + 1]
        else:
            where = indices
        yield _base(node.target, where), value, last < max(1, len(indices))


def _called(module: nodes.Module, target: nodes.Name) -> Rows:
    """Yield the values of a keyword without an index: in brackets, or of a setting also behind a blank."""
    row = table().get(target.name)
    if row is None or row.index != "none" or row.kind not in ("setting", "statement", "command"):
        return
    if _is_dotted(target) or (_is_bare(target) and row.kind != "setting"):
        return
    for each in target.args or ():
        yield row.name, each, True


def _compared(module: nodes.Module, condition: nodes.Expr) -> Rows:
    """Yield both sides of each comparison of a condition, for the first name in it."""
    waiting: list[nodes.Node] = [condition]
    while waiting:
        node = waiting.pop()
        operator = _operator(node)
        if operator in _COMPARISONS:
            names = [each for each in walk([node]) if isinstance(each, nodes.Name)]
            first = min(names, key=lambda each: each.start, default=None)
            if first is not None:
                base = _base(first, _indices(module, first))
                yield from ((base, side, True) for side in _operands(node))
        elif operator in _JOINS:
            waiting += _operands(node)


def _operator(node: nodes.Node) -> str:
    """Return the operator of an operation, the last one of a chain; "" for any other expression."""
    if isinstance(node, nodes.Chain):
        return node.links[-1].op
    return node.op if isinstance(node, (nodes.Unary, nodes.Binary)) else ""


def _operands(node: nodes.Node) -> list[nodes.Expr]:
    """Return the operands of an operation; [] for any other expression."""
    match node:
        case nodes.Unary():
            return [node.operand]
        case nodes.Binary():
            return [node.left, node.right]
        case nodes.Chain():
            return [node.first, *(each.value for each in node.links)]
    return []


# ----------------------------------------------------------------------------------------- names and numbers


def _word(node: nodes.Name | nodes.Define) -> str:
    """Return a name, that of a keyword as its row has it."""
    row = table().get(node.name)
    return row.name if row is not None else str(node.name)


def _base(name: nodes.Name, indices: list[str]) -> str:
    index = ",".join(indices)
    return f"{_word(name)}[{index}]" if index else _word(name)


def _indices(module: nodes.Module, name: nodes.Name) -> list[str]:
    """Return the text of each index of a name, without blanks."""
    if not name.args:
        return []
    text = module.source.text[name.name.end : name.end]
    if _is_dotted(name):
        return text[1:].split(".")
    found, depth = [""], 0
    for token in [str(each) for each in lex(PARSER, text)][1:-1]:
        depth += (token in ("(", "[")) - (token in (")", "]"))
        if token == "," and not depth:
            found.append("")
        else:
            found[-1] += token
    return found


def _is_dotted(name: nodes.Name) -> bool:
    """True for `MOVER.0`, whose channels are at the position of the name."""
    return bool(name.args) and name.args[0].start == name.start  # type: ignore[index]


def _is_bare(name: nodes.Name) -> bool:
    """True for `WAIT 7`, which has no bracket around its values."""
    return bool(name.args) and name.args[-1].end == name.end  # type: ignore[index]


def _numbers(
    module: nodes.Module, value: nodes.Node, base: str, at: int, may_be_whole: bool, writes: bool
) -> Iterator[Literal]:
    """Yield the numbers of a value; a sign is part of a number that is the only one."""
    line = module.line(at)
    waiting = [value]
    while waiting:
        node = waiting.pop()
        if isinstance(node, nodes.Number) and (text := _text(module, node)):
            is_whole = may_be_whole and node is value and node.end == node.start + len(text)
            yield Literal("", base, line, node.start, text, node.value, is_whole, writes)
        elif node is value and (text := _negative(module, node)):
            yield Literal("", base, line, node.start, text, -node.operand.value, may_be_whole, writes)  # type: ignore[attr-defined]
        else:
            waiting += _operands(node)


def _text(module: nodes.Module, number: nodes.Number) -> str:
    """Return the text of a number; "" for a character, whose code it is."""
    text = token_at(module.source.text, number.start)
    return "" if text.startswith("`") else text


def _negative(module: nodes.Module, node: nodes.Node) -> str:
    """Return the text of a minus sign with a number, without brackets; "" for anything else."""
    if not (isinstance(node, nodes.Unary) and node.op == "-" and isinstance(node.operand, nodes.Number)):
        return ""
    text, begin = _text(module, node.operand), node.operand.start
    if not text or node.end != begin + len(text):
        return ""
    return "-" + text.rjust(begin + len(text) - node.start - 1)
