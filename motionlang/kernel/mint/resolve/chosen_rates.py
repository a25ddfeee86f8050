"""Rates of a program's moves that no statement sets and no source gives.

A move without ACCEL or DECEL runs at a default that is a choice of this program, so its time is one, too.
"""

from __future__ import annotations

from collections.abc import Mapping

from motionlang.kernel.lang.machine.machine import ASSUMPTIONS
from motionlang.kernel.mint.keywords import axis
from motionlang.kernel.mint.keywords.switchable import name_of
from motionlang.kernel.mint.syntax.nodes import Assign, Module, Name
from motionlang.kernel.mint.syntax.traversal import names_of, walk

# The rates whose defaults are choices; the speed at power-up is printed.
RATES = ("accel", "decel")
# The first word of the effect of the keywords whose motion has these rates.
MOVES = frozenset(("move", "path"))


def chosen_rates(module: Module, settings: Mapping[str, object]) -> list[str]:
    """Return a line about the rates that the moves of a program take from a chosen default, if there are any."""
    targets = [node.target for node in walk(module.everything) if isinstance(node, Assign)]
    given = {each.row.gives for each in targets if isinstance(each, Name) and each.row is not None}
    if given.issuperset(RATES):
        return []
    effects = {name.row.effect for name in names_of(module) if name.row is not None}
    if not any(each.partition(" ")[0] in MOVES or each == "act endless" for each in effects):
        return []
    chosen = [
        row
        for row in axis.ROWS
        if row.gives in RATES
        and row.default is not None
        and row.gives not in given
        and f"{ASSUMPTIONS}{name_of(row)}" not in settings
    ]
    if not chosen:
        return []
    names, verb = " and ".join(row.name for row in chosen), "is" if len(chosen) == 1 else "are"
    value = " and ".join(dict.fromkeys(f"{row.default:.10g} counts/s²" for row in chosen))
    settled = " : ".join(f"{row.name}(0) = …" for row in chosen)
    return [
        f"{names} {verb} never set: {value} is a choice of motionlang ({', '.join(map(name_of, chosen))}); "
        f"{settled} settles it"
    ]
