"""What corrects motion from outside: another end for the move in progress, another base of time."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

ROWS = (
    Keyword("MOVECORRECTION", "", "setting", "W", "axis", "uu", "correction.correction",
            "Let the move in progress end this much further on, such as by the error of a print mark.",
            "MOVER(0) = 100\nGO(0)\nMOVECORRECTION(0) = 2\nPAUSE IDLE(0)\nPRINT POS(0)",
            low=-8388607.0, high=8388607.0, group="motion", effect="act"),
    Keyword("TIMESCALE", "", "setting", "RW", "axis", "number", "correction.time",
            "Seconds in the unit of time of speeds and accelerations: 60 makes them units a minute. Settings made "
            "before keep what they are.",
            "TIMESCALE(0) = 60\nSPEED(0) = 600\nMOVER(0) = 20\nGO(0)\nWAIT = 1000\nPRINT POS(0), VEL(0)",
            default=1.0, low=1e-6, high=1e6, group="axis"),
)  # fmt: skip
