"""Contour paths: several axes on lines and arcs at one vector velocity."""

from __future__ import annotations

from motionlang.mccl.keywords.row import Group

_G = Group("contour")
_row = _G.row

ROWS = (
    _row("CP", "move", "W", "axis", "number", "path",
         "Begin a contour path on the controlling axis: 0 user defined, 1 line, 2 clockwise arc, 3 anticlockwise arc; "
         "the commands that follow on the line say where it goes.",
         "1MN,2MN,1CM1,2CM1,1CP1,1MA100,2MA50", low=0, high=3, family="contours"),
    _row("CA", "setting", "W", "axis", "uu", "arc_center", "Centre of the arc of this path, absolute.",
         "1MN,2MN,1CM1,2CM1,1CP2,1CA100,2CA0,1MA200,2MA0", family="contours"),
    _row("CR", "setting", "W", "axis", "uu", "arc_center_by", "Centre of the arc of this path, from its start.",
         "1MN,2MN,1CM1,2CM1,1CP2,1CR100,2CR0,1MR200,2MR0", family="contours"),
    _row("EA", "setting", "W", "axis", "number", "arc_end",
         "Ending angle of the arc of this path, degrees, absolute.",
         "1MN,2MN,1CM1,2CM1,1CP3,1CR-100,2CR0,1EA90", family="contours"),
    _row("ER", "setting", "W", "axis", "number", "arc_end_by",
         "Ending angle of the arc of this path, degrees from its start.",
         "1MN,2MN,1CM1,2CM1,1CP3,1CR-100,2CR0,1ER90", family="contours"),
    _row("RR", "setting", "W", "axis", "uu", "arc_radius",
         "Radius of the arc of this path; negative takes the longer way.",
         "1MN,2MN,1CM1,2CM1,1CP2,1RR100,1MR200,2MR0", family="contours"),
    _row("CD", "setting", "W", "axis", "uu", "path_distance", "Length along a user-defined path.",
         "1MN,2MN,1CM1,2CM1,1CP0,1CD100,1MR60,2MR80", low=0, family="contours"),
    _row("TX", "reading", "R", "axis", "number", "tell_segment", "Tell the number of contour paths carried out.",
         "1TX", family="contours"),
    _row("CX", "reading", "R", "axis", "number", "tell_segment",
         "The same as TX; which of the two names is right is not known.", "1CX", family="contours"),
)  # fmt: skip
