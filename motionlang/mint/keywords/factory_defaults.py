"""Every parameter as it was at power-up."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_EXAMPLE = "SPEED(0) = 10 : MOTORPOLES(0) = 6\n{}\nPRINT SPEED(0), MOTORPOLES(0)"


def _word(name: str, short: str, help: str) -> Keyword:
    return Keyword(name, short, "command", "C", "none", "", "factory_defaults.defaults", help, _EXAMPLE.format(name),
                   group="axis")  # fmt: skip


ROWS = (
    _word("SYSTEMDEFAULTS", "sdf",
          "DEFAULTALL, and settings that are kept without an effect are forgotten; inputs, outputs and memory stay."),
    _word("FACTORYDEFAULTS", "fdf", "As SYSTEMDEFAULTS."),
)  # fmt: skip
