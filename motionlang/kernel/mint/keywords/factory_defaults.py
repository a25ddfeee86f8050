"""Reset every parameter to its power-up value."""

from __future__ import annotations

from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.limits_resetting import default
from motionlang.kernel.mint.keywords.no_effect import StoredValues
from motionlang.kernel.mint.runtime.binding import of
from motionlang.kernel.mint.runtime.environment import Environment


def do_defaults(environment: Environment) -> None:
    """SYSTEMDEFAULTS and FACTORYDEFAULTS: run DEFAULTALL, clear all stored settings."""
    for axis in environment.controller.axes:
        default(environment, axis)
    environment.component(StoredValues).values.clear()


# ------------------------------------------------------------------------------------------------- keywords

_DEFAULTS = Actions(do=of(Environment, do_defaults))

_EXAMPLE = "SPEED(0) = 10 : MOTORPOLES(0) = 6\n{}\nPRINT SPEED(0), MOTORPOLES(0)"


def _word(name: str, short: str, help: str) -> Keyword:
    return Keyword(name, short, "command", "C", "none", "", _DEFAULTS, help, _EXAMPLE.format(name),
                   group="axis")  # fmt: skip


ROWS = (
    _word("SYSTEMDEFAULTS", "sdf",
          "DEFAULTALL, and settings that are stored without an effect are reset; inputs, outputs and memory stay."),
    _word("FACTORYDEFAULTS", "fdf", "As SYSTEMDEFAULTS."),
)  # fmt: skip
