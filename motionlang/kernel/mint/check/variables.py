"""Check variables, array elements and members: what can be read and assigned to."""

from __future__ import annotations

from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.unknown_words import unknown_name
from motionlang.kernel.mint.check.values import article
from motionlang.kernel.mint.resolve.symbols import FLOAT, Symbol, Type
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.tools import count_of


def location(b: Body, node: nodes.Name | nodes.Member) -> Type:
    """Check a variable, an element or a member, and annotate it with its type, which is returned."""
    symbol = member(b, node) if isinstance(node, nodes.Member) else node.symbol
    if symbol is None:  # a member that is reported
        kind = Type(FLOAT)
    else:
        kind, name = symbol.type, node.field if isinstance(node, nodes.Member) else symbol.name
        if symbol.is_array:
            _element(b, node, name, symbol.dimensions, node.args)
        elif node.args is not None:
            b.problem("type", f"{name} is not an array", node)
    node.type = str(kind)
    return kind


def _element(
    b: Body, node: nodes.Node, name: str, sizes: tuple[int, ...], args: list[nodes.Expr] | None
) -> None:
    """Check the subscripts of an array; the sizes of an array parameter are 0."""
    if args is None:
        b.problem("index", f"{name} is an array and needs a subscript", node)
    elif len(args) != len(sizes):
        given = f"{len(args)} {'is' if len(args) == 1 else 'are'} given"
        b.problem("index", f"{name} has {count_of(len(sizes), 'subscript')}, {given}", node)
    else:
        for arg, size in zip(args, sizes, strict=True):
            known = b.number(arg, "a subscript").const
            if known is not None:
                check_subscript(b, arg, known, size)  # type: ignore[arg-type]


def check_subscript(b: Body, node: nodes.Node, value: float, size: int) -> None:
    """Report a subscript outside 1 … size, if the size is known."""
    if size and not 1 <= value <= size:
        hint = "the first element of an array has the subscript 1"
        b.problem("index", f"there is no element {value}: the subscript must be 1 to {size}", node, hint)


def member(b: Body, node: nodes.Member) -> Symbol | None:
    """Check a member as a whole and return its symbol; report an error."""
    owner = node.value
    if type(owner) is nodes.Name and owner.symbol is None:
        if owner.args is None and owner.row is not None:
            b.problem("syntax", f"{owner.name} needs a number after the dot, not a name", node,
                      f"write {owner.name}[{node.field}]")  # fmt: skip
        else:
            unknown_name(b, owner)
        return None
    if type(owner) is not nodes.Name and type(owner) is not nodes.Member:
        b.problem("type", "only a variable has members", node)
        return None
    kind = location(b, owner)
    if kind.record is None:
        hint = "declare the variable with a Type of yours"
        b.problem("type", f"{article(str(kind))} has no members", node, hint)
        return None
    if node.symbol is None:
        message = f"{kind.record.name} has no member {node.field}"
        b.program.problems.unknown(message, node.field, kind.record.members.keys, node.start)
    return node.symbol


def array(b: Body, node: nodes.Expr) -> Symbol | None:
    """Return the symbol of a whole array, which may be a member of a record; None for anything else."""
    symbol = None
    if type(node) is nodes.Name and node.args is None:
        symbol = node.symbol
    elif type(node) is nodes.Member and node.args is None:
        symbol = member(b, node)
    return symbol if symbol is not None and symbol.is_array else None
