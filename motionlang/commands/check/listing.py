"""The steps of a program beside its lines, and its syntax tree, for `check`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from motionlang.kernel import Dialect
from motionlang.kernel.lang import ListedStep, ListedUnit
from motionlang.kernel.tools import StackSpace
from motionlang.views.highlight import pieces
from motionlang.views.table import Column, Table
from motionlang.views.terminal import printable, styled

# The styles of the tokens of a program's line, by kind.
_STYLES = {"move": "word", "keyword": "word", "not-simulated": "warning", "comment": "dim"}


def render_steps(dialect: Dialect, units: Sequence[ListedUnit], *, colour: bool) -> Iterator[str]:
    """Return the lines of a list of steps, those of the program with their numbers."""
    for unit in units:
        if unit.name:
            yield styled(unit.name, "bold", colour) + "\n"
        for line in unit.lines:
            if line.line:
                yield f"{line.line:>4}  {_highlighted(dialect, line.text, colour)}\n"
            yield from (f"{_step(each)}\n" for each in line.steps)


def steps_table(found: Sequence[tuple[str, Sequence[ListedUnit]]]) -> Table:
    """Return the steps of files as data; those without a target or a cost have none."""
    rows = [
        {
            "file": file,
            "unit": unit.name,
            "line": line.line,
            "index": step.index,
            "kind": step.kind,
            "target": step.target if step.target >= 0 else None,
            "cost": step.cost or None,
        }
        for file, units in found
        for unit in units
        for line in unit.lines
        for step in line.steps
    ]
    columns = tuple(map(Column, ("file", "unit", "line", "index", "kind", "target", "cost")))
    return Table("steps", columns, rows)


def _highlighted(dialect: Dialect, text: str, colour: bool) -> str:
    text = printable(text.expandtabs().rstrip())
    return "".join(styled(piece, _STYLES.get(kind, ""), colour) for _, kind, piece in pieces(dialect, text))


def _step(step: ListedStep) -> str:
    does = f"{step.kind} to {step.target}" if step.target >= 0 else step.kind
    pays = f"{step.cost:g} statement{'' if step.cost == 1.0 else 's'}" if step.cost else ""
    return f"{step.index:>9}  {does:<18}{pays}".rstrip()


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
