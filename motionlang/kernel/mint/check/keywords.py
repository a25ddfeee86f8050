"""Check keywords: reads in expressions, writes with `=`, commands.

The keyword's row in the table gives its access, index, unit and range. A keyword that is not simulated is passed on to
`unsimulated.py`.
"""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.check import unsimulated
from motionlang.kernel.mint.check.access import can_be_read, not_a_command, refuse
from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.functions import call_function
from motionlang.kernel.mint.check.indices import axes_by_default, check_indices
from motionlang.kernel.mint.check.paths import write_path
from motionlang.kernel.mint.check.terminal import line
from motionlang.kernel.mint.check.values import NOTHING, KnownValue, literal, type_of
from motionlang.kernel.mint.check.writes import check_values, written_value
from motionlang.kernel.mint.resolve.folding import constant
from motionlang.kernel.mint.syntax import nodes


def read(b: Body, node: nodes.Name, row: Keyword) -> KnownValue:
    """Return the value of a keyword in an expression."""
    if not row.simulated:
        return unsimulated.read(b, node, row)
    if row.kind == "constant":
        if node.args is not None:
            b.problem("values", f"{row.word} is a constant and takes no brackets", node)
        return literal(constant(row.function, row.unit))
    if row.kind == "function":
        return call_function(b, node, row)
    if row.kind == "statement":
        b.problem("type", f"{row.word} is a statement and has no value", node)
        return NOTHING
    if not can_be_read(b, node, row):
        return NOTHING
    if not axes_by_default(b, node, row):
        check_indices(b, node, row, single=not row.every)  # IDLE[0, 1] is true if both axes are idle
    return KnownValue(type_of(row))


def write(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
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
        write_path(b, node, target, row)
    elif axes_by_default(b, target, row):
        check_values(b, node, row, None)
    else:
        check_values(b, node, row, check_indices(b, target, row, single=False))


def command(b: Body, node: nodes.Call, row: Keyword) -> None:
    """Check a keyword as a statement: `GO(0, 1)`, `WAIT(100)`."""
    target = node.target
    if not row.simulated:
        unsimulated.command(b, node, row)
    elif row.function == "wait":
        _wait(b, target, target.args or [], row)
    elif row.function == "line":
        line(b, node)
    elif row.access != "C" or row.kind == "statement":
        not_a_command(b, target, row)
    elif not axes_by_default(b, target, row):
        check_indices(b, target, row, single=False)


def _wait(b: Body, node: nodes.Node, values: list[nodes.Expr], row: Keyword) -> None:
    """Check `WAIT = ms` and `WAIT(ms)`."""
    if len(values) == 1:
        written_value(b, values[0], row)
    else:
        b.problem("values", f"WAIT needs 1 value, {len(values)} given", node, "WAIT = 100 waits for 100 ms")
