"""References of a drive: speed, velocity, position; what it demands and what it measures."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0
_LONGEST = 2147483647.0
_RUN = "DRIVESPEEDMAX(0) = 1000 : SPEEDREFACCELTIME(0) = 500 : SPEEDREFDECELTIME(0) = 500\n"
_STOP = "\nSPEEDREF(0) = 0\nPAUSE IDLE(0)\nPRINT POS(0)"


def _setting(name: str, unit: str, help: str, example: str, high: float, default: float = 0.0, short: str = "",
             effect: str = "") -> Keyword:  # fmt: skip
    return Keyword(name, short, "setting", "RW", "axis", unit, "drives.setting", help, example, default=default, low=0,
                   high=high, group="axis", effect=effect)  # fmt: skip


def _time(name: str, help: str) -> Keyword:
    return _setting(name, "number", help, f"{name}(0) = 200\nPRINT {name}(0)", _LONGEST)


def _reading(name: str, short: str, unit: str, verb: str, help: str) -> Keyword:
    return Keyword(name, short, "reading", "R", "axis", unit, verb, help,
                   f"JOG(0) = 100\nWAIT = 100\nPRINT {name}(0)\nCANCEL(0)", default=0.0, group="state")  # fmt: skip


def _reference(name: str, short: str, unit: str, verb: str, help: str, example: str) -> Keyword:
    return Keyword(name, short, "setting", "RW", "axis", unit, verb, help, example, default=0.0, low=-_LARGEST,
                   high=_LARGEST, group="motion", effect="act")  # fmt: skip


_EDGES = (
    ("ACCEL", "START", "from rest builds up"),
    ("ACCEL", "END", "fades as SPEEDREF is reached"),
    ("DECEL", "START", "to a lower SPEEDREF builds up"),
    ("DECEL", "END", "fades as the lower SPEEDREF is reached"),
)

ROWS = (
    _setting("DRIVESPEEDMAX", "uu/s",
             "The highest speed of the application: limits SPEEDREF, and is what its ramp times lead to.",
             "DRIVESPEEDMAX(0) = 1000\nPRINT DRIVESPEEDMAX(0)", _LARGEST, short="dsm"),
    _reference("SPEEDREF", "sdr", "uu/s", "drives.speed",
               "Speed reference: ramp to a speed in the SPEEDREF… times and keep it, until another one is written; 0 "
               "brings the axis to rest.", _RUN + "SPEEDREF(0) = 500\nWAIT = 1000\nPRINT VEL(0)" + _STOP),
    _setting("SPEEDREFENABLE", "bool", "0 lets the axis ramp to rest whatever SPEEDREF is, 1 lets it go on.",
             _RUN + "SPEEDREF(0) = 500\nSPEEDREFENABLE(0) = 0\nPAUSE IDLE(0)\nPRINT SPEEDREF(0)", 1, 1.0, effect="act"),
    _setting("SPEEDREFSOURCE", "integer",
             "What the speed reference is: 0 SPEEDREF, n analogue input n - 1, whose 100 % are the highest speed.",
             "SPEEDREFSOURCE(0) = 1\nPRINT SPEEDREF(0)", 64, effect="hands-over"),
    _time("SPEEDREFACCELTIME", "Milliseconds from rest to the highest speed (DRIVESPEEDMAX, else MAXSPEED, else "
                               "SPEED) in ramps of SPEEDREF; 0 for ACCEL."),
    _time("SPEEDREFDECELTIME", "Milliseconds from the highest speed to rest in ramps of SPEEDREF; 0 for DECEL."),
    *(_time(f"SPEEDREF{way}JERK{edge}TIME", f"Milliseconds in which the {way.lower()}eration {what}; the ramp grows "
                                            "by half of it.") for way, edge, what in _EDGES),
    _time("SPEEDREFERRORDECELTIME", "Milliseconds from the highest speed to rest when an error stops an axis that "
                                    "follows SPEEDREF; 0 for ERRORDECEL."),
    _reference("SPEEDTESTREF", "", "uu/s", "drives.speed",
               "A speed reference for tests, with ramps of its own.",
               "DRIVESPEEDMAX(0) = 1000 : SPEEDTESTREFACCELTIME(0) = 500 : SPEEDTESTREFDECELTIME(0) = 500\n"
               "SPEEDTESTREF(0) = 500\nWAIT = 1000\nPRINT VEL(0)\nSPEEDTESTREF(0) = 0"),
    _time("SPEEDTESTREFACCELTIME", "Milliseconds from rest to the highest speed in ramps of SPEEDTESTREF."),
    _time("SPEEDTESTREFDECELTIME", "Milliseconds from the highest speed to rest in ramps of SPEEDTESTREF."),
    _reference("VELREF", "", "uu/s", "drives.velocity",
               "Velocity reference: within a millisecond the axis has this velocity, without a ramp of its own.",
               "VELREF(0) = 100\nWAIT = 100\nPRINT VEL(0)\nVELREF(0) = 0"),
    _reference("POSREF", "", "uu", "drives.position",
               "Position reference: within a millisecond the axis is there, in a straight line.",
               "POSREF(0) = 2\nWAIT = 2\nPRINT POS(0)"),
    _reading("SPEEDDEMAND", "sdd", "uu/s", "demand_velocity", "The speed that the drive is to have now."),
    _reading("SPEEDMEASURED", "sms", "uu/s", "velocity", "The measured speed, as VEL."),
    _reading("SPEEDERROR", "", "uu/s", "drives.error", "Demanded minus measured speed."),
    _reading("VELERROR", "", "uu/s", "drives.error", "Demanded minus measured velocity."),
)  # fmt: skip
