"""Compile keywords that are known but not simulated: a warning and an operation.

The operations of `mint/keywords/no_effect` and `mint/keywords/unsimulated` define what they do at run time. The
rows of the latter classify them. Their indices are not known for certain, so any number of values is accepted
in brackets.
"""

from __future__ import annotations

from motionlang.errors import as_hint
from motionlang.lang.keyword import Keyword
from motionlang.mint.compile import keyword_use
from motionlang.mint.compile.body import Body, Value
from motionlang.mint.compile.conversions import NOTHING
from motionlang.mint.compile.expressions import value
from motionlang.mint.keywords import unsimulated
from motionlang.mint.keywords.no_effect import VERB as STORED
from motionlang.mint.resolve.symbols import STRING
from motionlang.mint.syntax import nodes

CODE = "not-simulated"
# Follows the meaning of a keyword that ends the run when the program reaches it.
_ENDS = "the run ends here"
_WHEN_WRITTEN = {
    unsimulated.MOTION: f"{_ENDS}, unless it is given 0",
}


def read(b: Body, node: nodes.Name, row: Keyword) -> Value:
    """Return the value of an unsimulated keyword."""
    if not keyword_use.can_be_read(b, node, row):
        return NOTHING
    _warn(b, node, row)
    b.observes = True
    where = _whatever(b, node) if _is_loose(row) else keyword_use.read_at(b, node, row)
    operation, where = b.whole.called("read", row, [*where, *_location(b, node, row)])
    return keyword_use.answer(row, f"{operation}({', '.join(where)})")


def write(b: Body, node: nodes.Assign, target: nodes.Name, row: Keyword) -> None:
    """Compile `WORD(axes) = values`; a command without details also accepts values."""
    if not ("W" in row.access or (row.access == "C" and row.verb != STORED)):
        keyword_use.refuse(b, node, target, row)
        return
    _warn(b, target, row, by=node)
    where = None if keyword_use.by_default(b, target, row) else _indices(b, target, row)
    keyword_use.give(b, node, row, where, _location(b, target, row))


def command(b: Body, node: nodes.Call, row: Keyword) -> None:
    """Compile an unsimulated keyword as a statement."""
    target = node.target
    if row.access != "C":
        keyword_use.not_a_command(b, target, row)
        return
    _warn(b, target, row, by=node)
    operation, where = keyword_use.done_at(b, target, row, _indices)
    b.operate([(operation, [*where, *_location(b, target, row)])])


def _is_loose(row: Keyword) -> bool:
    """True if a keyword accepts anything in brackets."""
    return row.verb != STORED and row.index not in ("axis", "axes")


def _location(b: Body, node: nodes.Node, row: Keyword) -> list[str]:
    """Return the last arguments of its operations: line and source offset."""
    if row.verb == STORED:
        return [str(b.whole.line(node.start))]
    at = -1 if b.whole.typed else node.start  # a typed sub may run when another line is executed
    return [str(b.whole.line(node.start)), str(at)]


def _indices(b: Body, node: nodes.Name, row: Keyword, single: bool = False) -> list[str]:
    return _whatever(b, node) if _is_loose(row) else keyword_use.indices(b, node, row, single)


def _whatever(b: Body, node: nodes.Name) -> list[str]:
    """Return the texts of all values in brackets, "0" for an array."""
    texts = []
    for arg in node.args or ():
        if type(arg) is nodes.Name and arg.args is None and _is_whole(b, arg):
            texts.append("0")
            continue
        found = value(b, arg)
        texts.append(found.text if found.is_number or found.type == STRING else "0")
    return texts


def _is_whole(b: Body, node: nodes.Name) -> bool:
    """True if a name refers to a whole array or is NULL."""
    symbol = node.symbol
    return node.name.lower() == "null" if symbol is None else symbol.is_array


# ------------------------------------------------------------------------------------------------ warning


def _warn(b: Body, node: nodes.Node, row: Keyword, by: nodes.Assign | nodes.Call | None = None) -> None:
    """Warn that a keyword is not simulated, and state what it does instead.

    `by` is the statement that writes it or carries it out.
    """
    if row.verb == STORED or _is_stored(row, by):
        _once(b, node, row, f"{row.name} is stored but has no effect")
    elif row.verb == unsimulated.COMMAND:
        _once(b, node, row, f"{row.name} is a Mint keyword that is not simulated: it has no effect")
    elif by is not None or row.name.upper() not in b.whole.supplied:
        _ending(b, node, row, by is not None)


def _is_stored(row: Keyword, by: nodes.Assign | nodes.Call | None) -> bool:
    """True if a keyword only stores its value, as far as is known."""
    if by is None:
        return False
    values = getattr(by, "values", ())
    harmless = {unsimulated.MOTION: 0}.get(row.verb)
    return row.verb == unsimulated.VALUE or (
        bool(values) and all(getattr(each, "value", None) == harmless for each in values)
    )


def _once(b: Body, node: nodes.Node, row: Keyword, message: str) -> None:
    b.whole.problems.depends()
    if all(message != each.message for each in b.whole.problems.found.values()):
        b.warn(CODE, message, node, f"{row.name}: {as_hint(row.help)}")


def _ending(b: Body, node: nodes.Node, row: Keyword, writes: bool) -> None:
    if writes and row.access == "C":
        end = _ENDS
    elif writes:
        end = _WHEN_WRITTEN.get(row.verb, _ENDS)
    else:
        end = f"{_ENDS}, unless it was written before or the machine file has it in [mint.values]"
    b.warn(
        CODE,
        f"{row.name} is a Mint keyword that is not simulated",
        node,
        f"{row.name}: {as_hint(row.help)}; {end}",
    )
    b.whole.problems.in_run.add((CODE, node.start))
