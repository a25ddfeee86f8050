"""Predefined constants; the `verb` of a row holds its value."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword


def _constant(name: str, value: str, unit: str, help: str) -> Keyword:
    return Keyword(name, "", "constant", "R", "none", unit, value, help, f"PRINT {name}",
                   group="constants")  # fmt: skip


ROWS = (
    _constant("_TRUE", "1", "bool", "True: 1."),
    _constant("_FALSE", "0", "bool", "False: 0."),
    _constant("_ON", "1", "bool", "On: 1."),
    _constant("_OFF", "0", "bool", "Off: 0."),
    _constant("_pi", "3.141592653589793", "number", "The ratio of a circle's circumference to its diameter."),
    _constant("_MAXINT", "2147483647", "integer", "The largest Integer."),
    _constant("_MININT", "-2147483648", "integer", "The smallest Integer."),
    _constant("_pmTRAPEZOIDAL", "0", "integer", "PROFILEMODE: trapezoidal moves."),
    _constant("_pmSRAMP", "1", "integer", "PROFILEMODE: S-ramp moves, with limited jerk."),
    _constant("_egALL", "0", "integer", "ERRORPRESENT and its family: every error."),
    _constant("_egSYNCHRONOUS", "1", "integer", "ERRORPRESENT and its family: errors of statements."),
    _constant("_egAXIS", "2", "integer", "ERRORPRESENT and its family: errors of an axis."),
    _constant("_egMISC", "3", "integer", "ERRORPRESENT and its family: errors of the controller."),
)  # fmt: skip
