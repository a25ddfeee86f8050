"""A syntax tree as an indented outline, for `check --tree`."""

from __future__ import annotations

from collections.abc import Iterator

from motionlang.kernel.tools import StackSpace

# What a later pass records in a node; it is no part of the text.
_LATER = frozenset(("at", "start", "end", "row", "definition", "symbol", "source"))
_INDENT = "  "


def render_tree(tree: object) -> str:
    """Return the tree with one node per line, each below the field that contains it."""
    with StackSpace():
        return "".join(f"{line}\n" for line in _node(tree, "", ""))


def _node(node: object, label: str, indent: str) -> Iterator[str]:
    plain, nested = [], []
    for name in _fields(node):
        value = getattr(node, name)
        if _has_nodes(value):
            nested.append((name, value))
        elif value or (value is not False and value == 0):
            plain.append(f"{name}={value!r}")
    yield f"{indent}{label}{' '.join([type(node).__name__, *plain])}"
    for name, value in nested:
        only_list = len(nested) == 1 and isinstance(value, (list, tuple))
        for each in value if isinstance(value, (list, tuple)) else [value]:
            yield from _below(each, "" if only_list else f"{name}: ", indent + _INDENT)


def _below(value: object, label: str, indent: str) -> Iterator[str]:
    """Yield the lines of a value that is a node, a list in a list, or neither."""
    if isinstance(value, (list, tuple)):
        yield f"{indent}{label}"
        for each in value:
            yield from _below(each, "", indent + _INDENT)
    elif _fields(value):
        yield from _node(value, label, indent)
    else:
        yield f"{indent}{label}{value!r}"


def _fields(value: object) -> tuple[str, ...]:
    """Return the fields of a node, () for anything else."""
    if not type(value).__module__.startswith("motionlang."):
        return ()
    own = vars(type(value))  # and not those of its base
    return tuple(
        name for name in own.get("__dataclass_fields__", own.get("__slots__", ())) if name not in _LATER
    )


def _has_nodes(value: object) -> bool:
    if isinstance(value, (list, tuple)):
        return any(map(_has_nodes, value))
    return bool(_fields(value))
