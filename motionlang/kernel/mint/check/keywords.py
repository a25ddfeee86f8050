"""Check keywords: reads in expressions, writes with `=`, commands, calls of Mint's own functions.

The keyword's row in the table gives its access, index, unit and range. A keyword that is not simulated is passed on to
`unsimulated.py`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.check import terminal, unsimulated
from motionlang.kernel.mint.check.access import (
    can_be_read,
    check_values,
    not_a_command,
    refuse,
    written_value,
)
from motionlang.kernel.mint.check.indices import axes_by_default, check_indices, many
from motionlang.kernel.mint.check.values import NOTHING, Value, literal, type_of, typed
from motionlang.kernel.mint.resolve.folding import constant
from motionlang.kernel.mint.resolve.symbols import FLOAT, INTEGER, STRING
from motionlang.kernel.mint.syntax import nodes

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


def read(b: UnitWriter, node: nodes.Name, row: Keyword) -> Value:
    """Return the value of a keyword in an expression."""
    if not row.simulated:
        return unsimulated.read(b, node, row)
    if row.kind == "constant":
        if node.args is not None:
            b.problem("values", f"{row.word} is a constant and takes no brackets", node)
        return literal(constant(row.function, row.unit))
    if row.kind == "function":
        return _call_function(b, node, row)
    if row.kind == "statement":
        b.problem("type", f"{row.word} is a statement and has no value", node)
        return NOTHING
    if not can_be_read(b, node, row):
        return NOTHING
    if not axes_by_default(b, node, row):
        check_indices(b, node, row, single=not row.every)  # IDLE[0, 1] is true if both axes are idle
    return typed(type_of(row))


def write(b: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Check `KEYWORD(axes) = values`."""
    if not row.simulated:
        unsimulated.write(b, node, target, row)
    elif "W" not in row.access:
        refuse(b, node, target, row)
    elif row.function == "wait":
        if target.args or node.repeat:
            b.problem("values", "WAIT = ms takes one time and no axis", target, "WAIT = 100 waits for 100 ms")
        _wait(b, node, node.values, row)
    elif row.kind == "move" and row.index == "axes":
        _write_path(b, node, target, row)
    elif axes_by_default(b, target, row):
        check_values(b, node, row, None)
    else:
        check_values(b, node, row, check_indices(b, target, row, single=False))


def command(b: UnitWriter, node: nodes.Call, row: Keyword) -> None:
    """Check a keyword as a statement: `GO(0, 1)`, `WAIT(100)`."""
    target = node.target
    if not row.simulated:
        unsimulated.command(b, node, row)
    elif row.function == "wait":
        _wait(b, target, target.args or [], row)
    elif row.function == "line":
        terminal.line(b, node)
    elif row.access != "C" or row.kind == "statement":
        not_a_command(b, target, row)
    elif not axes_by_default(b, target, row):
        check_indices(b, target, row, single=False)


def _wait(b: UnitWriter, node: nodes.Node, values: list[nodes.Expr], row: Keyword) -> None:
    """Check `WAIT = ms` and `WAIT(ms)`."""
    if len(values) == 1:
        written_value(b, values[0], row)
    else:
        b.problem("values", f"WAIT needs 1 value, {len(values)} given", node, "WAIT = 100 waits for 100 ms")


# ---------------------------------------------------------------------------------------- moves of axes


def _write_path(b: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Check a path.

    The row's unit lists the units of the values, "uu" once for each axis. A single unit applies to every
    axis.
    """
    for each in node.values:
        written_value(b, each, row)
    if not axes_by_default(b, target, row):
        _check_counts(b, node, target, row, check_indices(b, target, row, single=False))


def _check_counts(b: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword, axes: int) -> None:
    form = row.example.split("\n")[0]
    units = row.unit.split(", ")
    wanted = units.count("uu") if len(units) > 1 else 0
    if (wanted and axes != wanted) or axes < 2:
        needed = f"{wanted} axes" if wanted else "2 axes or more"
        b.problem("values", f"{row.word} needs {needed} in brackets, {axes} given", target, form)
        return
    count, given = len(units) if wanted else axes, len(node.values)
    if given != count:
        b.problem("values", f"{row.word} needs {count} values here, {given} given", node, form)


# ------------------------------------------------------------------------------------------- functions


def _call_function(b: UnitWriter, node: nodes.Name, row: Keyword) -> Value:
    """Return the result of a function; the row's index lists its arguments."""
    kinds = row.index.split(", ") if row.index else []
    args = node.args or []
    if len(kinds) - row.optional <= len(args) < len(kinds):
        kinds = kinds[: len(args)]
    if len(args) != len(kinds):
        message = f"{row.word} takes {many(len(kinds), 'value')}, {len(args)} given"
        b.problem("values", message, node, f"{row.word}({row.index})")
        return NOTHING
    if row.function == "choice":
        return _immediate_if(b, node, args)
    found = [_argument(b, arg, kind, row) for arg, kind in zip(args, kinds, strict=True)]
    if row.unit != "same":
        return typed(FLOAT if row.function == "random" else type_of(row))
    return typed(FLOAT if any(each.type == FLOAT for each in found) else INTEGER)


def _argument(b: UnitWriter, node: nodes.Expr, kind: str, row: Keyword) -> Value:
    if kind != "text":
        return b.number(node)
    found = b.value(node)
    if found.type != STRING and found is not NOTHING:
        b.problem("type", f"{row.word} needs a text, not a number", node, "convert the number with Str")
    return found


def _immediate_if(b: UnitWriter, node: nodes.Name, args: list[nodes.Expr]) -> Value:
    b.condition(args[0])
    yes, no = b.value(args[1]), b.value(args[2])
    if yes is NOTHING or no is NOTHING:
        return NOTHING
    if (yes.type == STRING) is not (no.type == STRING):
        b.problem("type", "the two values of IIf must both be numbers or both be texts", node)
        return NOTHING
    return typed(yes.type if yes.type == no.type else FLOAT)
