"""The form of a statement: a text that all spellings of it share.

Constants are folded, Defines replaced, keywords have their newest names, and operands of sums, products and comparisons
have one order, unless one of them does something when it is read. In a normal form, comparisons with a whole number are
one if they are equal for every value of an Integer or a bit: `n > 15` is `n >= 16`, `INX(1) <> 1` is `INX(1) = 0`, and
`Case 1 To 2` is `Case 1, 2`. `NAME` marks a name of the program, so that a reader can take renamed ones for one.
"""

from __future__ import annotations

from collections.abc import Callable

from motionlang.kernel.lang.structure import NAME
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.mint.syntax.traversal import meant

# Marks a call, and a reading that takes something away, such as that of a key.
_ACTS = "!"
_COMMUTE = frozenset(("+", "*", "=", "<>", "And", "Or", "&", "|", "Xor"))
_MIRRORED = {">": "<", ">=": "<="}
# The whole numbers that an operator accepts: the first and the last, as differences from the number on its right.
_WHOLE = {"=": (0, 0), "<": (None, -1), "<=": (None, 0), ">": (1, None), ">=": (0, None)}
_SIDES = {"=": "=", "<>": "<>", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
_LEAST, _MOST = -(2**31), 2**31 - 1
Ranges = list[tuple[int, int]]
# The form of a part of a node.
Inner = Callable[[object], str]
# What has statements of its own, is no content, or is shown by the nodes that use it.
_LEFT_OUT = frozenset(("body", "cases", "last_name", "orelse"))


def form(part: object, is_normal: bool = False) -> str:
    """Return the form of a node, of a list of them, or of another attribute of one.

    In a normal form, a comparison of an Integer or a bit with a whole number is the numbers that it accepts.
    """

    def inner(each: object) -> str:
        return form(each, is_normal)

    if isinstance(part, list):
        return f"({', '.join(map(inner, part))})"
    if not isinstance(part, nodes.Node):
        return f"{NAME}{part.lower()}" if isinstance(part, Word) else str(part)
    known = getattr(part, "const", None)
    if known is not None:
        return repr(known)
    match part:
        case nodes.Name():
            return _name(part, inner)
        case nodes.Binary():
            accepted = _accepted(part, inner) if is_normal and part.op in _SIDES else ""
            return accepted or _operation(part.op, inner(part.left), inner(part.right), part.type == "String")
        case nodes.Chain():
            text = inner(part.first)
            for link in part.links:
                text += f" {link.op} {inner(link.value)}"
            return f"({text})"
        case nodes.Assign():
            given = ", ".join(_given(part.target, each, inner) for each in part.values)
            return f"{inner(part.target)} = {given}{';' * part.repeat}"
        case nodes.Print():
            word = part.word.lower() or "print"
            return f"{word} {inner(part.terminal)} {inner(part.line)} {inner(part.items)}"
    slots = sorted(each for each in type(part).__slots__ if each not in _LEFT_OUT)
    return f"{type(part).__name__} {' '.join(inner(getattr(part, each)) for each in slots)}"


def case_form(subject: nodes.Expr, tests: list[nodes.CaseTest]) -> str:
    """Return the normal form of a Case: of an Integer or a bit, the ranges that its tests accept."""
    found: Ranges = []
    for each in tests:
        low, high = _whole(each.value), None if each.high is None else _whole(each.high)
        if low is None or (high is None and each.high is not None):
            return f"Case {form(tests, is_normal=True)}"
        found += _ranges(each.op, low) if high is None else [(low, high)]
    return f"Case {_merged(found)}" if found and _is_whole(subject) else f"Case {form(tests, is_normal=True)}"


def _accepted(node: nodes.Binary, inner: Inner) -> str:
    """Return the normal form of a comparison of an Integer or a bit with a whole number, "" of any other."""
    op, left, right = node.op, node.left, node.right
    if _whole(left) is not None:
        op, left, right = _SIDES[op], right, left
    number = _whole(right)
    if number is None or not _is_whole(left):
        return ""
    ranges = _merged(_ranges(op, number))
    if _is_bit(left):
        bits = [bit for bit in (0, 1) if any(low <= bit <= high for low, high in ranges)]
        return f"({inner(left)} in {bits})"
    return f"({inner(left)} in {ranges})"


def _ranges(op: str, number: int) -> Ranges:
    if op == "<>":
        return [(_LEAST, number - 1), (number + 1, _MOST)]
    low, high = _WHOLE[op]
    return [(_LEAST if low is None else number + low, _MOST if high is None else number + high)]


def _merged(ranges: Ranges) -> Ranges:
    """Return ranges in order, without what none accepts, those that meet as one."""
    made: Ranges = []
    for low, high in sorted((max(low, _LEAST), min(high, _MOST)) for low, high in ranges):
        if made and low <= made[-1][1] + 1:
            made[-1] = made[-1][0], max(high, made[-1][1])
        elif low <= high:
            made.append((low, high))
    return made


def _whole(node: nodes.Expr) -> int | None:
    known = getattr(node, "const", None)
    return known if isinstance(known, int) else None


def _is_whole(node: nodes.Expr) -> bool:
    return node.type == "Integer" or _is_bit(node)


def _is_bit(node: nodes.Expr) -> bool:
    found = meant(node)
    return (
        isinstance(found, nodes.Name)
        and found.row is not None
        and found.symbol is None
        and found.row.unit == "bool"
    )


def _name(node: nodes.Name, inner: Inner) -> str:
    found = meant(node)
    if found is not node:
        return inner(found)
    arguments = "" if node.args is None else inner(node.args)
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


def _given(target: nodes.Expr, value: nodes.Expr, inner: Inner) -> str:
    """Return the form of a value that a statement gives: to a keyword, 5 and 5.0 are the same."""
    target, known = meant(target), getattr(value, "const", None)
    is_keyword = isinstance(target, nodes.Name) and target.symbol is None
    return repr(float(known)) if is_keyword and isinstance(known, (int, float)) else inner(value)
