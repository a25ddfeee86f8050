"""Compensation of play and of a leadscrew's errors: POS shows where the load is, ENCODER where the motor is."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0
_PLAY = (
    "BACKLASH(0) = 2 : BACKLASHINTERVAL(0) = 200 : BACKLASHMODE(0) = 1\n"
    "MOVER(0) = 100\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0), ENCODER(0)"
)
_TABLE = (
    "Dim nut(4) As Float = 3, 0, 101, 199\nPRECISIONTABLE(0, nut, NULL)\nPRECISIONINCREMENT(0) = 100\n"
    "PRECISIONOFFSET(0) = 0\n"
    "PRECISIONMODE(0) = _lsSINGLE_TABLE\nMOVEA(0) = 101\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0), ENCODER(0)"
)


def _setting(name: str, short: str, unit: str, help: str, example: str, low: float, high: float) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, "compensation.setting", help, example, default=0.0,
                   low=low, high=high, group="compensation")  # fmt: skip


def _mode(name: str, value: int, help: str) -> Keyword:
    return Keyword(name, "", "constant", "R", "none", "integer", str(value), help, f"PRINT {name}",
                   group="constants")  # fmt: skip


ROWS = (
    _setting("BACKLASH", "", "uu",
             "The play of the axis. Its sign is the direction in which homing took the play up: positive, the motor "
             "needs the whole of it to go forward and nothing to go in reverse; negative, the other way round. The "
             "axis must be idle.", _PLAY, -_LARGEST, _LARGEST),
    _setting("BACKLASHINTERVAL", "BLI", "integer",
             "Servo cycles of LOOPTIME over which the play is taken up, while the axis moves; 0 at once. The axis must "
             "be idle.", _PLAY, 0, _LARGEST),
    _setting("BACKLASHMODE", "BLM", "integer", "1: play is compensated. Not with _lsDUAL_TABLE.",
             _PLAY, 0, 1),
    _mode("_blOFF", 0, "BACKLASHMODE: off."),
    Keyword("PRECISIONTABLE", "", "command", "C", "axis, array, array", "", "compensation.table",
            "Attach arrays to an axis: the positions of the nut at steps of PRECISIONINCREMENT, going forward, and in "
            "reverse (NULL: as forward). Element 1 is the number of positions.", _TABLE, group="compensation"),
    _setting("PRECISIONINCREMENT", "", "uu", "How far apart the positions of PRECISIONTABLE should be.", _TABLE,
             0, _LARGEST),
    _setting("PRECISIONOFFSET", "PCO", "uu", "Where PRECISIONTABLE begins, from the axis's zero.", _TABLE,
             -_LARGEST, _LARGEST),
    _setting("PRECISIONMODE", "", "integer",
             "Compensation of the leadscrew: _lsOFF, _lsSINGLE_TABLE for both directions, _lsDUAL_TABLE for one each.",
             _TABLE, 0, 2),
    _mode("_lsOFF", 0, "PRECISIONMODE: leadscrew compensation off."),
    _mode("_lsSINGLE_TABLE", 1, "PRECISIONMODE: leadscrew compensation by one table."),
    _mode("_lsDUAL_TABLE", 2, "PRECISIONMODE: leadscrew compensation by two tables."),
)  # fmt: skip
