"""Reports of keywords that cannot be read, written or carried out, or have too many or too few values."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.tools import as_hint, count_of

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter


def can_be_read(w: UnitWriter, node: nodes.Name, row: Keyword) -> bool:
    """True if a program may read a keyword; report an error if not."""
    if "R" in row.access:
        return True
    what = "is a command and has no value" if row.access == "C" else "can be written but not read"
    w.error("write-only", f"{row.word} {what}", node)
    return False


def refuse(w: UnitWriter, target: nodes.Name, row: Keyword) -> None:
    """Report that a keyword takes no value."""
    w.error("read-only", f"{row.word} {_why_not(row)}", target, _instead(row, target.name))


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


def not_a_command(w: UnitWriter, target: nodes.Name, row: Keyword) -> None:
    """Report that a keyword is not a statement."""
    shown = row.word if target.args is None else f"{row.word}(…)"
    if row.kind == "statement":
        w.error("syntax", f"{row.word} cannot be used here", target, as_hint(row.help))
    elif "W" in row.access:
        w.error("not-a-command", f"{row.word} needs a value", target, _with_value(target, row, shown))
    else:
        message = f"{row.word} is a value, not a statement"
        w.error("not-a-command", message, target, f"print it with PRINT {shown}")


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


def check_count(w: UnitWriter, node: nodes.Assign, row: Keyword, indices: int) -> None:
    """Report too many or too few values: there is one for each axis, or one alone."""
    wanted, given = max(1, indices) if row.index in ("axis", "axes") else 1, len(node.values)
    if given == wanted or (node.repeat and 0 < given < wanted):
        return
    hint = ""
    if given < wanted:
        hint = "end the list with ; to give the last value to all further axes"
    elif row.index in ("axis", "axes"):
        axes = ", ".join(map(str, range(given)))
        hint = f"name an axis for each value: {row.word}({axes}) = …"
    w.error(
        "values", f"{row.word} needs {many(wanted, 'value')} here, {many(given, 'value')} given", node, hint
    )


def check_path(w: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword, axes: int) -> None:
    """Report too many or too few axes or values of a path.

    The row's unit lists the units of the values, "uu" once for each axis. A single unit applies to every axis.
    """
    form = row.example.split("\n")[0]
    units = row.unit.split(", ")
    wanted = units.count("uu") if len(units) > 1 else 0
    if (wanted and axes != wanted) or axes < 2:
        needed = f"{wanted} axes" if wanted else "2 axes or more"
        w.error("values", f"{row.word} needs {needed} in brackets, {axes} given", target, form)
        return
    count, given = len(units) if wanted else axes, len(node.values)
    if given != count:
        w.error("values", f"{row.word} needs {count} values here, {given} given", node, form)


def many(count: int, what: str) -> str:
    """Return a count with a noun of the table of keywords: 2 axes, 1 value."""
    return count_of(count, what, {"axis": "axes", "index": "indices"}.get(what, ""))
