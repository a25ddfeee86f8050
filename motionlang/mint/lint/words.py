"""What the words of Mint do to an axis, as far as the linter goes by it; a word that is not here is known by its row.

The roles are those of the manual, so that they hold for words before they are simulated, too.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motionlang.lang.keyword import Keyword

# Moves of one axis that wait in its buffer until GO, and where they end is known.
MOVES = frozenset(("MOVEA", "MOVER"))
# Entries of the buffer of one axis that do not move it, and those that move it nobody knows where to.
ENTRIES = frozenset(("MOVEDWELL", "MOVEOUT", "MOVEOUTX", "MOVEPULSEOUTX"))
COURSES = frozenset(("FLY", "CAM", "SPLINE", "OFFSET"))
# An axis with one of these moves with its master, whatever it does itself.
FOLLOWS = frozenset(("FOLLOW", "FLY", "CAM", "OFFSET"))
# Moves of several axes together, which the GO of the first one starts.
PATHS = frozenset(("VECTORA", "VECTORR", "CIRCLEA", "CIRCLER", "HELIXA", "HELIXR"))
# End what an axis does and empty its buffer; those of HALTS at once.
STOPS = frozenset(("STOP", "CANCEL", "CANCELALL", "ABORT", "RESET", "RESETALL", "DEFAULT", "DEFAULTALL"))
HALTS = STOPS - {"STOP"}
OF_ALL_AXES = frozenset(("CANCELALL", "ABORT", "RESETALL", "DEFAULTALL"))
# Move an axis at once, without GO.
AT_ONCE = frozenset((
    "JOG", "INCA", "INCR", "HOME", "DATUM", "FOLLOW", "TORQUE", "FREQ", "JOGCOMMAND", "SPEEDREF", "SPEEDTESTREF",
    "VELREF", "POSREF", "TORQUEREF", "HTA", "HOLDTOANALOG", "MOVECORRECTION", "SPEEDREFENABLE",
    "TORQUEREFENABLE", "PRESETINDEX",
))  # fmt: skip
# Let something else than the program move an axis from now on: an input, a table, an analogue value.
HANDS_OVER = frozenset(("TRIGGERMODE", "PRESETMOVEENABLE", "SPEEDREFSOURCE", "TORQUEREFSOURCE"))
# Give the axis another zero.
ZEROES = frozenset(("RESET", "RESETALL", "DEFAULT", "DEFAULTALL"))
# Words that give the same property of moves; the one written last counts.
SLOTS = {
    "SPEED": "speed",
    "FEEDRATE": "speed",
    "ACCEL": "accel",
    "ACCELTIME": "accel",
    "ACCELTIMEMAX": "accel",
    "DECEL": "decel",
    "DECELTIME": "decel",
    "DECELTIMEMAX": "decel",
    "ACCELJERK": "accel jerk",
    "ACCELJERKTIME": "accel jerk",
    "DECELJERK": "decel jerk",
    "DECELJERKTIME": "decel jerk",
    "PROFILEMODE": "shape",
}
# Readings of an axis that stand still while it does.
STANDING = frozenset(("POS", "VEL", "POSREMAINING", "POSDEMAND", "VELDEMAND", "FOLERROR"))
SCALES = frozenset(("SCALEFACTOR", "POSSCALEFACTOR"))


def role(row: Keyword, written: bool) -> str:
    """What a statement with this word does to the axes it names.

    "move", "entry", "course", "path", "go", "stop", "act" (moves at once), "slot" (sets one of `SLOTS`), "scale",
    "zero" (POS), "use" (anything else that is given a value or carried out) and "read".
    """
    if not written:
        return "read"
    name = row.name
    for words, what in _ROLES:
        if name in words:
            return what
    return "use"


_ROLES = (
    (MOVES, "move"),
    (ENTRIES, "entry"),
    (COURSES, "course"),
    (PATHS, "path"),
    (frozenset(("GO",)), "go"),
    (STOPS, "stop"),
    (AT_ONCE, "act"),
    (frozenset(SLOTS), "slot"),
    (SCALES, "scale"),
    (frozenset(("POS",)), "zero"),
)
