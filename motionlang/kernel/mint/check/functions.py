"""Check calls of Mint's own functions: `Abs(x)`, `Str(n)`, `IIf(test, a, b)`."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.mint.check.body import Body
from motionlang.kernel.mint.check.indices import many
from motionlang.kernel.mint.check.values import NOTHING, KnownValue, type_of
from motionlang.kernel.mint.resolve.symbols import FLOAT, INTEGER, STRING
from motionlang.kernel.mint.syntax import nodes


def call_function(b: Body, node: nodes.Name, row: Keyword) -> KnownValue:
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
        return KnownValue(FLOAT if row.function == "random" else type_of(row))
    return KnownValue(FLOAT if any(each.type == FLOAT for each in found) else INTEGER)


def _argument(b: Body, node: nodes.Expr, kind: str, row: Keyword) -> KnownValue:
    if kind != "text":
        return b.number(node)
    found = b.value(node)
    if found.type != STRING and found is not NOTHING:
        b.problem("type", f"{row.word} needs a text, not a number", node, "convert the number with Str")
    return found


def _immediate_if(b: Body, node: nodes.Name, args: list[nodes.Expr]) -> KnownValue:
    b.condition(args[0])
    yes, no = b.value(args[1]), b.value(args[2])
    if yes is NOTHING or no is NOTHING:
        return NOTHING
    if (yes.type == STRING) is not (no.type == STRING):
        b.problem("type", "the two values of IIf must both be numbers or both be texts", node)
        return NOTHING
    return KnownValue(yes.type if yes.type == no.type else FLOAT)
