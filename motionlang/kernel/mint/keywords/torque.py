"""TORQUEREF: a ramped motor output in place of the servo loop; torque and current.

The reference changes once per servo period, as in a drive, so a ramp is a staircase. It is a percentage of
the full output, which is proportional to torque if the motor has a current amplifier in the machine file.
"""

from __future__ import annotations

from motionlang.kernel.errors import Rejected
from motionlang.kernel.lang.keyword import Actions, Keyword
from motionlang.kernel.mint.keywords.axis_settings import StoredSettings, setting_reader, setting_writer
from motionlang.kernel.mint.keywords.defaults import LOOP_TIME, PERIOD
from motionlang.kernel.mint.keywords.io_outputs import Analogue, analogue_input
from motionlang.kernel.mint.runtime.binding import of, of_word
from motionlang.kernel.mint.runtime.changes import moving
from motionlang.kernel.mint.runtime.environment import Environment

# Volts of one percent of full scale, and full scale in volts.
_PERCENT, FULL = 0.1, 10.0
DEFAULTS = {"TORQUEREFENABLE": 1.0}


class TorqueReferences(StoredSettings):
    """Settings of torque references, by keyword and axis, and the ramps in progress."""

    defaults = DEFAULTS

    def __init__(self, environment: Environment) -> None:
        super().__init__(environment)
        # The percentage in force on axes whose output is the reference.
        self._present: dict[int, float] = {}
        self._ramping: set[int] = set()
        self.controller.analogue_inputs.listen(self._analogue)

    def set(self, name: str, axis: int, value: float) -> None:
        """Write a setting; an axis that the reference controls uses it at once."""
        if name == "TORQUEREFSOURCE" and value:
            analogue_input(int(value) - 1)
        super().set(name, axis, value)
        if name in ("TORQUEREFENABLE", "TORQUEREFSOURCE") and (
            self.has(axis) or (name == "TORQUEREFSOURCE" and value)
        ):
            self.run(axis)

    def has(self, axis: int) -> bool:
        """True if the reference controls the output, which it does until the loop closes."""
        if axis in self._present and not self.controller.is_open(axis):
            del self._present[axis]
        return axis in self._present

    def wanted(self, axis: int) -> float:
        """Return the target percentage: the value written, or that of an analogue input."""
        if not self.setting("TORQUEREFENABLE", axis):
            return 0.0
        source = int(self.setting("TORQUEREFSOURCE", axis))
        return (
            self.environment.component(Analogue).read(source - 1)
            if source
            else self.setting("TORQUEREF", axis)
        )

    def run(self, axis: int) -> None:
        """Ramp to the reference, from 0 if the axis was under closed-loop control."""
        if not self.has(axis):
            self._open(axis, 0.0)
        if axis not in self._ramping:
            self._step(axis)

    def end(self, axis: int) -> None:
        """Give up control of the output to another keyword."""
        self._present.pop(axis, None)

    def _step(self, axis: int) -> None:
        """Carry out one servo period of the ramp."""
        self._ramping.discard(axis)
        if not self.has(axis):
            return
        seconds = self.controller.gain(axis, PERIOD, LOOP_TIME) / 1e6
        present, wanted = self._present[axis], self.wanted(axis)
        following = self._next(axis, present, wanted, seconds)
        if following != present:
            self._open(axis, following)
        if following != wanted:
            self._ramping.add(axis)
            clock = self.environment.clock
            clock.at(clock.now + seconds, lambda: self._step(axis))

    def _next(self, axis: int, present: float, wanted: float, seconds: float) -> float:
        """Return the percentage after one more servo period.

        A change towards 0 uses the fall time, a change away from 0 the rise time.
        """
        rises = present * wanted >= 0.0 and abs(wanted) > abs(present)
        goal = wanted if present * wanted >= 0.0 else 0.0
        time = self.setting("TORQUEREFRISETIME" if rises else "TORQUEREFFALLTIME", axis) / 1000.0
        most = 100.0 * seconds / time if time else abs(goal - present)
        return goal if abs(goal - present) <= most else present + (most if goal > present else -most)

    def _open(self, axis: int, percent: float) -> None:
        self.controller.open_loop(axis, percent * _PERCENT)
        self._present[axis] = percent

    def _analogue(self, channel: int, value: float) -> None:
        for name, axis in list(self._settings):
            if name == "TORQUEREFSOURCE" and self._settings[name, axis] == channel + 1 and self.has(axis):
                self.run(axis)


