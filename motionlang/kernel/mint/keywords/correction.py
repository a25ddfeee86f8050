"""External corrections of motion: MOVECORRECTION and TIMESCALE.

The first shifts the target of a move, the second changes the axis's unit of time.
"""

from __future__ import annotations

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import of, of_word, scale_of
from motionlang.kernel.mint.runtime.environment import Environment


def write_correction(environment: Environment, row: Keyword, axis: int, value: float, line: int) -> None:
    """MOVECORRECTION: extend the move in progress by a distance in user units.

    Raises Rejected if the axis is idle.
    """
    controller = environment.controller
    if controller.is_idle(axis):
        words = f"axis {axis} is on no move that could be corrected"
        raise Rejected("range", words, "INCR begins a move where the axis is at rest")
    controller.retarget_by(axis, scale_of(environment, axis).to_counts(value), row.name, line)


class TimeScales:
    """The unit of time of each axis in seconds, separate from its other scale factors."""

    def __init__(self, environment: Environment) -> None:
        self._controller = environment.controller
        self._seconds: dict[int, float] = {}
        environment.controller.listeners.append(self._on_event, "scale")

    def set(self, axis: int, seconds: float) -> None:
        """TIMESCALE: set the axis's unit of time in seconds."""
        self._seconds[axis] = seconds
        self._controller.set_time_unit(axis, seconds)

    def default(self, axis: int) -> None:
        """Reset the axis to its defaults (DEFAULT)."""
        self._seconds.pop(axis, None)
        self._controller.set_time_unit(axis, 1.0)

    def _on_event(self, what: str, axis: int) -> None:
        if what == "scale" and axis in self._seconds:
            self._controller.set_time_unit(axis, self._seconds[axis])


# ------------------------------------------------------------------------------------------------- keywords

_TIME = Actions(
    read=of(Environment, lambda e, axis: float(scale_of(e, axis).rate)), write=of(TimeScales, TimeScales.set)
)


ROWS = (
    Keyword("MOVECORRECTION", "", "setting", "W", "axis", "uu", Actions(write=of_word(Environment, write_correction)),
            "Let the move in progress end this much further on, such as by the error of a print mark.",
            "MOVER(0) = 100\nGO(0)\nMOVECORRECTION(0) = 2\nPAUSE IDLE(0)\nPRINT POS(0)",
            low=-8388607.0, high=8388607.0, group="motion", effect="act"),
    Keyword("TIMESCALE", "", "setting", "RW", "axis", "number", _TIME,
            "Seconds in the unit of time of speeds and accelerations: 60 makes them units a minute. Settings made "
            "before keep what they are.",
            "TIMESCALE(0) = 60\nSPEED(0) = 600\nMOVER(0) = 20\nGO(0)\nWAIT = 1000\nPRINT POS(0), VEL(0)",
            default=1.0, low=1e-6, high=1e6, group="axis"),
)  # fmt: skip
