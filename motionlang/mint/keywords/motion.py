"""Moves, and what starts and ends them."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

ROWS = (
    Keyword("MOVER", "MR", "move", "W", "axis", "uu", "load_by",
            "Load a move by a distance, counted from the end of the move before it; GO starts it.",
            "MOVER(0) = 12\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0)", group="motion", effect="move relative"),
    Keyword("MOVEA", "MA", "move", "W", "axis", "uu", "load_to",
            "Load a move to a position; GO starts it.",
            "MOVEA(0) = 100\nGO(0)\nPAUSE IDLE(0)\nPRINT POS(0)", group="motion", effect="move"),
    Keyword("GO", "", "command", "C", "axes", "", "go",
            "Start all moves in the buffers of the axes, together.",
            "MOVER(0, 1) = 10, 20\nGO(0, 1)\nPAUSE IDLE(0) And IDLE(1)\nPRINT POS(1)", group="motion", effect="go"),
    Keyword("JOG", "JG", "setting", "RW", "axis", "uu/s", "jogging.velocity",
            "Run at a constant speed, its sign the direction, until stopped or told another speed; 0 brings the axis "
            "to rest and ends it.",
            "JOG(0) = 100\nWAIT = 500\nPRINT VEL(0)\nSTOP(0)\nPAUSE IDLE(0)",
            default=0.0, low=-8388607.0, high=8388607.0, group="motion", effect="act endless"),
    Keyword("CANCEL", "CN", "command", "C", "axes", "", "cancel",
            "Stop the axes at once, empty their buffers and clear their errors.",
            "JOG(0) = 100\nWAIT = 500\nCANCEL(0)\nPRINT IDLE(0)", group="motion", effect="stop abrupt"),
    Keyword("CANCELALL", "CNA", "command", "C", "none", "", "cancel_all",
            "CANCEL for every axis.",
            "JOG(0) = 100\nWAIT = 500\nCANCELALL\nPRINT IDLE(0)", group="motion", effect="stop abrupt all"),
)  # fmt: skip