# ----------------------------------------------------------------------------------------------- operations


def write_reference(references: TorqueReferences, row: Keyword, axis: int, percent: float, line: int) -> None:
    """TORQUEREF: ramp the motor's output to a percentage, without the servo loop."""
    references.set(row.name, axis, percent)
    references.run(axis)


def demand(environment: Environment, axis: int) -> float:
    """TORQUEDEMAND: return the output to the motor in percent."""
    return 100.0 * environment.controller.servo_output(axis) / FULL


def read_current(environment: Environment, row: Keyword, axis: int, channel: int) -> float:
    """CURRENTMEAS and CURRENTDEMAND: return the current of a simulated motor.

    Its amplifier delivers exactly the current that is demanded.
    """
    if channel:
        hint = "channel 0 is the current of the motor, the only one that is simulated"
        raise Rejected("channel", f"{row.word}: there is no current {channel}", hint)
    return environment.controller.motor_current(axis)


# ------------------------------------------------------------------------------------------------- keywords

_REFERENCE = Actions(
    read=of(TorqueReferences, TorqueReferences.wanted), write=of_word(TorqueReferences, write_reference)
)
_SETTING = Actions(read=setting_reader(TorqueReferences), write=setting_writer(TorqueReferences))
_CURRENT = Actions(read=moving(of_word(Environment, read_current)))

_MAX_TIME = 2147483647.0


def _setting(name: str, unit: str, help: str, high: float, default: float = 0.0, effect: str = "") -> Keyword:
    return Keyword(name, "", "setting", "RW", "axis", unit, _SETTING, help,
                   f"{name}(0) = {default:.0f}\nPRINT {name}(0)", default=default, low=0, high=high,
                   group="servo", effect=effect)  # fmt: skip


def _reading(name: str, short: str, index: str, unit: str, actions: Actions, help: str) -> Keyword:
    where = "0, 0" if index == "axis, channel" else "0"
    return Keyword(name, short, "reading", "R", index, unit, actions, help, f"PRINT {name}({where})", default=0.0,
                   group="servo")  # fmt: skip


ROWS = (
    Keyword("TORQUEREF", "tqr", "setting", "RW", "axis", "%", _REFERENCE,
            "Torque reference: the output of the motor, percent of full scale, ramps to it in place of the servo loop, "
            "until CANCEL, STOP, RESET or a move closes the loop again. It needs a simulated motor.",
            "PRINT TORQUEREF(0)", default=0.0, low=-100.0, high=100.0, group="motion", effect="act"),
    _setting("TORQUEREFENABLE", "bool", "0 lets the output fall to 0 whatever TORQUEREF is, 1 lets it rise again.", 1,
             1.0, "act"),
    _setting("TORQUEREFSOURCE", "integer", "Source of the torque reference: 0 TORQUEREF, n analogue input n - 1.", 64,
             effect="hands-over"),
    _setting("TORQUEREFRISETIME", "number", "Milliseconds in which the output rises from 0 to 100 %; 0 for at once.",
             _MAX_TIME),
    _setting("TORQUEREFFALLTIME", "number", "Milliseconds in which the output falls from 100 % to 0; 0 for at once.",
             _MAX_TIME),
    _reading("TORQUEDEMAND", "", "axis", "%", Actions(read=moving(of(Environment, demand))),
             "Demand to the motor, percent of full scale: 0 if no motor is simulated."),
    _reading("EFFORT", "", "axis", "%", Actions(read=moving(of(Environment, lambda e, axis: abs(demand(e, axis))))),
             "Absolute demand to the motor, percent of full scale."),
    _reading("CURRENTMEAS", "cms", "axis, channel", "number", _CURRENT,
             "The current of the motor, A (channel 0): 0 where no motor is simulated."),
    _reading("CURRENTDEMAND", "", "axis, channel", "number", _CURRENT,
             "The current that is asked of the amplifier, A: the same, as a simulated amplifier gives it."),
)  # fmt: skip
