"""The state of an axis: idle or not, and its position."""

from __future__ import annotations

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import Maker, Operation, by_axis, of_word, scale_of
from motionlang.kernel.mint.runtime.environment import Environment


@by_axis
def read_is_idle(environment: Environment, row: Keyword, axis: int) -> Operation:
    """IDLE and POSACHIEVED: return 1 if at rest and, if settings require it, settled."""
    is_idle = environment.controller.reader("is_idle", axis)
    return lambda: int(is_idle() and (environment.settled is None or environment.settled(axis)))


def wrapped_position(name: str) -> Maker:
    """Make an operation that reads POS or POSDEMAND, within POSWRAP if it is set."""

    def read(environment: Environment, row: Keyword, axis: int) -> Operation:
        return environment.controller.reader(name, axis, "place", environment)

    return by_axis(read)


def write_position(environment: Environment, row: Keyword, axis: int, value: float) -> None:
    """POS: set a new value for the present position."""
    counts = scale_of(environment, axis).position_to_counts(value)
    if not -1e300 < counts < 1e300:
        raise Rejected("range", f"{row.word} cannot be {value:.10g}", "a position is finite, in counts too")
    environment.controller.define_position(axis, counts)


# ------------------------------------------------------------------------------------------------- keywords

IS_IDLE = Actions("is_idle", read=read_is_idle)
_POSITION = Actions("position", read=wrapped_position("position"), write=of_word(Environment, write_position))


ROWS = (
    Keyword("IDLE", "ID", "reading", "R", "axis", "bool", IS_IDLE,
            "1 when no move of the axis is executing.",
            "MOVER(0) = 12\nGO(0)\nPAUSE IDLE(0)\nPRINT IDLE(0)", default=1.0, group="state", every=True,
            meant="MOVING"),
    Keyword("POS", "PS", "setting", "RW", "axis", "uu", _POSITION,
            "Position of the axis, that of a simulated motor; writing it gives the present position a new value.",
            "POS(0) = 100\nPRINT POS(0)", default=0.0, group="state", effect="zero position", changes="motion",
            solved=True, meant="POSITION"),
    Keyword("VEL", "VL", "reading", "R", "axis", "uu/s", "velocity",
            "Velocity of the axis, that of a simulated motor.",
            "JOG(0) = 100\nWAIT = 100\nPRINT VEL(0)\nSTOP(0)",
            default=0.0, group="state", changes="motion", solved=True, meant="VELOCITY"),
    Keyword("POSREMAINING", "", "reading", "R", "axis", "uu", "remaining",
            "Distance still to go in the move that is executing, 0 at rest.",
            "MOVER(0) = 100\nGO(0)\nPRINT POSREMAINING(0)", default=0.0, group="state", changes="motion", solved=True),
    Keyword("FOLERROR", "FE", "reading", "R", "axis", "uu", "following_error",
            "Following error, demanded minus actual position: 0 where no motor is simulated.",
            "PRINT FOLERROR(0)", default=0.0, group="state", changes="motion", solved=True, reads="following"),
    Keyword("MOVEBUFFERFREE", "", "reading", "R", "axis", "integer", "room",
            "Free places in the move buffer of the axis.",
            "MOVER(0) = 10\nPRINT MOVEBUFFERFREE(0)\nGO(0)", default=2.0, group="state"),
)  # fmt: skip
