"""JOG: run at a constant speed."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.changes import repeatable
from motionlang.kernel.mint.runtime.environment import Environment


def write_velocity(environment: Environment, row: Keyword, axis: int, value: float, line: int) -> None:
    """JOG: run at a velocity in user units per second until the next command.

    The sign is the direction; 0 brings the axis to rest.
    """
    velocity = environment.controller.axes[axis].scale.to_counts(value, row.unit)
    environment.controller.jog(axis, velocity, row.name, line, ends=not velocity)
    environment.jogs[axis] = value


# ------------------------------------------------------------------------------------------------- keywords

_JOG = Actions(
    read=of(Environment, lambda e, axis: float(e.jogs.get(axis, 0.0))),
    write=repeatable(of_word(Environment, write_velocity)),
)


ROWS = (
    Keyword("JOG", "JG", "setting", "RW", "axis", "uu/s", _JOG,
            "Run at a constant speed, its sign the direction, until stopped or given another speed; 0 brings the axis "
            "to rest and ends it.",
            "JOG(0) = 100\nWAIT = 500\nPRINT VEL(0)\nSTOP(0)\nPAUSE IDLE(0)",
            default=0.0, low=-8388607.0, high=8388607.0, group="motion", effect="act endless"),
)  # fmt: skip
