"""Check moves of several axes: `VECTORA(0, 1) = 10, 20`, `CIRCLER(0, 1) = 10, 0, 90`."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.indices import axes_by_default, check_indices
from motionlang.kernel.mint.check.writes import written_value
from motionlang.kernel.mint.syntax import nodes


def write_path(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Check a path.

    The row's unit lists the units of the values, "uu" once for each axis. A single unit applies to every
    axis.
    """
    for each in node.values:
        written_value(b, each, row)
    if not axes_by_default(b, target, row):
        _check_counts(b, node, target, row, check_indices(b, target, row, single=False))


def _check_counts(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword, axes: int) -> None:
    """Check the number of axes and of values."""
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
