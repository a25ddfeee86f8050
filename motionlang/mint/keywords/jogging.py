"""Jogging by a command: a preset speed, a direction, a time."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0
_LONGEST = 2147483647.0
_PANEL = "JOGSPEED(0) = 100 : JOGMODE(0) = 1 : JOGDURATION(0) = 300\nJOGCOMMAND(0) = 1\nWAIT = 100\n"


def _setting(
    name: str, short: str, unit: str, help: str, example: str, high: float, low: float = 0.0
) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, "jogging.setting", help, example, default=0.0, low=low,
                   high=high, group="axis")  # fmt: skip


ROWS = (
    _setting("JOGSPEED", "jgs", "uu/s", "The speed at which JOGCOMMAND jogs; a new one acts at once.",
             "JOGSPEED(0) = 100\nJOGCOMMAND(0) = -1\nWAIT = 100\nPRINT VEL(0)\nJOGCOMMAND(0) = 0", _LARGEST),
    Keyword("JOGCOMMAND", "jgc", "setting", "RW", "axis", "integer", "jogging.command",
            "Jog at JOGSPEED: 1 forwards, -1 in reverse; 0 brings the axis to rest. It keeps its value until it is "
            "written again, also when JOGDURATION has ended the jog.",
            _PANEL + "PRINT VEL(0)\nPAUSE IDLE(0)\nPRINT POS(0)", default=0.0, low=-1, high=1,
            group="motion", effect="act"),
    _setting("JOGMODE", "", "integer",
             "How long JOGCOMMAND jogs: 0 until it is 0, 1 for JOGDURATION, once for each new command.",
             "JOGMODE(0) = 1\nPRINT JOGMODE(0)", 1),
    _setting("JOGDURATION", "", "ms",
             "After how many milliseconds a jog of JOGMODE 1 begins to come to rest.",
             "JOGDURATION(0) = 500\nPRINT JOGDURATION(0)", _LONGEST),
    Keyword("JOGTIME", "", "reading", "R", "axis", "integer", "jogging.time",
            "How many milliseconds JOGCOMMAND has been jogging; 0 while it does not.",
            _PANEL + "PRINT JOGTIME(0)\nPAUSE IDLE(0)", default=0.0, group="state", solved=True),
    _setting("JOGACCELTIMEMAX", "", "ms",
             "Acceleration of jogs, given as the time from rest to DRIVESPEEDMAX or, where that is not set, MAXSPEED "
             "or SPEED; 0 for ACCEL.",
             "MAXSPEED(0) = 200 : JOGACCELTIMEMAX(0) = 1000\nJOG(0) = 100\nWAIT = 250\nPRINT VEL(0)\nCANCEL(0)",
             _LONGEST),
    _setting("JOGDECELTIMEMAX", "", "ms",
             "Deceleration of jogs, given as the time from that speed to rest; 0 for DECEL.",
             "MAXSPEED(0) = 200 : JOGDECELTIMEMAX(0) = 1000\nJOG(0) = 100\nWAIT = 250\nSTOP(0)\nPAUSE IDLE(0)\n"
             "PRINT POS(0)", _LONGEST),
)  # fmt: skip
