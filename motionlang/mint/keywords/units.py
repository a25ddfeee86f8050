"""Units of their own for positions, speeds and accelerations, as newer drives have them."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_RPM = "POSSCALEFACTOR(0) = 4000\nVELSCALEFACTOR(0) = 4000 / 60\nACCELSCALEFACTOR(0) = 4000\nPRINT {}(0)"


def _factor(name: str, verb: str, help: str, effect: str = "") -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", "number", f"units.{verb}", help, _RPM.format(name), default=1.0,
                   low=1e-6, high=1e12, group="axis", effect=effect)  # fmt: skip


ROWS = (
    _factor("POSSCALEFACTOR", "position",
            "Counts per user unit of positions and distances. SCALEFACTOR writes it too.", "scale"),
    _factor("VELSCALEFACTOR", "speed",
            "Counts a second per user unit of speed: 4000 / 60 makes revolutions a minute of 4000 counts a turn. Goes "
            "by POSSCALEFACTOR until it is set, and again from SCALEFACTOR on."),
    _factor("ACCELSCALEFACTOR", "acceleration",
            "Counts a second² per user unit of acceleration, and likewise of jerk. Goes by POSSCALEFACTOR until it is "
            "set, and again from SCALEFACTOR on."),
)  # fmt: skip
