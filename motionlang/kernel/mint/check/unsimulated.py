"""Warnings of keywords that are known but not simulated, as the rows of `mint/keywords/unsimulated` classify them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.keywords import unsimulated
from motionlang.kernel.mint.keywords.no_effect import VERB as STORED
from motionlang.kernel.mint.syntax import nodes
from motionlang.kernel.tools import as_hint

if TYPE_CHECKING:
    from motionlang.kernel.mint.steps.unit import UnitWriter

CODE = "not-simulated"
# Follows the meaning of a keyword that ends the run when the program reaches it.
_ENDS = "the run ends here"


def warn(w: UnitWriter, node: nodes.Node, row: Keyword, by: nodes.Assign | nodes.Call | None = None) -> None:
    """Warn that a keyword is not simulated, and state what it does instead.

    `by` is the statement that writes it or carries it out.
    """
    if not w.checks:
        return
    is_known = by is None and row.name.upper() in w.program.supplied
    if row.function == STORED and row.access == "R":
        if not is_known:
            message = f"{row.word} is a Mint keyword that is not simulated: it {row.without_value}"
            _once(w, node, row, message)
    elif row.function == STORED or _is_stored(row, by):
        _once(w, node, row, f"{row.word} is stored but has no effect")
    elif row.function == unsimulated.COMMAND:
        _once(w, node, row, f"{row.word} is a Mint keyword that is not simulated: it has no effect")
    elif not is_known:
        _ending(w, node, row, by is not None)


def _is_stored(row: Keyword, by: nodes.Assign | nodes.Call | None) -> bool:
    """True if a keyword only stores its value, as far as is known."""
    if by is None:
        return False
    values = getattr(by, "values", ())
    harmless = 0 if row.function == unsimulated.MOTION else None
    return row.function == unsimulated.VALUE or (
        bool(values) and all(getattr(each, "value", None) == harmless for each in values)
    )


def _once(w: UnitWriter, node: nodes.Node, row: Keyword, message: str) -> None:
    diagnostics = w.program.names.diagnostics
    if all(message != each.message for each in diagnostics.found.values()):
        diagnostics.add(CODE, message, node.start, f"{row.name}: {as_hint(row.help)}", "warning")


def _ending(w: UnitWriter, node: nodes.Node, row: Keyword, writes: bool) -> None:
    end = _ENDS
    if writes and row.access != "C" and row.function == unsimulated.MOTION:
        end += ", unless it is given 0"
    elif not writes:
        end = f"{_ENDS}, unless it was written before or the machine file has it in [mint.values]"
    message = f"{row.word} is a Mint keyword that is not simulated"
    diagnostics = w.program.names.diagnostics
    diagnostics.add(CODE, message, node.start, f"{row.name}: {as_hint(row.help)}; {end}", "warning")
    diagnostics.in_run.add((CODE, node.start))
