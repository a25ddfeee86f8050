"""Moves of several axes along one path, and how one path goes over into the next."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LARGEST = 8388607.0
_READY = "SPEED(0) = 100 : ACCEL(0) = 1000 : DECEL(0) = 1000\n"
_END = '\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0), " ", POS(1)'
_TWO = "VECTORR(0, 1) = 60, 0\nVECTORR(0, 1) = 0, 60\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(1)"


def _path(name: str, unit: str, help: str, example: str, effect: str = "path") -> Keyword:
    short = "".join(name[at] for at in (0, -1)) if name[:5] != "HELIX" else ""  # VA, VR, CA, CR
    return Keyword(name, short, "move", "W", "axes", unit, "paths.arc" if "degrees" in unit else "paths.line", help,
                   example + _END, group="motion", effect=effect)  # fmt: skip


def _setting(name: str, unit: str, verb: str, help: str, example: str, high: float) -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, verb, help, _READY + example, default=0.0, low=0.0,
                   high=high, group="paths")  # fmt: skip


_RULE = "SPEED, ACCEL and DECEL of the first axis are those along the path, and GO of it starts all"
ROWS = (
    _path("VECTORA", "uu", f"Load a straight line of several axes to a position; {_RULE}.",
          "VECTORA(0, 1) = 30, 40", effect="path line"),
    _path("VECTORR", "uu", f"Load a straight line of several axes by distances; {_RULE}.",
          "VECTORR(0, 1) = 30, 40", effect="path line relative"),
    _path("CIRCLEA", "uu, uu, degrees",
          f"Load an arc of two axes: absolute centre and angle, positive from the first axis to the second; {_RULE}.",
          "CIRCLEA(0, 1) = 50, 0, 180"),
    _path("CIRCLER", "uu, uu, degrees",
          f"Load an arc of two axes: centre counted from its start, and angle; {_RULE}.",
          "CIRCLER(0, 1) = 50, 0, 180"),
    _path("HELIXA", "uu, uu, degrees, uu",
          f"Load a helix of three axes: absolute centre, angle, and where the third axis ends; {_RULE}.",
          "HELIXA(0, 1, 2) = 50, 0, 720, 20"),
    _path("HELIXR", "uu, uu, degrees, uu",
          f"Load a helix of three axes: centre counted from its start, angle, and the third axis's distance; {_RULE}.",
          "HELIXR(0, 1, 2) = 50, 0, 720, 20"),
    _setting("CONTOURMODE", "integer", "contour_mode",
             "1: paths of the same axes are run through without slowing down, where their directions differ by no more "
             "than CONTOURANGLE.", "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 90\n" + _TWO, 1),
    _setting("CONTOURANGLE", "number", "contour_angle",
             "Degrees by which the direction may change between two paths that are run through.",
             "CONTOURMODE(0) = 1 : CONTOURANGLE(0) = 90\n" + _TWO, 180),
    _setting("BLENDMODE", "integer", "blend_mode",
             "1: a path begins when BLENDDISTANCE is left of the one before it, on top of the rest of that one.",
             "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 5\n" + _TWO, 1),
    _setting("BLENDDISTANCE", "number", "blend_distance",
             "What is left of a path when the next one begins, in user units along it; up to half of the path.",
             "BLENDMODE(0) = 1 : BLENDDISTANCE(0) = 5\n" + _TWO, _LARGEST),
    Keyword("BLEND", "", "command", "C", "axes", "", "paths.blend",
            "Begin the next path now, on top of what remains of the present one; at most two paths overlap.",
            _READY + "VECTORR(0, 1) = 60, 0\nVECTORR(0, 1) = 0, 60\nGO(0)\nPAUSE POS(0) > 50\nBLEND(0)\n"
            "PAUSE IDLE(0)\nPRINT POS(1)", group="motion"),
    Keyword("VELDEMANDPATH", "", "reading", "R", "axis", "number", "path_speed",
            "Speed along the path that the axis is on, in user units a second.",
            _READY + "VECTORR(0, 1) = 30, 40\nGO(0)\nWAIT = 200\nPRINT VELDEMANDPATH(0)", default=0.0, group="paths"),
    Keyword("VECTORANGLE", "", "reading", "R", "axis, axis", "number", "paths.angle",
            "The direction, in degrees, in which two axes move in their plane; 0 at rest.",
            _READY + "VECTORR(0, 1) = 30, 30\nGO(0)\nWAIT = 100\nPRINT VECTORANGLE(0, 1)", default=0.0, group="paths"),
)  # fmt: skip
