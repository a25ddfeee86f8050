"""Motion by tables: cams over a master's positions, splines over time."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0
_CAM = (
    "Dim rise(5) As Float = 4, 1, 2, 2, 1\nSPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
    "CAMTABLE(1, rise)\nMASTERDISTANCE(1) = 10\n{}CAM(1) = 0\nGO(1)\nMOVER(0) = 40\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)"
)
_SPLINE = (
    "Dim way(4) As Float = 3, 10, 20, 10\nSPLINETABLE(0, way, NULL, NULL)\n{}SPLINE(0) = 0\nGO(0)\nPAUSE IDLE(0)\n"
    'PRINT POS(0), " ", TIME'
)
_SPLINE_BITS = (
    ("SPLINE_1", 0, "velocities are the means of the segments at each point"),
    ("ABSOLUTE", 1, "positions count from the begin of each cycle"),
    ("T_ABSOLUTE", 2, "positions are those of the axis"),
    ("CONTINUOUS", 4, "again and again until it is stopped"),
    ("SPLINE_2", 8, "the acceleration is continuous"),
)


def _setting(
    name: str, verb: str, unit: str, help: str, example: str, default: float, low: float, high: float
) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, verb, help, example, default=default, low=low,
                   high=high, group="tables")  # fmt: skip


def _index(name: str, help: str, example: str, verb: str) -> Keyword:
    return Keyword(name, "", "reading", "R", "axis", "integer", verb, help, example, default=0.0,
                   group="tables")  # fmt: skip


def _command(name: str, index: str, verb: str, help: str, example: str) -> Keyword:
    return Keyword(name, "", "command", "C", index, "", verb, help, example, group="motion")  # fmt: skip


ROWS = (
    *(
        Keyword(f"_sp{name}", "", "constant", "R", "none", "integer", str(value), f"SPLINE, and CAM: {help}.",
                f"PRINT _sp{name}", group="constants")
        for name, value, help in _SPLINE_BITS
    ),
    _command("CAMTABLE", "axis, array, array", "table_motion.cams.table",
             "Attach arrays to a cam: positions of each segment, and lengths of the master's way in it, without which "
             "MASTERDISTANCE is that of each. Element 1 is the number of segments.", _CAM.format("")),
    Keyword("CAM", "", "move", "RW", "axis", "integer", "table_motion.cams.cam",
            "Load a cam over the master; GO begins it where both axes then are. Bits: 0 positions count from its begin "
            "and not from segment to segment, 1 they are those of the axis, 2 again and again.",
            _CAM.format(""), low=0, high=7, group="motion", effect="course follows"),
    _setting("CAMSTART", "following.masters.setting", "integer", "The first segment of a cam that is used.",
             _CAM.format("CAMSTART(1) = 2\n"), 1.0, 1, 16777215),
    _setting("CAMEND", "following.masters.setting", "integer",
             "The last segment of a cam that is used; 0 for the table's last.",
             _CAM.format("CAMEND(1) = 3\n"), 0.0, 0, 16777215),
    _setting("CAMAMPLITUDE", "following.masters.setting", "number", "What the positions of a cam are multiplied by.",
             _CAM.format("CAMAMPLITUDE(1) = 2\n"), 1.0, -_LARGEST, _LARGEST),
    _index("CAMINDEX", "The segment of the cam that is executing, 0 without a cam.",
           _CAM.format("") + "\nPRINT CAMINDEX(1)", "table_motion.cams.index"),
    _command("CAMSEGMENT", "axis, table, segment, array", "table_motion.cams.segment",
             "Write other values into a cam's arrays, from a segment on: table 0 positions, 1 lengths. They count from "
             "the next cycle on.",
             "Dim more(2) As Float = 1, 5\n" + _CAM.format("CAMSEGMENT(1, 0, 2, more)\n")),
    _command("CAMPHASE", "axis, segment, segments, distance", "table_motion.cams.phase",
             "Let the master go further, or less far, by a distance over some segments in the next cycle.",
             _CAM.format("CAMPHASE(1, 1, 2, 5)\n")),
    _index("CAMPHASESTATUS", "1 while a CAMPHASE waits for its cycle or is under way.",
           _CAM.format("") + "\nPRINT CAMPHASESTATUS(1)", "table_motion.cams.phase_status"),
    _command("SPLINETABLE", "axis, array, array, array", "table_motion.splines.table",
             "Attach arrays to a spline: positions, velocities (NULL: chosen) and times of the segments in ms (NULL: "
             "SPLINETIME). Element 1 is the number of segments.", _SPLINE.format("")),
    Keyword("SPLINE", "SPL", "move", "RW", "axis", "integer", "table_motion.splines.spline",
            "Load a spline through the positions of SPLINETABLE; GO begins it. The bits are the _sp constants; "
            "the axis must be idle.",
            _SPLINE.format(""), low=0, high=15, group="motion", effect="course", family="splines"),
    _setting("SPLINESTART", "table_motion.splines.setting", "integer", "The first segment of a spline that is used.",
             _SPLINE.format("SPLINESTART(0) = 2\n"), 1.0, 1, 16777215),
    _setting("SPLINEEND", "table_motion.splines.setting", "integer",
             "The last segment of a spline that is used; 0 for the table's last.",
             _SPLINE.format("SPLINEEND(0) = 2\n"), 0.0, 0, 16777215),
    _setting("SPLINETIME", "table_motion.splines.setting", "ms",
             "Milliseconds of each segment of a spline, of which whole steps of 2 count.",
             _SPLINE.format("SPLINETIME(0) = 250\n"), 100.0, 4, 60000),
    _setting("SPLINESUSPENDTIME", "suspend_time", "ms",
             "Milliseconds in which SUSPEND and STOP bring a spline to rest on its path, and in which it does the rest "
             "of its segment when it goes on.",
             _SPLINE.format("SPLINESUSPENDTIME(0) = 20\n"), 100.0, 0, 60000),
    _index("SPLINEINDEX", "The segment of the spline that is executing, 0 without one.",
           _SPLINE.format("") + "\nPRINT SPLINEINDEX(0)", "table_motion.splines.index"),
    _command("SPLINESEGMENT", "axis, table, segment, array", "table_motion.splines.segment",
             "Write other values into a spline's arrays, from a segment on: table 0 positions, 1 velocities, 2 times.",
             "Dim more(2) As Float = 1, 5\n" + _SPLINE.format("SPLINESEGMENT(0, 0, 2, more)\n")),
)  # fmt: skip
