"""The vocabulary of MCCL: one row a mnemonic, in one module a group, and nothing that knows a mnemonic elsewhere.

`TABLE` is the whole. In the rows of MCCL `index` says what the number in front of a command means: "axes", one axis, or
all of them when there is none; "axis", one axis that must be named; "none", nothing. `access` "C" takes no parameter,
"W" takes one (0 when it is left out), "R" reports.
"""

from __future__ import annotations

from motionlang.lang.keyword import Table
from motionlang.mccl.keywords import (
    contour,
    filter,
    flow,
    io,
    limits,
    macros,
    miscellaneous,
    modes,
    motion,
    registers,
    reports,
    trajectory,
    units,
)

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Collection

TABLE = Table(
    row
    for group in (
        trajectory,
        filter,
        limits,
        units,
        modes,
        motion,
        contour,
        reports,
        io,
        macros,
        registers,
        flow,
        miscellaneous,
    )
    for row in group.ROWS
)


def of_families(families: Collection[str]) -> frozenset[str]:
    """The commands of some families."""
    return frozenset(row.name for row in TABLE if row.family in families)
