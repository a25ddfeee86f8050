"""Check keywords that are known but not simulated: each is a warning.

The rows of `mint/keywords/unsimulated` classify them. Their indices are not known for certain, so any number of values
is accepted in brackets.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.check.access import can_be_read, check_values, not_a_command, refuse
from motionlang.kernel.mint.check.indices import axes_by_default, check_indices
from motionlang.kernel.mint.check.values import NOTHING, Value, type_of, typed
from motionlang.kernel.mint.keywords import unsimulated
from motionlang.kernel.mint.keywords.no_effect import VERB as STORED
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.tools import as_hint

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter

CODE = "not-simulated"
# Follows the meaning of a keyword that ends the run when the program reaches it.
_ENDS = "the run ends here"


def read(b: UnitWriter, node: nodes.Name, row: Keyword) -> Value:
    """Return the value of an unsimulated keyword."""
    if not can_be_read(b, node, row):
        return NOTHING
    _warn(b, node, row)
    _indices(b, node, row, single=True)
    return typed(type_of(row))


def write(b: UnitWriter, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Check `WORD(axes) = values`; a command without details also accepts values."""
    if not ("W" in row.access or (row.access == "C" and row.function != STORED)):
        refuse(b, node, target, row)
        return
    _warn(b, target, row, by=node)
    check_values(b, node, row, _indices(b, target, row))


def command(b: UnitWriter, node: nodes.Call, row: Keyword) -> None:
    """Check an unsimulated keyword as a statement."""
    target = node.target
    if row.access != "C":
        not_a_command(b, target, row)
        return
    _warn(b, target, row, by=node)
    _indices(b, target, row)


def _indices(b: UnitWriter, node: nodes.Name, row: Keyword, single: bool = False) -> int | None:
    """Check what is in brackets, and return the number of indices, None for the axes of AXES."""
    if axes_by_default(b, node, row):
        return None
    if row.function == STORED or row.index in ("axis", "axes"):
        return check_indices(b, node, row, single)
    for arg in node.args or ():
        if not (type(arg) is nodes.Name and arg.args is None and _is_whole(arg)):
            b.value(arg)
    return len(node.args or ())


def _is_whole(node: nodes.Name) -> bool:
    """True if a name refers to a whole array or is NULL."""
    symbol = node.symbol
    return node.name.lower() == "null" if symbol is None else symbol.is_array


# ------------------------------------------------------------------------------------------------ warning


def _warn(b: UnitWriter, node: nodes.Node, row: Keyword, by: nodes.Assign | nodes.Call | None = None) -> None:
    """Warn that a keyword is not simulated, and state what it does instead.

    `by` is the statement that writes it or carries it out.
    """
    is_known = by is None and row.name.upper() in b.program.supplied
    if row.function == STORED and row.access == "R":
        if not is_known:
            message = f"{row.word} is a Mint keyword that is not simulated: it {row.without_value}"
            _once(b, node, row, message)
    elif row.function == STORED or _is_stored(row, by):
        _once(b, node, row, f"{row.word} is stored but has no effect")
    elif row.function == unsimulated.COMMAND:
        _once(b, node, row, f"{row.word} is a Mint keyword that is not simulated: it has no effect")
    elif not is_known:
        _ending(b, node, row, by is not None)


def _is_stored(row: Keyword, by: nodes.Assign | nodes.Call | None) -> bool:
    """True if a keyword only stores its value, as far as is known."""
    if by is None:
        return False
    values = getattr(by, "values", ())
    harmless = 0 if row.function == unsimulated.MOTION else None
    return row.function == unsimulated.VALUE or (
        bool(values) and all(getattr(each, "value", None) == harmless for each in values)
    )


def _once(b: UnitWriter, node: nodes.Node, row: Keyword, message: str) -> None:
    problems = b.program.names.problems
    if all(message != each.message for each in problems.found.values()):
        b.problem(CODE, message, node, f"{row.name}: {as_hint(row.help)}", "warning")


def _ending(b: UnitWriter, node: nodes.Node, row: Keyword, writes: bool) -> None:
    end = _ENDS
    if writes and row.access != "C" and row.function == unsimulated.MOTION:
        end += ", unless it is given 0"
    elif not writes:
        end = f"{_ENDS}, unless it was written before or the machine file has it in [mint.values]"
    message = f"{row.word} is a Mint keyword that is not simulated"
    b.problem(CODE, message, node, f"{row.name}: {as_hint(row.help)}; {end}", "warning")
    b.program.names.problems.in_run.add((CODE, node.start))
