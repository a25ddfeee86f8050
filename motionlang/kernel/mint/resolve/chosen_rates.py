"""Rates of a program's moves that no statement sets and no source gives.

A move without ACCEL or DECEL runs at a default that is a choice of this program, so its time is one, too.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from motionlang.kernel.lang.chosen_rates import note, unset
from motionlang.kernel.lang.machine.switch import ASSUMPTIONS
from motionlang.kernel.lang.structure import Statement
from motionlang.kernel.mint.keywords import axis
from motionlang.kernel.mint.keywords.switchable import name_of

# The rates whose defaults are choices; the speed at power-up is printed.
RATES = ("accel", "decel")
# The roles of the keywords whose motion has these rates.
MOVES = frozenset(("move", "path"))


def chosen_rates(statements: Iterable[Statement], settings: Mapping[str, object]) -> list[str]:
    """Return a line about the rates that the moves of a program take from a chosen default, if there are any."""
    uses = [use for each in statements for use in each.uses if use.row is not None]
    if not any(
        use.role in MOVES or (use.row is not None and use.row.effect == "act endless") for use in uses
    ):
        return []
    chosen = [
        row
        for row in unset(axis.ROWS, uses, RATES)
        if row.default is not None and f"{ASSUMPTIONS}{name_of(row)}" not in settings
    ]
    figures = [f"{row.default:.10g} counts/s²" for row in chosen]
    return note(chosen, figures, map(name_of, chosen), " : ".join(f"{row.name}(0) = …" for row in chosen))
