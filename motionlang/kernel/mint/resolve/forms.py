"""The form of a statement: a text that all spellings of it share.

Constants are folded, Defines replaced, keywords have their newest names, and operands of sums, products and comparisons
have one order, unless one of them does something when it is read. `NAME` marks a name of the program, so that a reader
can take renamed ones for one.
"""

from __future__ import annotations

from motionlang.kernel.lang.structure import NAME
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant

# Marks a call, and a reading that takes something away, such as that of a key.
_ACTS = "!"
_COMMUTE = frozenset(("+", "*", "=", "<>", "And", "Or", "&", "|", "Xor"))
_MIRRORED = {">": "<", ">=": "<="}
# What has statements of its own, is no content, or is shown by the nodes that use it.
_LEFT_OUT = frozenset(("body", "cases", "last_name", "orelse"))


def form(part: object) -> str:
    """Return the form of a node, of a list of them, or of another attribute of one."""
    if isinstance(part, list):
        return f"({', '.join(map(form, part))})"
    if not isinstance(part, nodes.Node):
        return f"{NAME}{part.lower()}" if isinstance(part, Word) else str(part)
    known = getattr(part, "const", None)
    if known is not None:
        return repr(known)
    match part:
        case nodes.Name():
            return _name(part)
        case nodes.Binary():
            return _operation(part.op, form(part.left), form(part.right), part.type == "String")
        case nodes.Chain():
            text = form(part.first)
            for link in part.links:
                text += f" {link.op} {form(link.value)}"
            return f"({text})"
        case nodes.Assign():
            given = ", ".join(_given(part.target, each) for each in part.values)
            return f"{form(part.target)} = {given}{';' * part.repeat}"
        case nodes.Print():
            word = part.word.lower() or "print"
            return f"{word} {form(part.terminal)} {form(part.line)} {form(part.items)}"
    slots = sorted(each for each in type(part).__slots__ if each not in _LEFT_OUT)
    return f"{type(part).__name__} {' '.join(form(getattr(part, each)) for each in slots)}"


def _name(node: nodes.Name) -> str:
    found = meant(node)
    if found is not node:
        return form(found)
    arguments = "" if node.args is None else form(node.args)
    if node.symbol is None and node.row is not None:
        name = node.row.name if "=" in node.row.renamed else node.row.renamed or node.row.name
        return f"{_ACTS if node.row.driven == 'key' else ''}{name}{arguments}"
    is_call = node.symbol is not None and node.symbol.kind == "sub"
    return f"{_ACTS if is_call else ''}{NAME}{node.name.lower()}{arguments}"


def _operation(op: str, left: str, right: str, is_text: bool) -> str:
    if op in _MIRRORED:
        op, left, right = _MIRRORED[op], right, left
    if op in _COMMUTE and not is_text and right < left and _ACTS not in left + right:
        left, right = right, left
    return f"({left} {op} {right})"


def _given(target: nodes.Expr, value: nodes.Expr) -> str:
    """Return the form of a value that a statement gives: to a keyword, 5 and 5.0 are the same."""
    target, known = meant(target), getattr(value, "const", None)
    is_keyword = isinstance(target, nodes.Name) and target.symbol is None
    return repr(float(known)) if is_keyword and isinstance(known, (int, float)) else form(value)
