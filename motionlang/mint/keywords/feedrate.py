"""Which speed a move goes at: FEEDRATE, its modes and its override; limits; times and percentages of ramps."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0
_LONGEST = 2147483647.0
_HALF = "SPEED(0) = 20\nFEEDRATEMODE(0) = 2\nFEEDRATEOVERRIDE(0) = 50\nMOVER(0) = 100\nGO(0)\nWAIT = 100\nPRINT VEL(0)"


def _most(name: str, unit: str, verb: str, help: str, example: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, verb, help, example, default=_LARGEST, low=1e-6,
                   high=1e12, group="axis")  # fmt: skip


def _ramp_time(name: str, verb: str, help: str, example: str, low: float, gives: str) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "ms", verb, help, example, low=low, high=_LONGEST,
                   group="axis", gives=gives)  # fmt: skip


ROWS = (
    Keyword("FEEDRATE", "", "setting", "RW", "axis", "uu/s", "speed",
            "Another name of SPEED: slew speed of moves; with bit 0 of FEEDRATEMODE each keeps that of its loading.",
            "FEEDRATE(0) = 250\nPRINT FEEDRATE(0), SPEED(0)",
            default=40000.0, low=0.0, high=_LARGEST, group="axis", gives="speed"),
    Keyword("FEEDRATEMODE", "FRM", "setting", "RW", "axis", "integer", "feedrate_mode",
            "Bit 0: moves keep the speed with which they are loaded; without it a new speed acts at once. "
            "Bit 1: FEEDRATEOVERRIDE acts.",
            "FEEDRATEMODE(0) = 1\nPRINT FEEDRATEMODE(0)", default=0.0, low=0, high=3, group="axis"),
    Keyword("FEEDRATEOVERRIDE", "FRO", "setting", "RW", "axis", "%", "override",
            "Percentage of its speed at which a move runs, where bit 1 of FEEDRATEMODE is set; it acts at once.",
            _HALF, default=100.0, low=0.0, high=_LARGEST, group="axis"),
    Keyword("FEEDRATEPARAMETER", "", "setting", "RW", "axis, parameter", "number", "feedrate.parameter",
            "What moves loaded from now on keep: parameter 0 a speed, 1 an acceleration, 2 a deceleration; 0 goes back "
            "to SPEED, ACCEL or DECEL.",
            "FEEDRATEPARAMETER(0, 0) = 25\nMOVER(0) = 100\nGO(0)\nWAIT = 100\nPRINT VEL(0)",
            default=0.0, low=0.0, high=1e12, group="axis"),
    _most("MAXSPEED", "uu/s", "max_speed",
          "The highest speed of moves, of JOG, of an axis on a path, and of OFFSET in its mode 1 and above.",
          "MAXSPEED(0) = 50\nSPEED(0) = 80\nMOVER(0) = 100\nGO(0)\nWAIT = 100\nPRINT VEL(0)"),
    _most("MAXACCEL", "uu/s2", "max_accel", "The highest acceleration of moves, of JOG and of an axis on a path.",
          "MAXACCEL(0) = 50\nPRINT MAXACCEL(0)"),
    _most("MAXDECEL", "uu/s2", "max_decel", "The highest deceleration of moves, of JOG, of STOP and on a path.",
          "MAXDECEL(0) = 50\nPRINT MAXDECEL(0)"),
    _ramp_time("ACCELTIMEMAX", "feedrate.time_to_most",
               "Acceleration given as the time from rest to MAXSPEED; replaces ACCEL.",
               "MAXSPEED(0) = 100\nACCELTIMEMAX(0) = 200\nPRINT ACCEL(0)", 0.001, "accel"),
    _ramp_time("DECELTIMEMAX", "feedrate.time_to_most",
               "Deceleration given as the time from MAXSPEED to rest; replaces DECEL.",
               "MAXSPEED(0) = 100\nDECELTIMEMAX(0) = 200\nPRINT DECEL(0)", 0.001, "decel"),
    _ramp_time("ACCELJERKTIME", "accel_jerk_time",
               "Jerk given as the time in which ACCEL builds up in an S-ramp, 0 for at once; replaces ACCELJERK.",
               "ACCEL(0) = 500\nACCELJERKTIME(0) = 100\nPRINT ACCELJERK(0)", 0, "accel jerk"),
    _ramp_time("DECELJERKTIME", "decel_jerk_time",
               "Jerk given as the time in which DECEL builds up in an S-ramp, 0 for at once; replaces DECELJERK.",
               "DECEL(0) = 500\nDECELJERKTIME(0) = 100\nPRINT DECELJERK(0)", 0, "decel jerk"),
    Keyword("SRAMP", "", "setting", "RW", "axis", "%", "feedrate.s_ramp",
            "Smoothing of ramps in percent: 0 a trapezoid, 100 acceleration that only rises and falls. Replaces "
            "PROFILEMODE and the jerks; ACCEL and DECEL stay the peaks, so ramps grow by this percentage.",
            "SPEED(0) = 100\nACCEL(0) = 500\nSRAMP(0) = 50\nPRINT ACCELJERK(0)",
            default=0.0, low=0.0, high=100.0, group="axis"),
)  # fmt: skip
