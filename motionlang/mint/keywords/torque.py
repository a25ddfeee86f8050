"""Torque references, and what a simulated motor is asked for and draws."""

from __future__ import annotations

from motionlang.lang.keyword import Keyword

_LONGEST = 2147483647.0


def _setting(name: str, unit: str, help: str, high: float, default: float = 0.0, effect: str = "") -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, "torque.setting", help,
                   f"{name}(0) = {default:.0f}\nPRINT {name}(0)", default=default, low=0, high=high,
                   group="servo", effect=effect)  # fmt: skip


def _reading(name: str, short: str, index: str, unit: str, verb: str, help: str) -> Keyword:
    where = "0, 0" if index == "axis, channel" else "0"
    return Keyword(name, short, "reading", "R", index, unit, verb, help, f"PRINT {name}({where})", default=0.0,
                   group="servo")  # fmt: skip


ROWS = (
    Keyword("TORQUEREF", "tqr", "setting", "RW", "axis", "%", "torque.reference",
            "Torque reference: the output of the motor, percent of full scale, ramps to it in place of the servo loop, "
            "until CANCEL, STOP, RESET or a move closes the loop again. It needs a simulated motor.",
            "PRINT TORQUEREF(0)", default=0.0, low=-100.0, high=100.0, group="motion", effect="act"),
    _setting("TORQUEREFENABLE", "bool", "0 lets the output fall to 0 whatever TORQUEREF is, 1 lets it rise again.", 1,
             1.0, "act"),
    _setting("TORQUEREFSOURCE", "integer", "What the torque reference is: 0 TORQUEREF, n analogue input n - 1.", 64,
             effect="hands-over"),
    _setting("TORQUEREFRISETIME", "number", "Milliseconds in which the output rises from 0 to 100 %; 0 for at once.",
             _LONGEST),
    _setting("TORQUEREFFALLTIME", "number", "Milliseconds in which the output falls from 100 % to 0; 0 for at once.",
             _LONGEST),
    _reading("TORQUEDEMAND", "", "axis", "%", "torque.demand",
             "What is asked of the motor, percent of full scale: 0 where no motor is simulated."),
    _reading("EFFORT", "", "axis", "%", "torque.effort",
             "The same without its sign: how much of what it can do the drive does."),
    _reading("CURRENTMEAS", "cms", "axis, channel", "number", "torque.current",
             "The current of the motor, A (channel 0): 0 where no motor is simulated."),
    _reading("CURRENTDEMAND", "", "axis, channel", "number", "torque.current",
             "The current that is asked of the amplifier, A: the same, as a simulated amplifier gives it."),
)  # fmt: skip
