"""What changes motion while it goes on: another end, a hold."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

ROWS = (
    Keyword("INCR", "", "setting", "W", "axis", "uu", "on_the_fly.by",
            "Let the move in progress end some distance further on; an axis at rest begins a move. No GO is needed.",
            "INCR(0) = 10\nINCR(0) = 5\nPAUSE IDLE(0)\nPRINT POS(0)", group="motion", effect="act"),
    Keyword("INCA", "", "setting", "W", "axis", "uu", "on_the_fly.to",
            "Let the move in progress end at a position; an axis at rest begins a move. No GO is needed.",
            "INCA(0) = 10\nINCA(0) = 5\nPAUSE IDLE(0)\nPRINT POS(0)", group="motion", effect="act"),
    Keyword("SUSPEND", "", "setting", "RW", "axis", "bool", "on_the_fly.suspend",
            "1 ramps the axis to rest and keeps its moves, 0 goes on with them.",
            "MOVER(0) = 100\nGO(0)\nWAIT = 1\nSUSPEND(0) = 1\nWAIT = 100\nPRINT VEL(0)\nSUSPEND(0) = 0\n"
            "PAUSE IDLE(0)\nPRINT POS(0)", default=0.0, low=0, high=1, group="motion", effect="switch"),
)  # fmt: skip
