"""Check if a keyword can be read, written or carried out, and the values that are written to it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.check.indices import many
from motionlang.kernel.mint.check.values import NOTHING
from motionlang.kernel.mint.resolve.symbols import STRING
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.tools import as_hint

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


def can_be_read(b: UnitWriter, node: nodes.Name, row: Keyword) -> bool:
    """True if a program may read a keyword; report an error if not."""
    if "R" in row.access:
        return True
    what = "is a command and has no value" if row.access == "C" else "can be written but not read"
    b.problem("write-only", f"{row.word} {what}", node)
    return False


def refuse(b: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Report that a keyword takes no value."""
    b.problem("read-only", f"{row.word} {_why_not(row)}", target, _instead(row, target.name))
    for each in node.values:
        b.value(each)


def _why_not(row: Keyword) -> str:
    if row.kind == "constant":
        return "is a constant and cannot be changed"
    if row.kind in ("function", "statement"):
        return f"is a {row.kind} and cannot be assigned to"
    return "is a command and takes no value" if row.access == "C" else "can be read but not written"


def _instead(row: Keyword, name: str) -> str:
    if name.lower() == row.short.lower():
        return f"{name} is short for {row.name}; Dim {name} makes a variable of it"
    if row.access == "C" and row.kind == "command":
        return f"write {row.word}(0) without ="
    if row.group == "v4":
        return "a variable of this name must be declared with Dim"
    return {"VEL": "SPEED sets the speed of moves", "IDLE": "PAUSE IDLE waits for the end of a move"}.get(
        row.name, ""
    )


def not_a_command(b: UnitWriter, target: nodes.Name, row: Keyword) -> None:
    """Report that a keyword is not a statement."""
    shown = row.word if target.args is None else f"{row.word}(…)"
    if row.kind == "statement":
        b.problem("syntax", f"{row.word} cannot be used here", target, as_hint(row.help))
    elif "W" in row.access:
        b.problem("not-a-command", f"{row.word} needs a value", target, _with_value(target, row, shown))
    else:
        message = f"{row.word} is a value, not a statement"
        b.problem("not-a-command", message, target, f"print it with PRINT {shown}")


def _with_value(target: nodes.Name, row: Keyword, shown: str) -> str:
    """Return the statement that writes a keyword: TIME = 0 for TIME 0 or TIME(0).

    If no value is given, add the statement that shows the keyword.
    """
    given = target.args or []
    if row.index == "none" and given:
        number = given[0] if len(given) == 1 else None
        value = f"{number.value:.10g}" if isinstance(number, nodes.Number) else "value"
        return f"{row.word} = {value}"
    return f"{shown} = value sets it, PRINT {shown} shows it" if "R" in row.access else f"{shown} = value"


def check_values(b: UnitWriter, node: nodes.Assign, row: Keyword, indices: int | None) -> None:
    """Check the values of `KEYWORD(axes) = values`: one for each axis, or one alone.

    The number of axes is None for those of AXES, which is known only in the run.
    """
    for each in node.values:
        if type(each) is not nodes.Omitted:
            written_value(b, each, row)
    if indices is not None:
        _check_count(b, node, row, max(1, indices) if row.index in ("axis", "axes") else 1)


def _check_count(b: UnitWriter, node: nodes.Assign, row: Keyword, wanted: int) -> None:
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


def written_value(b: UnitWriter, node: nodes.Expr, row: Keyword) -> None:
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
