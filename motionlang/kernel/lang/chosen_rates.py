"""Rates of a program's moves that no statement sets and no source gives, so that the time of a move is a choice."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.structure import Use
from motionlang.kernel.tools import listed


def unset(rows: Iterable[Keyword], uses: Iterable[Use], rates: Sequence[str]) -> list[Keyword]:
    """Return the rows of the rates that no use sets, in the order of `rates`."""
    given = {use.row.gives for use in uses if use.row is not None and use.role != "read"}
    found = [row for row in rows if row.gives in rates and row.gives not in given]
    return sorted(found, key=lambda row: rates.index(row.gives))


def note(
    rows: Sequence[Keyword], figures: Iterable[str], assumptions: Iterable[str], settled: str
) -> list[str]:
    """Return the line about rates that are never set, and what settles them; no line if there are none."""
    if not rows:
        return []
    names, values = listed(row.name for row in rows), list(dict.fromkeys(figures))
    verb = "are" if len(rows) > 1 else "is"
    return [
        f"{names} {verb} never set: {' and '.join(values)} {'are' if len(values) > 1 else 'is'} a "
        f"choice of motionlang ({', '.join(dict.fromkeys(assumptions))}); {settled} settles it"
    ]
