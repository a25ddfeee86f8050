"""The initial values of variables and arrays, as Python text."""

from __future__ import annotations

from motionlang.mint.resolve.symbols import FLOAT, INTEGER, RECORD, SEMAPHORE, STRING, TIME, Type


def zero(kind: Type) -> str:
    """Return the text of a new variable's initial value."""
    if kind.name == RECORD and kind.record is not None:
        members = [fresh(member, sizes) for _, member, sizes in kind.record.members.values()]
        return f"[{', '.join(members)}]"
    return {INTEGER: "0", FLOAT: "0.0", STRING: "''", TIME: "0.0", SEMAPHORE: "[None]"}.get(kind.name, "None")


def fresh(kind: Type, sizes: tuple[int, ...]) -> str:
    """Return the text of a new variable or array; element 0 of an array is never used."""
    if not sizes:
        return zero(kind)
    count = 1
    for size in sizes:
        count *= size
    if kind.name == RECORD:
        return f"[None] + [{zero(kind)} for _ in range({count})]"
    return f"[{zero(kind)}] * {count + 1}"
