"""The vocabulary of MCCL: one row per mnemonic, one file per subject.

No other package contains a mnemonic. In the rows of MCCL `index` is the meaning of the number in front of a
command: "axes" is one axis, or all axes if there is no number; "axis" is one axis, which is required;
"none" is no number. `access` "C" takes no parameter, "W" takes one (0 if it is omitted), "R" reports. The
function of a command is called with the task and the `Command`.
"""

from __future__ import annotations

from collections.abc import Collection
from functools import cache

from motionlang.kernel.lang.keyword import Keyword
from motionlang.kernel.lang.vocabulary import Vocabulary

# In the order of the pages.
ORDER = """
trajectory trajectory_backlash filter filter_stages limits units modes_gearing modes_jog motion motion_auxiliary
motion_homing motion_points motion_record contour reports io macros registers registers_functions registers_variables
flow flow_waits miscellaneous miscellaneous_texts
"""


@cache
def table() -> Vocabulary:
    """Return all commands of MCCL."""
    from motionlang.kernel.mccl.keywords.index import FILES

    return Vocabulary(__name__, FILES)


@cache
def tuning() -> tuple[Keyword, ...]:
    """Return the commands that set a quantity of the servo loop."""
    return tuple(row for row in table() if row.tunes)


def of_families(families: Collection[str]) -> frozenset[str]:
    """Return the commands that belong to some families."""
    return frozenset(row.name for row in table() if row.family in families) if families else frozenset()
