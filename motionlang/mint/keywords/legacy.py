"""Words of Mint v4 that MintMT has others for. A program may use their names for its own where it declares them."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

GROUP = "v4"
_FAIL = "\nEnd\nEvent ONERROR\n  PRINT {0}\nEnd Event"
_CONTOUR = "CONTOURMODE(0) = {}\n{}(0)\nPRINT CONTOURMODE(0)"


def _last(name: str, verb: str, help: str, default: float = 0.0) -> Keyword:
    return Keyword(name, "", "reading", "R", "none", "integer", f"legacy.{verb}", help,
                   f"SPEED(0) = 0\nMOVER(0) = 1\nGO(0){_FAIL.format(name)}", default=default, group=GROUP)  # fmt: skip


def _contour(name: str, before: int, help: str) -> Keyword:
    return Keyword(name, "", "command", "C", "axes", "", "legacy.contour", help, _CONTOUR.format(before, name),
                   group=GROUP)  # fmt: skip


ROWS = (
    _last("ERR", "error", "Number of the last error, 0 before the first one (v4; ERRCODE in MintMT)."),
    _last("ERL", "error_line", "Line of the last error, 0 before the first one (v4; ERRLINE in MintMT)."),
    _last("ERRAXIS", "error_axis", "Axis of the last error that an axis had, -1 before the first one (v4).",
          default=-1.0),
    Keyword("MODE", "", "reading", "R", "axis", "bits", "sensing.axis_mode",
            "Kind of motion of an axis (v4; AXISMODE in MintMT).", "MOVER(0) = 100\nGO(0)\nPRINT MODE(0)",
            default=0.0, group=GROUP),
    Keyword("HOLDTOANALOG", "", "setting", "RW", "axis", "%", "hold_to_analogue.hold",
            "Move an axis so that an analogue input holds this value (v4; HTA).",
            "HTACHANNEL(0) = 1 : HTAKPROP(0) = 2\nHOLDTOANALOG(0) = 25\nWAIT = 200\nPRINT VEL(0)\nSTOP(0)",
            default=0.0, low=-100.0, high=100.0, group="motion", effect="act"),
    _contour("CONTOURON", 0, "Run through paths without slowing down (v4; CONTOURMODE = 1 in MintMT)."),
    _contour("CONTOUROFF", 1, "Slow down between paths (v4; CONTOURMODE = 0 in MintMT)."),
)  # fmt: skip
