"""What an axis tells about itself."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

ROWS = (
    Keyword("IDLE", "ID", "reading", "R", "axis", "bool", "is_idle",
            "1 when no move of the axis is executing.",
            "MOVER(0) = 12\nGO(0)\nPAUSE IDLE(0)\nPRINT IDLE(0)", default=1.0, group="state"),
    Keyword("POS", "PS", "setting", "RW", "axis", "uu", "position",
            "Position of the axis, that of a simulated motor; writing it gives the present position a new value.",
            "POS(0) = 100\nPRINT POS(0)", default=0.0, group="state", effect="zero", changes="motion", solved=True),
    Keyword("VEL", "VL", "reading", "R", "axis", "uu/s", "velocity",
            "Velocity of the axis, that of a simulated motor.",
            "JOG(0) = 100\nWAIT = 100\nPRINT VEL(0)\nSTOP(0)",
            default=0.0, group="state", changes="motion", solved=True),
    Keyword("POSREMAINING", "", "reading", "R", "axis", "uu", "remaining",
            "Distance still to go in the move that is executing, 0 at rest.",
            "MOVER(0) = 100\nGO(0)\nPRINT POSREMAINING(0)", default=0.0, group="state", changes="motion", solved=True),
    Keyword("FOLERROR", "FE", "reading", "R", "axis", "uu", "following_error",
            "Following error, demanded minus actual position: 0 where no motor is simulated.",
            "PRINT FOLERROR(0)", default=0.0, group="state", changes="motion", solved=True),
    Keyword("MOVEBUFFERFREE", "", "reading", "R", "axis", "integer", "room",
            "Free places in the move buffer of the axis.",
            "MOVER(0) = 10\nPRINT MOVEBUFFERFREE(0)\nGO(0)", default=2.0, group="state"),
)  # fmt: skip
