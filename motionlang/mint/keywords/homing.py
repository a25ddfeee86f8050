"""Homing."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword
from motionlang.mint.keywords.defaults import HOME_BACKOFF, HOME_SPEED, HOME_TYPES

_HOMED = "If HOMEINPUT(0) >= 0 Then HOME(0) = _hmNEGATIVE_SWITCH\nPAUSE IDLE(0)\nPRINT {}(0)"


def _setting(
    name: str, unit: str, value: str, help: str, default: float | None, low: float, high: float
) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, "homing.setting", help,
                   f"{name}(0) = {value}\nPRINT {name}(0)", default=default, low=low, high=high,
                   group="homing")  # fmt: skip


def _what(direction: int, switch: str, index: bool) -> str:
    way = "forward" if direction > 0 else "in reverse"
    where = {"home": "the home switch", "limit": "the limit switch", "index": "the encoder's index"}[switch]
    return f"HOME: {way} to {where}{', then to the index' if index and switch != 'index' else ''}."


ROWS = (
    Keyword("HOME", "HM", "setting", "RW", "axis", "integer", "homing.home",
            "Find the datum of the axis: run to the switch, leave it slowly, go on to the index; one of the _hm types.",
            _HOMED.format("HOME"), low=0, high=len(HOME_TYPES) - 1, group="motion", effect="act datum"),
    Keyword("HOMETYPE", "", "setting", "RW", "axis", "integer", "homing.type",
            "The type of homing, as HOME was given it last.",
            "HOMETYPE(0) = _hmPOSITIVE_SWITCH\nPRINT HOMETYPE(0)",
            default=0.0, low=0, high=len(HOME_TYPES) - 1, group="homing"),
    _setting("HOMESPEED", "uu/s", "50", "Speed of the search for the switch.", HOME_SPEED, 1e-6, 8388607.0),
    _setting("HOMEBACKOFF", "number", "20", "What HOMESPEED is divided by while the axis leaves the switch.",
             HOME_BACKOFF,
             1.0, 1e6),
    _setting("HOMECREEPSPEED", "uu/s", "2", "Speed of the search for the index after the switch, and of the way to "
             "HOMEOFFSET; HOMESPEED / HOMEBACKOFF until it is set.", None, 1e-6, 8388607.0),
    _setting("HOMEACCEL", "uu/s2", "1000", "Acceleration while homing; ACCEL until it is set.", None, 1e-6, 1e12),
    _setting("HOMEDECEL", "uu/s2", "1000", "Deceleration while homing; DECEL until it is set.", None, 1e-6, 1e12),
    _setting("HOMEOFFSET", "uu", "5", "How far from the datum the axis ends its homing.", 0.0, -8388607.0, 8388607.0),
    _setting("HOMEREFPOS", "uu", "100", "The position that the datum gets.", 0.0, -8388607.0, 8388607.0),
    Keyword("HOMEPOS", "HPS", "reading", "R", "axis", "uu", "homing.position",
            "The position that the axis had at its datum before homing set it: POS(0) = HOMEPOS(0) afterwards counts "
            "as if the axis had not been homed, and after a second homing it shows slip or lost steps.",
            _HOMED.format("HOMEPOS"), default=0.0, low=-8388607.0, high=8388607.0, group="homing"),
    Keyword("HOMESTATUS", "", "setting", "RW", "axis", "bool", "homing.status",
            "1 when the axis has found its datum.",
            _HOMED.format("HOMESTATUS"), default=0.0, low=0, high=1, group="homing"),
    Keyword("HOMEPHASE", "", "reading", "R", "axis", "integer", "homing.phase",
            "Where the homing is: 0 at its end, 1 search, 2 stopping on the switch, 3 leaving it, 4 looking for the "
            "index, 5 stopping behind the datum, 6 on the way to HOMEOFFSET.",
            _HOMED.format("HOMEPHASE"), default=0.0, group="homing"),
    Keyword("HOMEINPUT", "hi", "setting", "RW", "axis", "integer", "limits.switches.input",
            "The input that is the home switch of the axis; -1 for none.",
            "HOMEINPUT(0) = 2\nPRINT HOMEINPUT(0)", default=-1.0, low=-1, high=999, group="homing"),
    Keyword("HOMESWITCH", "hsw", "reading", "R", "axis", "bool", "limits.switches.home_switch",
            "1 while the axis is on its home switch.",
            "PRINT HOMESWITCH(0)", default=0.0, group="homing", driven="input"),
    *(
        Keyword(name, "", "constant", "R", "none", "integer", str(value), _what(direction, switch, index),
                f"PRINT {name}", group="constants")
        for value, (name, direction, switch, index) in enumerate(HOME_TYPES)
    ),
)  # fmt: skip
