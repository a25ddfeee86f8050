"""The keywords of Mint, one file per subject.

A file holds the rows of its keywords and, above them, their operations. A run imports only the files of the
keywords that it uses. `index` lists the file of each keyword, so the package itself imports none of them.
"""

from __future__ import annotations

from functools import cache

from motionlang.kernel.lang.vocabulary import Vocabulary

# In the order of the documentation pages. The last file holds keywords that are not simulated.
ORDER = """
hold_to_analogue jogging axis feedrate motion buffer compensation on_the_fly paths following following_masters
following_auxiliary table_motion_cams table_motion_splines state timing tasks terminal io_inputs io_outputs io_signals
comms modbus remote network limits limits_switches limits_resetting homing latches sensing servo functions nonvolatile
no_effect identity legacy constants language library
"""


@cache
def table() -> Vocabulary:
    """Return the table of all Mint keywords."""
    from motionlang.kernel.mint.keywords.index import FILES

    return Vocabulary(__name__, FILES)
