"""INCA, INCR and SUSPEND: changes of the motion in progress."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.motion import finite
from motionlang.kernel.mint.runtime.binding import axis_of, of, of_word, scale_of
from motionlang.kernel.mint.runtime.environment import Environment


def write_by(environment: Environment, row: Keyword, axis: int, value: float, line: int) -> None:
    """INCR: shift the target by a distance in user units, even while in motion."""
    finite(row, value)
    counts = scale_of(environment, axis).to_counts(value)
    environment.controller.retarget_by(axis, counts, row.name, line)


def write_to(environment: Environment, row: Keyword, axis: int, value: float, line: int) -> None:
    """INCA: set a new target in user units, even while in motion."""
    finite(row, value)
    counts = environment.absolute_counts(axis_of(environment, axis), value)
    environment.controller.retarget_to(axis, counts, row.name, line)


def write_suspend(environment: Environment, axis: int, value: int, line: int) -> None:
    """SUSPEND: 1 suspends the axis, 0 resumes it."""
    controller = environment.controller
    (controller.suspend if value else controller.resume)(axis)


# ------------------------------------------------------------------------------------------------- keywords

_SUSPEND = Actions(
    read=of(Environment, lambda e, axis: int(e.controller.is_suspended(axis))),
    write=of(Environment, write_suspend),
)


ROWS = (
    Keyword("INCR", "", "setting", "W", "axis", "uu", Actions(write=of_word(Environment, write_by)),
            "Let the move in progress end some distance further on; the moves behind it keep their ends. At rest it "
            "begins a move without GO, in any other motion it is rejected.",
            "INCR(0) = 10\nINCR(0) = 5\nPAUSE IDLE(0)\nPRINT POS(0)", group="motion", effect="act"),
    Keyword("INCA", "", "setting", "W", "axis", "uu", Actions(write=of_word(Environment, write_to)),
            "Let the move in progress end at a position; the moves behind it keep their ends. At rest it begins a "
            "move without GO, in any other motion it is rejected.",
            "INCA(0) = 10\nINCA(0) = 5\nPAUSE IDLE(0)\nPRINT POS(0)", group="motion", effect="act"),
    Keyword("SUSPEND", "", "setting", "RW", "axis", "bool", _SUSPEND,
            "1 ramps the axis to rest and keeps its moves, 0 goes on with them.",
            "MOVER(0) = 100\nGO(0)\nWAIT = 1\nSUSPEND(0) = 1\nWAIT = 100\nPRINT VEL(0)\nSUSPEND(0) = 0\n"
            "PAUSE IDLE(0)\nPRINT POS(0)", default=0.0, low=0, high=1, group="motion", effect="switch"),
)  # fmt: skip
