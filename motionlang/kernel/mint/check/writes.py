"""Check the values that are written to keywords."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.indices import many
from motionlang.kernel.mint.check.values import NOTHING
from motionlang.kernel.mint.resolve.symbols import STRING
from motionlang.kernel.mint.syntax import nodes


def check_values(b: Body, node: nodes.Assign, row: Keyword, indices: int | None) -> None:
    """Check the values of `KEYWORD(axes) = values`: one for each axis, or one alone.

    The number of axes is None for those of AXES, which is known only in the run.
    """
    for each in node.values:
        if type(each) is not nodes.Omitted:
            written_value(b, each, row)
    if indices is not None:
        _check_count(b, node, row, max(1, indices) if row.index in ("axis", "axes") else 1)


def _check_count(b: Body, node: nodes.Assign, row: Keyword, wanted: int) -> None:
    given = len(node.values)
    if given == wanted or (node.repeat and 0 < given < wanted):
        return
    hint = ""
    if given < wanted:
        hint = "end the list with ; to give the last value to all further axes"
    elif row.index in ("axis", "axes"):
        axes = ", ".join(map(str, range(given)))
        hint = f"name an axis for each value: {row.word}({axes}) = …"
    b.problem(
        "values", f"{row.word} needs {many(wanted, 'value')} here, {many(given, 'value')} given", node, hint
    )


def written_value(b: Body, node: nodes.Expr, row: Keyword) -> None:
    """Check a value that is written to a keyword: its type, and its range if it is known."""
    found = b.value(node)
    if row.unit == "text":
        if found.type != STRING and found is not NOTHING:
            b.problem("type", f"{row.word} takes a text, not a number", node)
    elif not found.is_number:
        b.problem("type", f"{row.word} takes a number, not a text", node)
    elif found.const is not None and (refusal := row.refusal(float(found.const))) is not None:
        message, hint = refusal
        b.problem("range", message, node, hint)
