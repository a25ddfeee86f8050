"""Write an expression as its author would, for messages."""

from __future__ import annotations

from motionlang.kernel.mint.syntax import nodes


def shown(node: nodes.Expr, inside: bool = False) -> str:
    """Return the text of an expression; a nested operation is in brackets."""
    if type(node) is nodes.Number:
        return f"{node.value:.10g}"
    if type(node) is nodes.String:
        return f'"{node.value}"'
    if type(node) is nodes.Given:
        return node.name
    if type(node) is nodes.Cast:
        return shown(node.value, inside)
    if type(node) is nodes.Name:
        return node.name + _brackets(node.args)
    if type(node) is nodes.Member:
        return f"{shown(node.value)}.{node.field}{_brackets(node.args)}"
    if type(node) is nodes.Unary:
        gap = " " if node.op.isalpha() else ""
        return f"{node.op}{gap}{shown(node.operand, True)}"
    if type(node) is nodes.Chain:
        text = shown(node.first, True) + "".join(
            f" {link.op} {shown(link.value, True)}" for link in node.links
        )
        return f"({text})" if inside else text
    assert type(node) is nodes.Binary
    text = f"{shown(node.left, True)} {node.op} {shown(node.right, True)}"
    return f"({text})" if inside else text


def _brackets(args: list[nodes.Expr] | None) -> str:
    return "" if args is None else f"({', '.join(shown(each) for each in args)})"
