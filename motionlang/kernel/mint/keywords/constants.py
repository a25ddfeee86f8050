"""Predefined constants; the `function` of a row holds its value."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import constant

ROWS = (
    constant("_TRUE", 1, "True: 1.", "bool"),
    constant("_FALSE", 0, "False: 0.", "bool"),
    constant("_ON", 1, "On: 1.", "bool", "HIGH"),
    constant("_OFF", 0, "Off: 0.", "bool", "LOW"),
    constant("_pi", 3.141592653589793, "The ratio of a circle's circumference to its diameter.", "number"),
    constant("_MAXINT", 2147483647, "The largest Integer."),
    constant("_MININT", -2147483648, "The smallest Integer."),
    constant("_pmTRAPEZOIDAL", 0, "PROFILEMODE: trapezoidal moves."),
    constant("_pmSRAMP", 1, "PROFILEMODE: S-ramp moves, with limited jerk."),
    constant("_egALL", 0, "ERRORPRESENT and its family: every error."),
    constant("_egSYNCHRONOUS", 1, "ERRORPRESENT and its family: errors of statements."),
    constant("_egAXIS", 2, "ERRORPRESENT and its family: errors of an axis."),
    constant("_egMISC", 3, "ERRORPRESENT and its family: errors of the controller."),
)  # fmt: skip
